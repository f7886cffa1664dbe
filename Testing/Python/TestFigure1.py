# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 1 and the animation: what physics says of them first, the pictures second.

Baselines are Testing/Data/Baseline/Figure1-*.png; a picture that differs stays in the test's
temporary folder.
"""

import os
import unittest

import numpy as np

from programtest import ANIMATED_FOG, SOURCE, ProgramTest, read_png

FIGURE = os.path.join(SOURCE, "Examples", "Data", "figure1.json")
BASELINE = os.path.join(SOURCE, "Testing", "Data", "Baseline")
SIZE = ("--size", "640x360")
SHOWN = ("--exposure", "0.6")


class TestFigure1(ProgramTest):
    def compare(self, picture, name):
        """Equal but for the rounding of colours and a few pixels on edges of triangles."""
        difference = np.abs(picture - read_png(os.path.join(BASELINE, name)))
        self.assertLessEqual(difference.mean(), 0.25 / 255)
        self.assertLessEqual((difference > 3 / 255).any(axis=-1).mean(), 1e-3)

    def test_classical(self):
        picture = self.render(FIGURE, "a.png", "--no-medium", *SIZE, *SHOWN)
        self.compare(picture, "Figure1-a.png")

    def test_scattering(self):
        picture = self.render(FIGURE, "b.png", "--technique", "None", *SIZE, *SHOWN)
        self.compare(picture, "Figure1-b.png")

    def test_shadows(self):
        picture = self.render(FIGURE, "c.png", *SIZE, *SHOWN)
        self.compare(picture, "Figure1-c.png")

    def test_shadows_only_take_light_away(self):
        """Airlight, lit length and lit surfaces can only shrink; what the eye sees of the medium,
        its transmittance, stays."""
        for buffer, strict in (("Airlight", True), ("Surface", True), ("LitLength", True),
                               ("Transmittance", False)):
            without, shadowed = (
                self.render(FIGURE, "x.pfm", "--technique", technique, "--buffer", buffer, *SIZE)
                for technique in ("None", "ShadowPlanes"))
            with self.subTest(buffer=buffer):
                # A sum of parts may round above the whole.
                self.assertLessEqual((shadowed - without * (1 + 1e-4)).max(), 1e-6)
                if strict:
                    self.assertLess(shadowed.sum(), 0.97 * without.sum())
                else:
                    np.testing.assert_array_equal(shadowed, without)

    def test_same_frame_twice(self):
        first, second = (self.render(FIGURE, name, *SIZE) for name in ("1.pfm", "2.pfm"))
        np.testing.assert_array_equal(first, second)

    def test_animation(self):
        path = self.path("frame.png")
        self.succeed(FIGURE, "--frame", "10", "-o", path, *SIZE, program=ANIMATED_FOG)
        self.compare(read_png(path), "Figure1-frame10.png")

    def test_gallery(self):
        """The gallery's picture is this one at four times the size: the same light in each area."""
        path = self.path("use-animated-fog.png")
        self.succeed(FIGURE, "--frame", "30", "-o", path, "--size", "320x180",
                     program=ANIMATED_FOG)
        picture = read_png(path)
        large = read_png(os.path.join(SOURCE, "Documentation", "pictures", "use-animated-fog.png"))
        self.assertEqual(large.shape, (720, 1280, 3))
        np.testing.assert_allclose(picture.mean(), large.mean(), rtol=0.02)
        areas, expected = (image.reshape(18, image.shape[0] // 18, 32, -1, 3).mean(axis=(1, 3))
                           for image in (picture, large))
        self.assertLess(np.abs(areas - expected).max(), 0.04)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
