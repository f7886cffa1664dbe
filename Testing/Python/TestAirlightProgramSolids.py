# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models without polygons, and the colours of measurements.

Run it like TestAirlightProgram.py.
"""

import unittest

import numpy as np

from programtest import ProgramTest

CLEAR = ("--visibility", "1e6", "--ambient", "0,0,0", "--sun", "0,0,1:3", "--size", "96x72")
ALBEDO = 0.7
TUBE = 0.003  # radius, in diagonals of the box around all points


def decode(colour):
    """Linear, of sRGB from 0 to 1."""
    colour = np.asarray(colour)
    return np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055)**2.4)


def cloud(points, **properties):
    """A PLY file of points, with these arrays of more numbers of each."""
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property float {name}" for name in "xyz"]
    lines += [f"property {'uchar' if values.dtype == np.uint8 else 'float'} {name}"
              for name, values in properties.items()]
    rows = zip(*np.transpose(points), *properties.values())
    return "\n".join(lines + ["end_header"] + [" ".join(map(str, row)) for row in rows]) + "\n"


class TestSolids(ProgramTest):
    def draw(self, model, buffer, camera, *more):
        return self.render(model, "a.pfm", *CLEAR, "--buffer", buffer, "--camera", camera, *more)

    def test_lines(self):
        """A line is a tube, also where it stands still or turns a corner."""
        for cells in ("l 1 2 3\n", "l 1 2\nl 2 3\n", "l 1 1 2 2 3 3\n"):
            model = self.write("a.obj", "v 0 0 0\nv 3 0 0\nv 3 4 0\n" + cells)
            radius = 5 * TUBE
            for x, y, axis in ((1.5, 0, 0), (3, 2, 1)):
                depth = self.draw(model, "Depth", f"{x},{y},9:{x},{y},0:0.5")
                hit = depth > 0
                across = hit.sum(axis=axis)
                pixel = 2 * 9 * np.tan(np.radians(0.25)) / 72
                # Polygons of 8 corners on the circle.
                self.assertLessEqual(across.max(), 2 * radius / pixel + 1, cells)
                self.assertGreaterEqual(across.min(), 2 * 0.92 * radius / pixel - 2, cells)
                self.assertAlmostEqual(depth[36, 48], 9 - radius, delta=0.1 * radius)
            empty = self.draw(model, "Depth", "1,2,9:1,2,0:5")
            self.assertLess(empty.max(), 0)

    def test_points(self):
        """Points are beads in their colours; nothing is between them."""
        places = [(-1, -1, 0), (1, -1, 0), (-1, 1, 0), (1, 1, 0)]
        colours = np.array([(255, 0, 0), (0, 255, 0), (0, 0, 255), (200, 100, 50)], np.uint8)
        red, green, blue = colours.T
        model = self.write("a.ply", cloud(places, red=red, green=green, blue=blue))
        for (x, y, _), colour in zip(places, colours / 255):
            seen = self.draw(model, "Surface", f"{x},{y},9:{x},{y},0:0.5")[36, 48]
            np.testing.assert_allclose(seen / seen.max(), decode(colour) / decode(colour).max(),
                                       atol=0.02)
            self.assertGreater(seen.max(), 0.5 * decode(colour).max() * 3 / np.pi)
        light = self.draw(model, "Surface", "0,0,9:0,0,0:24")
        self.assertEqual(light[30:42].max(), 0)
        self.assertGreater(light[:36, :48, 2].max(), 0.5)

    def test_scan(self):
        """Points with normals are shaded as the surface that they are on, with others as beads."""
        x, y = (values.ravel() for values in np.meshgrid(*2 * [np.linspace(-1, 1, 61)]))
        points = np.transpose([x, y, 0 * x])
        shades = []
        for normals in (dict(nx=0 * x + 0.6, ny=0 * x, nz=0 * x + 0.8), {}):
            model = self.write("a.ply", cloud(points, **normals))
            light = self.draw(model, "Surface", "0,0,9:0,0,0:9", "--technique", "None")
            light = light[8:-8, 20:-20, 0]
            shades.append(light)
        np.testing.assert_allclose(shades[0][shades[0] > 0], 0.8 * ALBEDO * 3 / np.pi, rtol=0.01)
        self.assertGreater((shades[0] > 0).mean(), 0.6)
        self.assertGreater(shades[1][shades[1] > 0].std(), 0.03)

    def test_measurements(self):
        """Numbers of points are colours from cool to warm, unless all are the same."""
        for low, high in ((0, 1), (-300, 500), (7, 7)):
            model = self.write(
                "a.vtk", "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
                "-1 -1 0 1 -1 0 1 1 0 -1 1 0\nPOLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 4\n"
                f"SCALARS t float 1\nLOOKUP_TABLE default\n{low} {high} {high} {low}\n")
            light = self.draw(model, "Surface", "0,0,9:0,0,0:9") / (3 / np.pi)
            ends = light[36, 3], light[36, -4]
            expected = [decode((0.230, 0.299, 0.754)), decode((0.706, 0.016, 0.150))]
            for seen, colour in zip(ends, expected if low < high else 2 * [[ALBEDO] * 3]):
                np.testing.assert_allclose(seen, colour, atol=0.05)

    def test_nothing(self):
        empty = self.write("a.obj", "# nothing\n")
        self.fail_with([empty, "no polygons, lines or points"], "render", empty, "-o",
                       self.path("a.png"))
        lines = self.write("b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n")
        self.fail_with(["--surface", lines, "no polygons"], "render", self.path("b.obj"),
                       "--surface", lines, "-o", self.path("a.png"))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
