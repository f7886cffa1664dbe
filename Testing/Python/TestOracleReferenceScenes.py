# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the reference scenes, made again by Testing/Oracle/reference_scene.py."""

import os
import sys
import tempfile
import unittest

import numpy as np

TESTING = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
DATA = os.path.join(TESTING, "Data", "Reference")
sys.path[:0] = [os.path.join(TESTING, "Oracle"), DATA]
import reference_scene  # noqa: E402
from compare import read_pfm  # noqa: E402


def kept(name, part):
    """[pixels, channels], the lowest row first."""
    values = read_pfm(os.path.join(DATA, "ref", f"{name}.{part}.pfm"))[::-1]
    return values.reshape(-1, values.shape[-1])


class TestOracleReferenceScenes(unittest.TestCase):
    def check(self, name):
        scene, size = reference_scene.read_scene(os.path.join(DATA, "scenes", name + ".json"))
        chosen = np.arange(13, size[0] * size[1], 37)
        places = reference_scene.middles(*size)[chosen]
        picture = reference_scene.trace(scene, size, places)
        stable = kept(name, "mask")[chosen, 0] > 0.5
        for part, buffer in (*reference_scene.COLOURS.items(), ("depth", "Depth")):
            found, expected = picture[buffer][stable], kept(name, part)[chosen][stable]
            # The files hold single precision; what is dark must be dark.
            floor = 1e-3 * np.max(np.abs(expected)) + 1e-30
            error = np.abs(found - expected) / np.maximum(np.abs(expected), floor)
            print(f"{name}, {part}: largest error {np.max(error):.1e}")
            with self.subTest(scene=name, part=part):
                self.assertLessEqual(np.max(error), 1e-7)
        mask = reference_scene.stable(scene, size, places, picture)
        self.compare_masks(name, "mask", mask, stable)
        if scene["surfaces"]:
            shadowed = reference_scene.shadowed(picture, stable)
            expected = kept(name, "shadowmask")[chosen, 0] > 0.5
            self.compare_masks(name, "shadowmask", shadowed, expected)

    def compare_masks(self, name, part, found, expected):
        alike = np.mean(found == expected)
        print(f"{name}, {part}: {100 * alike:.2f} % alike")
        with self.subTest(scene=name, part=part):
            self.assertGreaterEqual(alike, 0.998)  # one pixel may be at the rule's very limit

    def test_isotropic(self):
        self.check("S1_point_iso")

    def test_forward_scattering(self):
        self.check("S2_point_hg_pos06")

    def test_shadows(self):
        self.check("S3_ground_occluders")

    def test_spot(self):
        self.check("S5_spot_slats")

    def test_sun(self):
        self.check("S6_sun_window")

    def test_files(self):
        """A picture that is written is read back as it is."""
        values = np.arange(24.0).reshape(8, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.pfm")
            reference_scene.write_pfm(path, values, (4, 2))
            np.testing.assert_array_equal(read_pfm(path)[::-1].reshape(8, 3), values)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
