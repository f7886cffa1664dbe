#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The lit parts of a fan of view rays through a smoky hall, as numpy arrays.

    lit_intervals_to_numpy.py [OUT.npz]

The light hangs behind a row of pillars. Their shadows cut the rays into parts. For each part there
are its length, the light that its smoke sends to the eye, and the causes of its start and its end.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkLight

import airlight

EYE = (-6.0, 1.7, 3.0)
LENGTH = 14.0  # m
DIRECTIONS = np.radians((-14, 0, 14, 24))  # in the plane y = 1.7, from the x axis towards -z
LAMP = (0.0, 3.0, -4.0)
PILLARS = (-3.0, -1.0, 1.0, 3.0)  # x of their axes; 0.5 wide, at z = -1

points, lines = vtkPoints(), vtkCellArray()
points.SetDataTypeToDouble()
for angle in DIRECTIONS:
    lines.InsertNextCell(2)
    lines.InsertCellPoint(points.InsertNextPoint(EYE))
    lines.InsertCellPoint(points.InsertNextPoint(
        np.add(EYE, LENGTH * np.array((np.cos(angle), 0, -np.sin(angle))))))
fan = vtkPolyData()
fan.SetPoints(points)
fan.SetLines(lines)

lamp = vtkLight()
airlight.vtkAirlight.SetRadiantIntensity(lamp, (40, 36, 30))  # W/sr
lamp.SetPosition(LAMP)
smoke = airlight.vtkParticipatingMedium()
smoke.SetScattering(0.08, 0.08, 0.08)  # per metre
smoke.SetAbsorption(0.02, 0.02, 0.02)

lit = airlight.vtkLitIntervalsFilter()
lit.SetInputData(fan)
for x in PILLARS:
    pillar = vtkCubeSource()
    pillar.SetBounds(x - 0.25, x + 0.25, 0, 5, -1.25, -0.75)
    lit.AddInputConnection(1, pillar.GetOutputPort())
lit.SetLight(lamp)
lit.SetMedium(smoke)
lit.Update()

data = lit.GetOutput().GetCellData()
arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
          for i in range(data.GetNumberOfArrays())}
causes = {lit.LINE_END: "the line's end", lit.MEDIUM: "the medium's edge", lit.CONE: "the cone",
          lit.BEND: "a bend"}
for line in range(len(DIRECTIONS)):
    parts = np.flatnonzero(arrays["SourceCell"] == line)
    total = arrays["Airlight"][parts].sum(axis=0)
    print(f"line {line}: {arrays['Length'][parts].sum():.4f} m of {LENGTH:g} m are lit, airlight "
          + " ".join(f"{value:.5f}" for value in total) + " W/(m^2 sr)")
    for part in parts:
        ends = [causes.get(arrays[end + "Cause"][part],
                           f"pillar {arrays[end + 'Occluder'][part]}") for end in ("Start", "End")]
        print(f"    from {arrays['Start'][part]:7.4f} ({ends[0]}) "
              f"to {arrays['End'][part]:7.4f} ({ends[1]})")
if len(sys.argv) > 1:
    np.savez(sys.argv[1], **arrays)
