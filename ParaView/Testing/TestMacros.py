# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The macros of Examples/ParaView/macros, as ParaView runs them: by the file's text."""

import pathlib
import runpy
import sys
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test

MACROS = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "ParaView" / "macros"


def run(name):
    return runpy.run_path(str(MACROS / f"{name}.py"), run_name="__main__")


class Macros(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        test.load_plugin()

    @staticmethod
    def make_plain_view():
        view = simple.CreateView("RenderView")
        view.ViewSize = list(test.SIZE)
        view.UseColorPaletteForBackground = 0
        view.Background = [0.1, 0.2, 0.4]
        contour = simple.Contour(Input=simple.Wavelet(), ContourBy=["POINTS", "RTData"],
                                 Isosurfaces=[157.0])
        display = simple.Show(contour, view)
        simple.ColorBy(display, ("POINTS", "Normals", "X"))
        display.Opacity = 0.8
        simple.ResetCamera(view)
        simple.SetActiveView(view)
        view.CameraPosition = [30, 20, 60]
        return view

    def test_convert(self):
        """With the medium off, the new view's picture is the old one's."""
        view = self.make_plain_view()
        layout = simple.GetLayout(view)
        before = test.picture(view, "before-conversion")
        run("ConvertToAirlight")
        found = simple.GetActiveView()
        self.assertEqual(found.GetXMLName(), "AirlightRenderView")
        self.assertEqual([each.GetXMLName() for each in simple.GetViews()], ["AirlightRenderView"])
        if layout:
            self.assertEqual(layout.GetViewLocation(found.SMProxy), 0)
        found.ViewSize = list(test.SIZE)
        fog = test.picture(found, "converted")
        self.assertGreater(np.abs(fog - before).mean(), 5)
        found.Airlight = 0
        np.testing.assert_allclose(test.picture(found, "converted-off"), before, atol=1)
        # Once more changes nothing.
        run("ConvertToAirlight")
        self.assertEqual(len(simple.GetViews()), 1)

    def test_lamp(self):
        """A light of the scene that is that of the view's property Lamp, but for its wide cone."""
        view = simple.CreateView("AirlightRenderView")
        view.ViewSize = list(test.SIZE)
        simple.SetActiveView(view)
        with self.assertRaisesRegex(RuntimeError, "shows no data"):
            run("AirlightLamp")
        simple.Show(simple.Cone(Center=[5, 6, 7], Radius=2), view)
        simple.ResetCamera(view)
        without = test.picture(view, "without-lamp")
        view.Lamp = 1
        expected = test.picture(view, "with-lamp")
        view.Lamp = 0
        run("AirlightLamp")
        self.assertEqual(len(view.AdditionalLights), 1)
        found = test.picture(view, "with-lamp-of-macro")
        self.assertGreater(np.abs(found - without).max(), 50)
        changed, kept = np.abs(expected - without).mean(), np.abs(found - expected).mean()
        print(f"lamp: mean change {changed:.1f}, the macro's differs by {kept:.1f}")
        self.assertLess(kept, 0.4 * changed)

    def test_errors(self):
        simple.SetActiveView(simple.CreateView("SpreadSheetView"))
        for name in ("AirlightLamp", "ConvertToAirlight"):
            with self.assertRaisesRegex(RuntimeError, "no render view"):
                run(name)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
