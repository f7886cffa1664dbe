# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Silhouettes and shadow planes from Python, as numpy arrays."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight

import airlight


def arrays(data):
    cells = data.GetLines() if data.GetNumberOfLines() else data.GetPolys()
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return (points, vtk_to_numpy(cells.GetConnectivityArray()),
            vtk_to_numpy(cells.GetOffsetsArray()),
            vtk_to_numpy(data.GetCellData().GetArray("Weight")))


class TestShadowPlanes(unittest.TestCase):
    def test_cube(self):
        cube = vtkCubeSource()
        edges = airlight.vtkSilhouetteEdgesFilter()
        edges.SetInputConnection(cube.GetOutputPort())
        edges.SetLightPosition(5, 0.1, 0.2)  # sees one face
        edges.Update()
        points, ids, _, weights = arrays(edges.GetOutput())
        self.assertEqual(list(weights), [2, 2, 2, 2])
        self.assertTrue((points[:, 0] == 0.5).all())
        # Anticlockwise seen from +x: the area of the face, by its border.
        ends = points[ids].reshape(-1, 2, 3)
        area = 0.5 * np.cross(ends[:, 0], ends[:, 1]).sum(axis=0)
        self.assertAlmostEqual(area[0], 1.0, delta=1e-6)

    def test_chain(self):
        # At each point as much weight arrives as leaves.
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(40)
        sphere.SetPhiResolution(30)
        sun = vtkLight()
        sun.SetPosition(1, 2, 3)
        edges = airlight.vtkSilhouetteEdgesFilter()
        edges.SetInputConnection(sphere.GetOutputPort())
        edges.SetLight(sun)
        for positional in (False, True):
            sun.SetPositional(positional)
            edges.Update()
            points, ids, _, weights = arrays(edges.GetOutput())
            ends = ids.reshape(-1, 2)
            balance = np.zeros(len(points), dtype=int)
            np.add.at(balance, ends[:, 0], weights)
            np.add.at(balance, ends[:, 1], -weights)
            self.assertGreater(len(weights), 40)
            self.assertFalse(balance.any())

    def test_closed(self):
        # With both caps the weighted area vectors sum up to zero, and the volume is that of the
        # cube's shadow: from each of the faces' two triangles a prism of their area across the light
        # times the length, 6 faces of |n . l|.
        cube = vtkCubeSource()
        planes = airlight.vtkShadowPlanesFilter()
        planes.SetInputConnection(cube.GetOutputPort())
        direction = np.array((-0.48, -0.6, -0.64))
        planes.SetLightDirection(*direction)
        planes.SetFarDistance(3.0)
        planes.LightCapOn()
        planes.FarCapOn()
        planes.Update()
        points, ids, offsets, weights = arrays(planes.GetOutput())
        part = vtk_to_numpy(planes.GetOutput().GetCellData().GetArray("Part"))
        self.assertEqual(np.bincount(part).tolist(), [6, 12, 12])
        area, volume = np.zeros(3), 0.0
        for begin, end, weight in zip(offsets[:-1], offsets[1:], weights):
            corners = points[ids[begin:end]]
            for b, c in zip(corners[1:-1], corners[2:]):
                area += 0.5 * weight * np.cross(b - corners[0], c - corners[0])
                volume += weight * np.dot(corners[0], np.cross(b, c)) / 6
        self.assertLess(np.abs(area).max(), 1e-12)
        self.assertAlmostEqual(volume, 3.0 * 2.0 * np.abs(direction).sum(), delta=1e-6)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
