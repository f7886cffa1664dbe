# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of Examples/Python share: running them, and comparing with the gallery."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from programtest import read_png

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"
GALLERY = EXAMPLES.parents[1] / "Documentation" / "pictures"

# The folder of the examples in C++, where they are built; else empty.
PROGRAMS = os.path.dirname(os.environ.get("AIRLIGHT_PROGRAM", ""))

# Examples with a purpose and a picture in the gallery, which TestUses runs.
USES = ("daylight_room", "depth_cueing", "headlights_in_fog", "laser_sheet", "smoke_corridor",
        "underwater_lamp")

# Examples with real data or a larger scene, in Python only, which TestScenes runs.
SCENES = ("cathedral_shafts", "ct_lit_through", "cumulus", "flow_with_lamps", "valley_fog")


def read_picture(path):
    """Values of 0 to 255, pixels in VTK's order."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


def load_example(name):
    """The example as a module, for the constants of its scene."""
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / (name + ".py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class ExampleTest(unittest.TestCase):
    ran = set()

    def run_example(self, name, *arguments, program=None):
        """What the example prints; it must print nothing on the error stream."""
        command = [program] if program else [sys.executable, EXAMPLES / name]
        done = subprocess.run([*command, *arguments], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""), name)
        self.ran.add(name)
        return done.stdout

    def compare_with_large(self, path):
        """Nearly equal to the larger picture of this name in the gallery, whose edges are smooth,
        at the smaller one's size."""
        name = os.path.basename(path)
        drawn, shown = read_png(str(path)), read_png(str(GALLERY / name))
        factor = shown.shape[0] // drawn.shape[0]
        self.assertEqual(shown.shape, (factor * drawn.shape[0], factor * drawn.shape[1], 3))
        self.assertGreaterEqual(shown.shape[1], 1280)
        small = shown.reshape(drawn.shape[0], factor, drawn.shape[1], factor, 3).mean(axis=(1, 3))
        difference = np.abs(drawn - small).max(axis=-1)
        self.assertLess(np.mean(difference > 0.1), 0.08, name)  # pixels on edges
        self.assertLess(np.median(difference), 0.01, name)
        # Light that is missing is missing over an area, where edges even out.
        side = 8
        height, width = (side * (length // side) for length in drawn.shape[:2])
        blocks = (drawn - small)[:height, :width].reshape(
            height // side, side, width // side, side, 3).mean(axis=(1, 3))
        self.assertLess(np.abs(blocks).mean(), 0.01, name)
        self.assertLess(abs(drawn.mean() / small.mean() - 1.0), 0.02, name)

    def compare_with_gallery(self, path):
        """Equal to the picture of this name in the gallery, where that is as large."""
        name = os.path.basename(path)
        drawn, shown = read_picture(path), read_picture(GALLERY / name)
        if len(shown) > len(drawn):
            self.compare_with_large(path)
            return
        self.assertEqual(drawn.shape, shown.shape)
        difference = np.abs(drawn - shown)
        # Edges may lie in the next pixel on another renderer; the rest may not change.
        self.assertLess(np.mean(difference > 4), 0.01, name)
        self.assertLess(np.mean(difference), 0.5, name)
