# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Windows without a screen, for servers, containers and tests."""

from .vtkAirlight import vtkAirlightHeadlessWindow


def headless_window(*renderers, size=(640, 480), device=0):
    """A render window that needs no X server, with the newest OpenGL that a device gives.

        window = airlight.headless_window(renderer, size=(800, 600))
        window.Render()
        airlight.display.write_picture(window, "fog.png")

    Parameters
    ----------
    *renderers : vtkRenderer
        What the window draws.
    size : (int, int), default: (640, 480)
        Pixels.
    device : int, default: 0
        One of vtkAirlightHeadlessWindow().GetNumberOfDevices(): graphics cards first, then software.

    Returns
    -------
    vtkAirlightHeadlessWindow
        It has its context, and has drawn nothing yet.

    Raises
    ------
    RuntimeError
        If there is no EGL, no such device or no OpenGL 3.2; the message names the remedy.
    """
    messages = []

    def keep(_window, _event, message):
        messages.append(" ".join(message.split()))

    keep.CallDataType = "string0"
    window = vtkAirlightHeadlessWindow()
    tag = window.AddObserver("ErrorEvent", keep)
    window.SetDeviceIndex(device)
    window.SetMultiSamples(0)
    window.SetSize(size)
    supported = window.SupportsOpenGL()
    window.RemoveObserver(tag)
    if not supported:
        raise RuntimeError(messages[-1].split("): ", 1)[-1] if messages else "no OpenGL")
    for renderer in renderers:
        window.AddRenderer(renderer)
    return window
