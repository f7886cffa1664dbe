# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python program of the README, word for word, and looks at what it rendered."""

import pathlib
import re
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy


class TestReadme(unittest.TestCase):
    def test_python_block(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        text = (root / "README.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        self.assertEqual(len(blocks), 1)
        names = {}
        exec(blocks[0], names)  # pylint: disable=exec-used

        width, height = names["window"].GetSize()
        self.assertEqual(names["radiance"].GetDimensions(), (width, height, 1))
        radiance = vtk_to_numpy(names["radiance"].GetPointData().GetScalars())
        self.assertTrue(numpy.isfinite(radiance).all())
        # Fog fills the view and the lamp lights all of it: no pixel is dark.
        self.assertGreater(radiance.min(), 0.0)
        # The cone is in the view, and so is the air beside it.
        depth = vtk_to_numpy(names["fog_pass"].GetBuffer("Depth").GetPointData().GetScalars())
        self.assertTrue((depth > 0).any() and (depth == -1).any())


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
