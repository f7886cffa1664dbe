# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkAirlightLight.SetScatters(): a light that lights surfaces and not the air."""

import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow)

import airlight


class TestLightScatters(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        sphere = vtkSphereSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        self.lights = []
        for x in (-2, 2):
            light = vtkLight()
            airlight.vtkAirlight.SetRadiantIntensity(light, (5, 5, 5))
            light.SetPosition(x, 1, 2)
            self.renderer.AddLight(light)
            self.lights.append(light)
        medium = airlight.vtkParticipatingMedium()
        medium.SetVisibility(20)
        self.render_pass = airlight.vtkAirlightPass()
        self.render_pass.SetMedium(medium)
        self.render_pass.RecordBuffersOn()
        self.renderer.SetPass(self.render_pass)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(60, 50)
        self.window.AddRenderer(self.renderer)

    def buffers(self, *names):
        self.window.Render()
        return [vtk_to_numpy(self.render_pass.GetBuffer(name).GetPointData().GetScalars()).copy()
                for name in names]

    def test_quiet_light(self):
        surface, second = self.buffers("Surface", "Airlight:1")
        self.render_pass.SetLightScatters(self.lights[0], False)
        self.assertFalse(self.render_pass.GetLightScatters(self.lights[0]))
        self.assertTrue(self.render_pass.GetLightScatters(self.lights[1]))
        names = ("Surface", "Airlight:0", "Airlight:1", "Airlight")
        quiet_surface, quiet, loud, total = self.buffers(*names)
        np.testing.assert_array_equal(quiet_surface, surface)  # surfaces keep the light
        self.assertEqual(quiet.max(), 0)
        np.testing.assert_array_equal(loud, second)
        np.testing.assert_array_equal(total, second)
        self.render_pass.SetLightScatters(self.lights[0], True)
        self.assertGreater(self.buffers("Airlight:0")[0].min(), 0)

    def test_the_light_keeps_it(self):
        """Passes, mappers and the reference read it from the light, and set it there."""
        light = self.lights[0]
        others = [airlight.vtkAirlightPass(), airlight.vtkAirlightPolyDataMapper(),
                  airlight.vtkAirlightReference()]
        airlight.vtkAirlightLight.SetScatters(light, False)
        for other in [self.render_pass] + others:
            self.assertFalse(other.GetLightScatters(light))
        self.assertEqual(self.buffers("Airlight:0")[0].max(), 0)
        reference = airlight.vtkAirlightReference()
        reference.SetRenderer(self.renderer)
        reference.AddMedium(self.render_pass.GetMedium(0))
        reference.SetSize(12, 10)
        reference.Update()
        one = vtk_to_numpy(reference.GetOutput().GetPointData().GetArray("Airlight")).sum()
        others[2].SetLightScatters(light, True)
        self.assertTrue(airlight.vtkAirlightLight.GetScatters(light))
        self.assertGreater(self.buffers("Airlight:0")[0].min(), 0)
        reference.Update()
        two = vtk_to_numpy(reference.GetOutput().GetPointData().GetArray("Airlight")).sum()
        self.assertGreater(two, 1.5 * one)

    def test_own_light(self):
        """The light that a renderer makes, a headlight: surfaces only, until it is switched on."""
        warnings = []
        self.render_pass.AddObserver("WarningEvent", lambda *_: warnings.append(1))
        self.renderer.RemoveAllLights()
        surface, airlight_sum = self.buffers("Surface", "Airlight")
        light = self.renderer.GetLights().GetItemAsObject(0)
        self.assertTrue(light.LightTypeIsHeadlight())
        self.assertFalse(self.render_pass.GetLightScatters(light))
        self.assertGreater(surface.max(), 0.1)
        self.assertEqual(airlight_sum.max(), 0)
        self.assertEqual(len(warnings), 1)
        self.render_pass.SetLightScatters(light, True)
        self.assertTrue(self.render_pass.GetLightScatters(light))
        self.assertGreater(self.buffers("Airlight")[0].min(), 0)
        self.assertEqual(len(warnings), 1)

    def test_null(self):
        errors = []
        self.render_pass.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        self.render_pass.SetLightScatters(None, False)
        self.assertEqual(len(errors), 1)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
