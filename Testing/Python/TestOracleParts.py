# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the oracle (Testing/Oracle) against sums of many samples and known numbers."""

import math
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Oracle"))
import lights  # noqa: E402
import media  # noqa: E402
import meshes  # noqa: E402
import phase  # noqa: E402
import quadrature  # noqa: E402
import regions  # noqa: E402
import scenes  # noqa: E402
import shadows  # noqa: E402
import tracer  # noqa: E402


def cornette_shanks_mean(g):
    return 3 * g * (4 + g**2) / (5 * (2 + g**2))


def draine_mean(g, alpha):
    return g * (1 + alpha * (3 + 2 * g**2) / 5) / (1 + alpha * (1 + 2 * g**2) / 3)


def schlick_mean(k):
    return 1 / k - (1 - k**2) / (2 * k**2) * math.log((1 + k) / (1 - k))


def holds(region, points):
    """Which points are inside a region, from its description; a mesh is convex here."""
    if region["type"] == "box":
        return np.all((points > region["min"]) & (points < region["max"]), axis=1)
    if region["type"] == "sphere":
        return np.sum((points - region["center"])**2, axis=1) < region["radius"]**2
    if region["type"] == "cylinder":
        axis = np.array(region["axis"]) / np.linalg.norm(region["axis"])
        from_center = points - region["center"]
        aside = np.linalg.norm(np.cross(from_center, axis), axis=1)
        return (np.abs(from_center @ axis) < region["height"] / 2) & (aside < region["radius"])
    a, b, c = np.moveaxis(np.array(region["points"])[np.array(region["faces"])], 1, 0)
    normals = np.cross(b - a, c - a)
    return np.all(points @ normals.T < np.sum(a * normals, axis=1), axis=1)


class TestOracleParts(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(26)

    def lines(self, count, spread=3.0):
        """Origins and unit directions of lines that cross the scenes."""
        origins = self.random.normal(size=(count, 3)) * spread
        ways = self.random.normal(size=(count, 3)) - origins
        return origins, ways / np.linalg.norm(ways, axis=1)[:, None]

    def test_phase_functions(self):
        """Each is 1 over the sphere and has the mean cosine of its formula."""
        node, weight = np.polynomial.legendre.leggauss(400)
        for description, mean in (
                ({"type": "isotropic"}, 0), ({"type": "rayleigh"}, 0),
                (scenes.with_g("henyey_greenstein", 0.7), 0.7),
                (scenes.with_g("henyey_greenstein", -0.4), -0.4),
                (scenes.with_g("cornette_shanks", 0.4), cornette_shanks_mean(0.4)),
                (scenes.with_g("schlick", 0.5), schlick_mean(0.5)),
                (scenes.draine(0.6, 5), draine_mean(0.6, 5)),
                ({"type": "mie_hazy"}, 4.5 * (2 / 10 - 1 / 9)),
                ({"type": "mie_murky"}, 16.5 * (2 / 34 - 1 / 33)),
                (scenes.table(0.4), None)):
            values = 2 * np.pi * weight * phase.make(description)(node)
            with self.subTest(description["type"]):
                self.assertAlmostEqual(values.sum(), 1, delta=1e-8)
                if mean is not None:
                    self.assertAlmostEqual(values @ node, mean, delta=1e-9)

    def test_regions(self):
        """A point of a line is inside where a part of the line is."""
        origins, ways = self.lines(60)
        t = np.linspace(0, 12, 1001)[1:-1]  # not the very ends
        for region in (scenes.BOX, scenes.BALL, scenes.BARREL, scenes.closed_mesh()):
            starts, ends = regions.make(region).inside(origins, ways, np.full(len(origins), 12.0))
            inside = np.any((t[:, None, None] > starts) & (t[:, None, None] < ends), axis=2)
            points = origins + t[:, None, None] * ways
            expected = holds(region, points.reshape(-1, 3)).reshape(inside.shape)
            with self.subTest(region=region["type"]):
                self.assertGreater(np.mean(expected), 0.02)
                np.testing.assert_array_equal(inside, expected)

    def test_columns(self):
        """The integral of the density along a line is that of its samples."""
        origins, ways = self.lines(40)
        lengths = self.random.uniform(2, 9, len(origins))
        share = (np.arange(4000) + 0.5) / 4000
        for region in ({"type": "everywhere"}, scenes.BOX, scenes.BALL, scenes.BARREL,
                       scenes.closed_mesh()):
            for density in ({"type": "uniform"}, scenes.height_fog(1.3, 0.2, (0.1, 1, 0.3)),
                            scenes.cloud()):
                medium = media.Medium(scenes.grey(region=region, density=density))
                found = medium.column(origins, ways, lengths)
                self.assertGreaterEqual(np.sum(found > 0), 10)
                for origin, way, length, column in zip(origins, ways, lengths, found):
                    points = origin + (share * length)[:, None] * way
                    samples = medium.density_at(points, np.broadcast_to(way, points.shape))
                    most = np.max(samples, initial=0)
                    # Midpoints: an end of the medium may lie anywhere between two.
                    with self.subTest(region=region["type"], density=density["type"]):
                        self.assertAlmostEqual(column, samples.mean() * length,
                                               delta=2 * most * length / 4000 + 1e-12)

    def test_column_to_infinity(self):
        medium = media.Medium(scenes.grey(density=scenes.height_fog(2.0)))
        up = medium.column(np.zeros((1, 3)), np.array([[0.0, 1, 0]]), np.array([np.inf]))
        self.assertAlmostEqual(up[0], 2.0, delta=1e-12)
        down = medium.column(np.zeros((1, 3)), np.array([[0.0, -1, 0]]), np.array([np.inf]))
        self.assertEqual(down[0], np.inf)

    def test_shadows(self):
        """The parts of rays in shadow are those whose samples a triangle hides from the light."""
        surfaces = tracer.Surfaces(scenes.BODY)
        origins, ways = self.lines(60)
        hidden_somewhere = 0
        for source in (scenes.POINT, scenes.SUN):
            light = lights.make(source)
            for origin, way in zip(origins, ways):
                parts = shadows.hidden(light, origin, way, surfaces.triangles)
                t = np.linspace(0, 12, 1001)[1:]
                dark = ~shadows.is_lit(light, origin + t[:, None] * way, surfaces.triangles)
                inside = np.any((t[:, None] > parts[:, 0]) & (t[:, None] < parts[:, 1]), axis=1)
                np.testing.assert_array_equal(inside, dark)
                hidden_somewhere += np.any(dark) and not np.all(dark)
        self.assertGreater(hidden_somewhere, 20)

    def test_quadrature(self):
        """Smooth, with a kink, with an infinite slope, and 1e-9 wide."""
        cases = ((np.exp, math.e - 1), (lambda x: np.abs(x - 0.3), 0.29),
                 (lambda x: np.sqrt(x), 2 / 3),
                 (lambda x: 1e-9 / (x**2 + 1e-18), math.atan(1e9)))
        found = quadrature.integrate(
            lambda group, x: np.choose(group, [case(x) for case, _ in cases])[:, None],
            np.arange(4), np.zeros(4), np.ones(4), 4, 1e-8, 1)
        np.testing.assert_allclose(found[:, 0], [value for _, value in cases], rtol=1e-8)

    def test_quadrature_that_does_not_converge(self):
        noise = np.random.default_rng(1)
        with self.assertRaises(quadrature.NotConverged):
            quadrature.HALVINGS, kept = 8, quadrature.HALVINGS
            try:
                quadrature.integrate(lambda group, x: noise.uniform(size=(len(x), 1)), [0], [0.0],
                                     [1.0], 1, 1e-8, 1)
            finally:
                quadrature.HALVINGS = kept

    def test_meshes(self):
        """Closed: each edge is that of two triangles, in opposite directions."""
        for points, faces in (meshes.box((0, 0, 0), (1, 2, 3)), meshes.ball((1, 2, 3), 2, 2)):
            edges = [(f[i], f[(i + 1) % 3]) for f in np.array(faces).tolist() for i in range(3)]
            self.assertEqual(len(set(edges)), len(edges))
            self.assertEqual({(b, a) for a, b in edges}, set(edges))
            corners = np.array(points)[np.array(faces)]
            volume = np.einsum("ni,ni->n", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
            self.assertGreater(volume.sum(), 0)  # they face outwards


if __name__ == "__main__":
    unittest.main(argv=[__file__])
