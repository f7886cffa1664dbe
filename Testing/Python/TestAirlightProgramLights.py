# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The lamps of the command line, --point, --spot and --sun, against closed forms and quadrature.

Run it like TestAirlightProgram.py.
"""

import json
import unittest

import numpy as np

from programtest import SceneTest, henyey_greenstein, pixel_rays, read_pfm, scene_file

FOUR_PI = 4 * np.pi


class TestSun(SceneTest):
    def test_unbounded(self):
        """The sun arrives unattenuated everywhere and the ray has no end, so that

            L = sigma_s p(w.d) E int_0^inf exp(-sigma_t t) dt = sigma_s/sigma_t p(w.d) E

        with w towards the sun: who looks at it sees light that went straight on.
        """
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        for number, sun in enumerate(((1, 2, -3), (-0.1, 0.02, 0.4))):
            cosine = rays @ (np.array(sun) / np.linalg.norm(sun))
            # g = 0 takes no fit; another one may err by the fit's 1e-3.
            for g, tolerance in ((0, 1e-5), (0.5, 1.01e-3)):
                image = self.render(
                    self.scene(), f"{number}.pfm", "--buffer", "Airlight", "--scattering",
                    "0.1,0.2,0.3", "--absorption", "0.1,0,0.6", "--anisotropy", str(g),
                    "--sun", ",".join(map(str, sun)) + ":4,5,6")
                albedo = np.array([1 / 2, 1, 1 / 3])
                expected = albedo * [4, 5, 6] * henyey_greenstein(g, cosine)[..., None]
                np.testing.assert_allclose(image, expected, rtol=tolerance)

    def test_box(self):
        """The sun overhead, the medium in a box with the top Y; on the ray o + t d from a to b:

            L = sigma_s E/(4 pi) int_a^b exp(-sigma_t ((t - a) + (Y - o_y - t d_y))) dt
              = sigma_s E/(4 pi) exp(-sigma_t (Y - o_y - a d_y)) (1 - exp(-k (b - a)))/k,
            k = sigma_t (1 - d_y).
        """
        low, high = np.array([-1.5, -1, -2]), np.array([1, 0.8, 1])
        image = self.render(
            self.scene(), "a.pfm", "--buffer", "Airlight", "--box", "-1.5,1,-1,0.8,-2,1",
            "--scattering", "0.3,0.6,1.2", "--absorption", "0.1,0,0.3", "--sun", "0,7,0:5")
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        ends = np.sort([(low - eye) / rays, (high - eye) / rays], axis=0)
        a = ends[0].max(axis=-1)[..., None]
        b = ends[1].min(axis=-1)[..., None]
        scattering, extinction = np.array([0.3, 0.6, 1.2]), np.array([0.4, 0.6, 1.5])
        dy = rays[..., 1:2]
        k = extinction * (1 - dy)
        expected = scattering * 5 / FOUR_PI * np.exp(-extinction * (high[1] - eye[1] - a * dy)) * (
            1 - np.exp(-k * (b - a))) / k
        long = (b - a)[..., 0] > 0.05  # shorter chords are worse conditioned than their pixels
        self.assertGreater(long.sum(), 200)
        np.testing.assert_allclose(image[long], expected[long], rtol=1e-4)
        outside = (b - a)[..., 0] < -1e-3
        self.assertGreater(outside.sum(), 200)
        self.assertEqual(image[outside].max(), 0)

    def test_wall(self):
        """A wall shows albedo/pi E cos(theta), less what the medium takes on both ways."""
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        wall = self.wall_scene([1, 0.5, 0.25])
        for sun, cosine in (("0,0,9", 1), ("3,0,1.7320508", 0.5)):
            clear = self.render(wall, "clear.pfm", "--buffer", "Surface", "--scattering", "0,0,0",
                                "--absorption", "0,0,0", "--sun", sun + ":3,4,5")
            expected = np.array([1, 0.5, 0.25]) / np.pi * [3, 4, 5] * cosine
            np.testing.assert_allclose(clear, np.broadcast_to(expected, clear.shape), rtol=1e-5)
            # 2 units of medium stand before the wall.
            foggy = self.render(wall, "foggy.pfm", "--buffer", "Surface", "--box",
                                "-99,99,-99,99,-1,2", "--scattering", "0.1,0.2,0",
                                "--absorption", "0.2,0.1,0.1", "--sun", sun + ":3,4,5")
            way = 2 / cosine + 2 / -rays[..., 2:]
            expected = expected * np.exp(-np.array([0.3, 0.3, 0.1]) * way)
            np.testing.assert_allclose(foggy, expected, rtol=2e-5)


class TestSpot(SceneTest):
    POSITION = np.array([0.3, 1.6, -0.2])
    TARGET = np.array([0.1, -0.4, 0.2])
    HALF_ANGLE = 21.0
    SPOT = "0.3,1.6,-0.2:0.1,-0.4,0.2:21:"

    def cosine(self, points):
        """Cosine of the angle to the spot's axis, and the distance from the spot."""
        axis = (self.TARGET - self.POSITION) / np.linalg.norm(self.TARGET - self.POSITION)
        way = points - self.POSITION
        distance = np.linalg.norm(way, axis=-1)
        return way @ axis / distance, distance

    def test_edge(self):
        """Exactly the pixels whose ray meets the cone are lit.

        With w = o - P, A = w.a, B = d.a, C = w.w, D = w.d the cosine to the axis along the ray is
        (A + B t)/sqrt(C + 2 D t + t^2). It has its one extremum at t = (A D - B C)/(B D - A); its
        largest value on the ray is there, at the eye or at infinity.
        """
        image = self.render(self.scene(), "a.pfm", "--buffer", "Airlight", "--scattering",
                            "0.1,0.1,0.1", "--spot", self.SPOT + "10")
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        axis = (self.TARGET - self.POSITION) / np.linalg.norm(self.TARGET - self.POSITION)
        w = eye - self.POSITION
        a, b, c, d = w @ axis, rays @ axis, w @ w, rays @ w
        t = np.maximum((a * d - b * c) / (b * d - a), 0)
        largest = np.maximum.reduce([self.cosine(eye + t[..., None] * rays)[0], b,
                                     np.full(b.shape, self.cosine(eye)[0])])
        margin = largest - np.cos(np.radians(self.HALF_ANGLE))
        sure = np.abs(margin) > 1e-5
        self.assertGreater(sure.sum(), 0.999 * sure.size)
        np.testing.assert_array_equal((image[..., 1] > 0)[sure], (margin > 0)[sure])
        self.assertGreater((margin < 0).sum(), 400)
        self.assertGreater((margin > 0).sum(), 200)

    def test_radiance(self):
        """Inside the cone, intensity times cosine to the exponent; by the midpoint rule.

        The rule runs over the angle phi, t = tL + h tan(phi), in which 1/r^2 dt = dphi/h. The
        cone's edge lies anywhere in a step, so the rule errs by up to one step of the lit part's
        few thousand.
        """
        eye = np.array(self.CAMERA["position"])
        rows, columns = np.mgrid[1:self.SIZE[1]:3, 2:self.SIZE[0]:3].reshape(2, -1)
        rays = pixel_rays(self.CAMERA, *self.SIZE)[rows, columns]
        foot = (self.POSITION - eye) @ rays.T
        h = np.linalg.norm(eye + foot[:, None] * rays - self.POSITION, axis=-1)
        steps = 20000
        start = np.arctan2(-foot, h)
        width = (np.pi / 2 - start) / steps
        for tail, exponent in (("", 0), (":0", 0), (":7.5", 7.5)):
            image = self.render(
                self.scene(), "a.pfm", "--buffer", "Airlight", "--scattering", "0.2,0.2,0.2",
                "--absorption", "0.05,0.05,0.05", "--spot", self.SPOT + "10,20,30" + tail)
            integral = np.empty(len(rays))
            for i, ray in enumerate(rays):
                phi = start[i] + (np.arange(steps) + 0.5) * width[i]
                t = foot[i] + h[i] * np.tan(phi)
                cosine, r = self.cosine(eye + t[:, None] * ray)
                inside = cosine > np.cos(np.radians(self.HALF_ANGLE))
                strength = np.where(inside, np.abs(cosine)**exponent, 0)
                integral[i] = np.sum(strength * np.exp(-0.25 * (t + r))) * width[i] / h[i]
            expected = 0.2 / FOUR_PI * integral[:, None] * [10, 20, 30]
            lit = integral > 0.1 * integral.max()
            self.assertGreater(lit.sum(), 20)
            np.testing.assert_allclose(image[rows, columns][lit], expected[lit], rtol=1e-3)

    def test_wall(self):
        """The wall z = 0 in clear air under a spot that faces it: albedo/pi I cos^(n+1)/r^2."""
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        points = eye - rays * (eye[2] / rays[..., 2:])
        way = points - [0.2, 0.1, 3]
        r = np.linalg.norm(way, axis=-1)
        cosine = -way[..., 2] / r
        image = self.render(
            self.wall_scene([0.8, 0.8, 0.8]), "a.pfm", "--buffer", "Surface", "--scattering",
            "0,0,0", "--absorption", "0,0,0", "--spot", "0.2,0.1,3:0.2,0.1,1:25:9:3")
        expected = 0.8 / np.pi * 9 * cosine**4 / r**2
        edge = cosine - np.cos(np.radians(25))
        lit, dark = edge > 1e-5, edge < -1e-5
        self.assertGreater(min(lit.sum(), dark.sum()), 200)
        np.testing.assert_allclose(image[lit][:, 0], expected[lit], rtol=2e-5)
        self.assertEqual(image[dark].max(), 0)


class TestMixture(SceneTest):
    LAMPS = (("--point", "0.13,4.21,-0.17:30,28,24"), ("--spot", "-2,5,1:0,0,0:25:60:2"),
             ("--sun", "1,2,0.5:3"), ("--point", "2,3,2:9"), ("--sun", "-1,2,-0.2:1,2,3"))

    def test_sum(self):
        """Light adds up, in the air and on surfaces, with every lamp's own shadows; the scene's
        lamp is gone, or it would be counted five times."""
        scene = scene_file("S3_ground_occluders")
        alone = [self.render(scene, f"{i}.pfm", *lamp) for i, lamp in enumerate(self.LAMPS)]
        for image in alone:
            self.assertGreater(image.max(), 0.01)
        together = self.render(scene, "all.pfm", *(word for lamp in self.LAMPS for word in lamp))
        np.testing.assert_allclose(together, sum(alone), rtol=1e-5, atol=1e-7)

    def test_one_number_for_three(self):
        scene = scene_file("S3_ground_occluders")
        for option, place in (("--point", "0,4,0:"), ("--spot", "0,4,0:0,0,0:30:"),
                              ("--sun", "1,1,1:")):
            np.testing.assert_array_equal(
                self.render(scene, "a.pfm", option, place + "7"),
                self.render(scene, "b.pfm", option, place + "7,7,7"), option)


class TestExtent(SceneTest):
    """Lamps of finite size: means over their points."""

    CLEAR = ("--scattering", "0,0,0", "--absorption", "0,0,0", "--buffer", "Surface",
             "--antialiasing", "256")

    def test_rectangle(self):
        """A wall close to a rectangle: the mean of albedo/pi I cos/r^2 over a grid of points."""
        image = self.render(
            self.wall_scene([0.8, 0.8, 0.8]), "a.pfm", *self.CLEAR, "--point", "0.2,0.1,0.8:9",
            "--lamp-size", "2,1", "--ies-aim", "0.2,0.1,0", "--ies-up", "1,0,0")
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        points = eye - rays * (eye[2] / rays[..., 2:])

        def shine(offsets_x, offsets_y):
            return np.mean([0.8 / np.pi * 9 * 0.8 / np.linalg.norm(
                points - [0.2 + x, 0.1 + y, 0.8], axis=-1)**3
                            for x in offsets_x for y in offsets_y], axis=0)
        steps = (np.arange(20) + 0.5) / 20 - 0.5
        expected = shine(steps, 2 * steps)  # the height, 1, lies along x
        np.testing.assert_allclose(image[..., 0], expected, rtol=0.03)
        self.assertGreater(np.abs(shine(2 * steps, steps) / expected - 1).max(), 0.1)

    def test_sun(self):
        """The shadow of a half plane 6 above a wall, under a sun of 20 degrees overhead: dark,
        half lit below the edge, and lit between 6 tan(10 degrees) beside it."""
        self.write("wall.ply", "\n".join((
            "ply", "format ascii 1.0", "element vertex 8", "property float x",
            "property float y", "property float z", "element face 2",
            "property list uchar int vertex_indices", "end_header",
            "-50 -50 0", "50 -50 0", "50 50 0", "-50 50 0",
            "0 -50 6", "50 -50 6", "50 50 6", "0 50 6", "4 0 1 2 3", "4 4 5 6 7", "")))
        scene = self.scene(surfaces=[{"mesh": "wall.ply", "albedo": [1, 1, 1]}])
        image = self.render(scene, "a.pfm", *self.CLEAR, "--sun", "0,0,1:3", "--sun-diameter",
                            "20")
        rays = pixel_rays(self.CAMERA, *self.SIZE)[15]
        x = 0.2 - rays[:, 0] * (5 / rays[:, 2])
        share = image[15, :, 0] * np.pi / 3
        # Towards a point a from the disc's middle, in units of its radius: half a circle's share.
        a = np.clip(x / (6 * np.tan(np.radians(10))), -1, 1)
        expected = 0.5 - (np.arcsin(a) + a * np.sqrt(1 - a * a)) / np.pi
        self.assertGreater(((expected > 0.1) & (expected < 0.9)).sum(), 5)
        np.testing.assert_allclose(share, expected, atol=0.04)

    def test_scene_file(self):
        """What the file says is what the options say."""
        path = self.wall_scene([0.5, 0.5, 0.5])
        with open(path) as file:
            scene = json.load(file)
        point = {"type": "point", "position": [0.2, 0.1, 1], "intensity": [5, 5, 5]}
        spot = {"type": "spot", "position": [0.2, 0.1, 1], "direction": [0, 0, -1],
                "cone_half_angle_deg": 40, "exponent": 2, "intensity": [5, 5, 5]}
        sun = {"type": "directional", "direction": [0, -1, -1], "irradiance": [5, 5, 5]}
        by_point = ("--point", "0.2,0.1,1:5")
        by_spot = ("--spot", "0.2,0.1,1:0.2,0.1,0:40:5:2")
        # No sun is seen through endless fog, of which a warning tells.
        more = ("--antialiasing", "8", "--box", "-99,99,-99,99,-1,9")
        for light, *options in (
                (dict(point, radius=0.5), *by_point, "--lamp-radius", "0.5"),
                (dict(point, size=[1, 0.5]), *by_point, "--lamp-size", "1,0.5"),
                (dict(point, size=[1, 0.5], direction=[0, 0, -1], photometry_up=[1, 0, 0]),
                 *by_point, "--lamp-size", "1,0.5", "--ies-aim", "0.2,0.1,0", "--ies-up", "1,0,0"),
                (dict(spot, radius=0.5), *by_spot, "--lamp-radius", "0.5"),
                (dict(spot, size=[1, 0.5]), *by_spot, "--lamp-size", "1,0.5"),
                (dict(spot, size=[1, 0.5], visible=True), *by_spot, "--lamp-size", "1,0.5",
                 "--lamp-visible"),
                (dict(sun, angular_diameter_deg=20, visible=True), "--sun", "0,1,1:5",
                 "--lamp-visible", "--sun-diameter", "20"),
                (dict(sun, angular_diameter_deg=20), "--sun", "0,1,1:5", "--sun-diameter", "20")):
            by_option = self.render(path, "a.pfm", *options, *more)
            by_file = self.render(self.write("b.json", json.dumps(dict(scene, lights=[light]))),
                                  "b.pfm", *more)
            np.testing.assert_array_equal(by_file, by_option, str(light))
            bare = self.render(path, "c.pfm", *options[:2], *more)
            self.assertGreater(np.abs(bare - by_option).max(), 1e-3 * bare.max(), str(light))

    def render_points(self, scene, name, *options):
        """One frame, which warns that it takes lamps for points."""
        code, _, errors = self.run_program("render", scene, "-o", self.path(name), *options)
        self.assertEqual(code, 0, errors)
        return read_pfm(self.path(name))

    VISIBLE_SUN = ("--sun", "0.02,-0.01,-1:5,4,3", "--sun-diameter", "8", "--lamp-visible")

    def test_visible(self):
        """A lamp shows its intensity over its area, a sun its irradiance over its solid angle."""
        disc = 2 * np.pi * (1 - np.cos(np.radians(4)))
        for options, radiance in (
                (("--point", "0.2,0.1,3:5,4,3", "--lamp-visible", "--lamp-radius", "0.25"),
                 np.array([5, 4, 3]) / (np.pi * 0.25**2)),
                (("--spot", "0.2,0.1,3:0.2,0.1,9:40:5,4,3", "--lamp-size", "1,0.5",
                  "--lamp-visible"), np.array([5, 4, 3]) / 0.5),
                (self.VISIBLE_SUN, np.array([5, 4, 3]) / disc)):
            clear = ("--scattering", "0,0,0", "--absorption", "0,0,0", *options)
            image = self.render_points(self.scene(), "a.pfm", *clear)
            brightest = image.reshape(-1, 3)[image[..., 0].argmax()]
            np.testing.assert_allclose(brightest, radiance, rtol=1e-3, err_msg=str(options))
            picture = self.render(self.scene(), "a.png", *clear)
            self.assertGreater(picture[image[..., 0] > 0].mean(), 0.25)
            hidden = [option for option in clear if option != "--lamp-visible"]
            self.assertEqual(self.render_points(self.scene(), "b.pfm", *hidden).max(), 0)

    def test_sun_disc(self):
        """Exactly the pixels whose ray meets it show the disc, behind what is before it."""
        image = self.render_points(
            self.scene(), "a.pfm", "--box", "-99,99,-99,99,-1,2", "--scattering", "0,0,0",
            "--absorption", "0.2,0.1,0.1", *self.VISIBLE_SUN)
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        sun = np.array([0.02, -0.01, -1])
        angle = np.degrees(np.arccos(rays @ (sun / np.linalg.norm(sun))))
        disc = angle < 4
        sure = np.abs(angle - 4) > 1e-3
        np.testing.assert_array_equal((image[..., 0] > 0)[sure], disc[sure])
        self.assertGreater(disc.sum(), 10)
        way = 3 / -rays[..., 2:]
        expected = np.array([5, 4, 3]) * np.exp(-np.array([0.2, 0.1, 0.1]) * way) / (
            2 * np.pi * (1 - np.cos(np.radians(4))))
        np.testing.assert_allclose(image[disc & sure], expected[disc & sure], rtol=1e-5)
        wall = self.render_points(self.wall_scene([0, 0, 0]), "b.pfm", "--scattering", "0,0,0",
                                  *self.VISIBLE_SUN)
        self.assertEqual(wall.max(), 0)

    def test_one_frame(self):
        """Is a warning, and takes the lamp for a point."""
        scene = self.wall_scene([0.5, 0.5, 0.5])
        code, _, errors = self.run_program("render", scene, "-o", self.path("a.pfm"), "--point",
                                           "0,0,1:5", "--lamp-radius", "0.5")
        self.assertEqual(code, 0)
        self.assertIn("warning: one frame takes lamps for points", errors)
        bare = self.render(scene, "b.pfm", "--point", "0,0,1:5")
        np.testing.assert_array_equal(read_pfm(self.path("a.pfm")), bare)

    def test_errors(self):
        """Name option or line, value and remedy."""
        path = self.wall_scene([0.5, 0.5, 0.5])
        out = ("-o", self.path("x.png"))
        point, sun = ("--point", "0,0,1:5"), ("--sun", "0,1,1:5")
        for options, words in (
                ((*point, "--lamp-radius", "-1"), ["--lamp-radius '-1'", "0 to 1e30"]),
                ((*point, "--lamp-radius", "nan"), ["--lamp-radius 'nan'"]),
                ((*point, "--lamp-size", "1"), ["--lamp-size '1'", "W,H"]),
                ((*point, "--lamp-size", "1,-1"), ["--lamp-size '1,-1'"]),
                ((*point, "--lamp-size", "1,1", "--lamp-radius", "1"), ["without --lamp-size"]),
                ((*point, "--lamp-radius", "1", "--lamp-size", "1,1"), ["without --lamp-radius"]),
                ((*sun, "--sun-diameter", "180"), ["--sun-diameter '180'", "179 degrees"]),
                ((*point, "--sun-diameter", "1"), ["behind the --sun"]),
                ((*sun, "--lamp-radius", "1"), ["behind the --point or --spot"]),
                (("--lamp-radius", "1", *point), ["behind the --point or --spot"]),
                ((*point, "--ies-up", "1,0,0"), ["--ies FILE or --lamp-size"]),
                ((*point, "--lamp-visible"), ["--lamp-visible", "--lamp-radius"]),
                ((*sun, "--lamp-visible"), ["--lamp-visible", "--sun-diameter"]),
                (("--lamp-visible", *point), ["--lamp-visible: expected behind"]),
                ((*point, "--lamp-radius", "1", "--lamp-visible", "--no-medium"),
                 ["--no-medium"]),
                ((*point, "--lamp-radius", "1", "--lamp-visible", "--reference"),
                 ["--reference", "--lamp-visible"]),
                ((*point, "--lamp-radius", "1", "--no-medium"), ["--no-medium"])):
            self.fail_with(words, "render", path, *out, *options)
        with open(path) as file:
            scene = json.load(file)
        lamp, far = scene["lights"][0], {"type": "directional", "direction": [0, -1, 0],
                                         "irradiance": [1, 1, 1]}
        for light, words in (
                (dict(lamp, radius=-1), ["lights[0].radius", "-1"]),
                (dict(lamp, radius="1"), ["lights[0].radius"]),
                (dict(lamp, size=1), ["lights[0].size", "list"]),
                (dict(lamp, size=[1]), ["lights[0].size", "2 numbers"]),
                (dict(lamp, size=[1, -1]), ["lights[0].size[1]"]),
                (dict(lamp, size=[1, 1], radius=1), ["lights[0].radius", "size"]),
                (dict(lamp, radius=1, direction=[0, 1, 0]), ["unknown key 'direction'"]),
                (dict(lamp, angular_diameter_deg=1), ["unknown key 'angular_diameter_deg'"]),
                (dict(far, angular_diameter_deg=180), ["lights[0].angular_diameter_deg"]),
                (dict(lamp, visible=True), ["lights[0].visible", "radius"]),
                (dict(far, visible=True), ["lights[0].visible", "angular_diameter_deg"]),
                (dict(lamp, radius=1, visible=1), ["lights[0].visible"]),
                (dict(far, radius=1), ["unknown key 'radius'", "angular_diameter_deg"])):
            bad = self.write("bad.json", json.dumps(dict(scene, lights=[light])))
            self.fail_with([bad + ":1: ", *words], "render", bad, *out)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
