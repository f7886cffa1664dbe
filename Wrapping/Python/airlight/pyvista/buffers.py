# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The buffers of a frame as PyVista images."""

from __future__ import annotations

from typing import Any

import pyvista as pv

from .messages import Messages

# Names of buffers; those that are radiances scale with what is drawn white.
RADIANCES = ("Radiance", "Airlight", "MultipleScattering", "Surface", "ErrorBound")
NAMES = (*RADIANCES, "Transmittance", "Depth", "LitLength", "BoundaryCount")


def check_name(name: Any) -> str:
    """A name of a buffer."""
    if not isinstance(name, str):
        raise TypeError(f"name is {name!r}: give one of {', '.join(map(repr, NAMES))}, or "
                        "'Airlight:0' for the first light.")
    head, _, index = name.partition(":")
    if name not in NAMES and not (head == "Airlight" and index.isdigit()):
        raise ValueError(f"name is {name!r}: give one of {', '.join(map(repr, NAMES))}, or "
                         "'Airlight:0' for the first light.")
    return name


def render_now(plotter: Any) -> None:
    """Render a frame, also before the plotter is shown, without a window on the screen."""
    window = plotter.render_window
    if not plotter._first_time:  # PyVista's own flag; render() draws only once it is cleared
        plotter.render()
        return
    for renderer in plotter.renderers:
        if not renderer.camera_set:
            renderer.camera_position = renderer.get_default_cam_pos()
            renderer.ResetCamera()
            renderer.camera_set = False  # show() places the camera for what is added until then
    was_off_screen = window.GetOffScreenRendering()
    window.SetOffScreenRendering(True)
    window.Render()
    window.SetOffScreenRendering(was_off_screen)


def read(plotter: Any, subplot: Any, source: str, name: str) -> pv.ImageData:
    """Render a frame and return its buffer ``source`` as ``name``.

    RuntimeError if there is no medium in the frame.
    """
    recorded = subplot.render_pass.GetRecordBuffers()
    subplot.render_pass.RecordBuffersOn()
    subplot.draws_at_once = True
    try:
        with Messages(subplot.render_pass) as messages:
            render_now(plotter)
    finally:
        subplot.draws_at_once = False
    render_pass = subplot.render_pass  # a chain of other passes may have made another one
    found = render_pass.GetBuffer(source)
    render_pass.SetRecordBuffers(recorded)
    if found is None:
        reason = messages.text or subplot.refused or f"the frame has no buffer {source!r}"
        raise RuntimeError(f"There is no buffer {source!r}: {reason}")
    image = pv.ImageData(found, deep=True)
    values = image.point_data[image.point_data.keys()[0]]
    if name.partition(":")[0] in RADIANCES and subplot.settings.white != 1.0:
        values = values * subplot.settings.white
    image.clear_data()
    image.point_data[name] = values
    image.set_active_scalars(name)
    return image
