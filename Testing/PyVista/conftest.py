# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of plotter.airlight and mesh.airlight: python3 -m pytest Testing/PyVista.

They need PyVista 0.48 or newer, pytest, and the airlight package with its entry points, and run
with EGL or with an X server.
"""

import gc

import pytest

pv = pytest.importorskip("pyvista", minversion="0.48")

# Every warning is an error, but for one of VTK 9.5's own code with NumPy 2.5.
OF_VTK = "ignore:Setting the shape on a NumPy array:DeprecationWarning"
STRICT = ["-W", "error", "-W", OF_VTK]


@pytest.fixture
def make_plotter():
    """Makes plotters off screen, small ones, and closes them."""
    made = []

    def make(**options):
        options.setdefault("window_size", (160, 120))
        plotter = pv.Plotter(off_screen=True, **options)
        made.append(plotter)
        return plotter
    yield make
    for plotter in made:
        plotter.close()
    made.clear()
    gc.collect()


@pytest.fixture
def plotter(make_plotter):
    """A plotter of a ball."""
    plotter = make_plotter()
    plotter.add_mesh(pv.Sphere())
    return plotter


@pytest.fixture
def dark(make_plotter):
    """A plotter without lights, on black."""
    plotter = make_plotter(lighting="none")
    plotter.background_color = "black"
    return plotter
