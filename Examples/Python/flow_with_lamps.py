#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines of a swirling spherical vortex, with coloured lamps in the flow.

The flow is an exact solution of the Euler equations, in the frame of the vortex: Moffatt's
spherical vortex of radius 1 (J. Fluid Mech. 35, 1969) with the swirl that makes its vorticity
parallel to its velocity, in a stream of speed 1 along x. The tubes are coloured by speed. Their
shadows in the haze show how far behind each other they are.

The program prints the largest speed, and the circulation around half of the vortex: the sum of the
vorticity across it. Both are in units of the stream's speed and the vortex's radius.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkArrayCalculator, vtkTubeFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer)

import airlight
import airlight.display

SHAPE, CELL = (67, 67, 161), 0.05  # points along z, y and x, around the vortex
WAVE = 4.493409457909064  # the first zero of j1: vorticity divided by velocity in the vortex
# Tubes: distance from the axis, how many, and how long. Those inside start in the middle plane, at
# distances from which streamlines come back after a quarter or a fifth of a turn around the axis:
# one round of each tube meets another tube. Those outside start at x = START, at some angles around
# the axis (degrees), so that none are in front of the vortex.
INSIDE = [(0.1467, 12, 4.04), (0.3387, 10, 3.42)]
OUTSIDE = [(0.45, 9, 12.0), (0.85, 13, 12.0), (1.3, 17, 12.0)]
START, OPEN = -3.9, (145, 365)
RADIUS = 0.02
COLOURS = [(0.0, 0.10, 0.22, 0.60), (1.0, 0.25, 0.55, 0.80), (2.0, 0.90, 0.80, 0.45),
           (4.6, 0.90, 0.25, 0.08)]  # speed; red, green, blue
LAMPS = [((0.0, 0.0, 0.0), (14.0, 7.5, 2.6)), ((1.75, 0.45, -0.35), (0.3, 1.3, 2.4)),
         ((-1.7, -0.5, -0.3), (1.6, 0.3, 1.3))]
LAMP_RADIUS = 0.01
SCATTERING = 0.18
EYE, TARGET, ANGLE = (1.9, 1.5, 5.4), (0.05, 0.0, 0.0), 26


def flow(points):
    """The velocity at points (..., 3)."""
    points = np.where(points.any(axis=-1, keepdims=True), points, (1e-4, 0, 0))  # r is not 0
    x, y, z = np.moveaxis(points, -1, 0)
    r = np.linalg.norm(points, axis=-1)
    t = WAVE * r
    j1 = (np.sin(t) / t - np.cos(t)) / t
    slope = np.sin(t) - j1  # d(r j1)/dr
    strength = 1.5 / np.sin(WAVE)  # as fast as the stream outside, on the sphere
    # Velocities along r, along the meridian away from x, and around x, the latter two divided by
    # the sine of the angle from x.
    inside = r < 1
    cube = np.where(inside, 1.0, r)**-3
    radial = np.where(inside, 2 * strength * j1 * WAVE / t, 1 - cube) * x / r
    meridian = -np.where(inside, strength * slope * WAVE / t, 1 + cube / 2)
    swirl = np.where(inside, WAVE * strength * j1, 0)
    velocity = (radial / r)[..., None] * points
    velocity[..., 0] -= meridian * (y**2 + z**2) / r**2
    velocity[..., 1] += (meridian * x * y / r - swirl * z) / r
    velocity[..., 2] += (meridian * x * z / r + swirl * y) / r
    return velocity


def make_grid():
    """The velocity, as an image."""
    z, y, x = (CELL * (np.arange(count) - count // 2) for count in SHAPE)
    points = np.stack(np.meshgrid(z, y, x, indexing="ij")[::-1], axis=-1)
    image = vtkImageData()
    image.SetDimensions(SHAPE[::-1])
    image.SetOrigin(x[0], y[0], z[0])
    image.SetSpacing(3 * [CELL])
    velocity = numpy_to_vtk(flow(points).reshape(-1, 3), deep=True)
    velocity.SetName("velocity")
    image.GetPointData().SetVectors(velocity)
    return image


def measure(image):
    """The largest speed, and the circulation around the half of the vortex above the axis."""
    velocity = vtk_to_numpy(image.GetPointData().GetVectors())
    gradient = vtkGradientFilter()
    gradient.SetInputData(image)
    gradient.SetInputScalars(0, "velocity")
    gradient.ComputeGradientOff()
    gradient.ComputeVorticityOn()
    gradient.Update()
    vorticity = vtk_to_numpy(gradient.GetOutput().GetPointData().GetArray("Vorticity"))
    section = vorticity.reshape(*SHAPE, 3)[SHAPE[0] // 2, SHAPE[1] // 2:, :, 2]  # z = 0, y >= 0
    return np.linalg.norm(velocity, axis=1).max(), section.sum() * CELL**2


def make_tubes(image, x, arc, radius, count, length):
    """The tubes through points on an arc around the x axis, between two angles in degrees."""
    seeds, points = vtkPolyData(), vtkPoints()
    for angle in np.radians(np.linspace(*arc, count, endpoint=False)):
        points.InsertNextPoint(x, radius * np.cos(angle), radius * np.sin(angle))
    seeds.SetPoints(points)
    tracer = vtkStreamTracer()
    tracer.SetInputData(image)
    tracer.SetSourceData(seeds)
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetIntegrationStepUnit(vtkStreamTracer.LENGTH_UNIT)
    tracer.SetInitialIntegrationStep(0.05)
    tracer.SetMaximumPropagation(length)
    tracer.SetComputeVorticity(False)
    speed = vtkArrayCalculator()
    speed.SetInputConnection(tracer.GetOutputPort())
    speed.AddVectorArrayName("velocity")
    speed.SetFunction("mag(velocity)")
    speed.SetResultArrayName("speed")
    tubes = vtkTubeFilter()
    tubes.SetInputConnection(speed.GetOutputPort())
    tubes.SetRadius(RADIUS)
    tubes.SetNumberOfSides(8)
    tubes.CappingOn()
    return tubes


def add_tubes(renderer, image):
    colours = vtkColorTransferFunction()
    for colour in COLOURS:
        colours.AddRGBPoint(*colour)
    for x, arc, rows in ((0.0, (0, 360), INSIDE), (START, OPEN, OUTSIDE)):
        for row in rows:
            tubes = make_tubes(image, x, arc, *row)
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(tubes.GetOutputPort())
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray("speed")
            mapper.SetLookupTable(colours)
            mapper.UseLookupTableScalarRangeOn()
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)


def add_lamps(renderer):
    for place, intensity in LAMPS:
        lamp = vtkLight()
        lamp.SetPosition(place)
        airlight.vtkAirlight.SetRadiantIntensity(lamp, intensity)
        airlight.vtkAirlightLight.SetRadius(lamp, LAMP_RADIUS)
        renderer.AddLight(lamp)
    fill = vtkLight()  # shows the tubes far from the lamps; the haze does not scatter it
    fill.SetLightTypeToHeadlight()
    fill.SetColor(0.5, 0.7, 1.0)
    fill.SetIntensity(0.3)
    airlight.vtkAirlightLight.SetScatters(fill, False)
    renderer.AddLight(fill)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser, (640, 360))
    options = parser.parse_args()
    image = make_grid()
    speed, circulation = measure(image)
    print(f"largest speed {speed:.3f}, by the formula {abs(WAVE / np.sin(WAVE)):.3f}; "
          f"circulation {abs(circulation):.3f}")

    renderer = vtkRenderer()
    renderer.SetBackground(0.002, 0.003, 0.006)
    add_tubes(renderer, image)
    add_lamps(renderer)
    haze = airlight.vtkParticipatingMedium()
    haze.SetScattering(3 * [SCATTERING])
    haze.SetRegionToBox()
    haze.SetBounds(-4, 4, -3, 3, -2.5, 2.5)
    renderer.SetUseFXAA(options.frames == 1)
    airlight.display.show_picture(renderer, haze, options, EYE, TARGET, ANGLE)


if __name__ == "__main__":
    main()
