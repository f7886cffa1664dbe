# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The programs `airlight` and `AnimatedFog`, from the command line to the files they write.

    export AIRLIGHT_PROGRAM=build/bin/airlight AIRLIGHT_SOURCE_DIR=.
    xvfb-run -a -s "-noreset -screen 0 1280x1024x24" python3 Testing/Python/TestAirlightProgram.py
"""

import json
import os
import pty
import struct
import subprocess
import unittest

import numpy as np

from programtest import (ANIMATED_FOG, PROGRAM, REFERENCE, ProgramTest, metrics, pixel_rays,
                         read_pfm, read_png, reference_file, scene_file, write_models)


def join(values):
    return ",".join(map(str, values))


class TestReferenceScenes(ProgramTest):
    """The program against scenes with exact answers (Testing/Data/Reference)."""

    # Median, 99th percentile and bias, each at most five times what Mesa's software renderer leaves
    # (Documentation/accuracy.md): the last places of single precision, and with a phase function that
    # is fitted its fit.
    LIMITS = {
        "S1_point_iso": {
            "total": (6e-7, 2.5e-6, 1.2e-7), "inscatter": (6e-7, 2.5e-6, 1.2e-7),
            "surface": (0, 0, 0)},
        "S2_point_hg_pos06": {
            "total": (3e-4, 6e-4, 2e-4), "inscatter": (3e-4, 6e-4, 2e-4),
            "surface": (0, 0, 0)},
        # Two pixels of the ball on an edge between its faces, 3 % off, make most of the bias.
        "S3_ground_occluders": {
            "total": (1.2e-6, 4.4e-6, 6e-5), "inscatter": (1.5e-6, 5e-6, 1.5e-7),
            "surface": (5e-6, 1.5e-5, 2.5e-4)},
        "S5_spot_slats": {
            "total": (1.4e-6, 1.2e-5, 6e-7), "inscatter": (2.5e-6, 6e-5, 1.5e-6),
            "surface": (1.2e-6, 1.3e-5, 1.2e-6)},
        "S6_sun_window": {
            "total": (2e-6, 2e-5, 8e-7), "inscatter": (6e-6, 1.5e-4, 3.5e-6),
            "surface": (1e-6, 3e-6, 8e-7)}}
    # Inside the shadows, where these two pixels are not.
    SHADOW_BIAS = {"total": 5e-7, "surface": 2e-6}
    LEAK = 1e-7

    def judge(self, image, name, part, mask="mask"):
        expected = read_pfm(reference_file(name, part))
        scores = metrics(image, expected, read_pfm(reference_file(name, mask)))
        median, p99, bias = self.LIMITS[name][part]
        if name == "S3_ground_occluders" and mask == "shadowmask":
            bias = self.SHADOW_BIAS.get(part, bias)
        with self.subTest(scene=name, part=part, mask=mask):
            self.assertEqual(scores["nonfinite"], 0)
            self.assertLessEqual(scores["median"], median, scores)
            self.assertLessEqual(scores["p99"], p99, scores)
            self.assertLessEqual(abs(scores["bias"]), bias, scores)
            # No light leaks into pixels that must be black.
            bright = np.percentile(expected, 99)
            self.assertLessEqual(scores["dark_max_abs"], max(self.LEAK * bright, 1e-9), scores)

    def judge_distances(self, name, mask):
        """Depth, and transmittance, which follows it.

        Where the surface is slanted, the depth changes within a pixel, and graphics cards place
        vertices on a grid of 1/256 pixel. To that comes single precision on coordinates up to ten
        times the depth.
        """
        depth = self.render(scene_file(name), "depth.pfm", "--buffer", "Depth")
        expected = read_pfm(reference_file(name, "depth"))
        inside = mask[..., 0] > 0.5
        np.testing.assert_array_equal(depth[inside] < 0, expected[inside] < 0)
        slope = sum(np.abs(np.gradient(expected[..., 0], axis=axis)) for axis in (0, 1))
        tolerance = slope[..., None] / 128 + 1e-5 * np.abs(expected) + 1e-5
        self.assertLessEqual((np.abs(depth - expected) / tolerance)[inside].max(), 1)

        image = self.render(scene_file(name), "t.pfm", "--buffer", "Transmittance")
        expected = read_pfm(reference_file(name, "transmittance"))
        with open(scene_file(name)) as file:
            medium = json.load(file)["medium"]
        extinction = max(np.add(medium["sigma_s"], medium["sigma_a"]))
        tolerance = extinction * tolerance * expected + 1e-5
        self.assertLessEqual((np.abs(image - expected) / tolerance)[inside].max(), 1)

    def check(self, name, masks):
        buffers = {"total": "Radiance", "inscatter": "Airlight", "surface": "Surface"}
        for part, buffer in buffers.items():
            image = self.render(scene_file(name), part + ".pfm", "--buffer", buffer)
            for mask in masks:
                self.judge(image, name, part, mask)
        self.judge_distances(name, read_pfm(reference_file(name, "mask")))

    def test_isotropic(self):
        self.check("S1_point_iso", ["mask"])

    def test_forward_scattering(self):
        self.check("S2_point_hg_pos06", ["mask"])

    def test_shadows(self):
        self.check("S3_ground_occluders", ["mask", "shadowmask"])

    def test_spot(self):
        self.check("S5_spot_slats", ["mask", "shadowmask"])

    def test_sun(self):
        self.check("S6_sun_window", ["mask", "shadowmask"])

    def test_shadow_maps(self):
        """Their own contract, inside and outside the shadows: half a percent, and five."""
        for name in ("S3_ground_occluders", "S5_spot_slats", "S6_sun_window"):
            for part, buffer in (("total", "Radiance"), ("inscatter", "Airlight"),
                                 ("surface", "Surface")):
                image = self.render(scene_file(name), part + ".pfm", "--buffer", buffer,
                                    "--technique", "ShadowMap")
                for mask in ("mask", "shadowmask"):
                    scores = metrics(image, read_pfm(reference_file(name, part)),
                                     read_pfm(reference_file(name, mask)))
                    with self.subTest(scene=name, part=part, mask=mask):
                        self.assertEqual(scores["nonfinite"], 0)
                        self.assertLessEqual(scores["median"], 5e-3, scores)
                        self.assertLessEqual(scores["p99"], 5e-2, scores)
                        self.assertLessEqual(abs(scores["bias"]), 5e-3, scores)

    def test_steps(self):
        """A ray march of few steps is worse than one of many, and that worse than intervals."""
        name = "S3_ground_occluders"
        expected = read_pfm(reference_file(name, "inscatter"))
        mask = read_pfm(reference_file(name, "shadowmask"))
        errors = [
            metrics(self.render(scene_file(name), "a.pfm", "--buffer", "Airlight", *options),
                    expected, mask)["median"]
            for options in (["--technique", "RayMarch", "--steps", "16"],
                            ["--technique", "RayMarch"],
                            ["--technique", "RayMarch", "--steps", "512"],
                            ["--technique", "ShadowMap", "--steps", "64"])]
        self.assertEqual(errors, sorted(errors, reverse=True))

    def test_options_build_the_same_scene(self):
        """Everything that S2 says, said on the command line over a scene that says otherwise."""
        with open(scene_file("S2_point_hg_pos06")) as file:
            scene = json.load(file)
        light = scene["lights"][0]
        other = json.loads(json.dumps(scene))
        other["image"] = {"width": 10, "height": 10}
        other["camera"].update(position=[9, 9, 9], focal_point=[0, 1, 0], view_angle_deg=70)
        other["medium"].update(sigma_s=[1, 1, 1], sigma_a=[0, 0, 0], phase={"type": "isotropic"})
        other["lights"].append(dict(light, position=[2, 2, 2]))

        camera = scene["camera"]
        image = self.render(
            self.write("other.json", json.dumps(other)), "other.pfm", "--size", "160x120",
            "--camera", f"{join(camera['position'])}:{join(camera['focal_point'])}:40",
            "--scattering", join(scene["medium"]["sigma_s"]),
            "--absorption", join(scene["medium"]["sigma_a"]), "--anisotropy", "0.6",
            "--point", f"{join(light['position'])}:{join(light['intensity'])}")
        self.judge(image, "S2_point_hg_pos06", "total")

    def build_with_options(self, name, *options):
        """The scene with another lamp, another medium and another region, put right by options."""
        with open(scene_file(name)) as file:
            scene = json.load(file)
        medium = scene["medium"]
        scene["lights"] = [{"type": "point", "position": [0, 3, 2], "intensity": [50, 50, 50]}]
        scene["medium"] = {"sigma_s": [1, 1, 1], "sigma_a": [0, 0, 0],
                           "phase": {"type": "henyey_greenstein", "g": -0.5},
                           "bounds": {"type": "box", "min": [0, 0, 0], "max": [1, 1, 1]}}
        for surface in scene["surfaces"]:
            surface["mesh"] = os.path.join(REFERENCE, surface["mesh"])
        box = np.transpose([medium["bounds"]["min"], medium["bounds"]["max"]]).ravel()
        image = self.render(
            self.write("other.json", json.dumps(scene)), "other.pfm", "--box", join(box),
            "--scattering", join(medium["sigma_s"]), "--absorption", join(medium["sigma_a"]),
            "--anisotropy", "0", *options)
        for mask in ("mask", "shadowmask"):
            self.judge(image, name, "total", mask)

    def test_spot_option(self):
        # Aims at the position plus twice the scene's direction.
        self.build_with_options(
            "S5_spot_slats", "--spot", "-0.55,4.63,0.21:-0.23,2.63,0.11:32:40,40,36")

    def test_sun_option(self):
        # Towards the sun: against the scene's direction.
        self.build_with_options("S6_sun_window", "--sun", "1,0.6,0.22:9,8,6.5")


class TestPictures(ProgramTest):
    """Formats, exposure and plain lighting."""

    SCENE = scene_file("S3_ground_occluders")
    PLAIN = ("--exposure", "1", "--antialiasing", "1", "--tone-mapping", "clamp", "--color-space",
             "linear")

    def test_formats_agree(self):
        linear = self.render(self.SCENE, "a.pfm")
        self.assertEqual(linear.shape, (120, 160, 3))
        picture = self.render(self.SCENE, "a.png", *self.PLAIN)
        self.assertLessEqual(np.abs(picture - linear.clip(0, 1)).max(), 1.0001 / 255)
        np.testing.assert_array_equal(
            self.render(self.SCENE, "b.pfm", "--exposure", "4"), linear * 4)
        exposed = self.render(self.SCENE, "b.png", *self.PLAIN[2:], "--exposure", "4")
        self.assertLessEqual(np.abs(exposed - (linear * 4).clip(0, 1)).max(), 1.0001 / 255)
        self.succeed("render", self.SCENE, "-o", self.path("a.tiff"))
        with open(self.path("a.tiff"), "rb") as file:
            self.assertIn(linear.astype("<f4").tobytes(), file.read())

    def test_exr(self):
        """What "OpenEXR File Layout" says of a file, with the numbers of the .pfm."""
        for options in ((), ("--buffer", "Depth")):
            linear = self.render(self.SCENE, "a.pfm", *options)
            self.succeed("render", self.SCENE, "-o", self.path("a.exr"), *options)
            with open(self.path("a.exr"), "rb") as file:
                content = file.read()
            self.assertEqual(struct.unpack("<2I", content[:8]), (20000630, 2))
            attributes, start = {}, 8
            while content[start]:
                name, kind, rest = content[start:start + 100].split(b"\0", 2)
                start += len(name) + len(kind) + 2
                size, = struct.unpack("<I", content[start:start + 4])
                attributes[name.decode()] = kind, content[start + 4:start + 4 + size]
                start += 4 + size
            self.assertEqual(attributes["dataWindow"],
                             (b"box2i", struct.pack("<4i", 0, 0, 159, 119)))
            self.assertEqual(attributes["displayWindow"], attributes["dataWindow"])
            self.assertEqual(attributes["compression"][1], b"\0")
            channels = attributes["channels"][1]
            self.assertEqual(len(channels), 18 * linear.shape[2] + 1)
            names = [chr(channels[i]) for i in range(0, len(channels) - 1, 18)]
            self.assertEqual(names, ["B", "G", "R"] if linear.shape[2] == 3 else ["Y"])
            offsets = struct.unpack("<120Q", content[start + 1:start + 961])
            for y, offset in enumerate(offsets):
                size = 4 * 160 * len(names)
                self.assertEqual(struct.unpack("<2I", content[offset:offset + 8]), (y, size))
                line = np.frombuffer(content[offset + 8:offset + 8 + size], "<f4")
                np.testing.assert_array_equal(line.reshape(-1, 160)[::-1].T, linear[y])
            self.assertEqual(len(content), offsets[-1] + 8 + size)

    def test_display(self):
        """A picture is the radiance as screens show it: middle grey, sRGB, smooth edges."""
        linear = self.render(self.SCENE, "a.pfm", "--antialiasing", "16")
        picture = self.render(self.SCENE, "a.png", "--tone-mapping", "clamp")
        fixed = self.render(self.SCENE, "b.png", "--exposure", "0.5", "--tone-mapping", "clamp")
        decoded = np.where(fixed <= 0.04045, fixed / 12.92, ((fixed + 0.055) / 1.055) ** 2.4)
        # A step of 255 is at most 2.4/1.055 steps of radiance.
        error = np.abs(decoded - (0.5 * linear).clip(0, 1))
        self.assertLessEqual(error.max(), 2.3 / 255)
        neutral = self.render(self.SCENE, "c.png")
        self.assertLess((neutral == 1).mean(), 0.1 * (picture == 1).mean())
        luminance = np.sort((picture @ [0.2126, 0.7152, 0.0722]).ravel())
        middle = luminance[int(0.4 * luminance.size):int(0.95 * luminance.size)].mean()
        self.assertAlmostEqual(middle, 0.46, delta=0.02)  # sRGB of 0.18

    def test_dithering(self):
        """Without it values are rounded to 8 bits; with it blocks of pixels have truer means."""
        linear = self.render(self.SCENE, "a.pfm").clip(0, 1)
        rounded = self.render(self.SCENE, "a.png", *self.PLAIN, "--no-dithering") - linear
        dithered = self.render(self.SCENE, "b.png", *self.PLAIN) - linear
        self.assertLessEqual(np.abs(rounded).max(), 0.5001 / 255)
        self.assertGreater(np.abs(dithered).max(), 0.6 / 255)

        def error(values):
            return np.abs(values.reshape(15, 8, 20, 8, 3).mean(axis=(1, 3))).mean()
        self.assertLess(error(dithered), 0.8 * error(rounded))
        self.fail_with(["--no-dithering", "linear"], "render", self.SCENE, "-o",
                       self.path("b.pfm"), "--no-dithering")

    def test_antialiasing(self):
        """Frames moved by parts of a pixel, and four samples of pixels at edges: closer to a picture
        of four times the size, at its edges."""
        large = self.render(self.SCENE, "large.pfm", "--size", "640x480")
        expected = large.reshape(120, 4, 160, 4, 3).mean(axis=(1, 3))
        one = self.render(self.SCENE, "one.pfm")
        mean = self.render(self.SCENE, "mean.pfm", "--antialiasing", "64")
        typical = np.median(expected)
        edges = (np.abs(one - expected) > 0.1 * typical) & (expected < 10 * typical)
        self.assertGreater(edges.sum(), 100)

        def error(picture):
            return np.sqrt(np.mean((picture - expected)[edges] ** 2))
        self.assertLess(error(mean), error(one) / 5)
        samples = self.render(self.SCENE, "samples.pfm", "--multisampling")
        self.assertLess(error(samples), 0.55 * error(one))
        self.assertGreater((samples == one).mean(), 0.6)
        self.fail_with(["--multisampling", "--antialiasing"], "render", self.SCENE, "-o",
                       self.path("b.png"), "--multisampling", "--antialiasing", "4")

    def test_buffers(self):
        for name, channels in (("Depth", 1), ("LitLength", 1), ("BoundaryCount", 1),
                               ("ErrorBound", 1),
                               ("Transmittance", 3)):
            image = self.render(self.SCENE, name + ".pfm", "--buffer", name)
            self.assertEqual(image.shape, (120, 160, channels), name)
            self.assertGreater(image.max(), 0, name)

    def test_shadow_technique(self):
        with_shadows = self.render(self.SCENE, "a.pfm", "--technique", "ShadowPlanes")
        without = self.render(self.SCENE, "b.pfm", "--technique", "None")
        mask = read_pfm(reference_file("S3_ground_occluders", "shadowmask"))[..., 0] > 0.5
        self.assertGreater((without - with_shadows)[mask].min(), 0)

    def test_plain_lighting(self):
        """Without medium and shadows the ground shows albedo/pi * I cos(theta)/r^2."""
        picture = self.render(self.SCENE, "plain.png", "--no-medium", *self.PLAIN)
        mask = read_pfm(reference_file("S3_ground_occluders", "mask"))[..., 0] > 0.5
        depth = read_pfm(reference_file("S3_ground_occluders", "depth"))[..., 0]
        with open(self.SCENE) as file:
            camera = json.load(file)["camera"]
        rays = pixel_rays(camera, 160, 120)
        eye = np.array(camera["position"])
        points = eye + depth[..., None] * rays
        ground = mask & (depth > 0) & (np.abs(points[..., 1]) < 1e-3)
        self.assertGreater(ground.sum(), 5000)
        to_light = np.array([0.13, 4.21, -0.17]) - points[ground]
        distance = np.linalg.norm(to_light, axis=-1, keepdims=True)
        cosine = to_light[:, 1:2] / distance
        expected = 0.5 / np.pi * np.array([30, 28, 24]) * cosine / distance**2
        self.assertLessEqual(np.abs(picture[ground] - expected.clip(0, 1)).max(), 1.5 / 255)

    def test_montage(self):
        left = self.render(self.SCENE, "left.png", "--exposure", "4")
        right = self.render(self.SCENE, "right.png", "--size", "50x120")
        self.succeed("montage", self.path("left.png"), self.path("right.png"), "-o",
                     self.path("both.png"))
        np.testing.assert_array_equal(
            read_png(self.path("both.png")), np.concatenate([left, right], axis=1))

    def test_animation(self):
        """The single frame is that of the series; frame 0 is the scene; the rest moves."""
        options = ("--period", "4", "--size", "80x60")
        for arguments in (["--frames", "3"], ["--frame", "1"]):
            code, _, errors = self.run_program(
                self.SCENE, "-o", self.path(arguments[0] + "%02d.png"), *arguments, *options,
                program=ANIMATED_FOG)
            self.assertEqual(code, 0, errors)
        frames = [read_png(self.path(f"--frames{i:02d}.png")) for i in range(3)]
        np.testing.assert_array_equal(frames[1], read_png(self.path("--frame01.png")))
        still = self.render(self.SCENE, "still.png", "--size", "80x60", "--exposure", "1")
        self.assertLessEqual(np.abs(frames[0] - still).max(), 1 / 255)
        self.assertGreater(np.abs(frames[1] - frames[0]).max(), 0.05)
        self.assertGreater(np.abs(frames[2] - frames[1]).max(), 0.05)
        # The same moment of a period, and of the next.
        for period, frame in (("8", "2"), ("4", "5")):
            self.run_program(self.SCENE, "-o", self.path("other.png"), "--period", period,
                             "--frame", frame, "--size", "80x60", program=ANIMATED_FOG)
            np.testing.assert_array_equal(frames[1], read_png(self.path("other.png")))
        self.fail_with(["%04d"], self.SCENE, "-o", self.path("a.png"), "--frames", "2",
                       program=ANIMATED_FOG)
        self.fail_with(["no surface 9"], self.SCENE, "-o", self.path("a.png"), "--frame", "2",
                       "--surface", "9", program=ANIMATED_FOG)


class TestOrbit(ProgramTest):
    """--orbit: pictures from all around."""

    SCENE = scene_file("S3_ground_occluders")

    def test_camera(self):
        """Picture 1 of 3 is what a camera sees that went a third of the circle to the right."""
        with open(self.SCENE) as file:
            camera = json.load(file)["camera"]
        self.succeed("render", self.SCENE, "-o", self.path("a%02d.pfm"), "--orbit", "3", "--size",
                     "80x60")
        still = self.render(self.SCENE, "still.pfm", "--size", "80x60")
        np.testing.assert_array_equal(read_pfm(self.path("a00.pfm")), still)
        up = np.array(camera["view_up"]) / np.linalg.norm(camera["view_up"])
        way = np.subtract(camera["position"], camera["focal_point"])
        angle = np.radians(120)
        turned = (way * np.cos(angle) + np.cross(up, way) * np.sin(angle)
                  + up * (up @ way) * (1 - np.cos(angle)))
        position = np.add(camera["focal_point"], turned)
        there = self.render(self.SCENE, "there.pfm", "--size", "80x60", "--camera",
                            f"{join(position)}:{join(camera['focal_point'])}")
        self.assertGreater(np.abs(there - still).max(), 0.1 * still.max())
        orbit = read_pfm(self.path("a01.pfm"))
        self.assertGreater((np.abs(orbit - there) <= 1e-4 * there + 1e-5).mean(), 0.999)
        self.assertFalse(os.path.exists(self.path("a03.pfm")))

    def test_exposure(self):
        """Automatic exposure is that of the first picture: a camera that turns into the light has
        brighter pictures, not other surfaces."""
        scene = write_models(self.path)[0]
        options = ("--size", "64x48", "--antialiasing", "2")
        self.succeed("render", self.path(scene), "-o", self.path("%d.png"), "--orbit", "4",
                     *options)
        frames = [read_png(self.path(f"{i}.png")) for i in range(4)]
        np.testing.assert_array_equal(frames[0], self.render(self.path(scene), "x.png", *options))
        means = [frame.mean() for frame in frames]
        self.assertGreater(max(means) / min(means), 1.15)
        # An exposure of its own shows each picture's middle as middle grey.
        own = self.render(self.path(scene), "y.png", "--camera", "1.9,0.5,-0.8:0,0,0", *options)
        self.assertLess(abs(own.mean() / frames[0].mean() - 1), 0.15)

    def test_progress(self):
        """A bar on terminals; elsewhere nothing, which succeed() asserts."""
        ours, theirs = pty.openpty()
        subprocess.run([PROGRAM, "render", self.SCENE, "-o", self.path("%d.pfm"), "--orbit", "2",
                        "--size", "16x12"], stderr=theirs, check=True, timeout=300)
        os.close(theirs)
        text = b""
        try:
            while True:
                text += os.read(ours, 1000)
        except OSError:  # the end
            pass
        os.close(ours)
        for words in (r"\] 0/2", r"\] 1/2, \d+:\d\d left", r"\] 2/2 in \d+:\d\d"):
            self.assertRegex(text.decode(), words)

    def test_errors(self):
        for output, options, words in (
                ("a.png", ["--orbit", "3"], ["--output", "%04d"]),
                ("a%d%d.png", ["--orbit", "3"], ["--output", "%04d"]),
                ("a%d.jpg", ["--orbit", "3"], ["png"]),
                ("a%d.png", ["--orbit", "0"], ["--orbit"]),
                ("a%d.png", ["--orbit", "x"], ["--orbit"]),
                ("a%d.pfm", ["--orbit", "3", "--reference"], ["--orbit", "--reference"])):
            self.fail_with(words, "render", self.SCENE, "-o", self.path(output), *options)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
