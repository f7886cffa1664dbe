# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkAirlightPolyDataMapper from Python: a surface in fog without a pass."""

import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

import airlight


class TestPolyDataMapper(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        plane = vtkPlaneSource()
        plane.SetOrigin(-9, -9, 0)
        plane.SetPoint1(9, -9, 0)
        plane.SetPoint2(-9, 9, 0)
        self.mapper = airlight.vtkAirlightPolyDataMapper()
        self.mapper.SetInputConnection(plane.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(0.8, 0.8, 0.8)
        self.renderer.AddActor(actor)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.GetActiveCamera().SetPosition(0, 0, 5)
        self.renderer.GetActiveCamera().SetClippingRange(0.1, 50)
        self.renderer.GetActiveCamera().ParallelProjectionOn()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(40, 30)
        self.window.AddRenderer(self.renderer)
        self.medium = airlight.vtkParticipatingMedium()
        self.medium.SetScattering(0, 0, 0)
        self.medium.SetAbsorption(0.1, 0.2, 0.3)

    def picture(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, 39, 29, 1, pixels, 0)
        return vtk_to_numpy(pixels).reshape(30, 40, 3)

    def test_absorption(self):
        self.assertEqual(np.unique(self.picture()).tolist(), [204])
        self.mapper.SetMedium(self.medium)
        self.assertEqual(self.mapper.GetNumberOfMedia(), 1)
        self.assertIs(self.mapper.GetMedium(0), self.medium)
        expected = 204 * np.exp(-5 * np.array([0.1, 0.2, 0.3]))  # from 5 units away
        for evaluate in (self.mapper.SetEvaluationToFragment, self.mapper.SetEvaluationToVertex):
            evaluate()
            self.assertLessEqual(np.abs(self.picture() - expected).max(), 1)
        self.mapper.RemoveAllMedia()
        self.assertEqual(np.unique(self.picture()).tolist(), [204])

    def test_bad_input(self):
        errors = []
        self.mapper.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        self.mapper.SetEvaluation(7)
        self.mapper.SetLightRadius(-1)
        self.assertIsNone(self.mapper.GetMedium(0))
        self.assertEqual(len(errors), 3)
        self.assertEqual(self.mapper.GetEvaluation(), self.mapper.FRAGMENT)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
