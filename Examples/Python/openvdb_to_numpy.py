#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The density of an OpenVDB file as a numpy array, and its optical depth along z.

    openvdb_to_numpy.py CLOUD.vdb [GRID]
"""

import sys

from vtkmodules.util.numpy_support import vtk_to_numpy

import airlight

if len(sys.argv) < 2:
    sys.exit(__doc__)
reader = airlight.vtkOpenVDBDensityReader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
for i in range(reader.GetNumberOfGrids()):
    print(f"grid {reader.GetGridName(i)!r} of {reader.GetGridType(i)}")
if len(sys.argv) > 2:
    reader.SetGridName(sys.argv[2])
reader.Update()
image = reader.GetOutput()
if image.GetNumberOfPoints() == 0:
    sys.exit(1)  # VTK has reported the reason

nx, ny, nz = image.GetDimensions()
scalars = image.GetPointData().GetScalars()
density = vtk_to_numpy(scalars).reshape(nz, ny, nx)  # x is fastest
print(f"{scalars.GetName()}: {nx} x {ny} x {nz} points, {density.min():g} to {density.max():g}")
print("one corner at", image.GetPoint(0), "steps", image.GetSpacing())

# The border of the image is background: the sum is also the integral by the trapezoidal rule.
depth = density.sum(axis=0) * image.GetSpacing()[2]
print(f"largest integral of the density along the third axis: {depth.max():g}")
