# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples of larger scenes: their numbers against geometry, sums over the data and closed
formulas, their pictures against the gallery."""

import re
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import airlight.display
from exampletest import SCENES, ExampleTest, load_example
from midpointrule import Grid, middles
from programtest import henyey_greenstein

SIZE = "320x180"


def numbers(text):
    return [float(value) for value in re.findall(r"\d+\.?\d*", text)]


class TestScenes(ExampleTest):
    def draw(self, name, size=SIZE):
        """The example as a module, and what it prints; its picture must be the gallery's."""
        with tempfile.TemporaryDirectory() as folder:
            picture = f"{folder}/use-{name.replace('_', '-')}.png"
            text = self.run_example(name + ".py", "-o", picture, "--size", size)
            print(text)
            self.compare_with_large(picture)
        return load_example(name), text

    def test_cathedral_shafts(self):
        scene, text = self.draw("cathedral_shafts")
        found, way, airlight_found = numbers(text)
        self.assertAlmostEqual(way, 2 * scene.HALF - 0.02, delta=0.005)
        to_sun = np.divide(scene.TO_SUN, np.linalg.norm(scene.TO_SUN))
        z = scene.FRONT - 2.5 * scene.BAY
        s = middles(way, 40000)
        points = np.stack((scene.HALF - 0.01 - s, np.full(len(s), 4.0), np.full(len(s), z)), axis=1)
        # Where the ray to the sun meets the middle, the inside and the outside of the wall: it must
        # be in a window there, and the bars must miss it.
        lit = np.ones(len(s), bool)
        for depth in np.linspace(0, scene.WALL, 91):
            t = (scene.HALF + depth - points[:, 0]) / to_sun[0]
            y, along = points[:, 1] + t * to_sun[1], points[:, 2] + t * to_sun[2]
            off = (along - z + scene.BAY / 2) % scene.BAY - scene.BAY / 2
            rise = scene.HEAD - scene.WINDOW_SPRING
            radius = (scene.WINDOW**2 + rise**2) / (2 * scene.WINDOW)
            above = np.hypot(np.abs(off) + radius - scene.WINDOW, y - scene.WINDOW_SPRING) < radius
            lit &= (np.abs(off) < scene.WINDOW) & (y > scene.SILL) & (
                (y < scene.WINDOW_SPRING) | above)
            middle = abs(depth - scene.WALL / 2)
            if middle < 0.07:
                lit &= np.abs(off) > 0.07
            if middle < 0.05:
                lit &= (np.abs(y - 6.2) > 0.05) & (np.abs(y - scene.WINDOW_SPRING) > 0.05)
        # The arch is a polygon, up to 4 mm inside its arc; steps across the wall are 1 cm.
        self.assertAlmostEqual(found, lit.sum() * way / len(s), delta=0.05)
        # The medium ends at the inner wall; light comes from the sun along the ray.
        inside = (scene.HALF - points[:, 0]) / to_sun[0]
        phase = henyey_greenstein(scene.ANISOTROPY, -to_sun[0])
        expected = (lit * scene.SUN[1] * scene.SCATTERING * phase
                    * np.exp(-scene.SCATTERING * (inside + s))).sum() * way / len(s)
        self.assertAlmostEqual(airlight_found, expected, delta=0.05 * expected + 1e-4)

    def test_ct_lit_through(self):
        scene, text = self.draw("ct_lit_through")
        volume, *depths = numbers(text.replace("cm^3", "cm"))
        _, units = scene.read_scan()
        # At least what is brighter than bone and not sharpened, at most what is so near to it.
        bright = units > 160
        near = bright.copy()
        for axis in range(3):
            for step in (-1, 1):
                near |= np.roll(bright, step, axis)
        self.assertTrue(np.count_nonzero(bright) < volume / 0.3**3 < np.count_nonzero(near), (
            volume, np.count_nonzero(bright), np.count_nonzero(near)))
        image = scene.make_tissue(*scene.read_scan()).GetDensityImage()
        density = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(
            image.GetDimensions()[::-1])
        grid = Grid(density, image.GetOrigin(), image.GetSpacing())
        end = image.GetBounds()[3]
        points = np.repeat([scene.LAMP], 20000, axis=0)
        points[:, 1] += middles(end - scene.LAMP[1], len(points))
        column = grid(points).mean() * (end - scene.LAMP[1])
        for found, absorption in zip(depths, scene.ABSORPTION, strict=True):
            self.assertAlmostEqual(found, column * (scene.SCATTERING + absorption), delta=2e-3)

    def test_cumulus(self):
        scene, text = self.draw("cumulus")
        density, _ = scene.make_cloud()
        # Columns of points instead of lines between them: the trapezium rule along y.
        columns = scene.EXTINCTION * scene.CELL * (
            density.sum(axis=1) - (density[:, 0] + density[:, -1]) / 2)
        largest, shaded = numbers(text)
        self.assertAlmostEqual(largest, columns.max(), delta=0.03 * columns.max())
        self.assertAlmostEqual(shaded, 100 * np.mean(columns > np.log(2)), delta=1.5)

    def test_flow_with_lamps(self):
        scene, text = self.draw("flow_with_lamps", "640x360")  # thin tubes
        speed, formula, circulation = numbers(text)
        # On the axis, the velocity is 2 A j1(k x)/x, with A such that the stream outside, which
        # slips along the sphere with 1.5 sin(angle), is as fast there. The line along the axis and
        # back over the sphere goes around half of the vortex.
        k = scene.WAVE
        self.assertAlmostEqual(np.tan(k), k, delta=1e-9)  # j1 is 0
        t = middles(k, 20000)
        axis = 2 * 1.5 / np.abs(np.sin(k)) * (np.sin(t) / t - np.cos(t)) / t**2 * k
        self.assertAlmostEqual(speed, axis[0], delta=2e-3)
        self.assertAlmostEqual(formula, axis[0], delta=2e-3)
        around = 2 * axis.mean() + 1.5 * np.sin(middles(np.pi, 20000)).mean() * np.pi
        self.assertAlmostEqual(circulation, around, delta=0.01 * around)

    def test_flow_is_a_solution(self):
        """The flow has no divergence; its vorticity is k times the velocity in the vortex, which
        makes it a steady solution of the Euler equations, and 0 outside."""
        scene = load_example("flow_with_lamps")
        points = np.random.default_rng(3).uniform(-1.5, 1.5, (2000, 3))
        r = np.linalg.norm(points, axis=1)
        points, step = points[np.abs(r - 1) > 0.01], 1e-4
        slopes = np.stack([(scene.flow(points + step * axis) - scene.flow(points - step * axis))
                           / (2 * step) for axis in np.eye(3)], axis=1)  # of axis, of component
        velocity = scene.flow(points)
        inside = np.linalg.norm(points, axis=1) < 1
        curl = np.stack([slopes[:, a, b] - slopes[:, b, a] for a, b in ((1, 2), (2, 0), (0, 1))], 1)
        self.assertLess(np.abs(np.trace(slopes, axis1=1, axis2=2)).max(), 1e-5)
        expected = np.where(inside[:, None], scene.WAVE * velocity, 0)
        self.assertLess(np.abs(curl - expected).max(), 1e-4)
        on_sphere = points / np.linalg.norm(points, axis=1)[:, None]
        jump = scene.flow(1.0000001 * on_sphere) - scene.flow(0.9999999 * on_sphere)
        self.assertLess(np.abs(jump).max(), 1e-5)

    def test_valley_fog(self):
        scene, text = self.draw("valley_fog")
        _, heights = scene.make_terrain()
        for found, height in zip(numbers(text), (heights.min(), heights.max()), strict=True):
            scale = scene.FOG_HEIGHT * scene.RAISED
            expected = scene.FOG * scale * np.exp(-(height - scene.FOG_BASE) / scale)
            self.assertAlmostEqual(found, expected, delta=6e-4)

    def test_options(self):
        """Sizes and numbers of frames that there are not."""
        for parse, good, value, bad in (
                (airlight.display.parse_size, "64x32", (64, 32), ("64", "0x32", "-1x2", "ax2", "")),
                (airlight.display.parse_frames, "64", 64, ("0", "-1", "2.5", "1025", "many"))):
            self.assertEqual(parse(good), value)
            for text in bad:
                with self.assertRaisesRegex(Exception, f"'{text}' is no"):
                    parse(text)

    @classmethod
    def tearDownClass(cls):
        missing = {name + ".py" for name in SCENES} - cls.ran
        if missing:
            raise AssertionError(f"not run: {missing}")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
