# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of `airlight view` share: events, a scene of a wall and a lamp, and its picture."""

import json
import re
import subprocess

import numpy as np

from keyboard import Keyboard
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

class ViewTest(ProgramTest):
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

    def record(self, scene, use, *options):
        """As use_for_real(), recorded."""
        self.use_for_real(scene, use, "--record", self.path("record.txt"), *options)

    def use_for_real(self, scene, use, *options):
        """A drag and keys as the X server sends them to the window; q at the end."""
        viewer = subprocess.Popen(
            [PROGRAM, "view", scene, *LINEAR, "--screenshots", self.path("real-%d.png"), *options],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
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
