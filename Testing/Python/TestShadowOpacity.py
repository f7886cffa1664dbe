# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkAirlightPass.SHADOW_OPACITY(): the coloured shadow of a pane, and that of its opacity alone."""

import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow)

import airlight


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


if __name__ == "__main__":
    unittest.main(argv=[__file__])
