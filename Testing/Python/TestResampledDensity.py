# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The recipe of Documentation/density.md: an unstructured grid as a density image."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkResampleToImage


def make_tetrahedron():
    """Corners at 0 and at 1 on the axes; "soot" is 1 + 2x + 3y + 4z there."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    corners = np.vstack([np.zeros(3), np.eye(3)])
    for corner in corners:
        points.InsertNextPoint(corner)
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_TETRA, 4, (0, 1, 2, 3))
    soot = numpy_to_vtk(1 + corners @ (2.0, 3.0, 4.0), deep=True)
    soot.SetName("soot")
    grid.GetPointData().AddArray(soot)
    return grid


class TestResampledDensity(unittest.TestCase):
    def test_linear_field(self):
        sampler = vtkResampleToImage()
        sampler.SetInputDataObject(make_tetrahedron())
        sampler.SetSamplingDimensions(12, 11, 10)
        sampler.Update()
        density = sampler.GetOutput()
        density.GetPointData().SetActiveScalars("soot")
        values = vtk_to_numpy(density.GetPointData().GetScalars())
        places = np.array([density.GetPoint(i) for i in range(density.GetNumberOfPoints())])
        # VTK takes samples within a tolerance of the slanted face, the corners among them, for
        # inside: those are left out.
        distance = 1 - places.sum(axis=1)
        clear = np.abs(distance) > 1e-3
        inside = clear & (distance > 0)
        outside = clear & (distance < 0)
        self.assertGreater(inside.sum(), 150)
        self.assertGreater(outside.sum(), 900)
        expected = 1 + places @ (2.0, 3.0, 4.0)
        self.assertLess(np.abs(values[inside] - expected[inside]).max(), 1e-6)
        self.assertEqual(np.abs(values[outside]).max(), 0)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
