# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples that have a purpose: their numbers against the midpoint rule and closed
formulas, their pictures against the gallery."""

import os
import re
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from exampletest import PROGRAMS, USES, ExampleTest, load_example
from midpointrule import Grid, box_interval, middles
from programtest import henyey_greenstein, pixel_rays, read_png


def numbers(text):
    """All numbers in it."""
    return [float(value) for value in re.findall(r"\d+\.?\d*(?:e[-+]?\d+)?", text)]


class TestUses(ExampleTest):
    drawn = {}  # by example: its picture

    def draw(self, name):
        """The example's constants and what it prints; its picture must be the gallery's."""
        with tempfile.TemporaryDirectory() as folder:
            picture = f"{folder}/use-{name.replace('_', '-')}.png"
            text = self.run_example(name + ".py", "-o", picture)
            print(text)
            self.compare_with_gallery(picture)
            self.drawn[name] = read_png(picture)
        return load_example(name), text

    def draw_in_cxx(self, name, shown, *options):
        """What the example in C++ prints; it must draw the same picture."""
        program = os.path.join(PROGRAMS, name)
        with tempfile.TemporaryDirectory() as folder:
            picture = folder + "/picture.png"
            text = self.run_example(name, *options, "-o", picture, program=program)
            drawn = read_png(picture)
        self.assertLess(np.abs(drawn - shown).mean(), 0.5 / 255)
        return text

    def compare_in_cxx(self, name, text):
        """The example in C++ draws and prints the same as the one in Python."""
        if PROGRAMS:
            program = name.title().replace("_", "")
            self.assertEqual(self.draw_in_cxx(program, self.drawn[name]), text)

    def test_smoke_corridor(self):
        scene, text = self.draw("smoke_corridor")
        extinction = scene.SCATTERING + scene.ABSORPTION
        eye, power = np.array((0, scene.EYE, 0)), np.mean(scene.POWER)
        edge = np.cos(np.radians(80))
        shines, lit = (numbers(line.split("contrast")[1]) for line in text.splitlines()[::2])
        ends = shines[1::2]
        self.assertEqual(ends, list(np.arange(5, 41, 5)))
        contrasts = []
        for end in ends:
            sign = np.array((0, scene.SIGN, -end))
            distance = np.linalg.norm(sign - eye)
            points = eye + middles(1, 20000)[:, None] * (sign - eye)
            t = np.linalg.norm(points - eye, axis=1)
            through = np.exp(-extinction * distance)
            veil = scene.SCATTERING / extinction * scene.AMBIENT * (1 - through)
            irradiance = 0
            for lamp in np.array(scene.LAMPS):
                way = points - lamp
                r = np.linalg.norm(way, axis=1)
                inside = -way[:, 1] > edge * r  # of the cone
                veil += np.where(inside, scene.SCATTERING * power / (4 * np.pi) / r**2
                                 * np.exp(-extinction * (r + t)), 0).mean() * distance
                r = np.linalg.norm(sign - lamp)
                if lamp[2] > sign[2] and lamp[1] - sign[1] > edge * r:
                    irradiance += power * (lamp[2] - sign[2]) / r**3 * np.exp(-extinction * r)
            contrasts.append((scene.LETTERS * through / veil, scene.ALBEDO / np.pi * (
                irradiance + np.pi * scene.AMBIENT) * through / veil))
        for printed, expected in zip((shines, lit), np.transpose(contrasts), strict=True):
            np.testing.assert_allclose(printed[::2], expected, rtol=0.01)
        # As far as the contrast is 2 %: between the signs before and behind.
        for line, (first, last), values in zip(text.splitlines()[1::2], ((5, 10), (2, 4)),
                                               np.transpose(contrasts), strict=True):
            reach, product = numbers(line)[:2]
            index = np.searchsorted(-values, -0.02)
            self.assertTrue(ends[index - 1] <= reach <= ends[index], line)
            self.assertAlmostEqual(product, reach * extinction, delta=0.1)
            self.assertTrue(first < product < last, "in the range that was measured")
        self.compare_in_cxx("smoke_corridor", re.sub("; measured.*", "", text))

    def test_headlights_in_fog(self):
        scene, text = self.draw("headlights_in_fog")
        extinction = 3.912 / scene.VISIBILITY  # the people are out of each other's shadows
        eye = np.array(scene.EYE)
        camera = {"position": eye, "focal_point": eye + (0, -0.045, -1), "view_up": (0, 1, 0),
                  "view_angle_deg": 17}

        def falls(points, lamp, low):
            """Irradiance on a plane that faces the lamp, without fog."""
            way = points - lamp
            r = np.linalg.norm(way, axis=-1)
            ahead = (-way[..., 2] / r).clip(0)
            intensity = scene.INTENSITY * scene.COLOUR[1] * ahead**60 * (
                ahead > np.cos(np.radians(35)))
            # The shield's lower edge is 0.5 mm below the axis and 50 mm ahead; two sides dim.
            stray = (1 - scene.SHIELD)**2 if low else 1
            return np.where(way[..., 1] > -0.01 * -way[..., 2], stray, 1) * intensity / r**2, r

        for line, (x, distance) in zip(text.splitlines(), scene.PEOPLE, strict=True):
            found = numbers(line.replace("^2", ""))
            self.assertEqual(found[0], distance)
            # The ray of the pixel in which the leg is, to the leg's front.
            aim = np.array((x + 0.1, 0.15, 0.1 - distance)) - eye
            rays = pixel_rays(camera, 480, 160)
            rays = rays[np.unravel_index((rays @ aim).argmax(), rays.shape[:2])]
            length = aim[2] / rays[2]
            leg = eye + length * rays
            points = eye + middles(1, 4000)[:, None] * (leg - eye)
            t = np.linalg.norm(points - eye, axis=1)
            for i, beam in enumerate(("low", "high")):
                veil, surface = 0, 0
                for lamp in np.array(scene.LAMPS):
                    falling, r = falls(points, lamp, beam == "low")
                    cosine = ((points - lamp) @ (eye - leg)) / r / length
                    veil += (extinction * henyey_greenstein(scene.ANISOTROPY, cosine) * falling
                             * np.exp(-extinction * (r + t))).mean() * length
                    falling, r = falls(leg, lamp, beam == "low")
                    surface += (0.07 / np.pi * falling * (lamp[2] - leg[2]) / r
                                * np.exp(-extinction * (r + length)))
                # Both are printed to 5e-4.
                self.assertAlmostEqual(found[1 + 2 * i], veil, delta=0.002 * veil + 5e-4, msg=line)
                self.assertAlmostEqual(found[2 + 2 * i], surface / veil,
                                       delta=0.002 * surface / veil + 5e-4, msg=line)
        self.assertGreater(found[3], 10 * found[1], "fog throws the high beam back")
        if PROGRAMS:
            shown = self.drawn["headlights_in_fog"]
            table = np.reshape(numbers(text.replace("^2", "")), (-1, 5))
            for half, columns, options in ((shown[:160], (0, 1, 2), ["--low"]),
                                           (shown[160:], (0, 3, 4), [])):
                found = numbers(self.draw_in_cxx("HeadlightsInFog", half, *options)
                                .replace("^2", ""))
                self.assertEqual(found, list(table[:, columns].ravel()))

    def test_underwater_lamp(self):
        scene, text = self.draw("underwater_lamp")
        extinction = scene.SCATTERING + np.array(scene.ABSORPTION)

        def contrast(lamp, distance):
            # Equal steps of the logarithm, as the water before the camera counts most.
            edges = np.concatenate(([0], np.geomspace(1e-4, distance, 20000)))
            t, step = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
            points = np.outer(t, (0, 0, -1))
            way = points - lamp
            r = np.linalg.norm(way, axis=1)
            phase = henyey_greenstein(scene.ANISOTROPY, way[:, 2] / r)
            veil = ((scene.SCATTERING * phase / r**2 * step)[:, None]
                    * np.exp(-np.outer(r + t, extinction))).sum(axis=0)
            board = np.array((0, 0, -distance))
            r = np.linalg.norm(board - lamp)
            return (scene.ALBEDO / np.pi * (lamp[2] + distance) / r**3
                    * np.exp(-extinction * (r + distance)) / veil)

        lines = text.splitlines()
        reaches = []
        for lamp, (first, second) in ((scene.LAMP_BESIDE, lines[:2]), (scene.LAMP, lines[2:])):
            printed = numbers(first)
            for i, distance in enumerate((2, 5, 10)):
                self.assertEqual(printed[4 * i + 3], distance)
                np.testing.assert_allclose(printed[4 * i:4 * i + 3],
                                           contrast(np.array(lamp), distance), rtol=6e-3)
            reaches.append(numbers(second))
            for channel, reach in enumerate(reaches[-1]):
                at = contrast(np.array(lamp), reach)[channel]
                # Ranges have two decimals, in which the contrast changes by 1 %.
                self.assertAlmostEqual(at, 0.02, delta=0.02 * 0.02)
        self.assertGreater(min(np.divide(reaches[1], reaches[0])), 1.4, "the arm pays")
        self.compare_in_cxx("underwater_lamp", text)

    def test_daylight_room(self):
        scene, text = self.draw("daylight_room")
        to_sun = scene.TO_SUN / np.linalg.norm(scene.TO_SUN)
        extinction = scene.SCATTERING + scene.ABSORPTION

        def in_sun(points):
            lit = np.ones(points.shape[:-1], bool)
            for bounds in scene.WALLS + scene.TABLE:
                enter, leave = box_interval(bounds, points, to_sun)
                lit &= enter >= leave
            return lit

        x0, x1, _, _, z0, z1 = scene.ROOM
        x, z = (np.arange(low + scene.SENSOR / 2, high, scene.SENSOR)
                for low, high in ((x0, x1), (z0, z1)))
        floor = np.stack(np.broadcast_arrays(x[:, None], 0, z), axis=-1).astype(float)
        lit = in_sun(floor)
        way = box_interval(scene.ROOM, floor, to_sun)[1]
        light = np.where(lit, np.mean(scene.SUN) * to_sun[1] * np.exp(-extinction * way), 0)
        area, irradiance, power = numbers(text.splitlines()[0].replace("^2", ""))
        square = scene.SENSOR**2  # a few sensors are on edges of shadows
        self.assertAlmostEqual(area, lit.sum() * square, delta=10 * square)
        self.assertAlmostEqual(irradiance, light[lit].mean(), delta=0.2)
        self.assertAlmostEqual(power, light.sum() * square, delta=10 * square * irradiance)

        eye = np.array(scene.EYE)
        camera = {"position": eye, "focal_point": scene.TARGET, "view_up": (0, 1, 0),
                  "view_angle_deg": 42}
        ray = pixel_rays(camera, 480, 320)[159, 240]
        length, found = numbers(text.splitlines()[1])
        ways = [box_interval(bounds, eye, ray) for bounds in scene.WALLS + scene.TABLE]
        first = min(enter for enter, leave in ways if enter < leave)
        self.assertAlmostEqual(length, first, delta=1e-3)
        length = min(first, box_interval(scene.ROOM, eye, ray)[1])  # where the dust ends
        step = length / 50000
        lit = in_sun(eye + middles(length, 50000)[:, None] * ray)
        edges = np.count_nonzero(np.diff(lit))
        self.assertGreater(edges, 2)
        self.assertAlmostEqual(found, lit.sum() * step, delta=1e-3 + edges * step)
        self.compare_in_cxx("daylight_room", text.splitlines()[1] + "\n")

    def test_laser_sheet(self):
        scene, text = self.draw("laser_sheet")
        smoke = scene.make_smoke().GetDensityImage()
        samples = vtk_to_numpy(smoke.GetPointData().GetScalars())
        grid = Grid(samples.reshape(smoke.GetDimensions()[::-1]), smoke.GetOrigin(),
                    smoke.GetSpacing())
        eye, lens = np.array(scene.EYE), np.array(scene.LENS)
        camera = {"position": eye, "focal_point": scene.TARGET, "view_up": (0, 1, 0),
                  "view_angle_deg": 30}
        rays = pixel_rays(camera, 480, 320)
        ray = rays[np.unravel_index((rays @ np.subtract(scene.PROBE, eye)).argmax(),
                                    rays.shape[:2])]

        def density(points):
            x, y, z = np.moveaxis(points, -1, 0)
            x0, x1, y0, y1, z0, z1 = scene.TUNNEL
            inside = (x0 < x) & (x < x1) & (y0 < y) & (y < y1) & (z0 < z) & (z < z1)
            return np.where(inside, grid(points), 0)

        def depth(ends):
            """Optical depth from the first to the second of them."""
            way = np.subtract(ends[1], ends[0])
            points = ends[0] + middles(1, 4000)[:, None] * way
            return scene.SCATTERING * density(points).mean() * np.linalg.norm(way)

        # The sheet is the wedge that the slit leaves of the lens's light.
        slope = scene.SLIT / 2 / scene.SLIT_DEPTH
        ends = [(side * slope * (lens[1] - eye[1]) - eye[2]) / (ray[2] + side * slope * ray[1])
                for side in (1, -1)]
        thickness = max(ends) - min(ends)
        t = min(ends) + middles(thickness, 9)
        terms = []
        for point in eye + t[:, None] * ray:
            r2 = np.square(point - lens).sum()
            terms.append(density(point) * scene.POWER[1] / r2 * np.exp(
                -depth((lens, point)) - depth((point, eye))))
        radiance = scene.SCATTERING / (4 * np.pi) * np.mean(terms) * thickness
        lines = [numbers(line.replace("m^2", "")) for line in text.splitlines()]
        self.assertAlmostEqual(lines[0][0], 1000 * thickness, delta=0.006)
        self.assertAlmostEqual(lines[0][1], 1000 * thickness, delta=0.02)
        self.assertAlmostEqual(lines[1][0], radiance, delta=0.003 * radiance)
        # By hand the density is that of one place: streaks vary by some per cent across the sheet.
        self.assertAlmostEqual(lines[1][1], radiance, delta=0.05 * radiance)

        # The tangents from the lens to the cylinder, where they meet the line.
        middle = np.arctan2(-lens[0], lens[1])
        half = np.arcsin(scene.RADIUS / np.hypot(*lens[:2]))
        height = lens[1] - scene.TUNNEL[2] - 0.01
        shadow = height * (np.tan(middle + half) - np.tan(middle - half))
        self.assertAlmostEqual(lines[2][0], shadow, delta=2e-4 * shadow + 5e-5)
        self.compare_in_cxx("laser_sheet", text)

    def test_depth_cueing(self):
        scene, text = self.draw("depth_cueing")
        (near, kept_near), (far, kept_far) = (numbers(line) for line in text.splitlines())
        for distance, kept in ((near, kept_near), (far, kept_far)):
            self.assertAlmostEqual(kept, 100 * np.exp(-distance / scene.RANGE), delta=0.012)
        # Phosphates are the outermost parts: the nearest one's front, the farthest one at most.
        balls = np.concatenate([scene.strand(0), scene.strand(scene.GROOVE)])
        distances = np.linalg.norm(balls - scene.EYE, axis=1)
        self.assertAlmostEqual(near, distances.min() - scene.PHOSPHATE, delta=0.01)
        self.assertTrue(distances.max() - 0.5 < far < distances.max() + scene.PHOSPHATE)
        self.compare_in_cxx("depth_cueing", text)

    @classmethod
    def tearDownClass(cls):
        missing = {name + ".py" for name in USES} - cls.ran
        if missing:
            raise AssertionError(f"not run: {missing}")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
