# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the programs of Examples/Python and looks at what they print and write."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"
WRITE_OPENVDB = os.environ.get("AIRLIGHT_WRITE_OPENVDB")


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


class TestExamples(unittest.TestCase):
    def run_example(self, name, *arguments):
        done = subprocess.run([sys.executable, EXAMPLES / name, *arguments], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""), name)
        self.ran.add(name)
        return done.stdout

    ran = set()

    def test_fog_to_numpy(self):
        with tempfile.TemporaryDirectory() as folder:
            text = self.run_example("fog_to_numpy.py", folder + "/fog.npz")
            arrays = dict(np.load(folder + "/fog.npz"))
        # A ball of radius 0.5 seen from 5 away, in a view of 30 degrees that is 4 : 3: the tangent
        # of its half angle is 0.5/sqrt(25 - 0.25), that of the view's tan(15 degrees).
        radius = 0.5 / np.sqrt(24.75) / np.tan(np.radians(15)) * 120
        covered = np.pi * radius**2 / (320 * 240)
        # The ball is a polyhedron of eight sides a turn, which covers less than the round one.
        share = float(re.search(r"covers ([\d.]+)%", text).group(1)) / 100
        self.assertTrue(0.8 * covered < share < covered, text)
        self.assertEqual(arrays["Radiance"].shape, (240, 320, 3))
        # All light is the fog's but the ball's own.
        sky = arrays["Depth"][..., 0] < 0
        np.testing.assert_allclose(arrays["Airlight"][sky], arrays["Radiance"][sky], rtol=1e-6)
        self.assertGreater(arrays["Radiance"].min(), 0)

    def test_compare_arrays(self):
        text = self.run_example("compare_arrays.py")
        scores = dict(re.findall(r"^(\w+) +([-\d.e]+)$", text, re.MULTILINE))
        # 1 % of the mean of 0.55; noise of 1e-3 in 9216 samples changes the mean by 1e-5.
        self.assertAlmostEqual(float(scores["bias"]), 0.01, delta=1e-4)
        self.assertEqual(int(scores["pixels"]), 64 * 48)
        with tempfile.TemporaryDirectory() as folder:
            for name, value in (("a", 3.0), ("b", 2.0)):
                np.save(f"{folder}/{name}.npy", np.full((4, 5, 1), value))
            text = self.run_example("compare_arrays.py", folder + "/a.npy", folder + "/b.npy")
        self.assertRegex(text, r"median +0.5\n")
        self.assertIn("channel: [1.]", text)

    @unittest.skipUnless(WRITE_OPENVDB, "built without OpenVDB")
    def test_openvdb_to_numpy(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([WRITE_OPENVDB, folder + "/"], check=True, timeout=60)
            text = self.run_example("openvdb_to_numpy.py", folder + "/tiles.vdb")
            self.assertIn("tiles: 67 x 34 x 18 points, 0 to 2\n", text)
            # 16 voxels of 1 and of density 2.
            self.assertIn("third axis: 32\n", text)
            text = self.run_example("openvdb_to_numpy.py", folder + "/names.vdb", "shared")
            self.assertIn("grid 'twin[1]' of float\n", text)
            self.assertIn("third axis: 10\n", text)

    def test_content_in_fog(self):
        """The pictures are those of the gallery."""
        gallery = EXAMPLES.parents[1] / "Documentation" / "pictures"
        names = sorted(path.name for path in gallery.glob("content-*.png"))
        with tempfile.TemporaryDirectory() as folder:
            self.run_example("content_in_fog.py", folder)
            self.assertEqual(sorted(os.listdir(folder)), names)
            for name in names:
                drawn, shown = read_picture(f"{folder}/{name}"), read_picture(gallery / name)
                self.assertEqual(drawn.shape, shown.shape)
                difference = np.abs(drawn - shown)
                # Edges may lie in the next pixel on another renderer; the rest may not change.
                self.assertLess(np.mean(difference > 4), 0.01, name)
                self.assertLess(np.mean(difference), 0.5, name)

    @classmethod
    def tearDownClass(cls):
        missing = {path.name for path in EXAMPLES.glob("*.py")} - cls.ran
        if WRITE_OPENVDB and missing:
            raise AssertionError(f"not run: {missing}")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
