# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""airlight.paraview.attach(): the medium in ParaView's own view, without the plugin."""

import sys
import unittest

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkCollection

import airlight.paraview
import paraviewtest as test


class Attach(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ball, cls.floor = test.make_sources()
        cls.view = test.make_view("RenderView")
        lamp = simple.AddLight(view=cls.view)
        lamp.Coords = "Scene"
        lamp.Position = [-1, 1.5, 1]
        test.show(cls.view, cls.ball, cls.floor)

    def test_attach(self):
        plain = test.picture(self.view, "attach-plain")
        fog = airlight.vtkParticipatingMedium()
        render_pass = airlight.paraview.attach(self.view, fog)
        render_pass.SurfaceShadowsOff()
        np.testing.assert_allclose(test.picture(self.view, "attach-clear"), plain, atol=2)

        # Light along (1, -1.5, -1), E = pi: 1/4 of the part that does not pass goes to the eye.
        fog.SetScattering(0.3, 0.2, 0.1)
        shown = test.picture(self.view, "attach-fog")
        background = shown[5, 10]  # above the horizon: all of the part
        np.testing.assert_allclose(background, 255 / 4, atol=1)
        self.assertGreater(np.abs(shown - plain).max(), 30)

        # A pick and switched antialiasing put ParaView's pass back.
        self.view.SMProxy.SelectSurfaceCells([80, 40, 120, 90], vtkCollection(), vtkCollection(),
                                             True)
        np.testing.assert_array_equal(test.picture(self.view, "attach-picked"), shown)
        self.view.UseFXAA = 1 - self.view.UseFXAA
        toggled = test.picture(self.view, "attach-toggled")
        self.assertLess(np.mean(np.abs(toggled - shown) > 4), 0.05, "edges alone change")
        self.view.UseFXAA = 1 - self.view.UseFXAA
        np.testing.assert_array_equal(test.picture(self.view, "attach-again"), shown)

        # Once more is the same pass; detached is as before.
        self.assertIs(airlight.paraview.attach(self.view, fog), render_pass)
        airlight.paraview.detach(self.view)
        airlight.paraview.detach(self.view)
        np.testing.assert_array_equal(test.picture(self.view, "attach-detached"), plain)

    def test_errors(self):
        for wrong in (None, 3, self.ball):
            with self.assertRaisesRegex(TypeError, "is no render view"):
                airlight.paraview.attach(wrong)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
