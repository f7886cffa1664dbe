#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""How far an underwater vehicle's camera sees by its lamp, and why the lamp is mounted aside.

Water absorbs the red of the light within metres, and the light that it scatters veils the target.
For a white board straight ahead, the program prints the contrast with the veil at several
distances, and the range at which the contrast has fallen to 2 %. It does so for each colour, with
the lamp beside the camera and on an arm. The water is coastal: it has the absorption of pure water
(Pope and Fry, Applied Optics 36, 1997) at 620, 540 and 470 nm and of dissolved matter, and
particles that scatter 0.15/m forward.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

ABSORPTION = (0.29, 0.07, 0.06)  # per metre, for red, green and blue
SCATTERING, ANISOTROPY = 0.15, 0.92
LAMP = (1.6, 0.9, 0.3)  # m; the camera is at the origin and looks along -z
LAMP_BESIDE = (0.15, 0.1, 0.0)
POWER = (240.0, 228.0, 204.0)  # W/sr
ALBEDO = 0.9  # of the board


def contrast(water, lamp, distance):
    """Light of a white board that arrives, divided by the light of the water in front of it."""
    board = np.array((0, 0, -distance))
    way = np.subtract(lamp, board)
    r = np.linalg.norm(way)
    veil, there, back = np.zeros((3, 3))
    airlight.vtkAirlight.Inscatter(water, lamp, POWER, (0, 0, 0), (0, 0, -1), 0, distance, veil)
    airlight.vtkAirlight.Transmittance(water, lamp, board, there)
    airlight.vtkAirlight.Transmittance(water, board, (0, 0, 0), back)
    return ALBEDO / np.pi * np.array(POWER) * way[2] / r**3 * there * back / veil


def find_range(water, lamp, channel):
    """Distance at which the contrast is 2 %; the contrast falls with the distance."""
    near, far = 0.5, 500.0
    while far - near > 1e-6:
        middle = (near + far) / 2
        if contrast(water, lamp, middle)[channel] > 0.02:
            near = middle
        else:
            far = middle
    return near


def add(renderer, source, albedo, place=(0, 0, 0), turn=0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(place)
    actor.RotateX(turn)
    actor.GetProperty().SetColor(albedo)
    renderer.AddActor(actor)
    return actor


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return source


def make_floor():
    """A sandy sea floor, 1.5 m below, with ripples of 5 cm."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-12, 0, 2)
    plane.SetPoint1(12, 0, 2)
    plane.SetPoint2(-12, 0, -30)
    plane.SetResolution(240, 320)
    plane.Update()
    mesh = plane.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    x, z = points[:, 0], points[:, 2]
    points[:, 1] = -1.5 + 0.05 * np.sin(4 * z + np.sin(1.3 * x)) + 0.12 * np.sin(0.7 * x + 0.4 * z)
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    return normals


def make_scene():
    renderer = vtkRenderer()
    floor = add(renderer, make_floor(), (0.62, 0.56, 0.42))
    airlight.vtkAirlightPass.SetCastsShadow(floor, False)
    pipe = vtkCylinderSource()
    pipe.SetRadius(0.3)
    pipe.SetHeight(40)
    pipe.SetResolution(48)
    add(renderer, pipe, (0.7, 0.68, 0.6), (-1.3, -1.2, -12), 90)
    ring = vtkCylinderSource()
    ring.SetRadius(0.36)
    ring.SetHeight(0.15)
    ring.SetResolution(48)
    for z in range(-29, 0, 3):
        add(renderer, ring, (0.75, 0.2, 0.1), (-1.3, -1.2, z), 90)
    for x, z in ((0.45, -3), (0, -5), (-1.2, -8), (-0.6, -12)):
        add(renderer, box(x, x + 0.6, -0.9, -0.3, z - 0.03, z), (0.9, 0.9, 0.9))
        add(renderer, box(x + 0.27, x + 0.33, -1.7, -0.9, z - 0.03, z), (0.5, 0.5, 0.5))
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser)
    options = parser.parse_args()
    water = airlight.vtkParticipatingMedium()
    water.SetScattering(3 * [SCATTERING])
    water.SetAbsorption(ABSORPTION)
    water.SetPhaseFunctionToHenyeyGreenstein()
    water.SetAnisotropy(ANISOTROPY)
    for name, lamp in (("beside the camera", LAMP_BESIDE), ("on an arm", LAMP)):
        print(f"lamp {name}: contrast " + ", ".join(
            "{:.3g} {:.3g} {:.3g} at {} m".format(*contrast(water, lamp, d), d)
            for d in (2, 5, 10)))
        print("  range: red {:.2f}, green {:.2f}, blue {:.2f} m".format(
            *(find_range(water, lamp, channel) for channel in range(3))))

    renderer = make_scene()
    lamp = vtkLight()
    airlight.vtkAirlight.SetRadiantIntensity(lamp, POWER)
    lamp.SetPosition(LAMP)
    lamp.SetFocalPoint(-0.3, -0.8, -7)
    lamp.SetConeAngle(40)
    lamp.SetExponent(0)
    renderer.AddLight(lamp)
    water_pass = airlight.vtkAirlightPass()
    water_pass.SetMedium(water)
    water_pass.SetSubpixelFrames(options.frames)
    water_pass.SetExposure(4.0)  # for the eye
    water_pass.SetToneMappingToReinhard()
    water_pass.SetOutputColorSpaceToSRGB()
    renderer.SetPass(water_pass)
    renderer.SetUseFXAA(options.frames == 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, -0.12, -1)
    camera.SetViewAngle(45)
    renderer.ResetCameraClippingRange()
    window = airlight.display.open_window(renderer, size=options.size,
                                          offscreen=bool(options.output))
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
