# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The media of the command line and of scene files: regions, ambient light, skies and height fog.

Run it like TestAirlightProgram.py.
"""

import unittest

import numpy as np

from vtkmodules.vtkFiltersSources import vtkCubeSource

from programtest import TETRAHEDRON, SceneTest, henyey_greenstein, pixel_rays, write_mesh

DARK = ("--point", "0,0,0:0")
COEFFICIENTS = ("--scattering", "0.3,0.6,0", "--absorption", "0.1,0,0.2")
ALBEDO, EXTINCTION = np.array([0.75, 1, 0]), np.array([0.4, 0.6, 0.2])


class TestRegions(SceneTest):
    def check(self, lengths, sure, *options):
        """Transmittance, and ambient light albedo L (1 - T), for these lengths of medium."""
        expected = np.exp(-EXTINCTION * lengths[..., None])
        image = self.render(self.scene(), "t.pfm", *COEFFICIENTS, *DARK, *options, "--buffer",
                            "Transmittance")
        np.testing.assert_allclose(image[sure], expected[sure], rtol=2e-5)
        image = self.render(self.scene(), "a.pfm", *COEFFICIENTS, *DARK, *options, "--buffer",
                            "Airlight", "--ambient", "1,2,3")
        expected = ALBEDO * [1, 2, 3] * (1 - expected)
        np.testing.assert_allclose(image[sure], expected[sure], rtol=2e-5, atol=1e-5)

    def test_box(self):
        low, high = np.array([-1.5, -1, -2]), np.array([1, 0.8, 1])
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        ends = np.sort([(low - eye) / rays, (high - eye) / rays], axis=0)
        lengths = ends[1].min(axis=-1) - ends[0].max(axis=-1)
        self.assertGreater(min((lengths > 1).sum(), (lengths < 0).sum()), 100)
        self.check(np.maximum(lengths, 0), np.abs(lengths) > 1e-3, "--box",
                   "-1.5,1,-1,0.8,-2,1")

    def test_surface(self):
        """A box given as a mesh, of every kind."""
        low, high = np.array([-1.5, -1, -2]), np.array([1, 0.75, 1])
        cube = vtkCubeSource()
        cube.SetBounds(-1.5, 1, -1, 0.75, -2, 1)
        cube.Update()
        # VTK 9.1 writes an OBJ of too few texture coordinates.
        cube.GetOutput().GetPointData().Initialize()
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        ends = np.sort([(low - eye) / rays, (high - eye) / rays], axis=0)
        lengths = ends[1].min(axis=-1) - ends[0].max(axis=-1)
        for extension in ("ply", "stl", "obj", "vtp"):
            mesh = self.path("cube." + extension)
            write_mesh(cube.GetOutput(), mesh)
            self.check(np.maximum(lengths, 0), np.abs(lengths) > 1e-3, "--surface", mesh)

    def test_light_in_surface(self):
        """The airlight of a lamp inside, outside and behind a box is the same whether the box is
        given by numbers or as a mesh: both within 1e-3 of the truth."""
        cube = vtkCubeSource()
        cube.SetBounds(-1.5, 1, -1, 0.75, -2, 1)
        cube.Update()
        mesh = self.path("cube.ply")
        write_mesh(cube.GetOutput(), mesh)
        for lamp in ("0.3,0.2,-0.5:9", "2,1.5,2:9", "0.1,0.2,-4:9"):
            box = self.render(self.scene(), "a.pfm", "--buffer", "Airlight", "--point", lamp,
                              "--box", "-1.5,1,-1,0.75,-2,1")
            surface = self.render(self.scene(), "b.pfm", "--buffer", "Airlight", "--point", lamp,
                                  "--surface", mesh)
            sure = box.min(axis=-1) > 0.01 * box.max()
            self.assertGreater(sure.sum(), 100)
            np.testing.assert_allclose(surface[sure], box[sure], rtol=2e-3, err_msg=lamp)

    def test_sphere(self):
        """A chord at the distance h from the middle is 2 sqrt(R^2 - h^2) long."""
        center, radius = np.array([-0.5, 0.3, -1]), 1.2
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        h = np.linalg.norm(np.cross(rays, center - eye), axis=-1)
        chords = 2 * np.sqrt(np.maximum(radius**2 - h**2, 0))
        self.assertGreater(min((chords > 1).sum(), (chords == 0).sum()), 100)
        self.check(chords, np.abs(h - radius) > 0.02, "--sphere", "-0.5,0.3,-1:1.2")

    def test_cylinder(self):
        """Along z, a chord is 2 sqrt(R^2 - h^2) long in x and y, cut off at the ends; along a ray
        it is longer by 1/sin, with the angle to the axis."""
        center, radius, half = np.array([-0.5, 0.3, -1]), 1.2, 0.8
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        o = np.array(self.CAMERA["position"]) - center
        across = rays[..., :2]
        sine = np.linalg.norm(across, axis=-1)
        h = np.abs(o[0] * across[..., 1] - o[1] * across[..., 0]) / sine
        foot = -(across @ o[:2]) / sine**2
        chord = np.sqrt(np.maximum(radius**2 - h**2, 0)) / sine
        ends = np.sort((np.array([[[-half, half]]]) - o[2]) / rays[..., 2:], axis=-1)
        lengths = np.minimum(foot + chord, ends[..., 1]) - np.maximum(foot - chord, ends[..., 0])
        self.assertGreater(min((lengths > 1).sum(), (lengths < 0).sum()), 100)
        self.check(np.maximum(lengths, 0), (np.abs(lengths) > 0.02) & (np.abs(h - radius) > 0.02),
                   "--cylinder", "-0.5,0.3,-1:1.2:1.6:0,0,3")

    def test_ground(self):
        """Fog that goes on below sends light back from there, as ground of a high albedo does."""
        self.write("tetrahedron.obj", TETRAHEDRON)
        pictures = []
        for ground in ({}, {"ground_height": -0.6, "ground_albedo": [0, 0, 0]},
                       {"ground_height": -0.6, "ground_albedo": [1, 1, 1]}):
            fog = {"type": "exponential_height", "reference_height": -0.5, "scale_height": 0.7}
            scene = self.scene(density=dict(fog, **ground), multiple_scattering=True)
            pictures.append(self.render(scene, "a.pfm", "--sun", "1,2,3:4").mean())
        once = self.render(self.scene(density=fog), "a.pfm", "--sun", "1,2,3:4").mean()
        self.assertGreater(pictures[1], 1.02 * once)
        self.assertGreater(pictures[0], 1.02 * pictures[1])
        self.assertGreater(pictures[2], 1.02 * pictures[1])

    def test_scene_file(self):
        """What a scene file says about regions and density is what the options say, and the options
        outdo the file."""
        fog = {"type": "exponential_height", "reference_height": -0.5, "scale_height": 0.7}
        other = {"bounds": {"type": "sphere", "center": [9, 9, 9], "radius": 0.1},
                 "density": {"type": "exponential_height", "reference_height": 3,
                             "scale_height": 9, "up": [1, 0, 0]}}
        sun = ("--sun", "1,2,3:4")
        self.write("tetrahedron.obj", TETRAHEDRON)
        plain = self.render(self.scene(), "plain.pfm", *sun)
        for key, value, *options in (
                ("bounds", {"type": "box", "min": [-1.5, -1, -2], "max": [1, 0.8, 1]},
                 "--box", "-1.5,1,-1,0.8,-2,1"),
                ("bounds", {"type": "sphere", "center": [-0.5, 0.3, -1], "radius": 1.2},
                 "--sphere", "-0.5,0.3,-1:1.2"),
                ("bounds", {"type": "cylinder", "center": [-0.5, 0.3, -1], "radius": 1.2,
                            "height": 1.6, "axis": [1, 2, 0]},
                 "--cylinder", "-0.5,0.3,-1:1.2:1.6:1,2,0"),
                ("bounds", {"type": "cylinder", "center": [0, 0.3, -1], "radius": 0.7,
                            "height": 2}, "--cylinder", "0,0.3,-1:0.7:2"),
                ("bounds", {"type": "surface", "mesh": "tetrahedron.obj"},
                 "--surface", self.path("tetrahedron.obj")),
                ("density", fog, "--height-fog", "-0.5:0.7"),
                ("density", dict(fog, up=[1, 2, 0]), "--height-fog", "-0.5:0.7:1,2,0")):
            with self.subTest(value=value):
                by_file = self.render(self.scene(**{key: value}), "a.pfm", *sun)
                self.assertGreater(np.abs(by_file - plain).max(), 1e-3)
                by_option = self.render(self.scene(), "b.pfm", *sun, *options)
                np.testing.assert_array_equal(by_option, by_file)
                over_other = self.render(self.scene(**{key: other[key]}), "c.pfm", *sun, *options)
                np.testing.assert_array_equal(over_other, by_file)


class TestSky(SceneTest):
    SKY = {"radiance": [1, 2, 3], "ground_radiance": [0.5, 0, 4], "up": [0, 1, -2]}

    def test_sky(self):
        """The mean of both colours and half their difference times what Henyey and Greenstein's
        function scatters of a sky that is 1 above and -1 below, by quadrature over directions."""
        g, up = 0.5, np.array([0, 1, -2]) / 5**0.5
        nodes, weights = np.polynomial.legendre.leggauss(60)
        azimuth = 2 * np.pi * (np.arange(200) + 0.5) / 200
        z = np.concatenate([0.5 * nodes - 0.5, 0.5 * nodes + 0.5])[:, None]
        area = np.tile(0.5 * weights, 2)[:, None] * 2 * np.pi / 200

        def scatter(x):
            cosine = x * z + np.sqrt((1 - x * x) * (1 - z * z)) * np.cos(azimuth)
            return (area * np.sign(z) * henyey_greenstein(g, cosine)).sum()

        heights = pixel_rays(self.CAMERA, *self.SIZE) @ up
        x = np.linspace(heights.min(), heights.max(), 200)
        share = np.interp(heights, x, [scatter(one) for one in x])[..., None]
        self.assertGreater(np.ptp(share), 0.2)
        scene = self.scene(sky=self.SKY, phase={"type": "henyey_greenstein", "g": g})
        seen = self.render(scene, "a.pfm", *DARK, "--buffer", "Airlight")
        expected = np.array([1, 1, 0.8]) * ([0.75, 1, 3.5] + share * [0.25, 1, -0.5])
        np.testing.assert_allclose(seen, expected, rtol=1e-3)

    def test_errors(self):
        fog = {"type": "exponential_height", "reference_height": 0, "scale_height": 1}
        for sky, changes, what in (
                ({"ground_radiance": [1, 1, 1]}, {}, "radiance"),
                ({"radiance": [1, -1, 1]}, {}, "medium.sky.radiance"),
                (dict(self.SKY, up=[0, 0, 0]), {}, "medium.sky.up"),
                (self.SKY, {"density": fog}, "medium.sky.up is that of medium.density")):
            with self.subTest(sky=sky):
                self.fail_with([what], "render", self.scene(sky=sky, **changes), "-o",
                               self.path("a.png"))


class TestHeightFog(SceneTest):
    def test_transmittance(self):
        """To the wall z = 0 at T = -o_z/d_z, with heights u.x, m = u.d:

            tau = sigma int_0^T exp(-(u.o + m t - Z)/H) dt = sigma exp(-(u.o - Z)/H) (1 -
            exp(-m T/H)) H/m
        """
        eye = np.array(self.CAMERA["position"])
        rays = pixel_rays(self.CAMERA, *self.SIZE)
        end = -eye[2] / rays[..., 2]
        for option, reference, scale, up in (("-0.5:0.7", -0.5, 0.7, (0, 1, 0)),
                                             ("0.4:3", 0.4, 3, (0, 1, 0)),
                                             ("0.2:1.5:1,2,0", 0.2, 1.5, (1, 2, 0)),
                                             ("-4:2.5:0,0,-8", -4, 2.5, (0, 0, -1))):
            up = np.array(up) / np.linalg.norm(up)
            image = self.render(self.wall_scene([1, 1, 1]), "t.pfm", *COEFFICIENTS, *DARK,
                                "--height-fog", option, "--buffer", "Transmittance")
            m = rays @ up
            length = np.exp(-(eye @ up - reference) / scale) * -np.expm1(-m * end / scale) * (
                scale / m)
            expected = np.exp(-EXTINCTION * length[..., None])
            # Single precision: relative errors of a few 1e-7 in an optical depth of up to 10.
            np.testing.assert_allclose(image, expected, rtol=5e-5, err_msg=option)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
