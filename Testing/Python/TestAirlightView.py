# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""`airlight view`: keys and mouse from logs of events, and what its screenshots then show."""

import json
import os
import re
import subprocess
import time
import unittest

import numpy as np

from keyboard import Keyboard
from midpointrule import middles
from programtest import PROGRAM, WALL, ProgramTest, pixel_rays, read_png

SIZE = (360, 270)
CAMERA = {"position": [0.2, 0.1, 5.0], "focal_point": [0.0, 0.0, 0.0], "view_up": [0, 1, 0],
          "view_angle_deg": 50.0}
LAMP = np.array((1.0, 1.0, 2.0))
POWER = np.array((8.0, 9.0, 10.0))
ALBEDO = np.array((0.9, 0.7, 0.5))
STEP = 1.01 / 255  # dithering and rounding to 8 bits, and single precision

# The window shows radiance.
LINEAR = ("--exposure", "1", "--tone-mapping", "clamp", "--color-space", "linear")

# A square before the wall, which takes the lamp's light from a part of it.
BLOCKER = WALL.replace("-50 -50 0\n50 -50 0\n50 50 0\n-50 50 0",
                       "0.2 0.2 1\n0.8 0.2 1\n0.8 0.8 1\n0.2 0.8 1")

CODES = {"plus": "+", "minus": "-"}  # of keys whose name is not the character


def press(name, modifiers=0):
    """What a window tells of a key, as vtkInteractorEventRecorder writes it."""
    character = CODES.get(name, name)
    code = ord(character) if len(character) == 1 else 0
    return [f"{event} 9 9 {modifiers} {code} 1 {name}"
            for event in ("KeyPressEvent", "CharEvent", "KeyReleaseEvent")]


def mouse(event, place, modifiers=0):
    return [f"{event} {place[0]} {place[1]} {modifiers} 0 0 Control_L"]


def grab(start, end, modifiers=0):
    """Without the release."""
    return [*mouse("MouseMoveEvent", start, modifiers),
            *mouse("LeftButtonPressEvent", start, modifiers),
            *mouse("MouseMoveEvent", end, modifiers)]


def drag(start, end, modifiers=0):
    return grab(start, end, modifiers) + mouse("LeftButtonReleaseEvent", end, modifiers)


def picture_axes():
    """To the right, up, and into the scene."""
    forward = -np.array(CAMERA["position"])
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, CAMERA["view_up"])
    right /= np.linalg.norm(right)
    return right, np.cross(right, forward), forward


def moved(lamp, x, y):
    """A lamp moved by shares of the picture's height, at its distance."""
    right, up, forward = picture_axes()
    height = 2 * (lamp - CAMERA["position"]) @ forward * np.tan(np.radians(25))
    return lamp + height * (x * right + y * up)


def dot(lamp, size=SIZE):
    """Where a lamp is in the window, from the bottom left."""
    right, up, forward = picture_axes()
    way = lamp - CAMERA["position"]
    scale = size[1] / (2 * np.tan(np.radians(25)) * (way @ forward))
    return tuple(round(side / 2 + scale * (way @ axis) - 0.5)
                 for side, axis in zip(size, (right, up)))


def shown_lamp(text):
    """Its number and place in the read-out."""
    number, place = re.search(r"lamp (\d) of \d at ([^;]*);", text).groups()
    return int(number), np.array(place.split(","), float)


def shown(name, text):
    return float(re.search(name + r" (-?[\d.e-]+)", text)[1])


def wall_points(rays):
    """Where rays from the camera meet the wall z = 0, and how far away."""
    distance = -CAMERA["position"][2] / rays[..., 2]
    return CAMERA["position"] + distance[..., None] * rays, distance


def lit_wall(extinction, lamp=LAMP, size=SIZE):
    """The picture of the wall by the lamp in a medium that only absorbs: albedo/pi E T."""
    points, distance = wall_points(pixel_rays(CAMERA, *size))
    r = np.linalg.norm(lamp - points, axis=-1)
    irradiance = lamp[2] / r**3 * np.exp(-extinction * (r + distance))
    return (irradiance[..., None] * POWER * ALBEDO / np.pi).clip(0, 1)


class TestView(ProgramTest):
    def scene(self, meshes, scattering=0.0, absorption=0.0, power=POWER):
        """A scene file of the lamp and these of wall.ply and blocker.ply."""
        for name, text in (("wall.ply", WALL), ("blocker.ply", BLOCKER)):
            self.write(name, text)
        return self.write("scene.json", json.dumps({
            "image": {"width": SIZE[0], "height": SIZE[1]}, "camera": CAMERA,
            "medium": {"sigma_s": 3 * [scattering], "sigma_a": 3 * [absorption],
                       "phase": {"type": "isotropic"}},
            "lights": [{"type": "point", "position": list(LAMP), "intensity": list(power)}],
            "surfaces": [{"mesh": mesh, "albedo": list(ALBEDO)} for mesh in meshes]}))

    def view(self, scene, events, *options):
        """What the viewer prints for each screenshot, and the pictures."""
        lines = ["# StreamVersion 1.1", *sum(events, []), *press("q")]
        log = self.write("log.txt", "\n".join(lines))
        output = self.succeed("view", scene, *LINEAR, "--play", log, "--screenshots",
                              self.path("shot-%02d.png"), *options)
        found = re.findall(r"^(.*\.png): (.*)$", output, re.MULTILINE)
        return [text for _, text in found], [read_png(file) for file, _ in found]

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

    def test_lamp_dots(self):
        """A lamp is moved by its dot; a press beside all dots turns the camera."""
        other = np.array((-1.0, -0.5, 1.0))
        lamps = [f"--point={','.join(map(str, lamp))}:{power}"
                 for lamp, power in ((LAMP, 8), (other, 0))]
        beside = np.array(dot(other)) + (14, 0)
        texts, pictures = self.view(
            self.scene(["wall.ply"], absorption=0.05),
            [drag(dot(other), np.add(dot(other), (54, 27))), press("s"),
             drag(dot(LAMP), dot(LAMP)), press("s"), drag(np.add(dot(LAMP), (-4, 3)), (120, 90)),
             press("i"), press("s"), press("i"),
             drag(beside, np.add(beside, (40, 0))), press("s"),
             # Hidden dots do not take the mouse either.
             press("r"), press("i"), drag((120, 90), (90, 90)), press("s")], *lamps)
        # A drag moves by what the mouse moves, wherever the dot was taken.
        away = moved(other, 54 / SIZE[1], 27 / SIZE[1])
        end = np.subtract((120, 90), np.add(dot(LAMP), (-4, 3)))
        dragged = moved(LAMP, *(end / SIZE[1]))
        expected = [(2, away), (1, LAMP)] + 3 * [(1, dragged)]
        for (number, place), text in zip(expected, texts, strict=True):
            self.assertEqual(shown_lamp(text)[0], number)
            np.testing.assert_allclose(shown_lamp(text)[1], place, atol=1e-5)
        # The dots themselves, yellow; the wall under them is reddish or dark.
        for picture, lamps in ((pictures[0], (LAMP, away)), (pictures[1], (LAMP, away))):
            for lamp in lamps:
                x, y = dot(lamp)
                np.testing.assert_allclose(picture[SIZE[1] - 1 - y, x], (1, 0.8, 0.2), atol=0.01)
        lit = (lit_wall(0.05, dragged) / POWER * 8).clip(0, 1)
        self.assertLess(np.abs(pictures[2] - lit).max(), STEP)  # and no shadow of a dot
        for picture in pictures[3:]:
            self.assertGreater(np.abs(picture - pictures[2]).mean(), 0.01)  # turned

    def test_lamp_outside(self):
        """A lamp outside the picture has its dot at the edge, and comes there when it is dragged."""
        lamp = np.array((1.0, 7.0, 2.0))
        x, y = dot(lamp)
        self.assertGreater(y, 2 * SIZE[1])
        edge = (x, SIZE[1] - 12)
        texts, pictures = self.view(
            self.scene(["wall.ply"], absorption=0.05),
            [press("s"), drag(edge, edge), press("s"), drag(edge, (200, 200)), press("s"),
             drag((200, 200), (210, 190)), press("s")], "--point=1,7,2:900")
        came = moved(lamp, (200 - x) / SIZE[1], (200 - y) / SIZE[1])
        places = lamp, lamp, came, moved(came, 10 / SIZE[1], -10 / SIZE[1])
        pixel = 1 / SIZE[1] * (came - lamp) @ picture_axes()[1] / ((200 - y) / SIZE[1])
        for place, text in zip(places, texts, strict=True):
            np.testing.assert_allclose(shown_lamp(text)[1], place, atol=abs(pixel))
        self.assertGreater(pictures[0][12, x][0], pictures[0][12, x][2] + 0.2)  # yellow

    def test_sliders(self):
        """Sliders of 184 pixels at the bottom, of which beads of 10 leave 174."""
        size = (640, 480)
        scene = self.scene(["wall.ply"], absorption=0.05, scattering=0.05)
        middles = [(108 + 212 * i, 13) for i in range(3)]
        moves = [drag(middle, np.add(middle, (step, 2)))
                 for middle, step in zip(middles, (-29, 58, 29))]
        texts, pictures = self.view(
            scene, [press("s"), *sum(([move, press("s")] for move in moves), []), press("i"),
                    press("s"), press("i"), press("e"), press("s"), press("p"), press("s"),
                    drag(middles[1], np.add(middles[1], (9, 9))), press("s")],
            "--size", "640x480")
        names = ("visibility", "anisotropy", "exposure")
        values = np.array([[shown(name, text) for name in names] for text in texts])
        first = np.array((39.12, 0, 1))
        changed = np.array((39.12 / 30**(1 / 3), 0.66, 4))  # of ranges 30^2, 1.98 and 12 stops
        expected = np.where(np.arange(3) < np.arange(4)[:, None], changed, first)
        np.testing.assert_allclose(values[:4], expected, rtol=2e-3, atol=2e-3)
        np.testing.assert_array_equal(values[4:, :2], np.tile(values[3, :2], (4, 1)))
        self.assertEqual([text.count(" auto;") for text in texts], [0, 0, 0, 0, 0, 1, 1, 1])
        # The picture is that of `airlight render` with these values.
        picture = self.render(
            scene, "x.png", "--visibility", str(values[3, 0]), "--anisotropy", str(values[3, 1]),
            *LINEAR[2:], "--exposure", str(values[3, 2]), "--antialiasing", "1", "--size", "640x480")
        self.assertLess(np.abs(pictures[4] - picture).max(), 2 * STEP)
        # Three light beads; p takes them away, and the mouse then turns the camera.
        row = pictures[0][size[1] - 1 - 13]
        for x, _ in middles:
            self.assertGreater(row[x].min(), 0.9)
        self.assertGreater(np.abs(pictures[5] - pictures[6])[-44:].max(), 0.3)
        self.assertLess(np.abs(pictures[5] - pictures[6])[130:-44].max(), STEP)
        self.assertGreater(np.abs(pictures[7] - pictures[6]).mean(), 0.002)

    def test_frame_time(self):
        """A frame that takes too long while the mouse moves is simpler, the one at rest is not."""
        scene = self.scene(["wall.ply", "blocker.ply"], absorption=0.05)
        start, away = (30, 90), (60, 90)
        events = [press("i"), press("s"), grab(start, away), mouse("MouseMoveEvent", start),
                  press("s"), mouse("LeftButtonReleaseEvent", start), press("s")]
        (_, full), (texts, simple) = (
            self.view(scene, events, "--frame-time", limit) for limit in ("0", "0.0001"))
        ends = [re.search(r" ms(.*)$", text)[1] for text in texts]
        self.assertEqual(ends, ["", ", 1/4 size, no shadows", ""])
        self.assertEqual([text[:24] for text in texts], 3 * ["technique ShadowPlanes;v"])
        np.testing.assert_array_equal(full[1], full[2])
        np.testing.assert_array_equal(simple[2], full[2])
        # The blocker is where it was; its shadow is gone, and pixels are interpolated.
        points, _ = wall_points(pixel_rays(CAMERA, *SIZE))
        eye = np.array(CAMERA["position"])
        crossing = points + (eye - points) / eye[2]
        beside = np.abs(crossing[..., :2] - 0.5).max(axis=-1)
        error = np.abs(simple[1] - full[1]).max(axis=-1)
        self.assertLess(error[beside < 0.2].max(), 0.03)
        self.assertGreater(error[beside > 0.4].max(), 0.1)
        error = np.abs(simple[1] - lit_wall(0.05)).max(axis=-1)[beside > 0.4].max()
        self.assertTrue(STEP < error < 0.03, error)

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

    def test_record(self):
        """A log played and recorded again does the same; screenshots do not overwrite files."""
        scene = self.scene(["wall.ply"], absorption=0.05)
        end = np.add(dot(LAMP), (-40, 20))
        self.view(scene, [drag(dot(LAMP), end), press("i"), press("Left"), press("s"), press("s")])
        self.assertTrue(os.path.exists(self.path("shot-01.png")))

        def use(keyboard):
            x, y = dot(LAMP)
            y = SIZE[1] - 1 - y
            keyboard.drag((x, y), (x - 40, y - 20))
            for name in ("i", "Left", "s"):
                keyboard.press(name)

        self.use_for_real(scene, use)
        self.play_again(scene)
        for name in ("shot-01", "real-0", "played-0"):
            np.testing.assert_array_equal(read_png(self.path(name + ".png")),
                                          read_png(self.path("shot-00.png")), name)

    def use_for_real(self, scene, use, *options):
        """A drag and keys as the X server sends them to the window, recorded; q at the end."""
        viewer = subprocess.Popen(
            [PROGRAM, "view", scene, *LINEAR, "--record", self.path("record.txt"), "--screenshots",
             self.path("real-%d.png"), *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True)
        try:
            keyboard = Keyboard("Airlight", 60)
            use(keyboard)
            keyboard.press("q")
            output, _ = viewer.communicate(timeout=60)
        finally:
            viewer.kill()
            viewer.wait()
        self.assertEqual(viewer.returncode, 0, output)
        self.assertIn("real-0.png", output)

    def play_again(self, scene):
        """Play what was recorded; the log."""
        with open(self.path("record.txt"), encoding="ascii") as file:
            events = file.read()
        log = self.write("again.txt", events + "\n".join(press("q")))
        output = self.succeed("view", scene, *LINEAR, "--play", log, "--screenshots",
                              self.path("played-%d.png"))
        self.assertIn("played-0.png", output)
        return events

    def test_held_keys(self):
        """Slow frames between keys are simpler; the one at rest, and a screenshot, is complete."""
        scene = self.scene(["wall.ply", "blocker.ply"], absorption=0.05)

        def use(keyboard):
            for name in ("i", "Left", "s"):
                keyboard.press(name)
            end = time.monotonic() + 60
            while not os.path.exists(self.path("real-0.png")):  # all shaders are compiled then
                self.assertLess(time.monotonic(), end)
                time.sleep(0.1)
            keyboard.press("Up")
            time.sleep(3)  # until the timer has ended; nothing tells
            keyboard.press("s")

        self.use_for_real(scene, use, "--frame-time", "0.0001")
        events = self.play_again(scene)
        timers = re.findall("^(?:TimerEvent|KeyPressEvent)", events, re.MULTILINE)
        self.assertEqual(timers, 4 * ["KeyPressEvent"] + ["TimerEvent", "KeyPressEvent"])
        for number in range(2):
            np.testing.assert_array_equal(read_png(self.path(f"real-{number}.png")),
                                          read_png(self.path(f"played-{number}.png")))

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
        self.fail_with(["none"], "view", scene, "--record", self.path("none/log.txt"))

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
