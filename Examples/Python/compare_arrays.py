#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two numpy arrays by the metrics of the reference scenes.

    compare_arrays.py [A.npy B.npy]      arrays [height, width, channels]
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import airlight


def make_image(array):
    """Converts an array to a vtkImageData. Row 0 becomes the bottom row."""
    height, width, channels = array.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(array).reshape(-1, channels)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return image


if len(sys.argv) == 3:
    a, b = (np.load(name) for name in sys.argv[1:])
else:  # a gradient, 1 % too bright and with noise
    b = np.tile(np.linspace(0.1, 1.0, 64)[None, :, None], (48, 1, 3))
    a = 1.01 * b + np.random.default_rng(1).normal(0.0, 1e-3, b.shape)

comparison = airlight.vtkAirlightComparison()
comparison.SetImageData(make_image(a))
comparison.SetReferenceData(make_image(b))
comparison.Update()
table = comparison.GetMetrics()
for i in range(table.GetNumberOfColumns()):
    print(f"{table.GetColumnName(i):14}{table.GetValue(0, i).ToDouble():.4g}")

difference = vtk_to_numpy(comparison.GetDifference().GetPointData().GetScalars()).reshape(a.shape)
print("mean difference per channel:", difference.mean(axis=(0, 1)))
