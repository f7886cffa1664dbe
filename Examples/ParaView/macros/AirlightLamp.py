# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A macro of ParaView: a lamp above the data of the active view.

In Macros, Import new macro, this file becomes a button. The lamp is a wide spotlight of ParaView,
which the Light Inspector (menu View) shows. It is above the data, to the left and slightly behind,
seen along -z, and shows a white surface at their centre slightly brighter than white, without a
medium.
"""

import math

from paraview import simple

PLACE = (-0.45, 0.82, -0.1)  # in diagonals of the data from their centre
CONE_ANGLE = 80  # ParaView draws the cone of the light that is edited; of 90 on, it has no end
RADIANCE = 1.1  # of a white surface at the centre


def visible_bounds(view):
    """Of all data that the view shows: three pairs."""
    boxes = [rep.Input.GetDataInformation().GetBounds() for rep in view.Representations
             if getattr(rep, "Input", None) and getattr(rep, "Visibility", 0)]
    boxes = [box for box in boxes if box[0] <= box[1]]
    if not boxes:
        raise RuntimeError("The active view shows no data: show some, then add the lamp.")
    return [(min(box[2 * i] for box in boxes), max(box[2 * i + 1] for box in boxes))
            for i in range(3)]


def add_lamp(view=None):
    """The light, in the view given or in the active one."""
    view = view or simple.GetActiveView()
    if view is None or not hasattr(view, "AdditionalLights"):
        raise RuntimeError("The active view is no render view: select one by a click into it.")
    bounds = visible_bounds(view)
    diagonal = math.dist(*zip(*bounds)) or 1.0
    center = [(low + high) / 2 for low, high in bounds]
    lamp = simple.AddLight(view=view)
    lamp.Coords = "Scene"
    lamp.Type = "Positional"
    lamp.Position = [c + diagonal * p for c, p in zip(center, PLACE)]
    lamp.FocalPoint = center
    lamp.ConeAngle = CONE_ANGLE
    lamp.DiffuseColor = [1, 1, 1]
    lamp.Intensity = RADIANCE * (diagonal * math.hypot(*PLACE)) ** 2
    lamp.Attenuation = [0, 0, 1]
    view.StillRender()  # simple.Render() would reset a camera once
    return lamp


if __name__ in ("__main__", "__vtkconsole__"):  # the latter in ParaView's window
    add_lamp()
