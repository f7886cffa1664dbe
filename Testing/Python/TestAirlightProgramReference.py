# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""`airlight render --reference`: pictures computed on the CPU, without a display."""

import json
import os
import unittest

import numpy as np

from programtest import (PROGRAM, SOURCE, ProgramTest, metrics, read_pfm, read_png, reference_file,
                         scene_file)

SCENE = scene_file("S3_ground_occluders")
LAMP = os.path.join(SOURCE, "Testing", "Data", "Photometry", "streetlight.ies")


class TestReference(ProgramTest):
    def compute(self, name, *options):
        """As render(), on a machine without a display."""
        self.succeed("-u", "DISPLAY", PROGRAM, "render", SCENE, "--reference", "-o",
                     self.path(name), *options, program="env")
        return read_png(self.path(name)) if name.endswith(".png") else read_pfm(self.path(name))

    def test_agrees_with_the_pass(self):
        size = ("--size", "64x48")
        for buffer in ("Radiance", "Airlight", "Surface", "Transmittance"):
            computed = self.compute("computed.pfm", *size, "--buffer", buffer)
            drawn = self.render(SCENE, "drawn.pfm", *size, "--buffer", buffer)
            self.assertEqual(computed.shape, (48, 64, 3))
            scores = metrics(drawn, computed)
            with self.subTest(buffer=buffer):
                self.assertLessEqual(scores["median"], 1e-5, scores)
        for buffer in ("Depth", "LitLength"):
            computed = self.compute("computed.pfm", *size, "--buffer", buffer)
            drawn = self.render(SCENE, "drawn.pfm", *size, "--buffer", buffer)
            self.assertEqual(computed.shape, (48, 64, 1))
            self.assertLessEqual(np.median(np.abs(computed - drawn)), 1e-4, buffer)

    def test_agrees_with_the_reference_scene(self):
        """At the scene's own size; the files hold single precision."""
        scores = metrics(self.compute("total.pfm"),
                         read_pfm(reference_file("S3_ground_occluders", "total")),
                         read_pfm(reference_file("S3_ground_occluders", "mask")))
        self.assertLessEqual(scores["median"], 1e-7, scores)
        self.assertLessEqual(scores["p99"], 1e-6, scores)

    def test_options(self):
        size = ("--size", "16x12")
        linear = self.compute("a.pfm", *size)
        np.testing.assert_allclose(self.compute("b.pfm", *size, "--exposure", "4"), 4 * linear,
                                   1e-6)
        exposed = self.compute("b.png", *size, "--exposure", "4")
        self.assertLessEqual(np.abs(exposed - (4 * linear).clip(0, 1)).max(), 0.5001 / 255)
        # Without a medium there is no airlight, and with more of it more.
        for coefficient in ("0", "0.2"):
            changed = self.compute("c.pfm", *size, "--buffer", "Airlight", "--absorption", "0,0,0",
                                   "--scattering", ",".join(3 * [coefficient]))
            self.assertEqual(changed.max() > 0, coefficient != "0")

    def test_extent(self):
        """A lamp's extent softens shadows as it does in a mean of the pass."""
        lamp = ("--size", "32x24", "--point", "0,6,0:60", "--buffer", "Surface")
        point, ball = (self.compute("a.pfm", *lamp, *more) for more in ((), ("--lamp-radius", "1")))
        drawn = self.render(SCENE, "b.pfm", *lamp, "--lamp-radius", "1", "--antialiasing", "256")
        changed = np.abs(ball - point) > 0.05 * point.max()
        self.assertGreater(changed.sum(), 10)
        # Only the mean is of whole pixels.
        self.assertLess(np.median(np.abs(ball - drawn)[changed]),
                        0.3 * np.median(np.abs(ball - point)[changed]))

    def test_photometry(self):
        """A photometric file as the pass has it, rotated, on surfaces and in the air."""
        lamp = ("--size", "24x18", "--point", "0,3,0:50", "--ies", LAMP, "--ies-aim", "1,0,0.5",
                "--ies-up", "1,0,3")
        for buffer in ("Airlight", "Surface"):
            computed = self.compute("computed.pfm", *lamp, "--buffer", buffer)
            drawn = self.render(SCENE, "drawn.pfm", *lamp, "--buffer", buffer)
            scores = metrics(drawn, computed)
            with self.subTest(buffer=buffer):
                self.assertLessEqual(scores["median"], 1e-5, scores)
                self.assertLessEqual(scores["p95"], 1e-4, scores)
        single = self.compute("computed.pfm", *lamp)
        many = self.compute("computed.pfm", *lamp, "--orders", "0", "--samples", "32")
        self.assertTrue(1.1 < many.mean() / single.mean() < 10)

    def test_orders(self):
        """More orders, more light; the noise is what was asked for, and says what it is."""
        options = ("--size", "16x12", "--orders")
        single = self.compute("a.pfm", "--size", "16x12")
        np.testing.assert_array_equal(self.compute("b.pfm", *options, "1"), single)
        double = self.compute("b.pfm", *options, "2", "--samples", "64")
        many = self.compute("b.pfm", *options, "0", "--samples", "64")
        self.assertGreater(double.mean(), 1.05 * single.mean())
        self.assertGreater(many.mean(), 1.02 * double.mean())
        target = (*options, "0", "--error", "0.1")
        first, again, other = (self.compute("b.pfm", *target, "--seed", seed) for seed in "112")
        np.testing.assert_array_equal(first, again)
        error = self.compute("b.pfm", *target, "--seed", "1", "--buffer", "StandardError")
        self.assertLessEqual(np.sqrt((error**2).mean()), 0.1 * first.mean())
        self.assertGreater(np.sqrt((error**2).mean()), 0.05 * first.mean())
        chi2 = ((first - other)[error > 0]**2 / (2 * error[error > 0]**2)).mean()
        self.assertTrue(0.5 < chi2 < 2, chi2)
        self.compute("b.pfm", *options, "0", "--time-limit", "0.2")

    def test_errors(self):
        with open(SCENE) as file:
            scene = json.load(file)
        scene.update(surfaces=[], scattered_surface_light=True)
        glowing = self.write("glowing.json", json.dumps(scene))
        for scene, options, words in (
                (SCENE, ["--glow"], ["--reference", "--glow"]),
                (SCENE, ["--steps", "16"], ["--reference", "--steps"]),
                (SCENE, ["--technique", "None"], ["--reference", "--technique"]),
                (SCENE, ["--no-medium"], ["--reference", "--no-medium"]),
                (SCENE, ["--orders", "-1"], ["--orders", "-1"]),
                (SCENE, ["--samples", "8"], ["--samples", "--orders"]),
                (SCENE, ["--orders", "0", "--samples", "1"], ["--samples", "1"]),
                (SCENE, ["--orders", "0", "--error", "nan"], ["--error 'nan'", "0.01"]),
                (SCENE, ["--orders", "0", "--error", "0"], ["--error '0'"]),
                (SCENE, ["--orders", "0", "--time-limit", "-1"], ["--time-limit '-1'"]),
                (SCENE, ["--orders", "0", "--seed", "x"], ["--seed"]),
                (SCENE, ["--buffer", "StandardError"], ["StandardError", "--orders"]),
                (SCENE, ["--buffer", "ErrorBound"], ["--reference", "ErrorBound"]),
                (SCENE, ["--buffer", "BoundaryCount"], ["--reference", "BoundaryCount"]),
                (glowing, [], [glowing, "--reference", "scattered_surface_light"])):
            with self.subTest(options=options):
                self.fail_with(words, "render", scene, "--reference", *options, "-o",
                               self.path("a.pfm"))
                self.assertFalse(os.path.exists(self.path("a.pfm")))
        for options in (["--orders", "0"], ["--buffer", "StandardError"]):
            with self.subTest(options=options):
                self.fail_with(["--reference"], "render", SCENE, *options, "-o", self.path("a.pfm"))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
