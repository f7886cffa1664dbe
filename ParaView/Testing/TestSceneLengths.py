# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Region and heights of the view's medium that follow the bounds of the visible data, by opacities
in closed form."""

import sys
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test

EXTINCTION = 0.8
EYE = np.array(test.CAMERA["position"])


def cross_ball(eye, rays, centre, radius):
    along = -((eye - centre) * rays).sum(axis=-1)
    root = np.sqrt(np.maximum(radius**2 - ((eye - centre)**2).sum(axis=-1) + along**2, 0))
    return along - root, along + root


def cross_upright_cylinder(eye, rays, centre, radius, height):
    """A cylinder along y."""
    flat = rays[..., [0, 2]]
    square = (flat**2).sum(axis=-1)
    offset = (eye - centre)[..., [0, 2]]
    middle = -(offset * flat).sum(axis=-1) / square
    root = np.sqrt(np.maximum(
        radius**2 / square - (offset**2).sum(axis=-1) / square + middle**2, 0))
    ends = (centre[1] + np.array([-0.5, 0.5])[:, None, None] * height - eye[..., 1]) / rays[..., 1]
    enter = np.maximum(middle - root, ends.min(axis=0))
    return enter, np.maximum(np.minimum(middle + root, ends.max(axis=0)), enter)


class SceneLengths(unittest.TestCase):
    """The data are a line, which hides next to nothing."""

    @classmethod
    def setUpClass(cls):
        test.load_plugin()
        cls.view = test.make_view()
        test.add_lamp(cls.view)
        cls.line = simple.Line(Point1=[-0.9, -0.6, -0.5], Point2=[0.8, 0.7, 0.6])
        test.show(cls.view, cls.line)
        cls.view.Thickness = "Coefficients"
        cls.view.Scattering = [EXTINCTION] * 3
        simple.Render(cls.view)
        test.place_camera(cls.view)
        cls.rays = test.pixel_rays(*test.SIZE)
        cls.eye = np.broadcast_to(EYE, cls.rays.shape)

    def setUp(self):
        for name in ("Region", "RegionBounds", "RegionCenter", "RegionRadius", "RegionHeight",
                     "RegionAxis", "Density", "ScaleHeight", "ReferenceHeight"):
            self.view.GetProperty(name).ResetToDefault()
        self.view.UpdateVTKObjects()
        self.line.Point2 = [0.8, 0.7, 0.6]

    def bounds(self):
        ends = np.array([list(self.line.Point1), list(self.line.Point2)])
        return ends.min(axis=0), ends.max(axis=0)

    def check(self, depths, name):
        seen = test.picture(self.view, name, TransparentBackground=1)[..., 3] / 255
        difference = np.abs(seen - (1 - np.exp(-depths)))
        print(f"{name}: opacities {seen.min():.3f} to {np.quantile(seen, 0.98):.3f}; difference: "
              f"median {np.median(difference):.5f}, 95 % {np.quantile(difference, 0.95):.5f}")
        self.assertGreater(np.quantile(seen, 0.98) - seen.min(), 0.4, "there is a medium")
        # An opacity is made of two pictures of 8 bits. The line has some pixels.
        self.assertLess(np.quantile(difference, 0.95), 2 / 255)

    def test_box(self):
        """5 % of the diagonal larger on each side; given bounds count; it follows the data."""
        self.view.Region = "Box"

        def check(name):
            low, high = self.bounds()
            margin = 0.05 * np.linalg.norm(high - low)
            enter, leave = test.cross_box(self.eye, self.rays, low - margin, high + margin)
            self.check(EXTINCTION * (leave - enter), name)
        check("box-follows")
        self.line.Point2 = [0.3, 1.1, 0.9]
        check("box-followed")
        self.view.RegionBounds = [0, 1, -0.5, 0.5, -1, 0]
        enter, leave = test.cross_box(self.eye, self.rays, [0, -0.5, -1], [1, 0.5, 0])
        self.check(EXTINCTION * (leave - enter), "box-given")
        self.view.RegionBounds = [0] * 6
        check("box-again")

    def test_sphere(self):
        """Through the corners of the bounds, whatever centre is given; or as it is given."""
        self.view.Region = "Sphere"
        self.view.RegionCenter = [0.5, 0, 0]
        low, high = self.bounds()
        enter, leave = cross_ball(
            self.eye, self.rays, 0.5 * (low + high), 0.5 * np.linalg.norm(high - low))
        self.check(EXTINCTION * (leave - enter), "sphere-follows")
        self.view.RegionRadius = 0.7
        enter, leave = cross_ball(self.eye, self.rays, np.array([0.5, 0, 0]), 0.7)
        self.check(EXTINCTION * (leave - enter), "sphere-given")

    def test_cylinder(self):
        """Radius and height by themselves."""
        self.view.Region = "Cylinder"
        low, high = self.bounds()
        centre = 0.5 * (low + high)
        across = 0.5 * np.hypot(*(high - low)[[0, 2]])
        for radius, height in ((0, 0), (0, 0.6), (0.5, 0), (0, 0)):
            self.view.RegionRadius, self.view.RegionHeight = radius, height
            enter, leave = cross_upright_cylinder(
                self.eye, self.rays, np.zeros(3) if radius else centre, radius or across,
                height or (high - low)[1])
            self.check(EXTINCTION * (leave - enter), f"cylinder-{radius}-{height}")

    def test_heights(self):
        """The density is 1 at the lower end of the data and falls to exp(-2) at the upper one."""
        self.view.Density = "Exponential height"
        self.view.Region = "Sphere"
        self.view.RegionRadius = 1.5
        self.view.ReferenceHeight = 3
        low, high = self.bounds()
        enter, leave = cross_ball(self.eye, self.rays, np.zeros(3), 1.5)

        def check(scale, reference, name):
            heights = [(EYE[1] + t * self.rays[..., 1] - reference) / scale for t in (enter, leave)]
            slope = self.rays[..., 1] / scale
            self.check(EXTINCTION * (np.exp(-heights[0]) - np.exp(-heights[1])) / slope, name)
        check(0.5 * (high - low)[1], low[1], "heights-follow")
        self.view.ScaleHeight = 0.8
        self.view.ReferenceHeight = 0.2
        check(0.8, 0.2, "heights-given")


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
