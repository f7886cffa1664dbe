# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the user guide's code, word for word, and checks its numbers; draws its pictures again.

With AIRLIGHT_WRITE_PICTURES set the recipes' pictures are written, not compared; plots.py writes
the plots.

Expected numbers come from the midpoint rule or from a formula beside them, not from the library.
"""

import contextlib
import io
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkWindowToImageFilter

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = ROOT / "Documentation" / "guide.md"
SOURCES = [path for folder in ("Module", "Filters", "Rendering")
           for path in (ROOT / folder).rglob("*.[ch]*") if path.is_file()]


def henyey_greenstein(g, mu):
    """Their phase function."""
    return (1 - g * g) / (4 * math.pi * (1 + g * g - 2 * g * mu) ** 1.5)


def airlight(scattering, extinction, lamp, intensity, eye, direction, length, g=0.0,
             count=200_000):
    """Single scattering of a point lamp on a ray, by the midpoint rule; no call of the library."""
    t = (np.arange(count) + 0.5) * length / count
    to_point = np.array(eye) + t[:, None] * np.array(direction) - np.array(lamp)
    r = np.linalg.norm(to_point, axis=1)
    mu = -(to_point @ np.array(direction)) / r  # of the light's direction and that to the eye
    arriving = intensity / r ** 2 * np.exp(-extinction * (r + t))
    return (scattering * henyey_greenstein(g, mu) * arriving).sum() * length / count


def pixels(image):
    """An image's scalars, the bottom row first."""
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def run_blocks():
    """What the guide's code leaves behind, and what it prints."""
    names, printed = {}, io.StringIO()
    text = GUIDE.read_text(encoding="utf-8")
    os.chdir(ROOT)  # the guide names files from there
    with contextlib.redirect_stdout(printed):
        for number, block in enumerate(re.findall(r"```python\n(.*?)```", text, re.DOTALL)):
            exec(compile(block, f"guide.md, block {number + 1}", "exec"), names)
    print(printed.getvalue())
    return names, printed.getvalue()


class TestGuide(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.names, cls.printed = run_blocks()

    def test_visibility(self):
        extinction = -math.log(0.7)
        self.assertIn(f"visibility {3.912 / extinction:.1f} m, albedo 0.25", self.printed)
        contrasts = self.names["contrasts"]
        for z in (2, 7, 20):
            eye, sign = np.array((0, 1.7, z)), np.array((0, 2.3, 0))
            distance = np.linalg.norm(sign - eye)
            veil = sum(airlight(0.25 * extinction, extinction, (0, 2.9, lamp), 100, eye,
                                (sign - eye) / distance, distance)
                       for lamp in (3, 9, 15, 21, 27, 33))
            passed = math.exp(-extinction * distance)
            expected = 148 * passed / (2 * passed + veil)
            self.assertAlmostEqual(contrasts[z], expected, delta=1e-6 * expected)
        seen = self.names["seen"]
        self.assertTrue(contrasts[seen] > 0.02 > contrasts[seen + 1])

    def test_visibility_with_multiple_scattering(self):
        """Albedo 0.25: each order has at most a quarter of the one before, near lamps far less."""
        multiple = self.names["multiple"]
        for z in (5, 15):
            self.assertGreater(multiple[z], 0.01)
            self.assertLess(multiple[z], 0.25 / (1 - 0.25))

    def test_headlights(self):
        """Below the cut-off of the low beam there is light, above it hardly any; see the file."""
        veil = pixels(self.names["veil"])[..., 1]
        self.assertTrue(np.isfinite(veil).all())
        rows = veil.shape[0]
        self.assertGreater(veil[:rows // 3].mean(), 10 * veil[5 * rows // 6:].mean())
        self.assertEqual(self.names["candela"], self.largest_candela())
        self.assertGreater(veil.max(), 0.01)

    def largest_candela(self):
        words = (ROOT / "Testing/Data/Photometry/lowbeam.ies").read_text().split("TILT=NONE")[1]
        numbers = [float(word) for word in words.split()]
        vertical, horizontal = int(numbers[3]), int(numbers[4])
        return max(numbers[13 + vertical + horizontal:]) * numbers[2]

    def test_water(self):
        extinction = np.array((0.340, 0.0565, 0.00922)) + 0.05
        expected = ", ".join(f"{share:.1f} %" for share in 100 * np.exp(-10 * extinction))
        self.assertIn("after 10 m: " + expected, self.printed)
        for beside, value in self.names["backscatter"].items():
            expected = airlight(0.05, extinction[1], (beside, 0, 0), 100, (0, 0, 0), (0, 0, 1), 5,
                                0.92)
            bound = self.names["water"].GetPhaseErrorBound()
            self.assertAlmostEqual(value, expected, delta=(bound + 1e-6) * expected)
        self.assertLess(self.names["backscatter"][1.0], 0.5 * self.names["backscatter"][0.1])
        self.assertGreater(self.names["turbid"], 0.05)

    def test_daylight(self):
        self.assertLess(self.names["median"], 1e-5)
        depth = pixels(self.names["room_pass"].GetBuffer("Depth"))[..., 0]
        glow = pixels(self.names["room_pass"].GetBuffer("Airlight"))[..., 1]
        lit = pixels(self.names["room_pass"].GetBuffer("LitLength"))[..., 0]
        self.assertGreater(np.count_nonzero(lit > 0), 1000)  # the beam
        self.assertGreater(np.count_nonzero(lit == 0), 1000)  # and the room's shade
        self.assertEqual(glow[lit == 0].max(), 0)
        self.assertTrue((depth[lit > 0] != 0).all())

    def test_laser_sheet(self):
        """Rays through the edges of the slit: it is as much wider as it is farther."""
        thickness = 0.002 * 3 / 0.1
        self.assertAlmostEqual(self.names["thickness"], thickness, delta=1e-6 * thickness)
        self.assertEqual(self.names["parts"].GetArray("Length").GetNumberOfTuples(), 1)
        extinction = -math.log(0.7)
        start = 2 - thickness / 2
        t = start + (np.arange(1000) + 0.5) * thickness / 1000
        r = np.sqrt((t - 2) ** 2 + 0.1 ** 2 + 3 ** 2)
        sum_ = (50 / r ** 2 * np.exp(-extinction * (r + t))).mean() * thickness
        expected = 0.25 * extinction / (4 * math.pi) * sum_
        self.assertAlmostEqual(self.names["glow"][1], expected, delta=1e-6 * expected)

    def test_depth_cueing(self):
        """Behind a length d the haze's colour is mixed in by 1 - exp(-d/5)."""
        haze_pass = self.names["haze_pass"]
        radiance, surface = (pixels(haze_pass.GetBuffer(name)) for name in ("Radiance", "Surface"))
        depth = pixels(haze_pass.GetBuffer("Depth"))[..., 0]
        seen = depth > 0
        self.assertGreater(np.count_nonzero(seen), 100)
        self.assertGreater(surface[seen].mean(), 0.01)
        colour = np.array((0.7, 0.8, 0.9))
        mixed = colour * (1 - np.exp(-depth[..., None] / 5))
        np.testing.assert_allclose(radiance[seen], (surface + mixed)[seen], atol=1e-4)
        np.testing.assert_allclose(radiance[~seen], np.broadcast_to(colour, radiance.shape)[~seen],
                                   atol=1e-4)

    def test_sensors(self):
        """The inverse square and the smoke; VTK keeps points in single precision."""
        extinction = -math.log(0.7)
        for x, value in zip((0, 1, 2), self.names["lux"]):
            r = math.hypot(x, 2.0)
            self.assertAlmostEqual(value, 100 / r ** 2 * math.exp(-extinction * r), delta=1e-6)

    def test_sight_lines(self):
        """In uniform smoke the visibility is K/extinction everywhere."""
        extinction = -math.log(0.7)
        for i in range(3):
            for name, constant in (("ReflectingSignVisibility", 3), ("EmittingSignVisibility", 8)):
                value = self.names["data"].GetArray(name).GetTuple1(i)
                self.assertAlmostEqual(value, constant / extinction, delta=1e-9)

    def test_errors(self):
        """The messages that the guide explains are those of the sources."""
        text = GUIDE.read_text(encoding="utf-8").split("## Errors")[1].split("\nAnd where")[0]
        messages = re.findall(r"^\| `(.*?)` \|", text, re.MULTILINE)
        self.assertGreaterEqual(len(messages), 5)
        sources = "".join(path.read_text(encoding="utf-8") for path in SOURCES)
        sources = re.sub(r'"\s*"', "", sources)  # literals on several lines
        for message in messages:
            self.assertTrue(message in sources, message)

    def test_names(self):
        """Methods that the text names exist."""
        library = self.names["airlight"]
        text = GUIDE.read_text(encoding="utf-8")
        classes = [getattr(library, name) for name in dir(library) if name.startswith("vtk")]
        methods = set().union(*map(
            dir, [*classes, vtkLight, vtkRenderer, vtkWindowToImageFilter]))
        named = set(re.findall(r"`(?:\w+(?:::|\.))?([A-Z]\w+)\(", text))
        self.assertGreater(len(named), 15)
        self.assertEqual(named - methods, set())

    def test_recipes(self):
        """The recipes' pictures are those that their code draws."""
        for name, window in (("headlights", "window"), ("daylight", "room_window"),
                             ("depth-cueing", "scene_window")):
            file = ROOT / "Documentation" / "pictures" / f"recipe-{name}.png"
            grab = vtkWindowToImageFilter()
            grab.SetInput(self.names[window])
            grab.ReadFrontBufferOff()
            grab.Update()
            if "AIRLIGHT_WRITE_PICTURES" in os.environ:
                writer = vtkPNGWriter()
                writer.SetFileName(str(file))
                writer.SetInputData(grab.GetOutput())
                writer.Write()
            difference = np.abs(pixels(grab.GetOutput()).astype(int) - self.read_png(file))
            # Edges may lie in the next pixel on another renderer; the rest may not change.
            self.assertLess(np.mean(difference > 4), 0.01, name)
            self.assertLess(np.mean(difference), 0.5, name)

    def test_plots(self):
        """The pictures are those that the script draws."""
        shown = ROOT / "Documentation" / "pictures"
        read = self.read_png
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, str(ROOT / "Documentation" / "plots.py"), folder],
                           check=True, timeout=300)
            drawn = sorted(path.name for path in pathlib.Path(folder).iterdir())
            self.assertEqual(drawn, sorted(path.name for path in shown.glob("guide-*.png")))
            for name in drawn:
                difference = np.abs(read(f"{folder}/{name}") - read(shown / name))
                # Texts may be drawn otherwise elsewhere; a curve elsewhere is more than that.
                self.assertLess(np.mean(difference > 32), 0.003, name)
                self.assertIn(f"](pictures/{name})", GUIDE.read_text(encoding="utf-8"))

    @staticmethod
    def read_png(file):
        reader = vtkPNGReader()
        reader.SetFileName(str(file))
        reader.Update()
        return pixels(reader.GetOutput()).astype(int)


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
