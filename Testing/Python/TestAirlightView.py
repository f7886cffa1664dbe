# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""`airlight view`: keys and Ctrl+drags from logs of events, and what its screenshots then show."""

import re
import time
import unittest

import numpy as np

from midpointrule import middles
from programtest import pixel_rays, read_png
from viewtest import (
    ALBEDO, CAMERA, LAMP, LINEAR, SIZE, STEP, ViewTest, dot, drag, lit_wall, moved, press,
    shown_lamp, wall_points)


class TestView(ViewTest):
    def test_visibility(self):
        """A wall in smoke that only absorbs: each key changes the extinction by 1.25."""
        texts, pictures = self.view(
            self.scene(["wall.ply"], absorption=0.1),
            [press(key) for key in ("i", "s", "minus", "minus", "s", "plus", "s", "equal", "s")])
        extinctions = 0.1 * np.array((1, 1.25**2, 1.25, 1))
        for extinction, picture, text in zip(extinctions, pictures, texts, strict=True):
            expected = lit_wall(extinction)
            self.assertTrue(0.15 < expected.max() < 0.99)
            self.assertLess(np.abs(picture - expected).max(), STEP)
            self.assertAlmostEqual(float(re.search(r"visibility ([\d.]+)", text)[1]),
                                   3.912 / extinction, delta=1e-3 * 3.912 / extinction)
        self.assertLess(pictures[1].mean(), 0.8 * pictures[0].mean())
        np.testing.assert_array_equal(pictures[0], pictures[3])

    def test_airlight(self):
        """Nothing but air that scatters: denser air is brighter, by as much as quadrature says."""
        extinction, power = 0.05, np.array((40.0, 45.0, 50.0))
        _, pictures = self.view(self.scene([], scattering=extinction, power=power),
                                [press(key) for key in ("i", "s", "minus", "s")])
        eye = np.array(CAMERA["position"])
        rays = pixel_rays(CAMERA, *SIZE)[::9, ::9]
        towards = LAMP - eye
        foot = rays @ towards
        nearest = np.sqrt((np.square(towards).sum() - foot**2).clip(1e-12))
        # Equal angles seen from the lamp, which takes 1/r^2 out; to where nothing is left.
        begin, end = np.arctan2(-foot, nearest), np.arctan2(300 - foot, nearest)
        count = 2000
        angle = begin[..., None] + middles(end - begin, count)
        t = foot[..., None] + nearest[..., None] * np.tan(angle)
        weight = ((end - begin) / count)[..., None] * nearest[..., None] / np.cos(angle)**2
        points = eye + t[..., None] * rays[..., None, :]
        expected = []
        for sigma in (extinction, 1.25 * extinction):
            r = np.linalg.norm(points - LAMP, axis=-1)
            terms = sigma / (4 * np.pi) * np.exp(-sigma * (r + t)) / r**2 * weight
            expected.append((terms.sum(axis=-1)[..., None] * power).clip(0, 1))
        for picture, value in zip(pictures, expected, strict=True):
            self.assertLess(np.abs(picture[::9, ::9] - value).max(), STEP + 1e-3)
        self.assertGreater(pictures[1].mean(), 1.1 * pictures[0].mean())

    def test_techniques(self):
        """t goes through them, and without shadows the wall is as if there were no blocker."""
        scene = self.scene(["wall.ply", "blocker.ply"], absorption=0.05)
        texts, pictures = self.view(
            scene, [press(key) for key in ("i", "s", "t", "s", "t", "t", "s", "t", "s", "T", "s")])
        names = [re.match(r"technique (\w+);view picture;", text)[1] for text in texts]
        self.assertEqual(names, ["ShadowPlanes", "ShadowMap", "None", "ShadowPlanes", "None"])
        points, _ = wall_points(pixel_rays(CAMERA, *SIZE))
        eye = np.array(CAMERA["position"])

        def crosses(origin, margin):
            """Whether the way from there to the wall passes the blocker's plane z = 1 in it."""
            x, y, _ = np.moveaxis(points + (origin - points) / origin[2], -1, 0)
            return (np.abs(x - 0.5) < 0.3 + margin) & (np.abs(y - 0.5) < 0.3 + margin)

        wall = lit_wall(0.05)
        hidden, shaded = crosses(eye, 0.02), crosses(LAMP, 0.02)
        for index in (2, 4):  # no shadows
            self.assertLess(np.abs(pictures[index] - wall)[~hidden].max(), STEP)
        dark = crosses(LAMP, -0.02) & ~hidden & (wall.min(axis=-1) > 0.05)
        self.assertGreater(dark.sum(), 500)
        for index in (0, 1, 3):
            self.assertEqual(pictures[index][dark].max(), 0)
            self.assertLess(np.abs(pictures[index] - wall)[~hidden & ~shaded].max(), STEP)
        # A screenshot is what `airlight render` draws.
        for index, name in ((0, "ShadowPlanes"), (1, "ShadowMap")):
            np.testing.assert_array_equal(
                pictures[index], self.render(scene, "x.png", "--technique", name, *LINEAR,
                                             "--antialiasing", "1"))

    def test_lamp(self):
        """Keys and mouse move the lamp, by shares of the picture's height at its distance."""
        texts, pictures = self.view(
            self.scene(["wall.ply"], absorption=0.05),
            [press("i"), press("Left"), press("Up"), press("s"), press("Next"), press("s"),
             drag((100, 100), (154, 73), 2), press("s"), press("n"), press("Prior"), press("s")])
        eye = np.array(CAMERA["position"])
        first = moved(moved(LAMP, -0.05, 0), 0, 0.05)
        nearer = eye + (first - eye) / 1.1
        dragged = moved(nearer, 54 / SIZE[1], -27 / SIZE[1])
        places = first, nearer, dragged, eye + 1.1 * (dragged - eye)
        for place, text, picture in zip(places, texts, pictures, strict=True):
            np.testing.assert_allclose(shown_lamp(text)[1], place, atol=1e-5)
            self.assertLess(np.abs(picture - lit_wall(0.05, place)).max(), STEP)
        self.assertGreater(np.abs(pictures[0] - pictures[1]).max(), 0.05)

    def test_sun(self):
        """A directional light turns; n chooses the next lamp. Nothing pushes it."""
        sun = np.array((0.3, 0.2, 1.0)) / np.linalg.norm((0.3, 0.2, 1.0))
        options = ["--sun", ",".join(map(str, sun)) + ":2", "--point", "0,0,1000:0"]
        texts, pictures = self.view(
            self.scene(["wall.ply"]), [press(key) for key in ("i", "n", "n", "Right", "s", "Prior",
                                                              "n", "Right", "s")], *options)
        eye = np.array(CAMERA["position"])
        forward = -eye / np.linalg.norm(eye)
        right = np.cross(forward, CAMERA["view_up"])
        up = np.cross(right / np.linalg.norm(right), forward)
        turn = np.radians(0.05 * 180)  # Rodrigues' rotation about the picture's upward direction
        turned = (sun * np.cos(turn) + np.cross(up, sun) * np.sin(turn)
                  + up * (up @ sun) * (1 - np.cos(turn)))
        self.assertGreater(np.abs(turned - sun).max(), 0.1)
        lamps = [re.search(r"lamp (\d) of 2 (\w+) ([^;]*);", text).groups() for text in texts]
        self.assertEqual([(number, word) for number, word, _ in lamps],
                         [("1", "from"), ("2", "at")])
        np.testing.assert_allclose(np.array(lamps[0][2].split(","), float), turned, atol=1e-5)
        for picture in pictures:
            self.assertLess(np.abs(picture - 2 / np.pi * turned[2] * ALBEDO).max(), STEP)

    def test_views(self):
        """Airlight alone, and boundaries only where the blocker's shadow is; drag and r."""
        scene = self.scene(["wall.ply", "blocker.ply"], 0.1, 0.1)
        texts, pictures = self.view(
            scene, [press("i"), *([press("v"), press("s")] * 4), drag((99, 99), (159, 99), 0),
                    press("s"), press("r"), press("s")])
        names = [re.search("view ([^;]*);", text)[1] for text in texts]
        self.assertEqual(names[:4], ["airlight only", "boundary count", "outlines of shadows",
                                     "picture"])
        airlight = self.render(scene, "a.pfm", "--buffer", "Airlight").clip(0, 1)
        self.assertLess(np.abs(pictures[0] - airlight).max(), STEP)
        count = self.render(scene, "n.pfm", "--buffer", "BoundaryCount")[..., 0]
        self.assertTrue(200 < (count > 0).sum() < 0.5 * count.size)
        np.testing.assert_array_equal(pictures[1].max(axis=-1) > 0, count > 0)
        red = (pictures[2][..., 0] > 0.5) & (pictures[2][..., 2] < 0.2)
        self.assertGreater(red.sum(), 20)  # the outlines where the view enters the shadow
        picture = self.render(scene, "x.png", *LINEAR, "--antialiasing", "1")
        np.testing.assert_array_equal(pictures[3], picture)
        self.assertGreater(np.abs(pictures[4] - picture).mean(), 0.01)  # turned
        np.testing.assert_array_equal(pictures[5], picture)

    def test_read_out(self):
        """The texts lie over the picture, which stays as it is around them."""
        scene = self.scene(["wall.ply"], absorption=0.05)
        start = time.perf_counter()
        texts, pictures = self.view(
            scene, [press(key) for key in ("s", "t", "s", "h", "s", "h", "i", "s")])
        took = 1000 * (time.perf_counter() - start)
        texts_shown = [(np.abs(picture - pictures[3]) > 0.02).any(axis=-1) for picture in pictures]
        # Eight lines of 14 points at the top left, and a ring of radius 9 around the lamp.
        ring = np.zeros(SIZE[::-1], bool)
        x, y = dot(LAMP)
        y = SIZE[1] - 1 - y
        ring[y - 11:y + 12, x - 11:x + 12] = True
        self.assertTrue(texts_shown[0][ring].any())
        rest = texts_shown[0] & ~ring
        rows, columns = (np.flatnonzero(rest.any(axis=axis)) for axis in (1, 0))
        self.assertTrue(rows.min() < 8 and 100 < rows.max() < 130, rows)
        self.assertTrue(columns.min() < 8 and 100 < columns.max() < 350, columns)
        # Another technique is another first line, of 14 pixels.
        changed = (pictures[0] != pictures[1]).any(axis=-1)[:18, :200]
        self.assertGreater(changed.sum(), 20)
        self.assertTrue(texts_shown[2][-40:].any() and not texts_shown[1][-40:].any())
        self.assertGreater(texts_shown[2].sum(), texts_shown[1].sum() + 5000)
        # A frame takes some time, and less than all of them together.
        times = [float(re.search(r"frame ([\d.]+) ms", text)[1]) for text in texts]
        self.assertTrue(0 < min(times) and sum(times) < took, times)

    def test_help(self):
        text = self.succeed("view", "--help")
        for key in ("t, T", "v, V", "+, -", "arrows", "Page Up", "n ", "s ", "i ", "h ", "r ",
                    "q ", "e ", "p ", "drag a lamp's dot"):
            self.assertIn("\n  " + key, text)

    def test_errors(self):
        scene = self.scene(["wall.ply"])
        first = "# StreamVersion 1.1\n"
        missing = self.path("missing.txt")
        self.fail_with([missing], "view", scene, "--play", missing)
        for text, words in (("KeyPressEvent 1 1 0 0 0 a", ["first line", "StreamVersion"]),
                            (first + "\nKeyPresEvent 1 1 0 0 0 a", ["line 3", "KeyPresEvent"]),
                            (first + "KeyPressEvent 1 1 0 0 a", ["line 2", "repeat count"]),
                            (first + "KeyPressEvent 1 x 0 0 0 a", ["line 2", "repeat count"])):
            log = self.write("bad.txt", text)
            self.fail_with([log, *words], "view", scene, "--play", log)
        for pattern, word in (("shot.png", "%d"), ("shot-%d.jpg", "jpg"),
                              (self.path("none/shot-%d.png"), "none")):
            self.fail_with(["shot", word], "view", scene, "--screenshots", pattern)
        for text in ("nan", "-1", "x"):
            self.fail_with(["--frame-time", text], "view", scene, "--frame-time", text)
        self.fail_with(["none"], "view", scene, "--record", self.path("none/log.txt"))

    def test_warning(self):
        """One frame shows lamps of finite size as points."""
        log = self.write("log.txt", "\n".join(["# StreamVersion 1.1", *press("q")]))
        for count in ("1", "2"):
            code, _, errors = self.run_program(
                "view", self.scene(["wall.ply"]), "--play", log, "--point", "0,0,1:5",
                "--lamp-radius", "0.5", "--antialiasing", count)
            self.assertEqual((code, "--antialiasing 16" in errors), (0, count == "1"), errors)

    def test_multisampling(self):
        """Single frames are closer to the mean of many at edges, and the same elsewhere."""
        scene = self.scene(["wall.ply", "blocker.ply"])
        mean = self.path("mean.png")
        self.succeed("render", scene, *LINEAR, "-o", mean, "--antialiasing", "64")
        expected = read_png(mean)
        keys = [press("i"), press("s")]
        plain = self.view(scene, keys)[1][0]
        smooth = self.view(scene, keys, "--multisampling")[1][0]
        edges = np.abs(plain - expected) > 0.05
        self.assertGreater(edges.sum(), 300)
        self.assertLess(np.abs(smooth - expected)[edges].mean(),
                        0.55 * np.abs(plain - expected)[edges].mean())
        self.assertGreater((smooth == plain).mean(), 0.9)

    def test_no_medium(self):
        """Keys of the medium do nothing where there is none; the lamp's still do."""
        texts, pictures = self.view(
            self.scene(["wall.ply"]),
            [press(key) for key in ("i", "s", "t", "v", "plus", "s", "Left", "s")], "--no-medium")
        self.assertTrue(texts[0].startswith("no medium;lamp 1 of 1 at 1,1,2;"), texts)
        np.testing.assert_array_equal(pictures[0], pictures[1])
        self.assertGreater(np.abs(pictures[2] - pictures[0]).max(), 0.02)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
