#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A molecule in a haze that shows depth: DNA, four turns of the double helix.

The haze has the colour of the background everywhere, and the light does not scatter in it. A colour
at distance d therefore keeps exp(-d/RANGE) of its contrast with the background. The program prints
this fraction for the nearest and the farthest part in the picture. Lengths are in nanometres. B-DNA
has 10.5 pairs a turn, 0.332 apart. Its phosphates are 0.9 from the axis, 133 degrees apart across
the minor groove.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkGlyph3DMapper, vtkLight, vtkPolyDataMapper, vtkRenderer)

import airlight
import airlight.display

SEQUENCE = "CAGCAGGGGGGCGTGACTGATCAAGCCTGAGATAATGCGGGT"
RADIUS, RISE, TWIST, GROOVE = 0.9, 0.332, 2 * np.pi / 10.5, np.radians(133)
PHOSPHATE = 0.2  # radius of the balls
RANGE = 8.0  # distance at which a colour has lost 63 % of its contrast
HAZE = (0.02, 0.04, 0.09)
EYE, TARGET = (-2.3, 2.1, 5.0), (-0.15, 0.12, -0.5)
BASES = {"A": (0.75, 0.2, 0.15), "T": (0.85, 0.65, 0.15), "G": (0.15, 0.5, 0.25),
         "C": (0.15, 0.3, 0.7)}


def strand(offset, radius=RADIUS):
    """Points along one strand of a helix along -z, rotated by an angle about its axis."""
    steps = np.arange(len(SEQUENCE))
    angle = steps * TWIST + offset
    return np.stack((radius * np.cos(angle), radius * np.sin(angle), 1 - steps * RISE), axis=1)


def make_lines(lines):
    """Converts lines, each an array of points, to a vtkPolyData."""
    points, cells = vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(np.concatenate(lines), deep=True))
    start = 0
    for line in lines:
        cells.InsertNextCell(len(line), range(start, start + len(line)))
        start += len(line)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    return data


def add(renderer, mapper, colour):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.9)
    renderer.AddActor(actor)


def add_tubes(renderer, lines, radius, colour):
    tubes = vtkTubeFilter()
    tubes.SetInputData(make_lines(lines))
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(16)
    tubes.CappingOn()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    add(renderer, mapper, colour)


def add_balls(renderer, places):
    ball = vtkSphereSource()
    ball.SetRadius(PHOSPHATE)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(16)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(make_lines([places]))
    mapper.SetSourceConnection(ball.GetOutputPort())
    add(renderer, mapper, (0.75, 0.5, 0.3))


def add_molecule(renderer):
    strands = [strand(0), strand(GROOVE)]
    add_tubes(renderer, strands, 0.1, (0.6, 0.6, 0.62))
    for places in strands:
        add_balls(renderer, places)
    halves = {base: [] for base in BASES}
    for i, base in enumerate(SEQUENCE):
        middle = (strands[0][i] + strands[1][i]) / 2
        halves[base].append(np.array((strands[0][i], middle)))
        halves["TACG"["ATGC".index(base)]].append(np.array((strands[1][i], middle)))
    for base, lines in halves.items():
        add_tubes(renderer, lines, 0.09, BASES[base])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser)
    options = parser.parse_args()
    haze = airlight.vtkParticipatingMedium()
    haze.SetScattering(3 * [1 / RANGE])
    haze.SetAmbientRadiance(HAZE)
    lamp = vtkLight()
    airlight.vtkAirlight.SetIrradiance(lamp, (5, 4.9, 4.6))
    lamp.SetPosition(-1, 3, 1.5)
    lamp.SetFocalPoint(0, 0, 0)
    renderer = vtkRenderer()
    renderer.AddLight(lamp)
    add_molecule(renderer)
    haze_pass = airlight.vtkAirlightPass()
    haze_pass.SetMedium(haze)
    haze_pass.SetSubpixelFrames(options.frames)
    haze_pass.SetLightScatters(lamp, False)
    haze_pass.SetShadowTechniqueToShadowPlanes()  # exact, though there are many edges
    haze_pass.RecordBuffersOn()
    haze_pass.EncodedOutputOn()  # for the eye
    renderer.SetPass(haze_pass)
    renderer.SetUseFXAA(options.frames == 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetFocalPoint(TARGET)
    camera.SetViewAngle(30)
    renderer.ResetCameraClippingRange()
    window = airlight.display.open_window(renderer, size=options.size,
                                          offscreen=bool(options.output))
    depth, kept = (vtk_to_numpy(haze_pass.GetBuffer(name).GetPointData().GetScalars())
                   for name in ("Depth", "Transmittance"))
    for name, place in (("nearest", np.where(depth > 0, depth, np.inf).argmin()),
                        ("farthest", depth.argmax())):
        print(f"{name}: at {depth[place]:.3f} nm {100 * kept[place, 0]:.2f} % of the contrast")
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
