# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Python state of the view: run again, it gives the same picture."""

import re
import sys
import unittest

import numpy as np
from paraview import simple, smstate

import paraviewtest as test

# Not the defaults.
CHANGES = (
    ("Thickness", "Visibility"), ("VisibilityDistance", 30.0), ("MediumColor", [0.9, 0.8, 0.7]),
    ("PhaseFunction", "Draine"), ("Anisotropy", 0.3), ("Alpha", 5.0),
    ("AmbientRadiance", [0.05, 0.1, 0.2]), ("Emission", [0.0, 0.001, 0.0]),
    ("SkyRadiance", [0.01, 0.02, 0.04]), ("GroundRadiance", [0.02, 0.01, 0.0]),
    ("Region", "Sphere"), ("RegionRadius", 4.0),
    ("Lamp", 1), ("LampColor", [1.0, 0.8, 0.5]), ("LampBrightness", 1.5), ("LampRadius", 0.2),
    ("LampVisible", 1), ("RadianceExposure", 1.2), ("ToneMapping", "Reinhard"),
    ("Multisampling", 1), ("SubpixelFrames", 2), ("OutputColorSpace", "sRGB"),
    ("SurfaceShadows", 0),
)


class PythonState(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        test.load_plugin()

    @staticmethod
    def make_scene():
        view = simple.CreateView("AirlightRenderView")
        view.ViewSize = list(test.SIZE)
        view.OrientationAxesVisibility = 0
        simple.SetActiveView(view)
        for source in test.make_sources():
            simple.Show(source, view)
        test.place_camera(view)
        simple.Render(view)
        return view

    def draw_again(self, script, name):
        """The picture of the view that a script makes in a session of its own."""
        simple.ResetSession()
        test.load_plugin()
        exec(compile(script, name, "exec"), {})  # a script of ParaView's own making
        view = test.find_view()
        view.ViewSize = list(test.SIZE)
        return view, test.picture(view, name)

    def check(self, script, before, name):
        view, after = self.draw_again(script, name)
        for key, value in CHANGES:
            found = getattr(view, key)
            found = list(found) if isinstance(value, list) else found
            self.assertEqual(found, value, key)
        difference = np.abs(after - before)
        print(f"{name}: largest difference {difference.max()}")
        self.assertGreater(before.std(), 10)
        self.assertLessEqual(difference.max(), 1)

    def test_same_picture(self):
        view = self.make_scene()
        for name, value in CHANGES:
            setattr(view, name, value)
        simple.Render(view)
        before = test.picture(view, "before-python-state")
        self.check(smstate.get_state(), before, "python-state")

    def test_surface_of_a_source(self):
        self.check_sources("surface", Scattering=[0.5] * 3, Region="Surface")

    def test_image_of_a_source(self):
        self.check_sources("image", Scattering=[0.003] * 3, Density="Image")

    def test_medium_representation(self):
        """Data as media are sources as all others, in any order."""
        view = self.make_scene()
        for name, value in CHANGES:
            setattr(view, name, value)
        display = simple.Show(simple.Box(XLength=1.5), view)
        display.Representation = "Medium"
        display.MediumColor = [0.9, 0.3, 0.2]
        display.MediumVisibilityDistance = 1.2
        simple.Render(view)
        before = test.picture(view, "before-python-medium")
        display.Visibility = 0
        without = test.picture(view, "before-python-no-medium")
        self.assertGreater(np.abs(before - without).max(), 20)
        display.Visibility = 1
        self.check(smstate.get_state(), before, "python-medium")

    def check_sources(self, name, **properties):
        """Sources of the medium, which the script makes after the view that names them: with the
        lines at its end that the documentation tells to move there."""
        view = self.make_scene()
        view.RegionSurface = simple.Box(XLength=2, YLength=1.2, ZLength=1.5)
        view.DensityImage = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -1, 1])
        view.DensityArray = ["POINTS", "RTData"]
        view.Thickness = "Coefficients"
        for key, value in properties.items():
            setattr(view, key, value)
        before = test.picture(view, f"before-python-{name}")
        lines = smstate.get_state().splitlines()
        late = [line for line in lines if re.search(
            r"= (FindSource|GetActiveSource)\(|\.(RegionSurface|DensityImage) = ", line)]
        self.assertEqual(len(late), 4, late)
        del view  # ParaView crashes if the former window ends after the new one's beginning
        script = "\n".join([line for line in lines if line not in late] + late)
        _, after = self.draw_again(script, f"python-{name}")
        print(f"{name}: largest difference {np.abs(after - before).max()}")
        self.assertGreater(before.std(), 10)
        self.assertLessEqual(np.abs(after - before).max(), 1)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
