# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exponential height fog in double precision, where naive exponentials overflow.

Density exp(-y/H), H = 1, extinction 0.5 at y = 0, isotropic, purely scattering.
"""

import math
import unittest

from vtkmodules.vtkRenderingCore import vtkLight

import airlight


class TestHeightFog(unittest.TestCase):
    def setUp(self):
        self.medium = airlight.vtkParticipatingMedium()
        self.medium.SetScattering(0.5, 0.5, 0.5)
        self.medium.SetDensityToExponentialHeight()

    def test_looking_down_from_far_above(self):
        # Optical depth of the whole column above y = 0: 0.5 H.
        for height in (10.0, 85.0, 100.0, 1000.0):
            for a, b in (((0, height, 0), (0, 0, 0)), ((0, 0, 0), (0, height, 0))):
                rgb = [0.0, 0.0, 0.0]
                self.assertTrue(airlight.vtkAirlight.Transmittance(self.medium, a, b, rgb))
                expected = math.exp(-0.5 * (1.0 - math.exp(-height)))
                self.assertAlmostEqual(rgb[0], expected, delta=1e-12)

    def test_low_sun(self):
        # Straight up, the sun's slope mu: the integrand 0.5 e^-y p E exp(-0.5 (1 - e^-y) - 0.5
        # e^-y/mu), by Simpson's rule in y.
        for mu in (0.5, 0.1, 0.006):
            def integrand(y, mu=mu):
                density = math.exp(-y)
                depth = 0.5 * (1.0 - density) + 0.5 * density / mu
                return 0.5 * density * math.exp(-depth) / (4 * math.pi)

            n, end = 200000, 60.0
            step = end / n
            total = integrand(0.0) + integrand(end)
            total += sum((4 if i % 2 else 2) * integrand(i * step) for i in range(1, n))
            expected = total * step / 3

            sun = vtkLight()
            airlight.vtkAirlight.SetIrradiance(sun, (1, 1, 1))
            sun.SetPosition(math.sqrt(1 - mu * mu), mu, 0)
            sun.SetFocalPoint(0, 0, 0)
            rgb = [0.0, 0.0, 0.0]
            self.assertTrue(airlight.vtkAirlight.Inscatter(
                self.medium, sun, (0, 0, 0), (0, 1, 0), 0.0, 1e18, rgb))
            self.assertAlmostEqual(rgb[0] / expected, 1.0, delta=1e-9)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
