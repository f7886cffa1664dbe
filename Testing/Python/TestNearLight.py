# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Rays that pass a light very closely: the pass against vtkAirlight, in double precision.

There the airlight goes as 1/h, h the distance between ray and light, and h is a small difference of
large numbers.
"""

import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow

import airlight

WIDTH, HEIGHT = 64, 48


class TestNearLight(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.medium = airlight.vtkParticipatingMedium()
        self.medium.SetScattering(0.1, 0.14, 0.2)
        self.medium.SetAbsorption(0.02, 0.01, 0.05)
        self.render_pass = airlight.vtkAirlightPass()
        self.render_pass.SetMedium(self.medium)
        self.render_pass.RecordBuffersOn()
        self.renderer.SetPass(self.render_pass)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(WIDTH, HEIGHT)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetPosition(3.1, -2.3, 7.7)
        self.camera.SetFocalPoint(0.3, 0.4, -0.2)
        self.camera.SetClippingRange(0.1, 100)

    def ray(self, x, y):
        """Origin and unit direction of a pixel's ray, from the camera's definition."""
        position = np.array(self.camera.GetPosition())
        forward = np.array(self.camera.GetDirectionOfProjection())
        right = np.cross(forward, self.camera.GetViewUp())
        right /= np.linalg.norm(right)
        up = np.cross(right, forward)
        u = (x + 0.5 - WIDTH / 2) / (HEIGHT / 2)
        v = (y + 0.5 - HEIGHT / 2) / (HEIGHT / 2)
        if self.camera.GetParallelProjection():
            scale = self.camera.GetParallelScale()
            return position + scale * (u * right + v * up), forward
        scale = np.tan(np.radians(self.camera.GetViewAngle()) / 2)
        direction = forward + scale * (u * right + v * up)
        return position, direction / np.linalg.norm(direction)

    def compare(self, relative_distance):
        """The light as far beside a pixel's ray, in parts of its distance from the eye."""
        x, y = 41, 30
        origin, direction = self.ray(x, y)
        aside = np.cross(direction, (0.3, 0.5, 0.8))
        aside /= np.linalg.norm(aside)
        position = origin + 8.0 * (direction + relative_distance * aside)
        light = vtkLight()
        airlight.vtkAirlight.SetRadiantIntensity(light, (10, 8, 6))
        light.SetPosition(position)
        self.renderer.RemoveAllLights()
        self.renderer.AddLight(light)
        self.window.Render()
        expected = [0.0, 0.0, 0.0]
        self.assertTrue(airlight.vtkAirlight.Inscatter(
            self.medium, light, origin, direction, 0.0, 1e18, expected))
        scalars = self.render_pass.GetBuffer("Airlight").GetPointData().GetScalars()
        got = vtk_to_numpy(scalars).reshape(HEIGHT, WIDTH, 3)[y, x]
        np.testing.assert_allclose(got, expected, rtol=1e-4)

    def check_all(self):
        for relative_distance in (2e-5, 1e-4, 5e-4, 3e-3, 2e-2):
            with self.subTest(relative_distance=relative_distance):
                self.compare(relative_distance)

    def test_perspective(self):
        self.check_all()

    def test_parallel(self):
        self.camera.ParallelProjectionOn()
        self.camera.SetParallelScale(3.0)
        self.check_all()


if __name__ == "__main__":
    unittest.main(argv=[__file__])
