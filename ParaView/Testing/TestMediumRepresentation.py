# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Data as media: the representation Medium, beside each other and beside the view's own medium."""

import pathlib
import subprocess
import sys
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test

RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
LOW, HIGH = np.array([-1.1, -0.7, -0.9]), np.array([1.1, 0.7, 0.9])


def make_box(low=LOW, high=HIGH):
    lengths, centre = high - low, (low + high) / 2
    return simple.Box(XLength=lengths[0], YLength=lengths[1], ZLength=lengths[2],
                      Center=list(centre))


def make_image(density="2"):
    """An image over the box, the same density everywhere."""
    source = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
    moved = simple.Calculator(Input=source, ResultArrayName="density", Function=density)
    half = (HIGH - LOW) / 2
    # Transform makes grids of images; resampled, they are images again.
    shrunk = simple.Transform(Input=moved)
    shrunk.Transform.Scale = list(half / 2)
    return simple.ResampleToImage(Input=shrunk, SamplingDimensions=[6, 5, 7])


def show_medium(view, source, thickness=0.0, **properties):
    display = simple.Show(source, view)
    display.Representation = "Medium"
    if thickness > 0:
        display.MediumThickness = "Coefficients"
        display.MediumScattering = [0, 0, 0]
        display.MediumAbsorption = [thickness] * 3
    display.MediumAmbientFromBackground = 0
    for name, value in properties.items():
        display.SetPropertyWithName(name, value)
    return display


class MediumRepresentation(test.ClearViewTestCase):
    """Before a white background: what is left of it tells the optical depth."""

    NAME = "medium"

    def setUp(self):
        super().setUp()
        self.view.Background = [1, 1, 1]

    def check(self, depths, name):
        """Pixels on the medium's edges may see any part of it."""
        seen = self.picture(name)
        slope = np.abs(np.gradient(depths)).sum(axis=0)
        error = np.abs(seen - np.exp(-depths)) - slope
        self.assertLess(error.max(), 1.5 / 255, name)
        self.assertGreater((slope < 0.03).mean(), 0.6)
        return seen

    def test_surface(self):
        show_medium(self.view, make_box(), 0.8)
        seen = self.check(0.8 * test.lengths_in_box(LOW, HIGH), "surface")
        self.assertLess(seen.min(), 0.3)

    def test_image(self):
        """The coefficients are those at density 1."""
        display = show_medium(self.view, make_image(), 0.4)
        display.MediumDensityArray = ["POINTS", "density"]
        self.check(0.8 * test.lengths_in_box(LOW, HIGH), "image")

    def test_several(self):
        """A surface, an image and the view's fog: their depths add up. Hidden data are no media."""
        view = self.view
        ends = np.array([-0.4, -1.2, -0.5]), np.array([0.5, 0.2, 1.4])
        image = show_medium(view, make_image(), 0.3)
        image.MediumDensityArray = ["POINTS", "density"]
        surface = show_medium(view, make_box(*ends), 0.5)
        view.Region = "Box"
        view.RegionBounds = [-0.2, 1.3, -0.9, 0.9, -2, -0.6]
        view.Absorption = [0.2] * 3
        fog = test.lengths_in_box(np.array([-0.2, -0.9, -2]), np.array([1.3, 0.9, -0.6]))
        depths = 0.6 * test.lengths_in_box(LOW, HIGH) + 0.5 * test.lengths_in_box(*ends) + 0.2 * fog
        self.check(depths, "several")
        surface.Visibility = 0
        self.check(depths - 0.5 * test.lengths_in_box(*ends), "fewer")
        surface.Visibility = 1
        image.Representation = "Outline"
        self.assertEqual(image.Representation, "Outline")
        image.Visibility = 0
        self.check(depths - 0.6 * test.lengths_in_box(LOW, HIGH), "one")

    def test_automatic_visibility(self):
        """2 % of the light is left along the diagonal at the greatest density."""
        diagonal = np.linalg.norm(HIGH - LOW)
        show_medium(self.view, make_box(), MediumColor=[0, 0, 0])
        seen = self.check(3.912 / diagonal * test.lengths_in_box(LOW, HIGH), "automatic")
        simple.Delete(simple.FindSource("Box1") or list(simple.GetSources().values())[0])
        image = show_medium(self.view, make_image("7"), MediumColor=[0, 0, 0])
        image.MediumDensityArray = ["POINTS", "density"]
        same = self.picture("automatic-image")
        self.assertLess(np.abs(same - seen).mean(), 1 / 255)

    def test_bounds(self):
        """The camera and the fog's automatic visibility follow media, too."""
        show_medium(self.view, make_box())
        simple.ResetCamera(self.view)
        self.assertLess(self.view.CameraParallelScale, 0.6 * np.linalg.norm(HIGH - LOW))
        far = simple.Sphere(Center=[30, 0, 0])
        show_medium(self.view, far)
        simple.Render(self.view)
        simple.ResetCamera(self.view)
        self.assertGreater(self.view.CameraParallelScale, 10)

    def test_state(self):
        """For that of Python, see TestPythonState."""
        show_medium(self.view, make_box(), 0.8, MediumEmission=[0.1, 0, 0])
        simple.Render(self.view)
        test.place_camera(self.view)
        before = test.picture(self.view, "medium-state")
        path = test.OUTPUT / "medium-state.pvsm"
        simple.SaveState(str(path))
        self.tearDown()
        simple.LoadState(str(path))
        self.view = simple.GetViews()[-1]
        after = test.picture(self.view, "medium-state-again")
        self.assertGreater(before.std(), 10)
        self.assertLessEqual(np.abs(after - before).max(), 1)

    def test_errors(self):
        """Bad data and another view: a message each, and all else is drawn."""
        program = """
import sys
from paraview import simple
import paraviewtest as test
import TestMediumRepresentation as medium
test.load_plugin()
view = test.make_view()
{}
simple.Render(view)
print("DRAWN", flush=True)
"""
        cases = {
            "open": ("medium.show_medium(view, simple.Plane(), 1)", "closed"),
            "negative": ("d = medium.show_medium(view, medium.make_image('-1'), 1);"
                         "d.MediumDensityArray = ['POINTS', 'density']", "density image"),
            "view": ("view = simple.CreateView('RenderView');"
                     "medium.show_medium(view, medium.make_box(), 1)", "Render View + Airlight"),
            "none": ("medium.show_medium(view, simple.Threshold(Input=medium.make_image(),"
                     "LowerThreshold=5, UpperThreshold=6, Scalars=['POINTS', 'density']), 1)",
                     "no polygons"),
        }
        folder = pathlib.Path(__file__).parent
        for name, (lines, message) in cases.items():
            path = test.OUTPUT / f"medium-error-{name}.py"
            path.write_text(f"import sys; sys.path.insert(0, {str(folder)!r})"
                            + program.format(lines), encoding="utf-8")
            played = subprocess.run([RUN, "--run", path], capture_output=True, text=True,
                                    timeout=120, check=False)
            text = played.stdout + played.stderr
            self.assertIn("DRAWN", text, name)
            self.assertIn(message, text, name)
            self.assertEqual(text.count("ERR|"), 0 if name == "view" else 1, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
