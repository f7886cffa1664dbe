# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The phase functions of the command line and of scene files, and light scattered onto surfaces.

Run it like TestAirlightProgram.py.
"""

import unittest

import numpy as np

from programtest import SceneTest, henyey_greenstein, pixel_rays

FOUR_PI = 4 * np.pi
K = 3.0  # of the table's function


def rayleigh(mu):
    return 3 / (16 * np.pi) * (1 + mu**2)


def schlick(k, mu):
    return (1 - k * k) / (FOUR_PI * (1 - k * mu)**2)


def cornette_shanks(g, mu):
    return 3 / (8 * np.pi) * (1 - g * g) / (2 + g * g) * (1 + mu**2) / (
        1 + g * g - 2 * g * mu)**1.5


def draine(g, alpha, mu):
    return ((1 - g * g) * (1 + alpha * mu**2) / (1 + alpha * (1 + 2 * g * g) / 3) / FOUR_PI
            / (1 + g * g - 2 * g * mu)**1.5)


def mie(n, mu):
    return (1 / 2 + (n + 1) / 2 * ((1 + mu) / 2)**n) / FOUR_PI


def von_mises(mu):
    """K/(4 pi sinh K) exp(K mu), whose integral over the sphere is 1."""
    return K / (FOUR_PI * np.sinh(K)) * np.exp(K * mu)


# Option, the same in a scene file, the function, its tolerance: closed forms, fits within 1e-3.
FUNCTIONS = (
    ("isotropic", {"type": "isotropic"}, lambda mu: henyey_greenstein(0, mu), 1e-5),
    ("rayleigh", {"type": "rayleigh"}, rayleigh, 1e-5),
    ("schlick:0.7", {"type": "schlick", "k": 0.7}, lambda mu: schlick(0.7, mu), 1e-5),
    ("schlick:-0.3", {"type": "schlick", "k": -0.3}, lambda mu: schlick(-0.3, mu), 1e-5),
    ("henyey_greenstein:0.5", {"type": "henyey_greenstein", "g": 0.5},
     lambda mu: henyey_greenstein(0.5, mu), 1.01e-3),
    ("cornette_shanks:0.6", {"type": "cornette_shanks", "g": 0.6},
     lambda mu: cornette_shanks(0.6, mu), 1.01e-3),
    ("draine:0.6:5", {"type": "draine", "g": 0.6, "alpha": 5},
     lambda mu: draine(0.6, 5, mu), 1.01e-3),
    ("draine:0.95:30", {"type": "draine", "g": 0.95, "alpha": 30},  # a table, without a fit
     lambda mu: draine(0.95, 30, mu), 1e-4),
    ("mie_hazy", {"type": "mie_hazy"}, lambda mu: mie(8, mu), 1e-5),
    ("mie_murky", {"type": "mie_murky"}, lambda mu: mie(32, mu), 2e-5),
)


class TestPhaseFunctions(SceneTest):
    """In an unbounded medium the sun in the direction w gives

        L = sigma_s/sigma_t p(w.d) E,

    see TestAirlightProgramLights.
    """

    SUNS = ((0.3, 0.4, -1), (-1, 0.5, 0.1), (-0.1, 0.2, 1))  # before, beside, behind the eye
    ALBEDO = np.array([2 / 3, 1, 4 / 5])  # of scene_medium() with the options below
    OPTIONS = ("--buffer", "Airlight", "--absorption", "0.1,0,0.1")

    def check(self, function, tolerance, scene, *options):
        cosines = []
        for sun in self.SUNS:
            cosine = pixel_rays(self.CAMERA, *self.SIZE) @ (np.array(sun) / np.linalg.norm(sun))
            image = self.render(scene, "a.pfm", *self.OPTIONS, *options, "--sun",
                                ",".join(map(str, sun)) + ":4,5,6")
            expected = self.ALBEDO * [4, 5, 6] * function(cosine)[..., None]
            np.testing.assert_allclose(image, expected, rtol=tolerance, err_msg=str(options))
            cosines.append(cosine)
        self.assertLess(np.min(cosines), -0.99)
        self.assertGreater(np.max(cosines), 0.99)

    def test_options(self):
        """Over a scene file that has another function."""
        scene = self.scene(phase={"type": "cornette_shanks", "g": -0.8})
        for option, _, function, tolerance in FUNCTIONS:
            self.check(function, tolerance, scene, "--phase", option)
        self.check(lambda mu: henyey_greenstein(0.5, mu), 1.01e-3, scene, "--anisotropy", "0.5")

    def test_scene_files(self):
        for _, phase, function, tolerance in FUNCTIONS:
            self.check(function, tolerance, self.scene(phase=phase))

    def test_table(self):
        """In any unit, with and without a heading, empty lines, either end of line."""
        rows = [f"{angle},{1e5 * von_mises(np.cos(np.radians(angle))):.9g}"
                for angle in range(181)]
        text = "angle,value\n" + "\n".join(rows) + "\n"
        # The fit's 1e-3, and what a cubic makes of a cosine within a degree.
        self.check(von_mises, 1.02e-3, self.scene(), "--phase-table", self.write("0.csv", text))
        options = (*self.OPTIONS, "--sun", "0.3,0.4,-1:4,5,6")
        phase = {"type": "tabulated", "table": "0.csv"}
        expected = self.render(self.scene(phase=phase), "0.pfm", *options)
        for i, variant in enumerate((
                "\n".join(rows), "\r\n".join(rows), text.replace("\n", "\n\n"))):
            table = self.write(f"{i + 1}.csv", variant)
            image = self.render(self.scene(), "a.pfm", *options, "--phase-table", table)
            np.testing.assert_array_equal(image, expected)
        image = self.render(self.scene(), "a.pfm", *options, "--phase-table", self.path("0.csv"))
        np.testing.assert_array_equal(image, expected)

    def test_steep_table(self):
        """A function that no fit follows: 1000 times as much around 90 degrees."""
        peak = [f"{angle},{1000 if 85 <= angle <= 95 else 1}" for angle in range(181)]
        table = self.write("peak.csv", "\n".join(peak))
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        image = self.render(self.scene(), "peak.pfm", *self.OPTIONS, "--phase-table", table,
                            "--sun", "-1,0,0.1:4,5,6")
        cosine = rays @ (np.array([-1, 0, 0.1]) / np.linalg.norm([-1, 0, 0.1]))
        angle = np.degrees(np.arccos(cosine))
        inside, outside = np.abs(angle - 90) < 5, np.abs(angle - 90) > 6
        self.assertGreater(min(inside.sum(), outside.sum()), 100)
        # Values: 1000 p where it is flat above, p below.
        base = image[outside][0]
        np.testing.assert_allclose(image[outside], np.broadcast_to(base, image[outside].shape),
                                   rtol=1e-5)
        np.testing.assert_allclose(image[inside], np.broadcast_to(1000 * base,
                                   image[inside].shape), rtol=1e-4)


class TestGlow(SceneTest):
    def test_sun(self):
        """The airlight L = sigma_s/sigma_t E/(4 pi) of a sun in an isotropic medium is the same in
        all directions: it lights a wall by pi L, and the wall sends albedo L more, less what the
        medium takes on the way."""
        wall = self.wall_scene([1, 0.5, 0.25])
        options = ("--buffer", "Surface", "--sun", "1,2,3:4,5,6")
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        way = -self.CAMERA["position"][2] / rays[..., 2:]
        expected = np.array([1, 0.5, 0.25]) * [1, 1, 0.8] * [4, 5, 6] / FOUR_PI * np.exp(
            -np.array([0.2, 0.3, 0.5]) * way)
        plain = self.render(wall, "plain.pfm", *options)
        glow = self.render(wall, "glow.pfm", *options, "--glow")
        # The difference of two pictures of single precision, 1 to 2 times as bright as it.
        np.testing.assert_allclose(glow - plain, expected, rtol=3e-3)

        with open(wall) as file:
            text = file.read()
        for value, image in (("true", glow), ("false", plain)):
            scene = self.write("b.json", '{"scattered_surface_light": ' + value + ", " + text[1:])
            np.testing.assert_array_equal(self.render(scene, "b.pfm", *options), image)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
