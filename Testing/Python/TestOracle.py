# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pass and the reference against the oracle, which shares no code with them (Testing/Oracle)."""

import os
import sys
import unittest

import numpy as np

import oraclescene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Oracle"))
import scenes  # noqa: E402
import tracer  # noqa: E402

SIZE = (24, 18)
NUMBERS = np.arange(2, SIZE[0] * SIZE[1], 5)
MIDDLES = np.stack([NUMBERS % SIZE[0] + 0.5, NUMBERS // SIZE[0] + 0.5], axis=1)
BUFFERS = ("Airlight", "Surface", "Transmittance", "Radiance", "Depth")


def allowed(expected, airlight, shares):
    """How far buffers may be off; airlight: as an absolute number, the others as shares."""
    surface = shares["Surface"] * expected["Surface"] + 1e-12 * np.max(expected["Surface"])
    depth = shares["Depth"] * np.abs(expected["Depth"])
    return {"Airlight": airlight, "Surface": surface, "Radiance": airlight + surface,
            "Transmittance": shares["Transmittance"], "Depth": depth}


class TestOracle(unittest.TestCase):
    def check(self, scene, image_share=1e-5):
        expected = tracer.trace(scene, SIZE, MIDDLES)
        steady = tracer.steady(scene, SIZE, MIDDLES)
        self.assertGreater(np.mean(steady), 0.95)  # what is compared is nearly all
        for values in expected.values():
            self.assertTrue(np.all(np.isfinite(values)))
        library = oraclescene.LibraryScene(scene, SIZE)
        computed = library.compute(BUFFERS)
        drawn = library.draw((*BUFFERS, "ErrorBound"))
        image = any(medium.GetDensityImage() for medium in library.media)
        fit = library.phase_error()
        unshadowed = expected["Unshadowed"] + 1e-9 * np.max(expected["Unshadowed"])

        # Documentation/accuracy.md and the contract of vtkAirlight::Inscatter().
        share = image_share if image else 1e-6 if scene["by_quadrature"] else 1e-9
        self.compare(scene["name"] + ", reference", computed, expected, steady, allowed(
            expected, (fit + share) * unshadowed,
            {"Surface": 1e-12, "Transmittance": 1e-12, "Depth": 1e-12}))

        # That of "ErrorBound", and the share of the unshadowed airlight in each channel. Densities
        # from images have the first alone.
        bound = drawn["ErrorBound"][NUMBERS]
        share = 1e-3 if scene["by_quadrature"] else 1e-4
        airlight = bound if image else np.minimum((fit + share) * unshadowed, bound)
        self.compare(scene["name"] + ", pass", drawn, expected, steady, allowed(
            expected, airlight, {"Surface": 2e-5, "Transmittance": 1e-5, "Depth": 1e-5}))

    def compare(self, name, found, expected, steady, most):
        report = []
        for buffer in BUFFERS:
            limit = np.broadcast_to(most[buffer], expected[buffer].shape)[steady]
            error = np.abs(found[buffer][NUMBERS] - expected[buffer])[steady]
            share = np.max(error / (limit + 1e-30)) if np.all(np.isfinite(error)) else np.inf
            report.append(f"{buffer} {share:.1e}")
            with self.subTest(scene=name, buffer=buffer):
                self.assertLessEqual(share, 1)
        print(f"{name}: errors as shares of what is allowed: {', '.join(report)}", flush=True)

    def test_closed_forms(self):
        for scene in scenes.closed_forms():
            self.check(scene)

    def test_sums(self):
        for scene in scenes.sums():
            self.check(scene)

    def test_by_quadrature(self):
        for scene in scenes.by_quadrature():
            self.check(scene)

    def test_cut_image(self):
        """Its own region cuts the image: the way to the sun has kinks that quadrature is not cut at."""
        self.check(scenes.cut_image(), 5e-5)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
