# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of "Render View + Airlight", with all that ParaView sets by default: data of any
kind and unit are readable in the fog, and so they are in the light of its lamp."""

import pathlib
import sys
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test

# Of the grey levels between fog and white.
SHARE = 1 / 3


def wavelet(**options):
    return simple.Wavelet(**options)


def make_contour():
    return simple.Contour(Input=wavelet(), ContourBy=["POINTS", "RTData"],
                          Isosurfaces=[100.0, 157.0, 200.0])


def make_clip():
    return simple.Clip(Input=wavelet(), ClipType="Plane")


def make_cow():
    cow = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Data" / "meshes" / "cow.ply"
    return simple.PLYReader(FileNames=[str(cow)])


def make_superquadric():
    return simple.Superquadric(Toroidal=1, ThetaResolution=64, PhiResolution=64)


def make_text():
    return simple.a3DText(Text="Airlight")


def make_terrain():
    plane = simple.Plane(XResolution=80, YResolution=80)
    heights = simple.Calculator(Input=plane, ResultArrayName="h",
                                Function="0.08*sin(9*coordsX)*cos(7*coordsY)")
    return simple.WarpByScalar(Input=heights, Scalars=["POINTS", "h"])


def make_glyphs():
    return simple.Glyph(Input=wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]), GlyphType="Arrow",
                        OrientationArray=["POINTS", "No orientation array"],
                        ScaleArray=["POINTS", "RTData"], ScaleFactor=0.006)


DATA = {
    "sphere": lambda: simple.Sphere(Radius=6.4e6, ThetaResolution=64, PhiResolution=64),
    "contour": make_contour,
    "clip": make_clip,
    "cow": make_cow,
    "superquadric": make_superquadric,
    "text": make_text,
    "terrain": make_terrain,
    "glyphs": make_glyphs,
}


class FirstView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        test.load_plugin()

    def check(self, name, picture, mask):
        """mask: where the data are."""
        grey = picture[..., :3].mean(axis=-1)
        fog = np.median(grey[~mask])
        low, high = np.percentile(grey[mask], (2, 98))
        share = (high - min(low, fog)) / (255 - fog)
        print(f"{name}: fog {fog:.0f}, data {low:.0f} to {high:.0f}, {share:.2f} of the levels")
        self.assertGreater(share, SHARE, name)
        self.assertGreater(fog, 20, f"{name}: fog that is seen")
        self.assertLess(np.mean(grey[mask] > 253), 0.02, f"{name}: nothing is blown out")

    def test_data(self):
        for name, make in DATA.items():
            with self.subTest(name):
                source = make()
                view = simple.CreateView("AirlightRenderView")
                view.ViewSize = [480, 360]
                view.OrientationAxesVisibility = 0
                simple.Show(source, view)
                simple.ResetCamera(view)
                picture = test.picture(view, f"first-{name}")
                lamp = {}
                view.Lamp = 1
                lamp = test.picture(view, f"first-{name}-lamp")
                view.Lamp = 0
                # Where the data are: what changes when they are hidden.
                view.Airlight = 0
                shown = test.picture(view, f"first-{name}-plain")
                simple.Hide(source, view)
                mask = np.abs(test.picture(view, "first-empty") - shown).max(axis=-1) > 3
                self.assertGreater(mask.mean(), 0.02)
                self.check(name, picture, mask)
                self.check(f"{name}, lamp", lamp, mask)
                simple.Delete(view)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
