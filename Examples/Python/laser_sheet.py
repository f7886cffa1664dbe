#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A laser's light sheet through the smoke of a wind tunnel, past a cylinder and its shadow.

The sheet spreads from a lens, a point, through a slit between two plates. Smoke wires make streaks
along the streamlines of potential flow past the cylinder. At the point where the middle line meets
the sheet, the program prints the thickness of the sheet along the view and its radiance, as drawn
and by hand. It also prints how much of the floor's middle line the cylinder shadows.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkLineSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

TUNNEL = (-0.6, 0.9, -0.4, 0.4, -0.3, 0.3)  # m; air flows along x
RADIUS = 0.1  # of the cylinder around the z axis
LENS = (0.1, 0.75, 0.0)
SLIT, SLIT_DEPTH = 0.001, 0.11  # m wide, and how far below the lens it ends
POWER = (9.0, 200.0, 26.0)  # W/sr, green
SCATTERING = 2.0  # per metre, in the streaks
WIRES = 0.05  # m between the smoke wires
EYE, TARGET = (0.75, 0.35, 2.0), (0.13, 0.02, 0.0)
PROBE = (-0.35, 0.0, 0.0)  # on the middle line, before the cylinder


def add(renderer, source, albedo):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(albedo)
    actor.GetProperty().SetAmbient(0.15)  # to see the tunnel by
    renderer.AddActor(actor)
    return actor


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return source


def make_cylinder():
    cylinder = vtkCylinderSource()
    cylinder.SetRadius(RADIUS)
    cylinder.SetHeight(0.4)
    cylinder.SetResolution(192)
    turn = vtkTransform()
    turn.RotateX(90)
    turned = vtkTransformPolyDataFilter()
    turned.SetInputConnection(cylinder.GetOutputPort())
    turned.SetTransform(turn)
    return turned


def make_smoke():
    """Density 1 in streaks of equal stream function y (1 - R^2/r^2), 0.15 between them."""
    x0, x1, y0, y1, z0, z1 = TUNNEL
    x, y = np.meshgrid(np.linspace(x0, x1, 301), np.linspace(y0, y1, 161))
    r2 = np.maximum(x**2 + y**2, RADIUS**2)
    stream = y * (1 - RADIUS**2 / r2)
    density = (0.15 + 0.85 * np.cos(np.pi * stream / WIRES)**8)
    image = vtkImageData()
    image.SetDimensions(301, 161, 2)
    image.SetOrigin(x0, y0, z0)
    image.SetSpacing((x1 - x0) / 300, (y1 - y0) / 160, z1 - z0)
    image.GetPointData().SetScalars(numpy_to_vtk(np.tile(density.ravel(), 2), deep=True))
    smoke = airlight.vtkParticipatingMedium()
    smoke.SetScattering(3 * [SCATTERING])
    smoke.SetDensityImage(image)
    smoke.SetDensityToImage()
    return smoke


def make_scene():
    renderer = vtkRenderer()
    lens = vtkLight()
    airlight.vtkAirlight.SetRadiantIntensity(lens, POWER)
    lens.SetPosition(LENS)
    lens.SetFocalPoint(LENS[0], 0, LENS[2])
    lens.SetConeAngle(50)
    lens.SetExponent(0)
    renderer.AddLight(lens)
    for z in (1, -1):
        edges = sorted((z * SLIT / 2, z * 0.15))
        bottom = LENS[1] - SLIT_DEPTH
        add(renderer, box(-0.3, 0.5, bottom, bottom + 0.01, *edges), (0.2, 0.2, 0.2))
    add(renderer, make_cylinder(), (0.5, 0.5, 0.5))
    add(renderer, box(-0.6, 0.9, -0.41, -0.4, -0.3, 0.3), (0.1, 0.1, 0.1))
    add(renderer, box(-0.6, 0.9, -0.4, 0.4, -0.31, -0.3), (0.02, 0.02, 0.02))
    return renderer, lens


def measure_shadow(lens):
    """Length of the cylinder's shadow on the floor's middle line, seen from the lens."""
    line = vtkLineSource()
    line.SetPoint1(TUNNEL[0], TUNNEL[2] + 0.01, 0)
    line.SetPoint2(TUNNEL[1], TUNNEL[2] + 0.01, 0)
    cylinder = make_cylinder()
    lit = airlight.vtkLitIntervalsFilter()
    lit.SetInputConnection(line.GetOutputPort())
    lit.AddInputConnection(1, cylinder.GetOutputPort())
    lit.SetLight(lens)
    lit.SetMedium(make_smoke())
    lit.Update()
    data = lit.GetOutput().GetCellData()
    return data.GetArray("Start").GetValue(1) - data.GetArray("End").GetValue(0)


def radiance_by_hand(smoke, place, thickness):
    """Green radiance of a thin sheet: sigma_s/(4 pi) I/r^2 T thickness."""
    there, back = np.zeros((2, 3))
    airlight.vtkAirlight.Transmittance(smoke, LENS, place, there)
    airlight.vtkAirlight.Transmittance(smoke, place, EYE, back)
    r2 = np.square(np.subtract(place, LENS)).sum()
    return SCATTERING / (4 * np.pi) * POWER[1] / r2 * there[1] * back[1] * thickness


def look_at(renderer, point):
    """The pixel that shows a point of the sheet, and the point at which its ray meets the sheet."""
    renderer.SetWorldPoint(*point, 1)
    renderer.WorldToDisplay()
    column, row = (int(place) for place in renderer.GetDisplayPoint()[:2])
    renderer.SetDisplayPoint(column + 0.5, row + 0.5, 0.5)
    renderer.DisplayToWorld()
    x, y, z, w = renderer.GetWorldPoint()
    ray = np.array((x, y, z)) / w - EYE
    return column, row, EYE - ray * EYE[2] / ray[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser)
    options = parser.parse_args()
    renderer, lens = make_scene()
    smoke = make_smoke()
    smoke_pass = airlight.vtkAirlightPass()
    smoke_pass.SetMedium(smoke)
    smoke_pass.SetSubpixelFrames(options.frames)
    smoke_pass.RecordBuffersOn()
    smoke_pass.SetExposure(2.5)  # for the eye
    smoke_pass.SetToneMappingToNeutralPBR()
    smoke_pass.SetOutputColorSpaceToSRGB()
    renderer.SetPass(smoke_pass)
    renderer.SetUseFXAA(options.frames == 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetFocalPoint(TARGET)
    camera.SetViewAngle(30)
    renderer.ResetCameraClippingRange()
    window = airlight.display.open_window(renderer, size=options.size,
                                          offscreen=bool(options.output))

    column, row, place = look_at(renderer, PROBE)
    drawn, length = (smoke_pass.GetBuffer(name).GetScalarComponentAsDouble(column, row, 0, channel)
                     for name, channel in (("Airlight", 1), ("LitLength", 0)))
    across = SLIT * (LENS[1] - place[1]) / SLIT_DEPTH
    thickness = across * np.linalg.norm(np.subtract(EYE, place)) / EYE[2]
    print(f"thickness along the view: {1000 * length:.2f} mm, by hand {1000 * thickness:.2f} mm")
    print(f"radiance: {drawn:.4f} W/(m^2 sr), by hand "
          f"{radiance_by_hand(smoke, place, thickness):.4f} W/(m^2 sr)")
    print(f"shadow on the floor: {measure_shadow(lens):.4f} m")
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
