# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The rays of a camera's pixels.

A camera is a dict: "position", "focal_point", "view_up", and either "view_angle_deg", the whole
vertical angle of a perspective view, or "parallel_scale", half the height of a parallel one.
"""

import numpy as np

from geometry import unit


def rays(camera, size, pixels):
    """Origins and unit directions [n, 3] at pixel coordinates [n, 2]; (0, 0) is the lower left
    corner of the picture, and the middle of its first pixel is (0.5, 0.5)."""
    width, height = size
    eye = np.array(camera["position"], float)
    forward = unit(np.subtract(camera["focal_point"], eye))
    right = unit(np.cross(forward, camera["view_up"]))
    up = np.cross(right, forward)
    pixels = np.asarray(pixels, float)
    x = (2 * pixels[:, 0] - width) / height
    y = (2 * pixels[:, 1] - height) / height
    aside = x[:, None] * right + y[:, None] * up
    if "parallel_scale" in camera:
        return eye + camera["parallel_scale"] * aside, np.broadcast_to(forward, aside.shape)
    tangent = np.tan(np.radians(camera["view_angle_deg"]) / 2)
    return np.broadcast_to(eye, aside.shape), unit(forward + tangent * aside)
