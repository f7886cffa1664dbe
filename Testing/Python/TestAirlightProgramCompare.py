# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""`airlight compare`: metrics, difference pictures and profiles.

Run it like TestAirlightProgram.py.
"""

import json
import unittest

import numpy as np

from programtest import ProgramTest, metrics, read_pfm, read_png, reference_file, write_pfm


class TestCompare(ProgramTest):
    def test_agrees_with_the_judge(self):
        random = np.random.default_rng(1)
        total = read_pfm(reference_file("S3_ground_occluders", "total"))
        mask = reference_file("S3_ground_occluders", "shadowmask")
        noisy = total * random.normal(1.01, 0.05, total.shape) + 1e-4
        broken = noisy.copy()
        broken[3, 4, 1] = np.nan
        broken[70:72, 80] = np.inf
        depth = reference_file("S3_ground_occluders", "depth")
        black = self.path("black.pfm")
        write_pfm(black, np.zeros_like(total))
        reference = reference_file("S3_ground_occluders", "total")
        for picture, other, options in (
                (noisy, reference, []), (noisy, reference, ["--mask", mask]),
                (broken, reference, []), (broken, reference, ["--mask", mask]),
                (read_pfm(depth) + 0.1, depth, []), (noisy, black, [])):
            picture_file = self.path("picture.pfm")
            write_pfm(picture_file, picture)
            printed = self.succeed("compare", picture_file, other, *options, "--json")
            scores = json.loads(printed)
            expected = metrics(read_pfm(picture_file), read_pfm(other),
                               read_pfm(mask) if options else None)
            self.assertEqual(list(scores), list(expected) + ["PSNR"])
            for name, value in expected.items():
                self.assertLessEqual(abs(scores[name] - value), 1e-9 * abs(value), name)
            line = self.succeed("compare", picture_file, other, *options).strip()
            psnr = -np.inf if scores["PSNR"] is None else scores["PSNR"]
            self.assertEqual(psnr == -np.inf, other == black)
            self.assertEqual(line, " ".join(
                f"{k}={v:.4g}" if isinstance(v, float) else f"{k}={v}"
                for k, v in [*expected.items(), ("PSNR", psnr)]))

    def test_difference(self):
        a = np.array([[[0.5, 1.0, 2.0], [3.0, 4.0, 5.0]]])
        b = np.array([[[1.0, 1.0, 1.0], [3.5, 2.0, 5.0]]])
        names = self.path("a.pfm"), self.path("b.pfm")
        for name, image in zip(names, (a, b)):
            write_pfm(name, image)
        for suffix in (".pfm", ".png"):
            self.succeed("compare", *names, "--difference", self.path("d" + suffix))
        np.testing.assert_array_equal(read_pfm(self.path("d.pfm")), a - b)
        # The largest difference, 2, is white; 0 is grey.
        np.testing.assert_allclose(read_png(self.path("d.png")), 0.5 + (a - b) / 4, atol=1 / 255)

    def test_profile(self):
        # Two rows: the lower has a red ramp from 0 to 1, the upper is the same in both pictures.
        # A is twice B in the lower row.
        b = np.zeros((2, 50, 3))
        b[0] = 0.2
        b[1, :, 0] = np.linspace(0, 1, 50)
        a = b * [[[1]], [[2]]]
        names = self.path("a.pfm"), self.path("b.pfm")
        for name, image in zip(names, (a, b)):
            write_pfm(name, image)
        plots = []
        for row in ("0", "1"):
            plots.append(self.path(row + ".png"))
            self.succeed("compare", *names, "--profile", row, "-o", plots[-1])
        lower, upper = (read_png(plot) for plot in plots)
        self.assertEqual(lower.shape, (600, 960, 3))

        def count_red(picture, part):
            colour = picture[part]
            return ((colour[..., 0] - colour[..., 1:].max(-1)) > 0.2).sum()
        # The line of A rises to the upper right corner of the plot, that of B to its middle; one
        # grey line stands for all channels of the upper row.
        self.assertGreater(count_red(lower, np.s_[40:300, 500:760]), 500)
        self.assertEqual(count_red(lower, np.s_[100:300, 120:300]), 0)
        self.assertEqual(count_red(upper, np.s_[:]), 0)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
