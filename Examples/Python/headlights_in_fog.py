#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a driver sees in fog at night by low and by high beam.

Fog scatters the light of the headlights back: a veil lies over the road. For both beams and for
people on the road at several distances, the program prints the luminance of the veil in front of
them and their contrast. The contrast is their own luminance as it arrives, divided by that of the
veil. For the low beam, a shield in front of each lamp blocks the light that would go higher than
1 % below the horizon. The picture shows the low beam at the top and the high beam at the bottom.
"""

import argparse

import numpy as np
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

INTENSITY = 20000.0  # cd, along the axis of each lamp
SHIELD = 0.9  # opacity of each of its two sides: 1 % of the light is stray light above the road
COLOUR = np.array((1.0, 0.96, 0.86))
LAMPS = [(-0.62, 0.65, 0.0), (0.62, 0.65, 0.0)]  # m; the car drives along -z
EYE = (-0.35, 1.25, 1.6)
VISIBILITY, ANISOTROPY = 100.0, 0.85  # of the fog: metres, and its droplets' mean cosine
PEOPLE = [(1.0, 12.0), (-0.4, 22.0), (-2.2, 34.0), (0.4, 48.0)]  # m to the right, and ahead
WHITE = 10.0  # cd/m^2, shown as white in the picture
EXPOSURE = 2.5


def add(renderer, source, albedo):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(albedo)
    renderer.AddActor(actor)
    return actor


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return source


def tube(start, end, radius):
    """A limb, from one point to another."""
    line, rounded = vtkLineSource(), vtkTubeFilter()
    line.SetPoint1(start)
    line.SetPoint2(end)
    rounded.SetInputConnection(line.GetOutputPort())
    rounded.SetRadius(radius)
    rounded.SetNumberOfSides(24)
    rounded.CappingOn()
    return rounded


def ball(*centre, radius):
    source = vtkSphereSource()
    source.SetCenter(centre)
    source.SetRadius(radius)
    source.SetThetaResolution(32)
    source.SetPhiResolution(32)
    return source


def add_person(renderer, x, z):
    coat, skin = (0.22, 0.1, 0.08), (0.35, 0.25, 0.2)
    for leg in (x - 0.2, x + 0.02):
        add(renderer, box(leg, leg + 0.16, 0, 0.8, z - 0.1, z + 0.1), (0.06, 0.07, 0.1))
    body = add(renderer, ball(0, 0, 0, radius=1), coat)
    body.SetPosition(x, 1.13, z)
    body.SetScale(0.23, 0.36, 0.14)
    for side in (-1, 1):
        shoulder, hand = (x + 0.2 * side, 1.38, z), (x + 0.3 * side, 0.82, z + 0.06)
        add(renderer, tube(shoulder, hand, 0.065), coat)
        add(renderer, ball(*shoulder, radius=0.075), coat)
        add(renderer, ball(*hand, radius=0.06), skin)
    add(renderer, tube((x, 1.4, z), (x, 1.6, z), 0.06), skin)
    add(renderer, ball(x, 1.65, z, radius=0.125), skin)


def add_road(renderer):
    add(renderer, box(-40, 40, -0.2, -0.02, -200, 10), (0.035, 0.05, 0.025))  # grass
    add(renderer, box(-5.2, 2.1, -0.2, 0, -200, 10), (0.07, 0.07, 0.07))
    for z in range(-190, 10, 9):
        add(renderer, box(-1.9, -1.78, -0.1, 0.01, z, z + 3), (0.5, 0.5, 0.48))
    add(renderer, box(1.8, 1.95, -0.1, 0.01, -200, 10), (0.5, 0.5, 0.48))
    for z in range(-190, 0, 10):
        for x in (-5.6, 2.4):
            add(renderer, box(x, x + 0.12, 0, 1, z, z + 0.12), (0.7, 0.7, 0.7))
    for x, distance in PEOPLE:
        add_person(renderer, x, -distance)


def make_view(beam, viewport):
    """Renderer and pass of the road in the light of one beam."""
    renderer = vtkRenderer()
    renderer.SetViewport(viewport)
    fog = airlight.vtkParticipatingMedium()
    fog.SetVisibility(VISIBILITY)
    fog.SetPhaseFunctionToHenyeyGreenstein()
    fog.SetAnisotropy(ANISOTROPY)
    fog_pass = airlight.vtkAirlightPass()
    fog_pass.SetMedium(fog)
    fog_pass.RecordBuffersOn()
    fog_pass.SetExposure(EXPOSURE)  # for the eye
    fog_pass.SetToneMappingToReinhard()
    fog_pass.SetOutputColorSpaceToSRGB()
    for x, y, z in LAMPS:
        lamp = vtkLight()
        airlight.vtkAirlight.SetRadiantIntensity(lamp, INTENSITY / WHITE * COLOUR)
        lamp.SetPosition(x, y, z)
        lamp.SetFocalPoint(x, y, z - 1)
        lamp.SetConeAngle(35)
        lamp.SetExponent(60)  # half as bright 9 degrees off its axis
        renderer.AddLight(lamp)
        if beam == "low":
            plate = box(x - 0.05, x + 0.05, y - 0.0005, y + 0.04, z - 0.051, z - 0.05)
            shield = add(renderer, plate, (0, 0, 0))
            fog_pass.SetShadowOpacity(shield, SHIELD, SHIELD, SHIELD)
    renderer.SetPass(fog_pass)
    add_road(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetFocalPoint(EYE[0], EYE[1] - 0.045, EYE[2] - 1)
    camera.SetViewAngle(17)
    camera.SetClippingRange(0.5, 300)
    return renderer, fog_pass


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser)
    options = parser.parse_args()
    views = {"low": make_view("low", (0, 0.5, 1, 1)), "high": make_view("high", (0, 0, 1, 0.5))}
    for _, fog_pass in views.values():
        fog_pass.SetSubpixelFrames(options.frames)
    window = airlight.display.open_window(*(renderer for renderer, _ in views.values()),
                                          size=options.size, offscreen=bool(options.output))

    for x, distance in PEOPLE:
        print(f"at {distance:g} m:", end="")
        for beam, (renderer, fog_pass) in views.items():
            renderer.SetWorldPoint(x + 0.1, 0.15, -distance + 0.1, 1)  # a leg
            renderer.WorldToDisplay()
            column, row, _ = renderer.GetDisplayPoint()
            column, row = int(column), int(row - renderer.GetOrigin()[1])
            surface, veil = (WHITE * fog_pass.GetBuffer(name).GetScalarComponentAsDouble(
                column, row, 0, 1) for name in ("Surface", "Airlight"))
            print(f"  {beam} beam: veil {veil:.3f} cd/m^2, contrast {surface / veil:.3f}", end="")
        print()
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
