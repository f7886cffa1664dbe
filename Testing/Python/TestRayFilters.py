# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkLitIntervalsFilter and vtkAirlightProbeFilter in a pipeline, their arrays in numpy.

An isotropic, purely scattering medium of extinction 0.2 and a lamp of 3 W/sr at (0, 2, 0).
"""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight

import airlight

SIGMA = 0.2
POWER = 3.0
LAMP = np.array((0.0, 2.0, 0.0))


def make_lamp():
    lamp = vtkLight()
    airlight.vtkAirlight.SetRadiantIntensity(lamp, (POWER, POWER, POWER))
    lamp.SetPosition(*LAMP)
    return lamp


def make_medium():
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(SIGMA, SIGMA, SIGMA)
    return medium


def make_square():
    """At y = 1, x and z from -0.5 to 0.5: shades |x| < 1 at y = 0."""
    square = vtkPlaneSource()
    square.SetOrigin(-0.5, 1, -0.5)
    square.SetPoint1(0.5, 1, -0.5)
    square.SetPoint2(-0.5, 1, 0.5)
    return square


def airlight_on_x(start, end, eye):
    """Radiance towards x = eye of the part [start, end] of the x axis, by the midpoint rule."""
    n = 50000
    x = start + (end - start) * (np.arange(n) + 0.5) / n
    r = np.hypot(x, LAMP[1])
    terms = SIGMA / (4 * np.pi) * POWER / r**2 * np.exp(-SIGMA * (r + np.abs(x - eye)))
    return terms.sum() * abs(end - start) / n


class TestRayFilters(unittest.TestCase):
    def test_lit_intervals(self):
        line = vtkLineSource()
        line.SetPoint1(-3, 0, 0.1)
        line.SetPoint2(4, 0, 0.1)
        lit = airlight.vtkLitIntervalsFilter()
        lit.SetInputConnection(line.GetOutputPort())
        square = make_square()
        lit.AddInputConnection(1, square.GetOutputPort())
        lamp = make_lamp()
        lamp.SetPosition(0, 2, 0.1)
        lit.SetLight(lamp)
        lit.SetMedium(make_medium())
        lit.Update()
        data = lit.GetOutput().GetCellData()
        arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
                  for i in range(data.GetNumberOfArrays())}
        np.testing.assert_allclose(arrays["Start"], (0, 4), atol=1e-12)
        np.testing.assert_allclose(arrays["End"], (2, 7), atol=1e-12)
        np.testing.assert_allclose(arrays["Length"], (2, 3), atol=1e-12)
        np.testing.assert_allclose(arrays["OpticalDepth"][:, 0], (2 * SIGMA, 3 * SIGMA))
        np.testing.assert_allclose(
            arrays["Transmittance"][:, 1], np.exp((-2 * SIGMA, -7 * SIGMA)))
        expected = (airlight_on_x(-3, -1, -3), airlight_on_x(1, 4, -3))
        for channel in range(3):
            np.testing.assert_allclose(arrays["Airlight"][:, channel], expected, rtol=1e-8)
        cause = airlight.vtkLitIntervalsFilter
        self.assertEqual(list(arrays["StartCause"]), [cause.LINE_END, cause.SHADOW])
        self.assertEqual(list(arrays["EndCause"]), [cause.SHADOW, cause.LINE_END])
        self.assertEqual(list(arrays["EndOccluder"]), [0, -1])
        self.assertEqual(lit.GetOutput().GetNumberOfLines(), 2)

    def test_probe(self):
        positions = np.random.default_rng(1).uniform(-4, 4, (200, 3))
        positions[:, 1:] = 0
        points = vtkPoints()
        points.SetDataTypeToDouble()
        vertices = vtkCellArray()
        for p in positions:
            vertices.InsertNextCell(1)
            vertices.InsertCellPoint(points.InsertNextPoint(*p))
        cloud = vtkPolyData()
        cloud.SetPoints(points)
        cloud.SetVerts(vertices)
        probe = airlight.vtkAirlightProbeFilter()
        probe.SetInputData(cloud)
        square = make_square()
        probe.AddInputConnection(1, square.GetOutputPort())
        probe.AddLight(make_lamp())
        probe.SetMedium(make_medium())
        probe.SetViewpoint(-5, 0, 0)
        probe.Update()
        data = probe.GetOutput().GetPointData()
        x = positions[:, 0]
        r = np.hypot(x, LAMP[1])
        direct = np.where(np.abs(x) < 1, 0, POWER / r**2 * np.exp(-SIGMA * r))
        seen = [airlight_on_x(-5, min(end, -1), -5) +
                (airlight_on_x(1, end, -5) if end > 1 else 0) for end in x]
        for channel in range(3):
            def column(name, channel=channel):
                return vtk_to_numpy(data.GetArray(name))[:, channel]
            np.testing.assert_allclose(column("Transmittance"), np.exp(-SIGMA * (x + 5)))
            np.testing.assert_allclose(column("DirectIrradiance"), direct, rtol=1e-9)
            np.testing.assert_allclose(column("Radiance"), seen, rtol=1e-8)
        self.assertIsNone(data.GetArray("ScatteredIrradiance"))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
