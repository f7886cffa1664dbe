# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window as a user opens it: the plugin loaded by its dialog, the view made from the list of
views, data shown, and not one message."""

import os
import pathlib
import shutil
import sys
import tempfile
import unittest

import numpy as np

import paraviewtest as test
import windowtest as window

PLUGIN = os.environ["AIRLIGHT_PLUGIN"]


def keep(name, pixels):
    """A picture of the screen, to be looked at."""
    import paraview.vtk as vtk
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkIOImage import vtkPNGWriter
    image = vtk.vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(np.ascontiguousarray(pixels[::-1]).reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(test.OUTPUT / f"{name}.png"))
    writer.SetInputData(image)
    writer.Write()


class Window(unittest.TestCase):
    def setUp(self):
        if not shutil.which("Xvfb"):
            self.skipTest("no Xvfb")

    def play(self, events, **options):
        with tempfile.TemporaryDirectory() as folder, window.Screen(folder) as screen:
            played = screen.play(events, **options)
            views = {name: test.read_png(pathlib.Path(folder, f"grab-{name}.png"))
                     for name in played.grabs}
        if played.status == window.SKIPPED:
            self.skipTest(played.text)
        for name, pixels in played.grabs.items():
            keep(f"window-{name}", pixels)
        return played, views

    def test_first_view(self):
        """A message of any kind would be in the output window's text."""
        played, views = self.play(
            window.load_plugin(PLUGIN) + [window.CHECK_MESSAGES] + window.make_view()
            + window.make_source("RTAnalyticSource") + window.make_filter("Contour")
            + [("", "grab", "first"), window.CHECK_MESSAGES])
        self.assertEqual(played.status, 0, played.text)
        for word in ("ERR|", "WARN|", "No proxy that matches", "critical"):
            self.assertNotIn(word, played.text)
        self.assertEqual(set(views), {"first"}, played.text)
        # The view is on the screen as in its screenshot.
        screen, view = played.grabs["first"].astype(float), views["first"][..., :3]
        self.assertGreater(view.std(), 15)
        self.assertLess(view.shape[0] * view.shape[1], screen.shape[0] * screen.shape[1])
        self.assertLess(self.find(screen, view), 3)

    @staticmethod
    def find(screen, view):
        """The mean difference of the screen's best place for a picture; its middle is compared."""
        rows, columns = view.shape[:2]
        middle = view[rows // 4:3 * rows // 4:3, columns // 4:3 * columns // 4:3]
        best = 255.0
        for y in range(screen.shape[0] - rows + 1):
            for x in range(screen.shape[1] - columns + 1):
                part = screen[y + rows // 4:y + 3 * rows // 4:3,
                              x + columns // 4:x + 3 * columns // 4:3]
                best = min(best, np.abs(part - middle).mean())
        return best

    def test_messages_are_seen(self):
        """The check of the output window fails if there is something in it."""
        played, _ = self.play(window.load_plugin(PLUGIN) + [
            ("", "activate", "no such thing")] + [window.CHECK_MESSAGES])
        self.assertNotEqual(played.status, 0)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    result = unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result
    if result.skipped or not result.wasSuccessful():
        sys.exit(window.SKIPPED if result.skipped and result.wasSuccessful() else 1)
