#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The sun through the windows of a dusty room: where it falls, and how much comes in.

The program prints the area of the sunlit floor, the irradiance there and the power that warms it,
from sensors every 5 cm. It also prints how much of the view ray through the centre of the picture
is in the sun.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

ROOM = (-3.5, 3.5, 0.0, 3.2, -6.0, 5.0)  # m: x, y and z inside the walls, which are 0.2 thick
TO_SUN = (-1.0, 0.72, -0.3)
SUN = (800.0, 720.0, 600.0)  # W/m^2 on a surface that faces it; red, green, blue
SCATTERING, ABSORPTION, ANISOTROPY = 0.07, 0.007, 0.6  # of the dust, per metre
SKYLIGHT = (4.5, 5.0, 5.6)  # W/(m^2 sr), from all sides, in the room
SENSOR = 0.05  # m
WHITE = 45.0  # W/(m^2 sr), shown as white in the picture
EYE, TARGET = (2.9, 1.5, 3.6), (-2.4, 1.0, -1.5)

# Boxes: the wall with three windows, from 0.9 to 2.7 m, and the bars in them; walls and ceiling.
WALLS = [(-3.7, -3.5, 0, 0.9, -6, 5), (-3.7, -3.5, 2.7, 3.2, -6, 5)]
WALLS += [(-3.7, -3.5, 0.9, 2.7, *z) for z in ((-6, -5.2), (-3.8, -2.9), (-1.5, -0.6), (0.8, 5))]
WALLS += [(-3.64, -3.56, 0.9, 2.7, z - 0.04, z + 0.04) for z in (-4.5, -2.2, 0.1)]
WALLS += [(-3.64, -3.56, 2.06, 2.14, -5.2, 0.8)]
WALLS += [(-3.7, 3.7, 3.2, 3.4, -6.2, 5.2), (3.5, 3.7, 0, 3.2, -6, 5),
          (-3.7, 3.7, 0, 3.2, -6.2, -6), (-3.7, 3.7, 0, 3.2, 5, 5.2)]
TABLE = [(-1.9, -0.2, 0.7, 0.75, -2.5, -1.1)] + [
    (x, x + 0.07, 0, 0.7, z, z + 0.07) for x in (-1.85, -0.32) for z in (-2.45, -1.22)]


def box(bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return source


def measure_floor(sun, dust):
    """Irradiances at the centres of squares of the floor, in the shadows of walls and table."""
    floor = vtkPlaneSource()
    x0, x1, y, _, z0, z1 = ROOM
    half = SENSOR / 2
    floor.SetOrigin(x0 + half, y, z1 - half)
    floor.SetPoint1(x1 - half, y, z1 - half)
    floor.SetPoint2(x0 + half, y, z0 + half)
    floor.SetResolution(round((x1 - x0) / SENSOR) - 1, round((z1 - z0) / SENSOR) - 1)
    probe = airlight.vtkAirlightProbeFilter()
    probe.SetInputConnection(floor.GetOutputPort())
    for bounds in WALLS + TABLE:
        caster = box(bounds)
        probe.AddInputConnection(1, caster.GetOutputPort())
    probe.AddLight(sun)
    probe.SetMedium(dust)
    probe.Update()
    arrived = probe.GetOutput().GetPointData().GetArray("DirectIrradiance")
    return WHITE * vtk_to_numpy(arrived).mean(axis=1)


def add(renderer, source, albedo):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(albedo)
    actor.GetProperty().SetAmbientColor(np.multiply(albedo, SKYLIGHT) / WHITE)
    actor.GetProperty().SetAmbient(1)
    renderer.AddActor(actor)


def make_room():
    renderer = vtkRenderer()
    renderer.SetBackground(0.5, 0.7, 0.9)  # the sky in the windows
    x0, x1, y0, y1, z0, z1 = ROOM
    add(renderer, box((x0 - 0.2, x1, y0 - 0.2, y0, z0, z1)), (0.36, 0.23, 0.13))
    for bounds in WALLS:
        add(renderer, box(bounds), (0.75, 0.72, 0.66))
    for bounds in TABLE:
        add(renderer, box(bounds), (0.45, 0.22, 0.1))
    ball = vtkSphereSource()
    ball.SetCenter(-1.2, 0.97, -1.7)
    ball.SetRadius(0.22)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    add(renderer, ball, (0.3, 0.55, 0.6))
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser)
    options = parser.parse_args()
    sun = vtkLight()
    airlight.vtkAirlight.SetIrradiance(sun, np.divide(SUN, WHITE))
    sun.SetPosition(TO_SUN)
    sun.SetFocalPoint(0, 0, 0)
    dust = airlight.vtkParticipatingMedium()
    dust.SetScattering(3 * [SCATTERING])
    dust.SetAbsorption(3 * [ABSORPTION])
    dust.SetAmbientRadiance(np.divide(SKYLIGHT, WHITE))
    dust.SetPhaseFunctionToHenyeyGreenstein()
    dust.SetAnisotropy(ANISOTROPY)
    dust.SetRegionToBox()
    dust.SetBounds(ROOM)

    arrived = measure_floor(sun, dust)
    lit = arrived > 0
    print(f"sun on {lit.sum() * SENSOR**2:.2f} m^2 of the floor, {arrived[lit].mean():.1f} W/m^2 "
          f"there, together {arrived.sum() * SENSOR**2:.0f} W")
    renderer = make_room()
    renderer.AddLight(sun)
    dust_pass = airlight.vtkAirlightPass()
    dust_pass.SetMedium(dust)
    dust_pass.SetSubpixelFrames(options.frames)
    dust_pass.RecordBuffersOn()
    dust_pass.SetToneMappingToNeutralPBR()  # for the eye
    dust_pass.SetOutputColorSpaceToSRGB()
    renderer.SetPass(dust_pass)
    renderer.SetUseFXAA(options.frames == 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetFocalPoint(TARGET)
    camera.SetViewAngle(42)
    renderer.ResetCameraClippingRange()
    window = airlight.display.open_window(renderer, size=options.size,
                                          offscreen=bool(options.output))
    column, row = (pixels // 2 for pixels in options.size)
    in_sun, all_of_it = (dust_pass.GetBuffer(name).GetScalarComponentAsDouble(column, row, 0, 0)
                         for name in ("LitLength", "Depth"))
    print(f"of {all_of_it:.3f} m straight ahead {in_sun:.3f} m are in the sun")
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
