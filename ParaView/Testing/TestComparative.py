# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The comparative view: each of its cells shows what a view of its own shows."""

import sys
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkCollection

import paraviewtest as test

RADII = (0.25, 0.5)
PROPERTIES = {"VisibilityDistance": 30, "Lamp": 1, "PhaseFunction": "Rayleigh", "Region": "Box",
              "RegionBounds": [-1.5, 1.5, -1, 1.5, -1.5, 1.5], "CameraPosition": [0.4, 0.6, 5],
              "CameraFocalPoint": [0, 0, 0], "OrientationAxesVisibility": 0}


def set_all(view, properties):
    for name, value in properties.items():
        setattr(view, name, value)


def cells(view):
    found = vtkCollection()
    view.SMProxy.GetViews(found)
    return [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]


class Comparative(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        test.load_plugin()

    def make(self):
        """A ball of two radii, side by side, above a floor."""
        ball, floor = test.make_sources()
        view = simple.CreateView("AirlightComparativeView")
        view.ViewSize = [403, 200]
        view.Dimensions = [2, 1]
        cue = servermanager.animation.ComparativeAnimationCue()
        cue.AnimatedProxy = ball
        cue.AnimatedPropertyName = "Radius"
        cue.SMProxy.UpdateXRange(0, *RADII)
        servermanager.ProxyManager().RegisterProxy("comparative_cues", "Radius", cue.SMProxy)
        view.Cues = [cue]
        test.show(view, ball, floor)
        return view, ball, floor

    def test_cells(self):
        view, ball, floor = self.make()
        simple.Render(view)
        set_all(view, PROPERTIES)
        seen = test.picture(view, "comparative")
        simple.Hide(floor, view)
        columns = []
        for cell, radius in zip(cells(view), RADII):
            width, height = (cell.GetProperty("ViewSize").GetElement(i) for i in range(2))
            single = simple.CreateView("AirlightRenderView")
            single.ViewSize = [width, height]
            # ParaView antialiases the first cell differently from the others.
            single.UseFXAA = cell.GetProperty("UseFXAA").GetElement(0)
            ball.Radius = radius
            test.show(single, ball, floor)
            simple.Render(single)
            set_all(single, PROPERTIES)
            columns.append(test.picture(single, f"comparative-{radius}", (width, height)))
            simple.Delete(single)
        left, right = columns
        parts = (seen[:, :left.shape[1]], seen[:, -right.shape[1]:])
        for radius, part, expected in zip(RADII, parts, columns):
            difference = np.abs(part - expected)
            print(f"radius {radius}: largest difference {difference.max()}")
            self.assertGreater(expected.std(), 10)
            self.assertLessEqual(difference.max(), 1)
        narrow = min(part.shape[1] for part in parts)
        self.assertGreater(np.abs(parts[0][:, :narrow] - parts[1][:, :narrow]).max(), 20)

    def test_state(self):
        view, _, _ = self.make()
        set_all(view, PROPERTIES)
        before = test.picture(view, "comparative-before-state")
        path = str(test.OUTPUT / "comparative.pvsm")
        simple.SaveState(path)
        del view
        simple.ResetSession()
        simple.LoadState(path)
        loaded = test.find_view("AirlightComparativeView")
        self.assertEqual(loaded.VisibilityDistance, 30)
        after = test.picture(loaded, "comparative-after-state", before.shape[1::-1])
        print(f"state: largest difference {np.abs(after - before).max()}")
        self.assertLessEqual(np.abs(after - before).max(), 1)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
