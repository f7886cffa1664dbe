#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What light that is scattered more than once adds: in fog, in smoke and in milk.

Each row is a medium. Its columns are vtkAirlightPass with light that is scattered once, the same
with multiple scattering, and paths of all orders by vtkAirlightReference, at one exposure. The
paths have a sixth of the resolution. The program prints the pictures' radiance by that of the
paths. It takes minutes: see --seconds.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageInterpolator, vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

# Scattering and absorption per metre, and the mean cosine of scattering; the same lamp stands
# 2.8 metres from the eye.
MEDIA = {
    "fog": (0.5, 0.0, 0.85),  # droplets absorb nothing
    "smoke": (0.35, 0.25, 0.5),  # soot absorbs
    "milk": (0.8, 0.002, 0.7),  # a few drops of it in water
}
LAMP, EYE, TARGET = (-0.35, 0.5, 0.8), (1.5, -1.6, 0.9), (0.0, 0.3, 0.55)
BALL, RADIUS, FLOOR = (0.35, 0.3, 0.35), 0.35, 0.4  # the floor's albedo
POWER = 1.0  # W/sr


def add(renderer, source, albedo):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(albedo)
    renderer.AddActor(actor)


def make_scene():
    renderer = vtkRenderer()
    floor = vtkPlaneSource()
    floor.SetOrigin(-30, -30, 0)
    floor.SetPoint1(30, -30, 0)
    floor.SetPoint2(-30, 30, 0)
    add(renderer, floor, 3 * [FLOOR])
    ball = vtkSphereSource()
    ball.SetCenter(BALL)
    ball.SetRadius(RADIUS)
    ball.SetThetaResolution(96)
    ball.SetPhiResolution(64)
    add(renderer, ball, (0.75, 0.3, 0.15))
    lamp = vtkLight()
    airlight.vtkAirlight.SetRadiantIntensity(lamp, 3 * [POWER])
    lamp.SetPosition(LAMP)
    renderer.AddLight(lamp)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetFocalPoint(TARGET)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(45)
    camera.SetClippingRange(0.05, 100)
    return renderer


def make_medium(scattering, absorption, mean_cosine):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(3 * [scattering])
    medium.SetAbsorption(3 * [absorption])
    medium.SetPhaseFunctionToHenyeyGreenstein()
    medium.SetAnisotropy(mean_cosine)
    return medium


def radiance_of_pass(medium, size, frames):
    """Rows from the bottom."""
    renderer = make_scene()
    medium_pass = airlight.vtkAirlightPass()
    medium_pass.SetMedium(medium)
    medium_pass.SetSubpixelFrames(frames)
    medium_pass.RecordBuffersOn()
    renderer.SetPass(medium_pass)
    # The window has to live while its buffers are read.
    window = airlight.display.open_window(renderer, size=size, offscreen=True)
    radiance = as_array(medium_pass.GetBuffer("Radiance"), size)
    window.Finalize()
    return radiance


def radiance_of_paths(medium, size, seconds):
    paths = airlight.vtkAirlightReference()
    paths.SetRenderer(make_scene())
    paths.SetMedium(medium)
    # A sixth of the pixels' rows and columns, with 36 times the paths each.
    coarse = [max(length // 6, 1) for length in size]
    paths.SetSize(coarse)
    paths.SetScatteringOrders(0)
    paths.SetSamplesPerPixel(100000)
    paths.SetTimeLimit(seconds)
    paths.Update()
    paths.GetOutput().GetPointData().SetActiveScalars("Radiance")
    linear = vtkImageInterpolator()
    linear.SetInterpolationModeToLinear()
    resized = vtkImageResize()
    resized.SetInterpolator(linear)
    resized.SetInputData(paths.GetOutput())
    resized.SetOutputDimensions(*size, 1)
    resized.Update()
    return as_array(resized.GetOutput(), size)


def as_array(image, size):
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(size[1], size[0], -1)[:, :, :3].astype(float)


def srgb(radiance):
    x = np.clip(radiance, 0, 1)
    return np.where(x < 0.0031308, 12.92 * x, 1.055 * x**(1 / 2.4) - 0.055)


def write(pixels, name):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    colours = np.round(255 * pixels).astype(np.uint8).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(colours, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputData(image)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="scattering-orders.png",
                        help="picture to write, a PNG; default: %(default)s")
    parser.add_argument("--size", type=airlight.display.parse_size, default=(426, 300),
                        metavar="WxH", help="pixels of each of the nine pictures; default: 426x300")
    parser.add_argument("--seconds", type=float, default=200,
                        help="for the paths of each medium; default: %(default)s")
    parser.add_argument("--frames", type=airlight.display.parse_frames, default=16, metavar="N",
                        help="SubpixelFrames of the pass; default: %(default)s")
    options = parser.parse_args()
    rows = []
    for name, coefficients in MEDIA.items():
        medium = make_medium(*coefficients)
        paths = radiance_of_paths(medium, options.size, options.seconds)
        once = radiance_of_pass(medium, options.size, options.frames)
        medium.MultipleScatteringOn()
        multiple = radiance_of_pass(medium, options.size, options.frames)
        print(f"{name}: of all light, scattered once {once.sum() / paths.sum():.2f}, "
              f"multiple scattering {multiple.sum() / paths.sum():.2f}")
        white = np.percentile(paths, 98)
        rows.insert(0, np.hstack([srgb(picture / white) for picture in (once, multiple, paths)]))
    write(np.vstack(rows), options.output)


if __name__ == "__main__":
    main()
