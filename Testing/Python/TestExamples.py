# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the programs of Examples/Python and looks at what they print and write."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import airlight
from exampletest import EXAMPLES, GALLERY, SCENES, USES, ExampleTest, load_example
from midpointrule import Grid, box_interval, lamp_airlight, middles, sunlit_airlight
from programtest import metrics, pixel_rays, read_png

WRITE_OPENVDB = os.environ.get("AIRLIGHT_WRITE_OPENVDB")


PLATE = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
-0.5 0 -0.5
0.5 0 -0.5
0.5 0 0.5
-0.5 0 0.5
3 0 1 2
3 0 2 3
"""


def project(point, eye, focal_point, size, angle=30.0):
    """The row from the top and the column of the pixel that sees a point; up is y."""
    camera = {"position": eye, "focal_point": focal_point, "view_up": (0, 1, 0),
              "view_angle_deg": angle}
    rays = pixel_rays(camera, *size)
    towards = np.subtract(point, eye)
    nearest = (rays @ (towards / np.linalg.norm(towards))).argmax()
    return np.unravel_index(nearest, rays.shape[:2])


class TestExamples(ExampleTest):
    def test_fog_to_numpy(self):
        with tempfile.TemporaryDirectory() as folder:
            text = self.run_example("fog_to_numpy.py", folder + "/fog.npz")
            arrays = dict(np.load(folder + "/fog.npz"))
        # A ball of radius 0.5 seen from 5 away, in a view of 30 degrees that is 4 : 3: the tangent
        # of its half angle is 0.5/sqrt(25 - 0.25), that of the view's tan(15 degrees).
        radius = 0.5 / np.sqrt(24.75) / np.tan(np.radians(15)) * 120
        covered = np.pi * radius**2 / (320 * 240)
        # The ball is a polyhedron of eight sides a turn, which covers less than the round one.
        share = float(re.search(r"covers ([\d.]+)%", text).group(1)) / 100
        self.assertTrue(0.8 * covered < share < covered, text)
        self.assertEqual(arrays["Radiance"].shape, (240, 320, 3))
        # All light is the fog's but the ball's own.
        sky = arrays["Depth"][..., 0] < 0
        np.testing.assert_allclose(arrays["Airlight"][sky], arrays["Radiance"][sky], rtol=1e-6)
        self.assertGreater(arrays["Radiance"].min(), 0)

    def test_compare_arrays(self):
        text = self.run_example("compare_arrays.py")
        scores = dict(re.findall(r"^(\w+) +([-\d.e]+)$", text, re.MULTILINE))
        # 1 % of the mean of 0.55; noise of 1e-3 in 9216 samples changes the mean by 1e-5.
        self.assertAlmostEqual(float(scores["bias"]), 0.01, delta=1e-4)
        self.assertEqual(int(scores["pixels"]), 64 * 48)
        with tempfile.TemporaryDirectory() as folder:
            for name, value in (("a", 3.0), ("b", 2.0)):
                np.save(f"{folder}/{name}.npy", np.full((4, 5, 1), value))
            text = self.run_example("compare_arrays.py", folder + "/a.npy", folder + "/b.npy")
        self.assertRegex(text, r"median +0.5\n")
        self.assertIn("channel: [1.]", text)

    @unittest.skipUnless(WRITE_OPENVDB, "built without OpenVDB")
    def test_openvdb_to_numpy(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([WRITE_OPENVDB, folder + "/"], check=True, timeout=60)
            text = self.run_example("openvdb_to_numpy.py", folder + "/tiles.vdb")
            self.assertIn("tiles: 67 x 34 x 18 points, 0 to 2\n", text)
            # 16 voxels of 1 and of density 2.
            self.assertIn("third axis: 32\n", text)
            text = self.run_example("openvdb_to_numpy.py", folder + "/names.vdb", "shared")
            self.assertIn("grid 'twin[1]' of float\n", text)
            self.assertIn("third axis: 10\n", text)

    def test_shadow_planes(self):
        with tempfile.TemporaryDirectory() as folder:
            model, output = folder + "/plate.ply", folder + "/planes.png"
            pathlib.Path(model).write_text(PLATE)
            text = self.run_example("shadow_planes.py", model, "-o", output)
            picture = read_png(output)
        # The plate's shadow lies on the floor alone: a plane for each of its sides, and a far cap
        # for each of its triangles.
        self.assertEqual(text, "6 polygons\n")
        # The lamp is at (-0.9, 0.9, 0.3), the floor at -0.35: the shadow of the plate's middle is
        # 1.25/0.9 times as far from the lamp as the middle itself, and not behind the plate.
        view = ((1.3, 1.5, 4.8), (0.35, 0.14, 0), picture.shape[1::-1])
        shade = picture[project((0.35, -0.35, -0.117), *view)]
        floor = picture[project((-1, -0.35, 1), *view)]
        np.testing.assert_allclose(floor, (0.75, 0.75, 0.78), atol=0.01)
        # The caps' own colour under two planes that let 94 % through.
        np.testing.assert_allclose(shade, (0.25, 0.25, 0.3), atol=0.08)

    def test_scattering_orders(self):
        """Multiple scattering is nearer to all light than one scattering, and the rows are drawn."""
        with tempfile.TemporaryDirectory() as folder:
            text = self.run_example("scattering_orders.py", "-o", folder + "/orders.png", "--size",
                                    "24x18", "--seconds", "2", "--frames", "1")
            self.assertEqual(read_png(folder + "/orders.png").shape[:2], (54, 72))
        rows = re.findall(r"(\w+): of all light, scattered once (\S+), multiple scattering (\S+)",
                          text)
        self.assertEqual([row[0] for row in rows], ["fog", "smoke", "milk"])
        for name, once, multiple in rows:
            self.assertLess(abs(float(multiple) - 1), 0.4, name)
            self.assertLess(float(once), 0.9, name)
            self.assertGreater(float(multiple), float(once), name)

    def test_lit_intervals(self):
        with tempfile.TemporaryDirectory() as folder:
            text = self.run_example("lit_intervals_to_numpy.py", folder + "/lit.npz")
            arrays = dict(np.load(folder + "/lit.npz"))
        found = [line.split() for line in text.splitlines() if line.startswith("line")]
        eye, lamp, length, count = np.array((-6, 1.7, 3)), np.array((0, 3, -4)), 14, 40000
        self.assertEqual(len(found), 4)
        for line, angle in enumerate(np.radians((-14, 0, 14, 24))):
            points = eye + middles(length, count)[:, None] * (np.cos(angle), 0, -np.sin(angle))
            lit = np.ones(count, bool)
            for x in (-3, -1, 1, 3):  # dark is what a pillar hides from the lamp, inside it or not
                enter, leave = box_interval((x - 0.25, x + 0.25, 0, 5, -1.25, -0.75), points,
                                            lamp - points)
                lit &= (enter >= leave) | (enter > 1)
            radiance = lamp_airlight(points, eye, lamp, (40, 36, 30), 0.08, 0.1, lit)
            parts = arrays["SourceCell"] == line
            edges = np.count_nonzero(np.diff(np.pad(lit, 1).astype(int)))
            self.assertEqual(2 * parts.sum(), edges, line)
            self.assertGreater(edges, 4, "the pillars cut each line")
            # Each edge is found to half a sample.
            step = length / count
            self.assertAlmostEqual(float(found[line][2]), lit.sum() * step, delta=edges * step)
            expected = radiance * step
            printed = [float(value) for value in found[line][10:13]]
            np.testing.assert_allclose(printed, expected, rtol=1e-3)
            np.testing.assert_allclose(arrays["Airlight"][parts].sum(axis=0), expected, rtol=1e-3)

    def test_sensors_on_floor(self):
        with tempfile.TemporaryDirectory() as folder:
            text = self.run_example("sensors_on_floor.py", folder + "/floor.npz")
            arrays = dict(np.load(folder + "/floor.npz"))
        position, lamp, eye = arrays["Position"], np.array((0, 2.5, 0)), np.array((0, 1.7, 6))
        power = np.array((40, 36, 30))
        # From 2.5 high a table of half widths 1 and 0.6 at 0.75 shades 2.5/1.75 of them: of the
        # sensors, 0.25 apart, those to 1.25 and 0.75.
        shaded = np.logical_and(*(np.abs(position[..., i]) < half * 2.5 / 1.75
                                  for i, half in ((0, 1), (2, 0.6))))
        self.assertEqual(shaded.sum(), 11 * 7)
        self.assertIn("77 of 1089 sensors are in the table's shadow", text)
        r = np.linalg.norm(position - lamp, axis=-1)
        direct = np.where(shaded, 0, 2.5 / r**3 * np.exp(-0.2 * r))[..., None] * power
        np.testing.assert_allclose(arrays["DirectIrradiance"], direct, rtol=1e-6)
        self.assertIn(f"up to {direct.max():.4f}, mean {direct.mean():.4f} W/m^2", text)
        distance = np.linalg.norm(position - eye, axis=-1)
        np.testing.assert_allclose(arrays["Transmittance"][..., 0], np.exp(-0.2 * distance), 1e-6)

        # The smoke before each sensor, lit where the lamp is not behind the table.
        count = 2000
        points = eye + middles(np.ones(r.shape), count)[..., None] * (position - eye)[..., None, :]
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (0.75 - points[..., 1]) / (2.5 - points[..., 1])
        x, z = (points[..., i] * (1 - share) for i in (0, 2))
        lit = (share < 0) | (np.abs(x) > 1) | (np.abs(z) > 0.6)
        radiance = lamp_airlight(points, eye, lamp, power, 0.15, 0.2, lit)
        radiance *= (distance / count)[..., None]
        np.testing.assert_allclose(arrays["Radiance"], radiance, rtol=2e-3)
        seen = 0.5 / np.pi * (direct + arrays["ScatteredIrradiance"]) * arrays["Transmittance"]
        contrast = seen / (seen + radiance)
        printed = [float(value) for value in re.findall(r"contrast.* ([\d.]+) to ([\d.]+),.* "
                                                        r"([\d.]+)\n", text)[0]]
        np.testing.assert_allclose(
            printed, (contrast.min(), contrast.max(), contrast[shaded].max()), atol=2e-3)

    def test_fire_visibility(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = folder + "/use-fire-visibility.png"
            text = self.run_example("fire_visibility.py", "-o", picture, "--csv",
                                    folder + "/map.csv")
            self.compare_with_gallery(picture)
            rows = np.genfromtxt(folder + "/map.csv", delimiter=",", names=True)
        print(text)
        sys.path.insert(0, str(EXAMPLES))
        self.addCleanup(sys.path.remove, str(EXAMPLES))
        example = load_example("fire_visibility")
        self.ran.add("fire_smoke.py")
        image = example.solve_plume(135.0)
        samples = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
        density = Grid(samples.reshape(image.GetDimensions()[::-1]), (0, 0, 0), image.GetSpacing())
        self.assertEqual(len(rows), 25 * 15)

        # The mean extinction by its definition.
        eyes = np.column_stack([rows["x"], rows["y"], np.full(len(rows), 1.6)])
        points = eyes[:, None] + middles(np.ones(len(rows)), 4000)[..., None] * (
            np.array(example.SIGN) - eyes)[:, None]
        extinction = 8700 * density(points).mean(axis=1)
        np.testing.assert_allclose(rows["mean_extinction"], extinction, rtol=1e-4)
        for name, constant in (("reflecting", 3), ("emitting", 8)):
            np.testing.assert_allclose(rows["visibility_" + name],
                                       np.minimum(constant / extinction, 50), rtol=1e-4)
        seen = rows["in_sight"] > 0
        counts = (seen.sum(), len(rows), np.sum(seen & (
            8 / extinction >= np.minimum(rows["distance"], 50))))
        self.assertIn("{} of {} points have the sign in sight, {} can read it".format(*counts), text)

        # Letters that shine keep their contrast but for airlight, which ends it where Jin found.
        self.assertTrue(np.all(rows["contrast"] < rows["contrast_without_airlight"]))
        self.assertTrue(np.all(rows["contrast_without_airlight"] > 0.99))
        near = seen & (np.abs(np.log(rows["contrast"] / 0.01)) < 0.7)
        depth = np.median((extinction * rows["distance"])[near])
        self.assertIn(f"extinction times distance {depth:.1f} ", text)
        self.assertTrue(5 < depth < 10, depth)

    def read_density(self, path):
        reader = airlight.vtkOpenVDBDensityReader()
        reader.SetFileName(path)
        reader.Update()
        image = reader.GetOutput()
        samples = vtk_to_numpy(image.GetPointData().GetScalars())
        samples = samples.reshape(image.GetDimensions()[::-1]).astype(float)
        return Grid(samples, image.GetOrigin(), image.GetSpacing()), samples, image

    @unittest.skipUnless(WRITE_OPENVDB, "built without OpenVDB")
    def test_cloud_beside_vtk(self):
        """The pass is near the exact picture, VTK's plain ray casting is not."""
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([WRITE_OPENVDB, folder + "/"], check=True, timeout=60)
            text = self.run_example("cloud_beside_vtk.py", folder + "/plume.vdb", "density", "-o",
                                    folder + "/clouds.png", "--size", "48", "48")
            picture = read_png(folder + "/clouds.png")
        print(text)
        errors = {name: float(error)
                  for name, error in re.findall(r"^(\S.*?) +error +(\S+)", text, re.MULTILINE)}
        self.assertEqual(picture.shape, (48, 48 * len(errors), 3))
        self.assertEqual(errors["vtkAirlightReference"], 0)
        self.assertLess(errors["vtkAirlightPass"], 0.02)
        self.assertGreater(errors["VTK, no shadows"], 0.3)
        cloud = picture[:, :48].max(axis=-1)
        self.assertTrue(0.1 < (cloud > 0.1).mean() < 0.6 and cloud.max() > 0.9)

    @unittest.skipUnless(WRITE_OPENVDB, "built without OpenVDB")
    def test_plume_as_fog(self):
        width, height = 18, 27
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([WRITE_OPENVDB, folder + "/"], check=True, timeout=60)
            text = self.run_example("plume_as_fog.py", folder + "/plume.vdb", "density", "-o",
                                    folder + "/plume.png", "--arrays", folder + "/plume.npz",
                                    "--size", str(width), str(height))
            arrays = dict(np.load(folder + "/plume.npz"))
            picture = read_png(folder + "/plume.png")
            density, samples, image = self.read_density(folder + "/plume.vdb")
        print(text)
        # The most along the level axis where that is less is to be an optical depth of 4.
        level = min(samples.sum(axis=axis).max() for axis in (0, 2)) * image.GetSpacing()[0]
        self.assertAlmostEqual(arrays["extinction"], 4 / level, delta=1e-6 * 4 / level)
        self.assertEqual(tuple(arrays["bounds"]), image.GetBounds())

        # As requested: equal mean transmittance of the pixels that see the plume.
        seen = arrays["seen"]
        np.testing.assert_array_equal(seen, arrays["plume_t"][..., 0] < 0.99)
        self.assertTrue(0.1 < seen.mean() < 0.6)
        self.assertAlmostEqual(arrays["plume_t"][seen].mean(), arrays["exact_t"][seen].mean(),
                               delta=1e-7)

        # Both pictures by the midpoint rule.
        camera = {"position": arrays["eye"], "focal_point": arrays["focal_point"],
                  "view_up": (0, 1, 0), "view_angle_deg": 30}
        rays = pixel_rays(camera, width, height)[::-1]
        to_sun = np.array((-2, 1.5, 1)) / np.linalg.norm((-2, 1.5, 1))
        marched, depths = {}, {}
        for name, function, extinction in (
                ("plume", density, arrays["extinction"]),
                ("exact", lambda points: np.ones(points.shape[:-1]), arrays["matched"])):
            rows = [sunlit_airlight(function, image.GetBounds(), arrays["eye"], row, to_sun, 0.9,
                                    extinction, 10) for row in rays]
            marched[name] = np.array([row[0] for row in rows])
            depths[name] = max(row[2] for row in rows)
            transmittance = np.array([row[1] for row in rows])
            np.testing.assert_allclose(arrays[name + "_t"][..., 0], transmittance, atol=2e-3)
            largest = marched[name].max()
            error = np.abs(arrays[name][..., 0] - marched[name])
            self.assertLess(error.max(), 0.01 * largest, name)
            self.assertLess(error.mean(), 0.001 * largest, name)

        # If the sun reached all smoke undimmed, a ray's airlight would be albedo p E (1 - T), and
        # the bias 0 as the mean T is the same. So 1 + bias is the ratio of the sun's mean
        # transmittances to the smoke that is seen, each between exp(-largest depth) and 1. It is
        # above 1: the plume's smoke is together, in its own shade, that of the box spread out.
        bias = marched["exact"][seen].sum() / marched["plume"][seen].sum() - 1
        print(f"bias {bias:.4f}, largest depths towards the sun {depths}")
        self.assertTrue(0 < bias < np.exp(depths["plume"]) - 1)
        marched["drawn"] = marched["exact"]
        scores = dict((line[:33].strip(), line[43:].split()) for line in text.splitlines()[3:])
        for name, a, b in (("homogeneous, reference", "exact", "plume"),
                           ("homogeneous, pass", "drawn", "plume"),
                           ("homogeneous, pass to reference", "drawn", "exact")):
            expected = metrics(arrays[a].astype(float), arrays[b], seen[..., None])
            printed = [float(value) for value in scores[name]]
            np.testing.assert_allclose(
                printed[:4], [expected[key] for key in ("relMSE", "median", "p99", "bias")], 6e-3)
            if b == "plume":
                lit = metrics(*(marched[key][..., None] for key in (a, b)), seen[..., None])["bias"]
                self.assertAlmostEqual(printed[3], lit, delta=0.005)
            else:  # the pass is exact to single precision
                self.assertLess(printed[2], 1e-4)

        # Density, box, difference: red where the box is brighter, blue where the plume is.
        self.assertEqual(picture.shape, (height, 3 * width, 3))
        difference = marched["exact"][::-1] - marched["plume"][::-1]
        clear = np.abs(difference) > 0.01 * marched["plume"].max()
        panel = picture[:, 2 * width:]
        np.testing.assert_array_equal((panel[..., 0] > panel[..., 2])[clear],
                                      (difference > 0)[clear])

    def test_content_in_fog(self):
        """The pictures are those of the gallery."""
        names = sorted(path.name for path in GALLERY.glob("content-*.png"))
        with tempfile.TemporaryDirectory() as folder:
            self.run_example("content_in_fog.py", folder)
            self.assertEqual(sorted(os.listdir(folder)), names)
            for name in names:
                self.compare_with_gallery(f"{folder}/{name}")

    @classmethod
    def tearDownClass(cls):
        missing = {path.name for path in EXAMPLES.glob("*.py")} - cls.ran - {
            name + ".py" for name in USES + SCENES}
        if WRITE_OPENVDB and missing:
            raise AssertionError(f"not run: {missing}")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
