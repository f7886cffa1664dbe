#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Incense in a Gothic nave: the sun's shafts through the windows.

Walls, vault, ribs and the rose window are closed meshes, extruded from outlines, so that every
shaft of the side windows has the exact form of its window. The sun's disc of 0.53 degrees softens the borders of shafts
when the pass has several frames (--frames).

The program prints how long a line across the nave, 4 m above the floor in the middle of a bay, is
in the sun, and the airlight on it, in units of the radiance that is shown as white.
"""

import argparse

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

BAY, BAYS, FRONT = 5.0, 9, 10.0  # m: from pier to pier, how many, and the z of the first
HALF, SPRING, CROWN = 5.0, 12.2, 18.5  # m: half the nave's width; heights where the vault begins, ends
SILL, WINDOW_SPRING, HEAD, WINDOW = 5.0, 9.8, 12.0, 1.1  # m: a window's heights and half width
WALL = 0.9  # m: thickness
ROSE, ROSE_HEIGHT = 2.9, 11.6  # m: radius, and height of its centre
TO_SUN = (1.0, 0.95, -0.35)
SUN = (40.0, 32.0, 21.0)  # irradiance, with 1 as white; red, green, blue
SKY = (0.028, 0.033, 0.042)  # radiance from all sides in the nave
FILL = 0.28  # radiance of white stone that faces the eye
SCATTERING, ANISOTROPY = 0.016, 0.35  # of the incense, per metre
EYE, TARGET, ANGLE = (-0.7, 2.6, 9.2), (0.45, 6.9, -16.0), 62
STONE, WOOD, FLOOR = (0.60, 0.54, 0.46), (0.16, 0.09, 0.05), (0.34, 0.31, 0.28)
X, Y, Z = np.eye(3)


def arch(half, spring, crown, count=14):
    """A pointed arch from its right foot to its left one: two arcs with centres at the spring."""
    rise = crown - spring
    radius = (half**2 + rise**2) / (2 * half)
    angle = np.linspace(0, np.arctan2(rise, radius - half), count)
    right = np.stack((half - radius + radius * np.cos(angle), spring + radius * np.sin(angle)), 1)
    return np.concatenate((right, right[-2::-1] * (-1, 1)))


def extrude(outline, origin, u, v, depth):
    """The closed prism of an outline in the plane of u and v."""
    points, cells = vtkPoints(), vtkCellArray()
    for a, b in outline:
        points.InsertNextPoint(origin + a * u + b * v)
    cells.InsertNextCell(len(outline), range(len(outline)))
    polygon = vtkPolyData()
    polygon.SetPoints(points)
    polygon.SetPolys(cells)
    prism = vtkLinearExtrusionFilter()
    prism.SetInputData(polygon)
    prism.SetExtrusionTypeToVectorExtrusion()
    prism.SetVector(depth)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(prism.GetOutputPort())
    return triangles


def box(x0, x1, y0, y1, z0, z1):
    source = vtkCubeSource()
    source.SetBounds(x0, x1, y0, y1, z0, z1)
    return source


def side_wall(x):
    """A wall above the sills, whose inner face is at x: one outline, notched by the windows."""
    end = FRONT - BAY * BAYS
    outline = [(end, CROWN + 1), (end, SILL)]
    for k in reversed(range(BAYS)):
        z = FRONT - BAY * (k + 0.5)
        notch = arch(WINDOW, WINDOW_SPRING, HEAD, 9)[::-1] + (z, 0)
        outline += [(z - WINDOW, SILL), *notch, (z + WINDOW, SILL)]
    outline += [(FRONT, SILL), (FRONT, CROWN + 1)]
    yield extrude(outline, x * X, Z, Y, np.sign(x) * WALL * X)
    low, high = sorted((x, x + np.sign(x) * WALL))
    yield box(low, high, 0, SILL, end, FRONT + 0.5)


def window_bars(x):
    """A mullion and two bars in each window; no bar's shadow goes through the eye."""
    middle = x + np.sign(x) * WALL / 2
    for k in range(BAYS):
        z = FRONT - BAY * (k + 0.5)
        yield box(middle - 0.07, middle + 0.07, SILL, HEAD, z - 0.07, z + 0.07)
        for y in (6.2, WINDOW_SPRING):
            yield box(middle - 0.05, middle + 0.05, y - 0.05, y + 0.05, z - WINDOW, z + WINDOW)


def pier(x, z):
    """A round pier with four shafts, from the floor to the vault."""
    turn = np.linspace(0, 2 * np.pi, 25)[:-1]
    circle = np.stack((np.cos(turn), np.sin(turn)), axis=1)
    for dx, dz, radius in ((0, 0, 0.42), (-0.42, 0, 0.16), (0.42, 0, 0.16), (0, -0.42, 0.16),
                           (0, 0.42, 0.16)):
        yield extrude(radius * circle, np.array((x + dx, 0, z + dz)), X, Z, SPRING * Y)
    for low, high, radius in ((0, 0.9, 0.78), (SPRING - 0.5, SPRING, 0.72)):
        yield extrude(radius * circle, np.array((x, low, z)), X, Z, (high - low) * Y)


def end_wall(z):
    """The wall at the end, with a round hole for the rose window."""
    for side in (-1, 1):
        turn = np.linspace(-np.pi / 2, np.pi / 2, 40)
        hole = np.stack((side * ROSE * np.cos(turn), ROSE_HEIGHT + ROSE * np.sin(turn)), axis=1)
        outline = [(0, 0), (side * (HALF + WALL), 0), (side * (HALF + WALL), CROWN + 1),
                   (0, CROWN + 1)] + list(hole[::-1])
        yield extrude(outline, np.array((0, 0, z)), X, Y, -WALL * Z)


def rose(z):
    """The stone of the rose window: three rings and 24 spokes."""
    centre = np.array((0, ROSE_HEIGHT, z - WALL / 2))
    turn = np.linspace(0, 2 * np.pi, 49)
    for inner, outer in ((0.62, 0.80), (1.72, 1.86), (ROSE - 0.16, ROSE + 0.05)):  # rings, as halves
        for half in (turn[:25], turn[24:]):
            ring = np.stack((np.cos(half), np.sin(half)), axis=1)
            yield extrude(np.concatenate((outer * ring, inner * ring[::-1])), centre, X, Y, 0.2 * Z)
    for k in range(24):
        angle = np.pi * k / 12
        along, across = np.cos(angle) * X + np.sin(angle) * Y, np.cos(angle) * Y - np.sin(angle) * X
        start = 0.7 if k % 2 == 0 else 1.8
        spoke = [(start, -0.045), (ROSE, -0.045), (ROSE, 0.045), (start, 0.045)]
        yield extrude(spoke, centre, along, across, 0.18 * Z)


def vault(z0, z1):
    """A pointed barrel vault."""
    inside, outside = arch(HALF, SPRING, CROWN), arch(HALF + WALL, SPRING, CROWN + 1.2)
    yield extrude(np.concatenate((inside, outside[::-1])), np.array((0, 0, z1)), X, Y, (z0 - z1) * Z)


def rib(z):
    outer, inner = arch(HALF + 0.1, SPRING, CROWN + 0.1), arch(HALF - 0.45, SPRING, CROWN - 0.5)
    yield extrude(np.concatenate((inner, outer[::-1])), np.array((0, 0, z - 0.25)), X, Y, 0.5 * Z)


def pews(z):
    for side in (-1, 1):
        near, far = sorted((side * 1.1, side * 3.9))
        yield box(near, far, 0.40, 0.46, z - 0.45, z)
        yield box(near, far, 0.40, 0.98, z, z + 0.06)
        for x in (near, far):
            yield box(x - 0.05, x + 0.05, 0, 1.05, z - 0.5, z + 0.1)


def make_nave():
    """Parts, their albedo, and whether they cast: piers, ribs and the rose do not, to save time."""
    back = FRONT - BAY * BAYS
    shell = [*side_wall(HALF), *vault(FRONT + 0.5, back), *end_wall(back)]
    inside = [*side_wall(-HALF), *window_bars(-HALF), *rose(back),
              box(-HALF - WALL, HALF + WALL, 0, CROWN + 1.2, FRONT + 0.5, FRONT + 1.2)]
    for z in FRONT - BAY * np.arange(BAYS + 1):
        inside += [*pier(HALF - 0.25, z), *pier(0.25 - HALF, z), *rib(z)]
    for x in (-HALF, HALF):  # string courses
        inside.append(box(x - 0.06, x + 0.06, SILL - 0.3, SILL - 0.1, back, FRONT))
    wood = [part for z in np.arange(back + 9, FRONT - 3.5, 1.25) for part in pews(z)]
    floor = [box(-HALF - WALL, HALF + WALL, -0.3, 0, back - WALL, FRONT + 1.2)]
    floor += [box(-2.2, 2.2, 0, h, back, back + d) for h, d in ((0.18, 6.0), (0.36, 5.5))]
    floor += [box(-1.1, 1.1, 0.36, 1.4, back + 2.5, back + 3.4)]  # the altar
    return ((shell, STONE, True), (list(window_bars(HALF)), STONE, True), (inside, STONE, False),
            (wood, WOOD, True), (floor, FLOOR, False))


def join(parts):
    joined = vtkAppendPolyData()
    for part in parts:
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(part.GetOutputPort())
        joined.AddInputConnection(triangles.GetOutputPort())
    return joined


def measure_view(nave, sun, incense):
    """Length in the sun and airlight of a line across the nave, 4 m above the floor."""
    line = vtkLineSource()
    z = FRONT - 2.5 * BAY
    line.SetPoint1(HALF - 0.01, 4, z)
    line.SetPoint2(0.01 - HALF, 4, z)
    lit = airlight.vtkLitIntervalsFilter()
    lit.SetInputConnection(line.GetOutputPort())
    for mesh, _, casts in nave:
        if casts:
            lit.AddInputConnection(1, mesh.GetOutputPort())
    lit.SetLight(sun)
    lit.SetMedium(incense)
    lit.Update()
    data = lit.GetOutput().GetCellData()
    return [sum(data.GetArray(name).GetComponent(i, c) for i in range(data.GetNumberOfTuples()))
            for name, c in (("Length", 0), ("Airlight", 1))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser, (640, 360))
    options = parser.parse_args()
    sun = vtkLight()
    airlight.vtkAirlight.SetIrradiance(sun, SUN)
    sun.SetPosition(TO_SUN)
    sun.SetFocalPoint(0, 0, 0)
    airlight.vtkAirlightLight.SetAngularDiameter(sun, 0.53)
    incense = airlight.vtkParticipatingMedium()
    incense.SetScattering(3 * [SCATTERING])
    incense.SetAmbientRadiance(SKY)
    incense.SetPhaseFunctionToHenyeyGreenstein()
    incense.SetAnisotropy(ANISOTROPY)
    incense.SetRegionToBox()
    incense.SetBounds(-HALF, HALF, 0, CROWN + 1.2, FRONT - BAY * BAYS, FRONT + 0.5)

    nave = [(join(parts), *rest) for parts, *rest in make_nave()]
    length, brightness = measure_view(nave, sun, incense)
    print(f"across the nave {length:.2f} m of {2 * HALF - 0.02:.2f} m are in the sun, "
          f"airlight {brightness:.4f}")
    renderer = vtkRenderer()
    renderer.SetBackground(0.55, 0.75, 1.1)  # the sky in the windows
    for mesh, albedo, casts in nave:
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(mesh.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(albedo)
        actor.GetProperty().SetAmbientColor(np.multiply(albedo, SKY))
        actor.GetProperty().SetAmbient(1)
        airlight.vtkAirlightPass.SetCastsShadow(actor, casts)
        renderer.AddActor(actor)
    renderer.AddLight(sun)
    fill = vtkLight()  # stands for the light of the other windows
    fill.SetLightTypeToHeadlight()
    fill.SetColor(0.75, 0.85, 1.0)
    fill.SetIntensity(FILL)
    airlight.vtkAirlightLight.SetScatters(fill, False)
    renderer.AddLight(fill)
    airlight.display.show_picture(renderer, incense, options, EYE, TARGET, ANGLE)


if __name__ == "__main__":
    main()
