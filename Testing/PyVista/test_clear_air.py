# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""In clear air, without shadows, plots are those of PyVista."""

import math

import numpy as np
import pytest
import pyvista as pv
from pyvista import examples


def scalars(plotter):
    plotter.add_mesh(examples.load_hexbeam(), scalars="sample_point_scalars", show_edges=True)


def smooth(plotter):
    plotter.add_mesh(examples.load_nut(), smooth_shading=True, specular=1, specular_power=30)


def texture(plotter):
    plotter.add_mesh(examples.load_globe(), texture=examples.load_globe_texture())


def translucent(plotter):
    plotter.add_mesh(pv.Sphere(), opacity=0.4, color="red")
    plotter.add_mesh(pv.Cube(), opacity=0.6, color="blue")


def blocks(plotter):
    plotter.add_mesh(pv.MultiBlock([pv.Sphere(center=(i, 0, 0)) for i in range(3)]))


def lines(plotter):
    plotter.add_mesh(examples.load_airplane(), style="wireframe", line_width=2)
    plotter.show_bounds()


def points(plotter):
    plotter.add_mesh(pv.Sphere(), style="points", point_size=5)
    plotter.add_text("points")
    plotter.show_axes()


def glyphs(plotter):
    grid = pv.ImageData(dimensions=(4, 4, 2))
    grid["v"] = np.ones((grid.n_points, 3)) * 0.3
    plotter.add_mesh(grid.glyph(orient="v", scale="v"))
    plotter.add_legend([["arrows", "k"]])


def clipped(plotter):
    plotter.add_mesh(pv.Sphere().clip("x"), color="w", backface_params={"color": "red"})
    plotter.enable_parallel_projection()


def gradient(plotter):
    plotter.add_mesh(pv.Cone(), color="orange", ambient=0.3)
    plotter.set_background("white", top="blue")


def channels(plotter):
    plotter.add_mesh(examples.load_channels().threshold(2.5), cmap="viridis")


# The largest step of 255 that rounding and VTK's blending in 8 bits make.
@pytest.mark.parametrize("draw, steps", [
    (scalars, 1), (smooth, 1), (texture, 1), (translucent, 3), (blocks, 1), (lines, 1), (points, 1),
    (glyphs, 1), (clipped, 1), (gradient, 1), (channels, 1)],
    ids=lambda value: getattr(value, "__name__", ""))
def test_same_picture(make_plotter, draw, steps):
    pictures = []
    for medium in (False, True):
        plotter = make_plotter(window_size=(300, 240))
        plotter.enable_anti_aliasing("msaa", multi_samples=0)
        draw(plotter)
        if medium:
            plotter.airlight.enable(visibility=math.inf, lamp=False, shadows=False,
                                    anti_aliasing=False)
        pictures.append(plotter.screenshot().astype(int))
    assert np.ptp(pictures[0]) > 50
    difference = abs(pictures[0] - pictures[1]).max(axis=-1)
    # a few pixels of lines, which are drawn where depths are equal, may fall to the other side
    assert (difference > steps).mean() < 1e-3
