# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Windows and pictures, for short scripts.

    import airlight.display
    window = airlight.display.open_window(renderer)
    airlight.display.show(window)                       # until q is pressed

    window = airlight.display.open_window(renderer, offscreen=True)
    airlight.display.write_picture(window, "fog.png")

show_picture() does all of it from the options of a command line.
"""

import argparse

from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkRenderWindow, vtkRenderWindowInteractor, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
import vtkmodules.vtkRenderingUI  # noqa: F401 its windows

import airlight
from airlight.windows import require_screen


def parse_size(text):
    """(1280, 720) of "1280x720"; raises argparse.ArgumentTypeError for anything else."""
    width, _, height = text.partition("x")
    if not (width.isdecimal() and height.isdecimal() and 0 < min(int(width), int(height))
            and max(int(width), int(height)) <= 16384):
        raise argparse.ArgumentTypeError(
            f"'{text}' is no size: give width and height in pixels, for example 1280x720")
    return int(width), int(height)


def parse_frames(text):
    """A number of frames from 1 to 1024; raises argparse.ArgumentTypeError for anything else."""
    if not text.isdecimal() or not 1 <= int(text) <= 1024:
        raise argparse.ArgumentTypeError(f"'{text}' is no number of frames from 1 to 1024")
    return int(text)


def add_picture_options(parser, size=(480, 320)):
    """Adds --output, --size and --frames to an argparse.ArgumentParser, with these pixels."""
    parser.add_argument("-o", "--output", help="picture to write, a PNG; default: a window")
    parser.add_argument("--size", type=parse_size, default=size, metavar="WxH",
                        help=f"pixels; default: {size[0]}x{size[1]}")
    parser.add_argument("--frames", type=parse_frames, default=1, metavar="N",
                        help="SubpixelFrames of the pass, for smooth edges and soft shadows of "
                             "lamps that have a size; default: %(default)s")


def open_window(*renderers, size=(480, 320), offscreen=False):
    """A vtkRenderWindow that has drawn its first frame, so that the passes' buffers can be read.

    size: pixels. offscreen: without a place on the screen, for a picture; else with an interactor
    whose mouse moves the camera. Without multisampling, which the medium's pass does not need.
    Raises RuntimeError where VTK has nothing to draw with.
    """
    window = vtkRenderWindow()
    require_screen(window)
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


def write_picture(window, path, redraw=True):
    """The window's scene as a PNG. Raises OSError if it cannot be written.

    redraw: draw it for the picture; else the picture is what the window has drawn last.
    """
    with open(path, "wb"):
        pass  # Python tells why a file cannot be written, VTK only that
    shot = vtkWindowToImageFilter()
    shot.SetInput(window)
    shot.ReadFrontBufferOff()
    shot.SetShouldRerender(redraw)
    writer = vtkPNGWriter()
    writer.SetInputConnection(shot.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"the picture {path} could not be written: is the disk full?")


def show_or_write(window, path, redraw=True):
    """write_picture() where there is a path, else show(): for an option of a script."""
    if path:
        write_picture(window, path, redraw)
    else:
        show(window)


def show_picture(renderer, medium, options, eye, target, angle, up=(0, 1, 0)):
    """Shows or writes a renderer's scene in a medium, as the options of add_picture_options() say.

    eye, target, angle, up: the camera's place, the point that it looks at, its vertical view angle
    in degrees and what is up. The renderer gets a pass with exact shadows, whose bright colours fade
    to white, for screens, and which is returned.
    """
    medium_pass = airlight.vtkAirlightPass()
    medium_pass.SetMedium(medium)
    medium_pass.SetShadowTechniqueToShadowPlanes()  # exact, however many borders a pixel sees
    medium_pass.SetSubpixelFrames(options.frames)
    medium_pass.SetToneMappingToNeutralPBR()
    medium_pass.SetOutputColorSpaceToSRGB()
    renderer.SetPass(medium_pass)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(eye)
    camera.SetFocalPoint(target)
    camera.SetViewUp(up)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()
    window = open_window(renderer, size=options.size, offscreen=bool(options.output))
    show_or_write(window, options.output, redraw=False)
    return medium_pass
