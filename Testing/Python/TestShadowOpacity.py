# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""SetShadowOpacity() and SetCastsShadow(): the coloured shadow of a pane, none, and bad values."""

import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (vtkInformation, vtkLogger, vtkOutputWindow,
                                      vtkStringOutputWindow)
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow)

import airlight


def take_errors(action):
    """What an action writes to VTK's output window."""
    window = vtkStringOutputWindow()
    old = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    action()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
    vtkOutputWindow.SetInstance(old)
    return window.GetOutput()


class TestShadowOpacity(unittest.TestCase):
    def setUp(self):
        """All air that is seen lies in the shadow of a wide pane, in the sun."""
        pane = vtkPlaneSource()
        pane.SetOrigin(-2000, 300, -2000)
        pane.SetPoint1(2000, 300, -2000)
        pane.SetPoint2(-2000, 300, 2000)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(pane.GetOutputPort())
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.GetProperty().SetOpacity(0.25)
        sun = vtkLight()
        sun.PositionalOff()
        sun.SetPosition(0.1, 1, 0.2)
        sun.SetFocalPoint(0, 0, 0)
        medium = airlight.vtkParticipatingMedium()
        medium.SetVisibility(20)
        self.render_pass = airlight.vtkAirlightPass()
        self.render_pass.SetMedium(medium)
        self.render_pass.RecordBuffersOn()
        renderer = vtkRenderer()
        renderer.AddActor(self.actor)
        renderer.AddLight(sun)
        renderer.SetPass(self.render_pass)
        renderer.GetActiveCamera().SetPosition(0, 0, 5)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(60, 50)
        self.window.AddRenderer(renderer)

    def airlight(self):
        self.window.Render()
        scalars = self.render_pass.GetBuffer("Airlight").GetPointData().GetScalars()
        return vtk_to_numpy(scalars).astype(float)

    def test_colours(self):
        self.render_pass.TranslucentShadowsOff()
        clear = self.airlight()
        self.render_pass.TranslucentShadowsOn()
        np.testing.assert_allclose(self.airlight(), 0.75 * clear, rtol=1e-5)
        keys = vtkInformation()
        keys.Set(airlight.vtkAirlightPass.SHADOW_OPACITY(), 0.1, 0.5, 1.0)
        self.actor.SetPropertyKeys(keys)
        np.testing.assert_allclose(self.airlight(), clear * (0.9, 0.5, 0.0), rtol=1e-5, atol=1e-9)
        airlight.vtkAirlightPass.SetShadowOpacity(self.actor, 0.5, 0.0, 0.1)
        np.testing.assert_allclose(self.airlight(), clear * (0.5, 1.0, 0.9), rtol=1e-5, atol=1e-9)
        airlight.vtkAirlightPass.SetCastsShadow(self.actor, False)
        np.testing.assert_array_equal(self.airlight(), clear)
        airlight.vtkAirlightPass.SetCastsShadow(self.actor, True)
        np.testing.assert_allclose(self.airlight(), clear * (0.5, 1.0, 0.9), rtol=1e-5, atol=1e-9)

    def test_shared_keys(self):
        """The setters keep the prop's other keys, and change no other prop."""
        keys = vtkInformation()
        keys.Set(airlight.vtkAirlightPass.CASTS_SHADOW(), 0)
        other = vtkActor()
        for actor in (self.actor, other):
            actor.SetPropertyKeys(keys)
        airlight.vtkAirlightPass.SetShadowOpacity(self.actor, 0.2, 0.4, 0.6)
        own = self.actor.GetPropertyKeys()
        key = airlight.vtkAirlightPass.SHADOW_OPACITY()
        self.assertEqual([own.Get(key, i) for i in range(3)], [0.2, 0.4, 0.6])
        self.assertEqual(own.Get(airlight.vtkAirlightPass.CASTS_SHADOW()), 0)
        self.assertFalse(other.GetPropertyKeys().Has(key))

    def test_bad_values(self):
        """An error names prop, value and remedy; the old value stays."""
        airlight.vtkAirlightPass.SetShadowOpacity(self.actor, 0.2, 0.4, 0.6)
        time = self.actor.GetMTime()
        for value, text in ((-0.25, "-0.25"), (1.5, "1.5"), (float("nan"), "nan")):
            for place in range(3):
                values = [0.5, 0.5, 0.5]
                values[place] = value
                errors = take_errors(
                    lambda v=values: airlight.vtkAirlightPass.SetShadowOpacity(self.actor, *v))
                for part in ("vtkOpenGLActor", text, "from 0 to 1"):
                    self.assertIn(part, errors)
        self.assertEqual(self.actor.GetMTime(), time)
        self.assertIn("null", take_errors(
            lambda: airlight.vtkAirlightPass.SetShadowOpacity(None, 0.5, 0.5, 0.5)))
        self.assertIn("null", take_errors(
            lambda: airlight.vtkAirlightPass.SetCastsShadow(None, False)))
        self.assertIn("null", take_errors(
            lambda: airlight.vtkAirlightPass.SetVolumeScatters(None, True)))
        self.assertIn("null", take_errors(
            lambda: airlight.vtkAirlightPass.SetVolumePhaseFunction(None, None)))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
