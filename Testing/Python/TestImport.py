#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The package imports, its classes are there, and values go in and come out."""

import math
import sys
import unittest

import airlight


class TestImport(unittest.TestCase):
    def test_version(self):
        self.assertRegex(airlight.__version__, r"^\d+\.\d+\.\d+$")

    def test_medium(self):
        medium = airlight.vtkParticipatingMedium()
        self.assertEqual(medium.GetScattering(), (0.0, 0.0, 0.0))
        medium.SetScattering(0.1, 0.2, 0.3)
        medium.SetAbsorption(0.3, 0.2, 0.1)
        for value in medium.GetExtinction():
            self.assertAlmostEqual(value, 0.4, 15)

    def test_airlight(self):
        # The class, not the submodule of the same name.
        self.assertTrue(airlight.vtkAirlight().IsA("vtkAirlight"))
        medium = airlight.vtkParticipatingMedium()
        medium.SetScattering(0.1, 0.2, 0.3)
        rgb = [0.0, 0.0, 0.0]
        self.assertTrue(airlight.vtkAirlight.Transmittance(medium, (0, 0, 0), (2, 0, 0), rgb))
        for value, sigma in zip(rgb, (0.1, 0.2, 0.3)):
            self.assertAlmostEqual(value, math.exp(-2.0 * sigma), 14)

    def test_pass(self):
        render_pass = airlight.vtkAirlightPass()
        self.assertEqual(render_pass.GetShadowTechnique(), airlight.vtkAirlightPass.AUTOMATIC)
        render_pass.SetShadowTechniqueToNone()
        self.assertEqual(render_pass.GetShadowTechnique(), airlight.vtkAirlightPass.NONE)
        medium = airlight.vtkParticipatingMedium()
        render_pass.SetMedium(medium)
        self.assertEqual(render_pass.GetNumberOfMedia(), 1)
        self.assertIs(render_pass.GetMedium(0), medium)


    def test_distance_without_reciprocal(self):
        medium = airlight.vtkParticipatingMedium()
        errors = []
        medium.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        medium.SetVisibility(1e-310)
        medium.SetMeanFreePath(1e-310)
        self.assertEqual(len(errors), 2)
        self.assertEqual(medium.GetExtinction(), (0, 0, 0))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
