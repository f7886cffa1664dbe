# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The view "Render View + Airlight": its picture, clear and in fog, and all that a view does."""

import sys
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkCollection
from vtkmodules.vtkCommonDataModel import vtkCellLocator
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import paraviewtest as test

EYE = np.array(test.CAMERA["position"])


class View(unittest.TestCase):
    """One scene for all tests: a window and its shaders take seconds."""

    @classmethod
    def setUpClass(cls):
        test.load_plugin()
        cls.ball, cls.floor = test.make_sources()
        cls.view = test.make_view()
        cls.lamp = test.add_lamp(cls.view)
        test.show(cls.view, cls.ball, cls.floor)
        cls.plain = test.make_view("RenderView")
        cls.plain.AdditionalLights = [cls.lamp]
        test.show(cls.plain, cls.ball, cls.floor)

    def setUp(self):
        self.view.Airlight = 1
        self.view.SurfaceShadows = 1
        self.view.Thickness = "Coefficients"
        self.view.Scattering = [0.12, 0.12, 0.12]
        self.view.Absorption = [0.03, 0.03, 0.03]
        self.view.PhaseFunction = "Isotropic"
        self.view.Anisotropy = 0
        test.place_camera(self.view)

    def make_clear(self):
        self.view.Scattering = self.view.Absorption = [0, 0, 0]
        self.view.SurfaceShadows = 0

    def assert_same(self, first, second, most, text=""):
        self.assertEqual(first.shape, second.shape)
        difference = np.abs(first - second)
        print(f"{text}: largest difference {difference.max()}, mean {difference.mean():.4f}")
        self.assertLessEqual(difference.max(), most, text)

    def test_clear_is_plain(self):
        self.make_clear()
        plain = test.picture(self.plain, "plain")
        self.assertGreater(plain.std(), 20, "the scene is seen")
        self.assert_same(test.picture(self.view, "clear"), plain, 2, "clear")
        # 1e-9 is no clear medium: all is drawn, but changes nothing. FXAA would enhance dithering.
        self.view.Dithering = 0
        self.view.Scattering = [1e-9] * 3
        self.assert_same(test.picture(self.view, "nearly-clear"), plain, 2, "nearly clear")
        self.view.Dithering = 1
        self.view.Scattering = [0.5] * 3
        self.view.Airlight = 0
        self.assert_same(test.picture(self.view, "off"), plain, 0, "off")

    def test_display(self):
        """Exposure, tone mapping and the mean of frames."""
        self.view.RadianceExposure = 4
        clamped = test.picture(self.view, "clamped")
        self.view.ToneMapping = "Neutral PBR"
        mapped = test.picture(self.view, "mapped")
        self.assertLess((mapped == 255).mean(), 0.5 * (clamped == 255).mean())
        self.view.AutomaticExposure = 1
        self.assertGreater(np.abs(test.picture(self.view, "automatic") - mapped).mean(), 2)
        self.view.SubpixelFrames = 4
        self.assertGreater(test.picture(self.view, "mean").std(), 5)
        for name in ("RadianceExposure", "AutomaticExposure", "SubpixelFrames"):
            self.view.GetProperty(name).ResetToDefault()
        self.view.UpdateVTKObjects()
        self.view.ToneMapping = "Clamp"

    def test_progressive_refinement(self):
        """Each rendering of a client adds a frame; screenshots are complete."""
        self.view.SubpixelFrames = 4
        complete = test.picture(self.view, "complete")
        self.view.ProgressiveRefinement = 1

        def render():
            self.view.StillRender()
            self.view.UpdatePropertyInformation()
            return self.view.GetProperty("AccumulatedFrames").GetElement(0)
        self.assertEqual([render() for _ in range(5)], [1, 2, 3, 4, 4])
        self.assert_same(test.picture(self.view, "refined"), complete, 0, "screenshot")
        self.view.ProgressiveRefinement = 0
        self.assertEqual(render(), 4)
        self.view.GetProperty("SubpixelFrames").ResetToDefault()
        self.view.UpdateVTKObjects()

    def test_stock_scene(self):
        """ParaView's own lights, axes and antialiasing, coloured data: nothing changes either."""
        pictures = []
        wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
        contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"],
                                 Isosurfaces=[150.0])
        for kind in ("RenderView", "AirlightRenderView"):
            view = simple.CreateView(kind)
            view.ViewSize = list(test.SIZE)
            view.UseFXAA = 1
            view.AxesGrid.Visibility = 1
            display = simple.Show(contour, view)
            simple.ColorBy(display, ("POINTS", "RTData"))
            simple.ResetCamera(view)
            if kind != "RenderView":
                view.Thickness = "Coefficients"
                view.Scattering = [0, 0, 0]
                view.SurfaceShadows = 0
            pictures.append(test.picture(view, "stock-" + kind))
            simple.Delete(view)
        self.assertGreater(pictures[0].std(), 20)
        self.assert_same(*pictures, 2, "stock scene")

    def test_fog_is_right(self):
        """Against the midpoint rule along each ray, which knows nothing of the library."""
        for function, anisotropy in (("Isotropic", 0), ("Schlick", 0.6)):
            with self.subTest(function):
                self.view.PhaseFunction = function
                self.view.Anisotropy = anisotropy
                self.check_fog(function, anisotropy)

    def check_fog(self, name, k):
        """k is Schlick's, whose function is isotropic if k = 0."""
        fog = test.picture(self.view, f"fog-{name}")
        step = 5
        rays = test.pixel_rays(*test.SIZE)[step // 2::step, step // 2::step]
        shown = fog[step // 2::step, step // 2::step] / 255
        eye = np.broadcast_to(EYE, rays.shape)
        ball, floor = test.hit_ball(eye, rays), test.hit_floor(eye, rays)
        end = np.minimum(ball, floor)
        lamp = np.array(self.lamp.Position)
        radiance = np.array(self.lamp.DiffuseColor) * self.lamp.Intensity
        scattering, extinction = 0.12, 0.15

        # The medium before the surface, or to where it sends less than exp(-0.15 * 60) more.
        count = 6000
        length = np.minimum(end, 60.0)
        t = length[..., None] * (np.arange(count) + 0.5) / count
        added = np.zeros(rays.shape)
        for row in range(rays.shape[0]):
            points = EYE + t[row][..., None] * rays[row][:, None, :]
            way = lamp - points
            r = np.linalg.norm(way, axis=-1)
            dark = test.hit_ball(points, way / r[..., None]) < r
            dark |= test.hit_floor(points, way / r[..., None]) < r
            phase = (1 - k**2) / (1 - k * (way * rays[row][:, None, :]).sum(axis=-1) / r)**2
            terms = np.where(dark, 0, phase * np.exp(-extinction * (t[row] + r)) / r**2)
            # I = pi * radiance, and the function is phase / (4 pi).
            share = scattering / 4 * terms.sum(axis=-1) * length[row] / count
            added[row] = share[..., None] * radiance

        # Lambert's law and the shadow on the surfaces, which are white.
        hit = EYE + np.where(np.isfinite(end), end, 0)[..., None] * rays
        normal = np.where((ball < floor)[..., None], hit / 0.5, np.array([0, 1, 0]))
        way = lamp - hit
        r = np.linalg.norm(way, axis=-1)
        cosine = np.maximum((normal * way).sum(axis=-1) / r, 0)
        dark = test.hit_ball(hit + 1e-6 * normal, way / r[..., None]) < r
        seen = np.isfinite(end) & ~dark
        sent = np.where(seen, cosine / r**2 * np.exp(-extinction * (r + end)), 0)
        expected = np.clip(added + sent[..., None] * radiance, 0, 1)

        difference = np.abs(shown - expected).max(axis=-1)
        print(f"fog, {name}: median {np.median(difference):.5f}, "
              f"90 % {np.quantile(difference, 0.9):.5f}, largest {difference.max():.5f}")
        # Half a step of 8 bits, and as much for the facets of the ball. Pixels at edges mix nothing
        # here, but the ball's facets move its outline and that of its shadow.
        self.assertLess(np.quantile(difference, 0.9), 1 / 255)
        self.assertLess(np.mean(difference > 3 / 255), 0.02)
        self.assertGreater(added.max(), 0.1, "there is fog to be seen")
        self.assertGreater(np.count_nonzero(dark & np.isfinite(end)), 10, "and a shadow")

    def test_picking(self):
        """The cells that rays meet, the same as in a plain view; and the picture as before."""
        found = {}
        for kind in ("RenderView", "AirlightRenderView"):
            # ParaView picks nonsense in the first of two windows under a virtual display.
            view = test.make_view(kind)
            test.add_lamp(view)
            displays = test.show(view, self.ball, self.floor)
            before = test.picture(view, "before-pick")
            found[kind] = self.select(view)
            self.assert_same(test.picture(view, "after-pick"), before, 0, "after picking")
            self.assertEqual(view.SMProxy.Pick(100, 75), displays[0].SMProxy, "in the middle")
            simple.Delete(view)
        self.assertEqual(*found.values())
        cells = set(found["AirlightRenderView"][self.ball.SMProxy])
        self.assertEqual(found["AirlightRenderView"][self.floor.SMProxy], [0])

        locator = vtkCellLocator()
        locator.SetDataSet(servermanager.Fetch(self.ball))
        locator.BuildLocator()
        met = set()
        for ray in test.pixel_rays(*test.SIZE)[::-1][40:91, 80:121].reshape(-1, 3):
            cell = mutable(-1)
            if locator.IntersectWithLine(EYE, EYE + 10 * ray, 0, mutable(0.0), [0] * 3, [0] * 3,
                                         mutable(0), cell):
                met.add(int(cell))
        self.assertGreater(len(met), 1000)
        # Rays through the border of two cells may meet the other one.
        self.assertGreater(len(met & cells) / len(met | cells), 0.98)

    @staticmethod
    def select(view):
        """Of each source that is seen in a rectangle, the cells."""
        seen, sources = vtkCollection(), vtkCollection()
        view.SMProxy.SelectSurfaceCells([80, 40, 120, 90], seen, sources, True)
        found = {}
        for i in range(seen.GetNumberOfItems()):
            source = seen.GetItemAsObject(i).GetProperty("Input").GetProxy(0)
            ids = sources.GetItemAsObject(i).GetProperty("IDs")
            # Pairs of process and cell.
            found[source] = sorted(
                ids.GetElement(k) for k in range(1, ids.GetNumberOfElements(), 2))
        return found

    def test_large_screenshot(self):
        """Three times as large: larger than the window, so drawn in tiles."""
        small = test.picture(self.view, "small")
        large = test.picture(self.view, "large", [3 * n for n in test.SIZE])
        # The middle one of each 3 x 3 pixels is the small picture's pixel.
        difference = np.abs(large[1::3, 1::3] - small).max(axis=-1)
        print(f"large: {np.mean(difference > 2):.4f} of the pixels differ")
        self.assertLess(np.mean(difference > 2), 0.01)
        self.assertGreater(small.std(), 10)

    def test_transparent_background(self):
        """The medium is as opaque as it hides the background: 1 - exp(-extinction distance)."""
        self.view.Region = "Sphere"
        self.view.RegionRadius = 1.5
        self.view.Scattering = [0.5, 0.5, 0.5]
        self.view.Background = [0.3, 0.3, 0.3]  # whose colour is a share of the fog's
        simple.Hide(self.floor, self.view)
        simple.Render(self.view)
        test.place_camera(self.view)
        seen = test.picture(self.view, "transparent", TransparentBackground=1)
        self.view.Background = [0, 0, 0]
        simple.Show(self.floor, self.view)
        self.view.Region = "Unbounded"
        self.assertEqual(seen.shape[-1], 4)
        rays = test.pixel_rays(*test.SIZE)
        eye = np.broadcast_to(EYE, rays.shape)
        along = -(eye * rays).sum(axis=-1)
        inside = np.sqrt(np.maximum(1.5**2 - (EYE @ EYE) + along**2, 0)) * 2
        expected = np.where(np.isfinite(test.hit_ball(eye, rays)), 1, 1 - np.exp(-0.53 * inside))
        difference = np.abs(seen[..., 3] / 255 - expected)
        print(f"opacity: median {np.median(difference):.5f}, 97 % "
              f"{np.quantile(difference, 0.97):.5f}")
        # Pixels on the sphere's outline, where the way inside changes fast, are not worth more.
        self.assertLess(np.quantile(difference, 0.97), 2 / 255)
        self.assertEqual(seen[0, 0, 3], 0, "nothing in the corner")

    def test_cylinder_and_draine(self):
        """A cylinder and Draine's function change the picture, and their parameters, too."""
        seen = []
        for changes in ({}, {"Region": "Cylinder", "RegionRadius": 1.5, "RegionHeight": 2},
                        {"RegionHeight": 1}, {"RegionAxis": [1, 0, 0]},
                        {"PhaseFunction": "Draine", "Anisotropy": 0.5}, {"Alpha": 20}):
            for name, value in changes.items():
                setattr(self.view, name, value)
            seen.append(test.picture(self.view, f"cylinder-{len(seen)}").astype(int))
        for name, value in (("Region", "Unbounded"), ("PhaseFunction", "Isotropic"),
                            ("Anisotropy", 0), ("Alpha", 1), ("RegionAxis", [0, 1, 0]),
                            ("RegionHeight", 1)):
            setattr(self.view, name, value)
        for before, after in zip(seen, seen[1:]):
            self.assertGreater(np.abs(after - before).max(), 3)

    def test_state(self):
        """Saved, all deleted, loaded: the same picture."""
        self.view.PhaseFunction = "Henyey-Greenstein"
        self.view.Anisotropy = 0.6
        self.view.VisibilityDistance = 12.5  # as in states of before it followed the data
        before = test.picture(self.view, "before-state")
        path = str(test.OUTPUT / "state.pvsm")
        simple.SaveState(path)
        views = {view.GetXMLName() for view in simple.GetViews()}
        self.assertIn("AirlightRenderView", views)
        simple.ResetSession()
        simple.LoadState(path)
        loaded = test.find_view()
        self.assertEqual(loaded.Anisotropy, 0.6)
        self.assertEqual(loaded.VisibilityDistance, 12.5)
        self.assert_same(test.picture(loaded, "after-state"), before, 0, "state")
        simple.ResetSession()
        View.setUpClass()

    def first_view(self, source, *others):
        """What a user sees who shows something in a new view: the view, and its picture in grey."""
        view = simple.CreateView("AirlightRenderView")
        view.ViewSize = list(test.SIZE)
        view.OrientationAxesVisibility = 0
        test.show(view, source, *others)
        simple.ResetCamera(view)
        return view, test.picture(view, "first-view").mean(axis=-1)

    def test_first_view(self):
        """Not one even grey, in any unit of length, with ParaView's own lights."""
        first = None
        for size in (1e-3, 1.0, 1e4):
            ball = simple.Sphere(Radius=0.5 * size, ThetaResolution=48, PhiResolution=48)
            floor = simple.Plane(Origin=[-size, -0.5 * size, size], Point1=[size, -0.5 * size, size],
                                 Point2=[-size, -0.5 * size, -size])
            view, grey = self.first_view(ball, floor)
            low, high = np.percentile(grey, (1, 99))
            levels = len(np.unique(np.round(grey[(grey >= low) & (grey <= high)])))
            print(f"first view of size {size}: {low} to {high}, {levels} levels")
            self.assertGreater(high - low, 60)
            self.assertGreater(levels, 30)
            first = grey if first is None else first
            self.assertLess(np.quantile(np.abs(grey - first), 0.99), 2, "the same in all units")
            # A value that is set stays; 0 is automatic again.
            view.VisibilityDistance = 0.5 * size
            self.assertLess(test.picture(view, "thick").std(), 0.5 * grey.std())
            self.assertEqual(view.VisibilityDistance, 0.5 * size)
            view.VisibilityDistance = 0
            np.testing.assert_array_equal(test.picture(view, "again").mean(axis=-1), grey)
            simple.Delete(view)

    def test_automatic_visibility(self):
        """13.7 diagonals of what is visible, from the background that is left beside the data."""
        view, _ = self.first_view(self.ball)
        view.UseColorPaletteForBackground = 0
        view.Background = [1, 1, 1]
        view.ToneMapping = "Clamp"
        view.Region = "Sphere"  # so that rays leave the medium
        view.RegionRadius = 3.0
        view.RegionCenter = [0, 0, 0]
        test.place_camera(view)
        for shown in ([self.ball], [self.ball, self.floor]):
            test.show(view, *shown)
            bounds = np.array([source.GetDataInformation().GetBounds() for source in shown])
            diagonal = np.linalg.norm(bounds[:, 1::2].max(axis=0) - bounds[:, ::2].min(axis=0))
            corner = test.picture(view, "automatic")[5, 5] / 255
            rays = test.pixel_rays(*test.SIZE)[5, 5]
            inside = 2 * np.sqrt(9 - EYE @ EYE + (EYE @ rays)**2)
            far = 0.5 / np.sin(np.radians(15)) + 0.5  # half of whose light is left
            clear = 0.5 ** (inside / (far * diagonal))
            expected = clear + 0.55 * (1 - clear)  # and a share of the background is added
            print(f"diagonal {diagonal}: {corner} of the background, {expected} expected")
            self.assertLess(np.abs(corner - expected).max(), 1.5 / 255)
        simple.Delete(view)

    def test_camera_lights(self):
        """The light kit lights the medium only after it is switched on."""
        view, _ = self.first_view(self.ball)
        view.UseColorPaletteForBackground = 0
        view.Background = [0, 0, 0]
        view.DebugView = "Airlight only"
        self.assertEqual(test.picture(view, "kit-off").max(), 0)
        view.CameraLightsScatter = 1
        self.assertGreater(test.picture(view, "kit-on").mean(), 5)
        view.CameraLightsScatter = 0
        self.assertEqual(test.picture(view, "kit-off").max(), 0)
        simple.Delete(view)

    def test_level_of_detail(self):
        """While the camera moves, decimated data with their shadows; then all of them again."""
        before = test.picture(self.view, "before-detail")
        self.view.LODThreshold = 0
        self.view.LODResolution = 0
        self.view.SMProxy.InteractiveRender()
        coarse = self.read_window(self.view)
        self.view.SMProxy.StillRender()
        changed = np.abs(coarse - before).max(axis=-1)
        self.assertGreater(changed.max(), 10, "the ball is coarser")
        self.assertLess(np.mean(changed > 10), 0.05, "in the same fog and light")
        self.assert_same(self.read_window(self.view), before, 0, "still again")
        for name in ("LODThreshold", "LODResolution"):
            self.view.GetProperty(name).ResetToDefault()
        self.view.UpdateVTKObjects()

    @staticmethod
    def read_window(view):
        """What the window shows, without another rendering."""
        reader = vtkWindowToImageFilter()
        reader.SetInput(view.SMProxy.GetRenderWindow())
        reader.SetReadFrontBuffer(False)
        reader.SetShouldRerender(False)
        reader.Update()
        image = reader.GetOutput()
        width, height, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)
        return pixels[::-1].astype(float)

    def test_settings_of_views(self):
        """Each changes the picture as it does ParaView's, and it is the same afterwards."""
        self.view.StereoType = "Anaglyph"
        before = test.picture(self.view, "before-settings")
        for name, value, default in (
                ("UseAmbientOcclusion", 1, 0), ("StereoRender", 1, 0),
                ("CameraParallelProjection", 1, 0), ("CenterAxesVisibility", 1, 0)):
            with self.subTest(name):
                setattr(self.view, name, value)
                seen = test.picture(self.view, f"setting-{name}")
                self.assertGreater(np.abs(seen - before).max(), 5)
                self.assertGreater(seen.std(), 5)
                setattr(self.view, name, default)
                self.assert_same(test.picture(self.view, f"after-{name}"), before, 0, name)

    def test_palettes(self):
        """A white background makes light fog, and a black one the former picture."""
        simple.LoadPalette("BlackBackground")
        self.view.UseColorPaletteForBackground = 1
        before = test.picture(self.view, "palette-black")
        simple.LoadPalette("WhiteBackground")
        white = test.picture(self.view, "palette-white")
        self.assertGreater((white - before).min(), 0)
        self.assertGreater((white - before).mean(), 50)
        simple.LoadPalette("BlackBackground")
        self.assert_same(test.picture(self.view, "palette-again"), before, 0, "palette")
        self.view.UseColorPaletteForBackground = 0

    def test_debug_views(self):
        """Airlight alone is less than the picture, and there are boundaries at the shadow."""
        whole = test.picture(self.view, "whole")
        self.view.DebugView = "Airlight only"
        alone = test.picture(self.view, "airlight-only")
        self.view.DebugView = "Boundary count"
        counts = test.picture(self.view, "boundary-count")
        self.view.DebugView = "Shaded"
        self.assertLessEqual((alone - whole).max(), 1)
        self.assertGreater((whole - alone).max(), 20)
        self.assertGreater(np.mean(counts.max(axis=-1) > 0), 0.02)
        self.assertGreater(np.mean(counts.max(axis=-1) == 0), 0.02)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
