# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkOpenVDBDensityReader from Python, on files that a C++ program of the tests writes."""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import airlight

WRITE = os.environ.get("AIRLIGHT_WRITE_OPENVDB")


class TestOpenVDBDensityReader(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run([WRITE, cls.folder.name + "/"], check=True, timeout=60)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def make_reader(self, name):
        reader = airlight.vtkOpenVDBDensityReader()
        reader.SetFileName(os.path.join(self.folder.name, name))
        return reader

    def test_fog_sphere(self):
        reader = self.make_reader("types.vdb")
        reader.UpdateInformation()
        names = [reader.GetGridName(i) for i in range(reader.GetNumberOfGrids())]
        self.assertEqual(names, ["velocity", "points", "fog"])
        reader.SetGridName("fog")
        reader.Update()
        image = reader.GetOutput()
        values = vtk_to_numpy(image.GetPointData().GetArray("fog"))
        # The sum of min(1, max(0, (1.5 - r)/0.3)) over the sphere: the integral of the ramp by
        # parts is that of volumes 4/3 pi r^3 over r from 1.2 to 1.5, divided by 0.3.
        expected = np.pi / 3 * (1.5**4 - 1.2**4) / 0.3
        self.assertAlmostEqual(values.sum() * 0.1**3 / expected, 1, delta=2e-3)
        middle = image.FindPoint(1, 2, 3)
        self.assertEqual(values[middle], 1)
        np.testing.assert_allclose(image.GetPoint(middle), (1, 2, 3), atol=1e-6)

    def test_errors(self):
        reader = self.make_reader("types.vdb")
        reader.SetGridName("smoke")
        errors = []
        reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        self.assertEqual(len(errors), 1)
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(reader.GetNumberOfGrids(), 3)


if __name__ == "__main__":
    if not WRITE:
        print("skipped: built without OpenVDB")
        assert not hasattr(airlight, "vtkOpenVDBDensityReader")
        sys.exit(125)
    unittest.main(argv=[__file__])
