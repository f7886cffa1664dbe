# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Lamps with photometric files on the command line and in scene files, against formulas.

Run it like TestAirlightProgram.py.
"""

import json
import os
import unittest

import numpy as np

from programtest import SOURCE, SceneTest, pixel_rays

FILES = os.path.join(SOURCE, "Testing", "Data", "Photometry")
DOWNLIGHT = os.path.join(FILES, "downlight.ies")
STREETLIGHT = os.path.join(FILES, "streetlight.ies")


class Lamp:
    """A file of type C, from 0 to 90 degrees vertically, horizontally 0 or 0 to 180."""

    def __init__(self, path):
        with open(path) as file:
            text = file.read()
        numbers = [float(word) for word in text[text.index("TILT="):].split()[1:]]
        vertical, horizontal = int(numbers[3]), int(numbers[4])
        self.vertical, rest = np.split(np.array(numbers[13:]), [vertical])
        self.horizontal, values = np.split(rest, [horizontal])
        self.values = values.reshape(horizontal, vertical) / values.max()

    def share(self, points, position, axis, up):
        """Of the largest intensity, towards the points: linear between the angles. Horizontal 0
        is towards `up`, 90 away from cross(axis, up); both sides are alike."""
        way = points - position
        way = way / np.linalg.norm(way, axis=-1, keepdims=True)
        right = np.cross(axis, up)
        v = np.degrees(np.arccos(np.clip(way @ axis, -1, 1)))
        h = np.abs(np.degrees(np.arctan2(-(way @ right), way @ up)))
        rows = np.array([np.interp(v, self.vertical, row, right=0) for row in self.values])
        if len(rows) == 1:
            return rows[0]
        i = np.clip(np.searchsorted(self.horizontal, h) - 1, 0, len(rows) - 2)
        low, high = self.horizontal[i], self.horizontal[i + 1]
        first, second = (np.take_along_axis(rows, j[None], axis=0)[0] for j in (i, i + 1))
        return first + (second - first) * (h - low) / (high - low)


class TestPhotometry(SceneTest):
    CLEAR = ("--scattering", "0,0,0", "--absorption", "0,0,0")

    def setUp(self):
        super().setUp()
        self.eye = np.array(self.CAMERA["position"])
        self.rays = pixel_rays(self.CAMERA, *self.SIZE)

    def test_wall(self):
        """The wall z = 0 in clear air shows albedo/pi I(direction) cos/r^2."""
        points = self.eye - self.rays * (self.eye[2] / self.rays[..., 2:])
        position, axis = np.array([0.2, 0.1, 1.5]), np.array([0, 0, -1])
        way = points - position
        r = np.linalg.norm(way, axis=-1)
        for path, options, up in (
                (DOWNLIGHT, (), (0, 1, 0)), (STREETLIGHT, (), (0, 1, 0)),
                (STREETLIGHT, ("--ies-up", "3,4,7"), (0.6, 0.8, 0))):
            share = Lamp(path).share(points, position, axis, np.array(up))
            image = self.render(self.wall_scene([0.8, 0.8, 0.8]), "a.pfm", "--buffer", "Surface",
                                *self.CLEAR, "--point", "0.2,0.1,1.5:9,18,27", "--ies", path,
                                "--ies-aim", "0.2,0.1,0", *options)
            expected = 0.8 / np.pi * share * -way[..., 2] / r**3
            self.assertGreater(expected.max(), 10 * expected.min())
            np.testing.assert_allclose(image, expected[..., None] * [9, 18, 27], rtol=2e-4,
                                       atol=1e-5, err_msg=f"{path} {options}")

    def test_air(self):
        """A lamp that hangs, unless options turn it; airlight by the midpoint rule over
        t = tL + h tan(phi), in which 1/r^2 dt = dphi/h."""
        position = np.array([0.3, 1.6, -0.2])
        lamp = Lamp(STREETLIGHT)
        rows, columns = np.mgrid[1:self.SIZE[1]:4, 2:self.SIZE[0]:4].reshape(2, -1)
        rays = self.rays[rows, columns]
        foot = (position - self.eye) @ rays.T
        h = np.linalg.norm(self.eye + foot[:, None] * rays - position, axis=-1)
        steps = 8000
        start = np.arctan2(-foot, h)
        width = (np.pi / 2 - start) / steps
        integral = np.empty(len(rays))
        for i, ray in enumerate(rays):
            phi = start[i] + (np.arange(steps) + 0.5) * width[i]
            t = foot[i] + h[i] * np.tan(phi)
            points = self.eye + t[:, None] * ray
            # Up lies along the axis here, so that it is 0,0,1.
            share = lamp.share(points, position, np.array([0, -1, 0]), np.array([0, 0, 1]))
            r = np.linalg.norm(points - position, axis=-1)
            integral[i] = np.sum(share * np.exp(-0.25 * (t + r))) * width[i] / h[i]
        image = self.render(
            self.scene(), "a.pfm", "--buffer", "Airlight", "--scattering", "0.2,0.2,0.2",
            "--absorption", "0.05,0.05,0.05", "--point", "0.3,1.6,-0.2:10,20,30", "--ies",
            STREETLIGHT)
        expected = 0.2 / (4 * np.pi) * integral[:, None] * [10, 20, 30]
        lit = integral > 0.01 * integral.max()
        self.assertGreater(lit.sum(), 50)
        np.testing.assert_allclose(image[rows, columns][lit], expected[lit], rtol=1.1e-3)

    def test_several(self):
        """A file is for the lamp before it, and light adds up."""
        lamps = (("--point", "1,2,1:5"), ("--point", "-1,2,0:7", "--ies", DOWNLIGHT),
                 ("--sun", "1,2,3:1"), ("--spot", "0,3,1:0,0,0:40:9", "--ies", STREETLIGHT),
                 ("--point", "2,1,0:3", "--ies", STREETLIGHT, "--ies-aim", "0,0,0", "--ies-up",
                  "1,0,0"))
        wall = self.wall_scene([0.5, 0.5, 0.5])
        alone = [self.render(wall, f"{i}.pfm", *lamp) for i, lamp in enumerate(lamps)]
        together = self.render(wall, "all.pfm", *(word for lamp in lamps for word in lamp))
        np.testing.assert_allclose(together, sum(alone), rtol=1e-5)
        for i, lamp in enumerate(lamps):
            bare = self.render(wall, "bare.pfm", *lamp[:2])
            changed = np.abs(alone[i] - bare).max() > 0.1 * bare.max()
            self.assertEqual(changed, "--ies" in lamp)

    def test_scene_file(self):
        """Names are looked up beside the scene file; what it says is what the options say."""
        with open(STREETLIGHT) as file:
            self.write("street.ies", file.read())
        path = self.wall_scene([0.5, 0.5, 0.5])
        with open(path) as file:
            scene = json.load(file)
        point = {"type": "point", "position": [1, 2, 1], "intensity": [5, 6, 7],
                 "photometry": "street.ies"}
        spot = {"type": "spot", "position": [0, 3, 1], "direction": [0, -3, -1],
                "cone_half_angle_deg": 40, "exponent": 2, "intensity": [5, 6, 7],
                "photometry": "street.ies"}
        for light, *options in (
                (point, "--point", "1,2,1:5,6,7", "--ies", STREETLIGHT),
                (dict(point, direction=[-1, -1, -1], photometry_up=[1, 0, 0]), "--point",
                 "1,2,1:5,6,7", "--ies", STREETLIGHT, "--ies-aim", "0,1,0", "--ies-up", "1,0,0"),
                (spot, "--spot", "0,3,1:0,0,0:40:5,6,7:2", "--ies", STREETLIGHT),
                (dict(spot, photometry_up=[1, 0, 0]), "--spot", "0,3,1:0,0,0:40:5,6,7:2", "--ies",
                 STREETLIGHT, "--ies-up", "1,0,0")):
            by_option = self.render(path, "a.pfm", *options)
            by_file = self.render(self.write("b.json", json.dumps(dict(scene, lights=[light]))),
                                  "b.pfm")
            np.testing.assert_array_equal(by_file, by_option, str(light))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
