# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The size of a renderer's scene and the view of it, from which defaults are derived."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

# As far as vtkRenderer.ResetCamera() puts the camera from the scene's centre, in diagonals of its
# bounds: half a diagonal over the sine of half of the view angle of 30 degrees.
RESET_DISTANCE = 0.5 / np.sin(np.radians(15.0))

# What is left of the light of the scene's far end: fog that is clearly seen, and seen through.
FAR_TRANSMITTANCE = 0.3

KOSCHMIEDER = 3.912  # visibility times extinction


class Scene(NamedTuple):
    """The bounds of a scene, and the camera's place and axes."""

    low: np.ndarray
    high: np.ndarray
    eye: np.ndarray
    forward: np.ndarray
    up: np.ndarray

    @property
    def center(self) -> np.ndarray:
        """The centre of the bounds."""
        return (self.low + self.high) / 2

    @property
    def diagonal(self) -> float:
        """The length of the bounds' diagonal; 1 for a scene that is one point."""
        return float(np.linalg.norm(self.high - self.low)) or 1.0

    @property
    def is_inside(self) -> bool:
        """Whether the camera is inside the bounds, as in a room."""
        return bool((self.eye > self.low).all() and (self.eye < self.high).all())

    @property
    def visibility(self) -> float:
        """The visibility at which the far end of the scene keeps FAR_TRANSMITTANCE."""
        far = np.linalg.norm(self.eye - self.center) + self.diagonal / 2
        return float(KOSCHMIEDER / -np.log(FAR_TRANSMITTANCE) * far)

    @property
    def lamp_position(self) -> np.ndarray:
        """Above the scene, to the left and slightly behind; in a room below its ceiling."""
        if self.is_inside:
            axis = int(np.argmax(np.abs(self.up)))
            position = self.center.copy()
            position[axis] += 0.35 * (self.high - self.low)[axis] * np.sign(self.up[axis])
            return position
        right = np.cross(self.forward, self.up)
        return self.center + self.diagonal * (0.82 * self.up - 0.45 * right + 0.1 * self.forward)


def measure(renderer: Any) -> Scene | None:
    """The scene of a PyVista renderer; None if it has nothing visible."""
    bounds = np.array(renderer.ComputeVisiblePropBounds())
    low, high = bounds[::2], bounds[1::2]
    if not np.isfinite(bounds).all() or (low > high).any() or np.abs(bounds).max() > 1e100:
        return None
    camera = renderer.GetActiveCamera()
    if camera is not None and renderer.camera_set:
        eye = np.array(camera.GetPosition())
        forward = np.array(camera.GetDirectionOfProjection())
        up = np.array(camera.GetViewUp())
    else:  # as PyVista will set it
        position, focus, up = (np.array(v, dtype=float) for v in renderer.get_default_cam_pos())
        forward = (focus - position) / np.linalg.norm(focus - position)
        eye = (low + high) / 2 - forward * RESET_DISTANCE * np.linalg.norm(high - low)
    up = up - np.dot(up, forward) * forward
    length = np.linalg.norm(up)
    if length < 1e-12:
        return Scene(low, high, eye, forward, np.array((0.0, 0.0, 1.0)))
    return Scene(low, high, eye, forward, up / length)


def background(renderer: Any) -> tuple[float, ...]:
    """The mean colour of a renderer's background."""
    colour = np.array(renderer.GetBackground())
    if renderer.GetGradientBackground():
        colour = (colour + np.array(renderer.GetBackground2())) / 2
    return tuple(colour.tolist())
