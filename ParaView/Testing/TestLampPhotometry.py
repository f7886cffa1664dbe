# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The light of a photometric file for the view's lamp."""

import pathlib
import subprocess
import sys
import unittest

import airlight
from airlight import paraview as attaching
import numpy as np
from paraview import simple
from vtkmodules.vtkRenderingCore import vtkLight

import paraviewtest as test

RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
FILES = pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Data" / "Photometry"


def make_view(kind="AirlightRenderView"):
    view = test.make_view(kind)
    ball, floor = test.make_sources()
    test.show(view, ball, floor)
    simple.Render(view)
    test.place_camera(view)
    if kind == "AirlightRenderView":
        view.Thickness = "Coefficients"
        view.Scattering = [0.12] * 3
        view.Absorption = [0.03] * 3
        view.PhaseFunction = "Isotropic"
        view.Lamp = 1
        view.LampBrightness = 2
    return view, [ball, floor]


class LampPhotometry(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        test.load_plugin()
        cls.view, cls.sources = make_view()

    def by_classes(self, name, file, up):
        """A light of vtkAirlightLight in a plain view, where the documentation places the lamp."""
        bounds = np.array([source.GetDataInformation().GetBounds() for source in self.sources])
        low, high = bounds[:, ::2].min(axis=0), bounds[:, 1::2].max(axis=0)
        offset = np.linalg.norm(high - low) * np.array([-0.45, 0.82, -0.1])
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*(0.5 * (low + high) + offset))
        light.SetFocalPoint(*(0.5 * (low + high)))
        # A white surface at the centre that faces it has twice the radiance 1.1.
        airlight.vtkAirlightLight.SetRadiantIntensity(light, [2 * 1.1 * np.pi * offset @ offset] * 3)
        self.assertTrue(airlight.vtkAirlightLight.SetPhotometry(light, file))
        airlight.vtkAirlightLight.SetPhotometryUp(light, *up)
        medium = airlight.vtkParticipatingMedium()
        medium.SetScattering(*[0.12] * 3)
        medium.SetAbsorption(*[0.03] * 3)
        view, _ = make_view("RenderView")
        view.SMProxy.GetRenderer().AddLight(light)
        attaching.attach(view, medium)
        expected = test.picture(view, name)
        simple.Delete(view)
        return expected

    def test_files(self):
        """As by the classes; another file, another picture; a turned one, too."""
        seen = [test.picture(self.view, "photometry-none")]
        for name, up in (("downlight", (0, 1, 0)), ("lowbeam", (0, 1, 0)),
                         ("lowbeam", (0.2, 0.3, 1)), ("streetlight", (0, 0, 1))):
            file = str(FILES / f"{name}.ies")
            self.view.LampPhotometry = file
            self.view.LampPhotometryUp = up
            picture = test.picture(self.view, f"photometry-{name}-{len(seen)}")
            expected = self.by_classes(f"photometry-{name}-by-classes", file, up)
            difference = np.abs(picture - expected).max()
            print(f"{name}, up {up}: {difference} from the classes'")
            self.assertLessEqual(difference, 1)
            self.assertGreater(picture.std(), 3)
            self.assertGreater(np.abs(picture - seen[-1]).max(), 10)
            seen.append(picture)
        self.view.LampPhotometry = ""
        np.testing.assert_array_equal(test.picture(self.view, "photometry-removed"), seen[0])

    def test_bad_files(self):
        """An error that names the file; the old one stays."""
        done = subprocess.run([str(RUN), "--run", __file__, "--bad"], capture_output=True,
                              text=True, timeout=120)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        self.assertIn("no-such.ies", text)
        self.assertIn(pathlib.Path(__file__).name, text)
        self.assertEqual(text.count("ERR|"), 3, text)
        self.assertEqual(text.count("same picture: True"), 3, text)


def use_bad_files():
    """In a process of its own, whose output is read."""
    test.load_plugin()
    view, _ = make_view()
    view.LampPhotometry = str(FILES / "downlight.ies")
    before = test.picture(view, "before-bad-file")
    for name, value in (("LampPhotometry", str(FILES / "no-such.ies")),
                        ("LampPhotometry", __file__), ("LampPhotometryUp", [0, 0, 0])):
        setattr(view, name, value)
        print("same picture:", (test.picture(view, "after-bad-file") == before).all())


if __name__ == "__main__":
    if sys.argv[1:] == ["--bad"]:
        use_bad_files()
    # pvpython loses its window where a script calls sys.exit() with a view open.
    elif not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
