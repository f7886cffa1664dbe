# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The medium of the view in a closed surface, with densities of an image, and both, of sources."""

import pathlib
import subprocess
import sys
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test

RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
EYE = np.array(test.CAMERA["position"])
SCATTERING = 0.6
SIZES = np.array([2.2, 1.4, 1.8])


def turn_y(vectors, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return vectors @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T


def make_box(lengths=SIZES, centre=(0.0, 0.0, 0.0)):
    return simple.Box(XLength=lengths[0], YLength=lengths[1], ZLength=lengths[2],
                      Center=list(centre))


def make_ramp():
    """An image whose density is x + 3, from -2 to 2 along x and y and from -1 to 1 along z."""
    image = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -1, 1])
    return simple.Calculator(Input=image, ResultArrayName="ramp", Function="coordsX+3")


def make_view():
    view = test.make_view()
    test.add_lamp(view)
    test.show(view, simple.Sphere(Radius=0.3, ThetaResolution=48, PhiResolution=48))
    view.Thickness = "Coefficients"
    view.Scattering = [SCATTERING] * 3
    view.PhaseFunction = "Isotropic"
    simple.Render(view)
    test.place_camera(view)
    return view


class MediumSources(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        test.load_plugin()
        cls.view = make_view()

    def setUp(self):
        self.view.Region, self.view.Density = "Unbounded", "Uniform"
        self.view.RegionSurface = self.view.DensityImage = None

    def check_opacity(self, depths, name):
        """depths: of each pixel's ray through the medium, by closed forms."""
        rays = test.pixel_rays(*test.SIZE)
        seen = test.picture(self.view, name, TransparentBackground=1)[..., 3] / 255
        ball = test.hit_ball(np.broadcast_to(EYE, rays.shape), rays, 0.31)
        difference = np.abs(seen - (1 - np.exp(-depths)))[np.isinf(ball)]
        print(f"{name}: opacities to {seen[np.isinf(ball)].max():.3f}; difference: median "
              f"{np.median(difference):.5f}, 98 % {np.quantile(difference, 0.98):.5f}")
        self.assertGreater(seen[np.isinf(ball)].max(), 0.4, "there is a medium")
        # An opacity is made of two pictures of 8 bits. Pixels on outlines mix two rays.
        self.assertLess(np.quantile(difference, 0.98), 2 / 255)

    def box_depths(self, low, high, turn=0.0):
        rays = test.pixel_rays(*test.SIZE)
        eye = np.broadcast_to(turn_y(EYE, -turn), rays.shape)
        enter, leave = test.cross_box(eye, turn_y(rays, -turn), np.array(low), np.array(high))
        return SCATTERING * (leave - enter)

    def ramp_depths(self, low, high):
        """Of make_ramp() in a box, whose mean density along a ray is that of the middle."""
        rays = test.pixel_rays(*test.SIZE)
        enter, leave = test.cross_box(
            np.broadcast_to(EYE, rays.shape), rays, np.array(low), np.array(high))
        middle = EYE[0] + 0.5 * (enter + leave) * rays[..., 0]
        return SCATTERING / 4 * (leave - enter) * (middle + 3)

    def test_surface(self):
        """A turned box, which changes, and whose filter does."""
        box = make_box()
        turned = simple.Transform(Input=box, Transform="Transform")
        turned.Transform.Rotate = [0, 30, 0]
        self.view.RegionSurface = turned
        self.view.Region = "Surface"
        self.check_opacity(self.box_depths(-SIZES / 2, SIZES / 2, 30), "surface")
        box.XLength = 1.2
        half = np.array([0.6, *SIZES[1:] / 2])
        self.check_opacity(self.box_depths(-half, half, 30), "surface-changed")
        turned.Transform.Rotate = [0, -50, 0]
        self.check_opacity(self.box_depths(-half, half, -50), "surface-turned")
        # Not while it is unused, and all at once when it is used again.
        self.view.Region = "Sphere"
        box.XLength = 1.6
        test.picture(self.view, "surface-unused")
        self.view.Region = "Surface"
        half[0] = 0.8
        self.check_opacity(self.box_depths(-half, half, -50), "surface-again")

    def test_as_by_the_classes(self):
        """The light as well as the opacity: what vtkParticipatingMedium draws in a plain view."""
        import airlight
        from airlight import paraview as attaching
        from vtkmodules.vtkFiltersSources import vtkSphereSource

        self.view.RegionSurface = simple.Sphere(Radius=1.1, Center=[0.1, 0.2, 0.3])
        self.view.Region = "Surface"
        seen = test.picture(self.view, "sphere")
        medium = airlight.vtkParticipatingMedium()
        medium.SetScattering(*[SCATTERING] * 3)
        surface = vtkSphereSource()
        surface.SetRadius(1.1)
        surface.SetCenter(0.1, 0.2, 0.3)
        surface.Update()
        medium.SetSurface(surface.GetOutput())
        medium.SetRegionToSurface()
        view = test.make_view("RenderView")
        test.add_lamp(view)
        test.show(view, simple.Sphere(Radius=0.3, ThetaResolution=48, PhiResolution=48))
        attaching.attach(view, medium)
        simple.Render(view)
        test.place_camera(view)
        expected = test.picture(view, "sphere-by-classes")
        simple.Delete(view)
        print(f"sphere: {np.abs(seen - expected).max()} from the classes'")
        self.assertGreater(expected.std(), 10)
        self.assertLessEqual(np.abs(seen - expected).max(), 1)

    def test_outer_surface(self):
        """Of data that are not polygons, and of several."""
        image = simple.Wavelet(WholeExtent=[-1, 1, -1, 1, -1, 1])
        self.view.Region = "Surface"
        self.view.RegionSurface = image
        depths = self.box_depths([-1, -1, -1], [1, 1, 1])
        self.check_opacity(depths, "outside-image")
        self.view.RegionSurface = simple.Tetrahedralize(Input=image)
        self.check_opacity(depths, "outside-tetrahedra")
        self.view.RegionSurface = simple.GroupDatasets(Input=[
            make_box((1, 1, 1), (-0.8, 0, 0)), make_box((0.6, 1.2, 1), (0.9, 0, 0))])
        self.check_opacity(self.box_depths([-1.3, -0.5, -0.5], [-0.3, 0.5, 0.5]) +
                           self.box_depths([0.6, -0.6, -0.5], [1.2, 0.6, 0.5]), "outside-group")

    def test_image(self):
        """A linear density: its mean along a ray is that of the middle."""
        self.view.DensityImage = make_ramp()
        self.view.DensityArray = ["POINTS", "ramp"]
        self.view.Density = "Image"
        self.view.Scattering = [SCATTERING / 4] * 3
        depths = self.ramp_depths([-2, -2, -1], [2, 2, 1])
        self.check_opacity(depths, "image")
        # The other array, whose values are at least 37.
        self.view.DensityArray = ["POINTS", "RTData"]
        dense = test.picture(self.view, "image-dense", TransparentBackground=1)[..., 3]
        self.assertEqual(dense[75, 100], 255)
        # Without a choice the active scalars, which are those of the Calculator.
        self.view.DensityArray = [None, ""]
        self.check_opacity(depths, "image-scalars")
        # A closed surface cuts it.
        self.view.RegionSurface = make_box()
        self.view.Region = "Surface"
        self.check_opacity(self.ramp_depths(-SIZES / 2, SIZES / 2), "image-in-surface")
        self.view.Scattering = [SCATTERING] * 3

    def test_colours(self):
        """Arrays that are the same everywhere draw as the medium's own albedo and emission do."""
        image = make_ramp()
        for name, function in (("steam", "0.2*iHat+0.5*jHat+0.8*kHat"), ("heat", "0.5")):
            image = simple.Calculator(Input=image, ResultArrayName=name, Function=function)
        view = self.view
        view.DensityImage, view.Density = image, "Image"
        view.DensityArray = ["POINTS", "ramp"]
        view.Scattering = [SCATTERING / 4] * 3
        plain = test.picture(view, "colours-none")
        view.AlbedoArrayName = "steam"
        view.Emission, view.EmissionArrayName = [0.2, 0.4, 0.6], "heat"
        found = test.picture(view, "colours")
        view.AlbedoArrayName = view.EmissionArrayName = ""
        view.Emission = [0.1, 0.2, 0.3]
        albedo = np.array([0.2, 0.5, 0.8])
        view.Scattering = list(SCATTERING / 4 * albedo)
        view.Absorption = list(SCATTERING / 4 * (1 - albedo))
        expected = test.picture(view, "colours-expected")
        self.assertLessEqual(np.abs(found - expected).max(), 1)
        self.assertGreater(np.abs(plain - expected).max(), 20)
        view.Emission, view.Absorption, view.Scattering = [0] * 3, [0] * 3, [SCATTERING / 4] * 3
        np.testing.assert_array_equal(test.picture(view, "colours-again"), plain)
        view.Scattering = [SCATTERING] * 3

    def test_time(self):
        """The surface is that at the view's time."""
        source = simple.TimeSource(XAmplitude=1.0, Growing=0)
        places = {}
        for time in np.array(source.TimestepValues)[[0, 2, 5]]:
            source.UpdatePipeline(time)
            places[time] = np.array(source.GetDataInformation().GetBounds())
        self.assertGreater(np.ptp([bounds[0] for bounds in places.values()]), 0.3, "it moves")
        self.view.Region = "Surface"
        self.view.RegionSurface = source
        for time, bounds in places.items():
            self.view.ViewTime = time
            self.check_opacity(self.box_depths(bounds[::2], bounds[1::2]), f"time-{time:.2f}")
        self.view.ViewTime = 0

    def test_state(self):
        """Saved, all deleted, loaded: the same picture. So is it once the sources are deleted."""
        surface, image = make_box(), make_ramp()
        self.view.RegionSurface, self.view.DensityImage = surface, image
        self.view.DensityArray = ["POINTS", "ramp"]
        self.view.EmissionArrayName = "ramp"
        self.view.Emission = [0.1, 0, 0]
        pictures = {}
        for region, density in (("Surface", "Uniform"), ("Unbounded", "Image")):
            self.view.Region, self.view.Density = region, density
            pictures[region] = test.picture(self.view, f"before-{region}")
        self.assertGreater(np.abs(pictures["Surface"] - pictures["Unbounded"]).max(), 20)
        path = str(test.OUTPUT / "media.pvsm")
        simple.SaveState(path)
        del MediumSources.view
        simple.ResetSession()
        simple.LoadState(path)
        loaded = test.find_view()
        self.assertEqual(loaded.RegionSurface.XLength, SIZES[0])
        self.assertEqual((loaded.DensityArray[1], loaded.EmissionArrayName), ("ramp", "ramp"))
        for attempt in ("loaded", "deleted"):
            for region, density in (("Surface", "Uniform"), ("Unbounded", "Image")):
                loaded.Region, loaded.Density = region, density
                np.testing.assert_array_equal(
                    test.picture(loaded, f"{attempt}-{region}"), pictures[region])
            for source in (loaded.RegionSurface, loaded.DensityImage):
                simple.Delete(source)
        # ParaView crashes in a view that compiles a shader after another session's view is gone.
        del loaded, source
        simple.ResetSession()
        MediumSources.setUpClass()

    def test_bad_sources(self):
        """The medium is left out, with an error if there is a source, and is there again when all is
        well."""
        done = subprocess.run([str(RUN), "--run", __file__, "--bad"], capture_output=True,
                              text=True, timeout=200)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        for message in ("The surface is not closed: 4 edges have an odd number of polygons",
                        "The surface has no polygons",
                        "The density image has the value -1",
                        "The density image has 5 x 5 x 1 points and needs at least 2"):
            self.assertEqual(text.count(message), 1, message + "\n" + text)
        self.assertEqual(text.count("ERR|"), 4, text)
        self.assertEqual(text.count("without the medium: True"), 6, text)
        self.assertEqual(text.count("with the medium again: True"), 2, text)


def use_bad_sources():
    """In a process of its own, whose output is read."""
    test.load_plugin()
    view = make_view()
    view.Scattering = [0, 0, 0]
    clear = test.picture(view, "bad-clear")
    view.Scattering = [SCATTERING] * 3

    def say(name):
        same = (test.picture(view, f"bad-{name}") == clear).all()
        print("without the medium:", same)

    image = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
    for kind, name, good, others in (
            ("Region", "RegionSurface", make_box(), {
                "open": simple.Plane(),
                "empty": simple.Contour(Input=image, ContourBy=["POINTS", "RTData"],
                                        Isosurfaces=[1e6])}),
            ("Density", "DensityImage", make_ramp(), {
                "negative": simple.Calculator(Input=image, ResultArrayName="d", Function="-1"),
                "flat": simple.Wavelet(WholeExtent=[-2, 2, -2, 2, 0, 0])})):
        setattr(view, kind, "Surface" if kind == "Region" else "Image")
        say(f"no-{name}")
        setattr(view, name, good)
        view.DensityArray = ["POINTS", "ramp"]
        right = test.picture(view, f"good-{name}")
        for what, source in others.items():
            setattr(view, name, source)
            view.DensityArray = ["POINTS", "d" if what == "negative" else "RTData"]
            say(what)
        setattr(view, name, good)
        view.DensityArray = ["POINTS", "ramp"]
        again = test.picture(view, f"again-{name}")
        print("with the medium again:", (again == right).all() and (again != clear).any())
        view.Region = "Unbounded"


if __name__ == "__main__":
    if sys.argv[1:] == ["--bad"]:
        use_bad_sources()
    # pvpython loses its window where a script calls sys.exit() with a view open.
    elif not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
