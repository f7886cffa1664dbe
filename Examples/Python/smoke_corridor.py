#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""How far exit signs can be read in a corridor full of smoke.

A sign can be read while the contrast of its letters with their dark ground is at least 2 %. The
contrast is the light of the letters that comes through the smoke, divided by the light that the
smoke in front of the sign scatters. The program prints the largest such distance times the
extinction K of the smoke, beside the measured rule (T. Jin, "Visibility through fire smoke", J.
Fire & Flammability 9, 1978): 5 to 10 for signs that shine, 2 to 4 for signs that are lit. In
uniformly lit smoke the contrast is B exp(-K d)/(A (1 - exp(-K d))).
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer
from vtkmodules.vtkRenderingFreeType import vtkVectorText

import airlight
import airlight.display

SCATTERING, ABSORPTION = 0.12, 0.08  # per metre; their sum is K
EYE, SIGN, END = 1.6, 2.26, 45.0  # m: heights, and the length of the corridor along -z
LAMPS = [(0.0, 2.45, -2.5 - 5 * i) for i in range(8)]
POWER = (7.5, 6.8, 5.7)  # W/sr, of each lamp, within 80 degrees around straight down
AMBIENT = 0.06  # W/(m^2 sr), scattered more than once by smoke and walls
LETTERS = 8.0  # W/(m^2 sr), of letters that shine
ALBEDO = 0.8  # of letters that do not


def make_lamps():
    lamps = [vtkLight() for _ in LAMPS]
    for lamp, place in zip(lamps, LAMPS):
        airlight.vtkAirlight.SetRadiantIntensity(lamp, POWER)
        lamp.SetPosition(place)
        lamp.SetFocalPoint(place[0], 0, place[2])
        lamp.SetConeAngle(80)
        lamp.SetExponent(0)
        airlight.vtkAirlightLight.SetRadius(lamp, 0.15)  # its glass, in means of frames
    return lamps


def measure(smoke, lamps, signs):
    """Contrasts of letters that shine and of letters that are lit, at distances from the eye."""
    places, normals = np.zeros((2, len(signs), 3))
    places[:, 1], places[:, 2], normals[:, 2] = SIGN, -signs, 1
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))
    probe = airlight.vtkAirlightProbeFilter()
    probe.SetInputData(surface)
    for lamp in lamps:
        probe.AddLight(lamp)
    probe.SetMedium(smoke)
    probe.SetViewpoint(0, EYE, 0)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    veil, through, light = (vtk_to_numpy(data.GetArray(name)).mean(axis=1) for name in
                            ("Radiance", "Transmittance", "DirectIrradiance"))
    return LETTERS * through / veil, ALBEDO / np.pi * (light + np.pi * AMBIENT) * through / veil


def add(renderer, source, colour, shines, place=(0, 0, 0), scale=1):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(place)
    actor.SetScale(scale)
    colour = np.array(colour)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetAmbient(1 if shines else AMBIENT)
    actor.GetProperty().SetDiffuse(0 if shines else 1)
    renderer.AddActor(actor)


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return source


def make_corridor():
    renderer = vtkRenderer()
    for x, y, z in LAMPS:
        sides = x - 0.2, x + 0.2, z - 0.2, z + 0.2
        add(renderer, box(*sides[:2], y + 0.01, y + 0.03, *sides[2:]), (4, 3.8, 3.4), True)
        add(renderer, box(*sides[:2], y + 0.03, 2.6, *sides[2:]), (0.5, 0.5, 0.5), False)
    for bounds, colour in (((-1.3, -1.2, 0, 2.6), (0.6, 0.58, 0.5)),
                           ((1.2, 1.3, 0, 2.6), (0.6, 0.58, 0.5)),
                           ((-1.3, 1.3, -0.1, 0), (0.3, 0.3, 0.33)),
                           ((-1.3, 1.3, 2.6, 2.7), (0.7, 0.7, 0.7)),
                           ((-1.2, -1.17, 0, 0.25), (0.08, 0.07, 0.06)),
                           ((1.17, 1.2, 0, 0.25), (0.08, 0.07, 0.06)),
                           ((-1.2, -1.12, 0.9, 1), (0.3, 0.15, 0.07)),
                           ((1.12, 1.2, 0.9, 1), (0.3, 0.15, 0.07))):
        add(renderer, box(*bounds, -END, 2), colour, False)
    text = vtkVectorText()
    text.SetText("EXIT")
    text.Update()
    left, right = text.GetOutput().GetBounds()[:2]
    middle = 0.15 * 0.5 * (left + right)
    for z in range(-5, -43, -5):
        add(renderer, box(-0.34, 0.34, 2.12, 2.4, z - 0.04, z - 0.01), (0.01, 0.8, 0.2), True)
        add(renderer, text, 3 * [LETTERS], True, (-middle, 2.19, z), 0.15)
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser)
    options = parser.parse_args()

    smoke = airlight.vtkParticipatingMedium()
    smoke.SetScattering(3 * [SCATTERING])
    smoke.SetAbsorption(3 * [ABSORPTION])
    smoke.SetAmbientRadiance(3 * [AMBIENT])
    lamps = make_lamps()
    signs = np.arange(5, END - 2, 5)  # each as far behind a lamp as the others
    for name, contrast, jin in zip(("shine", "are lit"), measure(smoke, lamps, signs),
                                   ("5 to 10", "2 to 4")):
        reach = np.interp(-np.log(0.02), -np.log(contrast), signs)
        print(f"signs that {name}: contrast " + ", ".join(
            f"{value:.3g} at {sign} m" for value, sign in zip(contrast, signs)))
        print(f"  readable to {reach:.1f} m, K times that {reach * (SCATTERING + ABSORPTION):.1f}; "
              f"measured {jin}")

    renderer = make_corridor()
    for lamp in lamps:
        renderer.AddLight(lamp)
    smoke_pass = airlight.vtkAirlightPass()
    smoke_pass.SetMedium(smoke)
    smoke_pass.SetSubpixelFrames(options.frames)
    smoke_pass.SetShadowTechniqueToShadowPlanes()  # exact, though there are many edges
    smoke_pass.SetToneMappingToNeutralPBR()  # for the eye
    smoke_pass.SetOutputColorSpaceToSRGB()
    renderer.SetPass(smoke_pass)
    renderer.SetUseFXAA(options.frames == 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, EYE, 0)
    camera.SetFocalPoint(0, EYE + 0.05, -1)
    camera.SetViewAngle(40)
    renderer.ResetCameraClippingRange()
    window = airlight.display.open_window(renderer, size=options.size,
                                          offscreen=bool(options.output))
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
