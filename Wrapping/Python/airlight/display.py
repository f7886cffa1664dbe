# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Windows and pictures, for short scripts.

    import airlight.display
    window = airlight.display.open_window(renderer)
    airlight.display.show(window)                       # until q is pressed

    window = airlight.display.open_window(renderer, offscreen=True)
    airlight.display.write_picture(window, "fog.png")
"""

from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkRenderWindow, vtkRenderWindowInteractor, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
import vtkmodules.vtkRenderingUI  # noqa: F401 its windows


def open_window(*renderers, size=(480, 320), offscreen=False):
    """A vtkRenderWindow that has drawn its first frame, so that the passes' buffers can be read.

    size: pixels. offscreen: without a place on the screen, for a picture; else with an interactor
    whose mouse moves the camera. Without multisampling, which the medium's pass does not need.
    """
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.SetOffScreenRendering(offscreen)
    if not offscreen:
        interactor = vtkRenderWindowInteractor()
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        interactor.SetRenderWindow(window)
    window.Render()
    return window


def show(window):
    """Until q is pressed in this window of open_window(), or it is closed."""
    interactor = window.GetInteractor()
    if interactor is None:
        raise ValueError("the window has no interactor: open it with open_window(), not off screen")
    interactor.Start()


def write_picture(window, path):
    """What the window shows, as a PNG. Raises OSError where the file cannot be written."""
    with open(path, "wb"):
        pass  # Python tells why a file cannot be written, VTK only that
    shot = vtkWindowToImageFilter()
    shot.SetInput(window)
    shot.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shot.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"the picture {path} could not be written: is the disk full?")


def show_or_write(window, path):
    """write_picture() where there is a path, else show(): for an option of a script."""
    if path:
        write_picture(window, path)
    else:
        show(window)
