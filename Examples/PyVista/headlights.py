#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Headlights in fog, seen from the roadside: a cyclist cuts the beams.

    python3 headlights.py [FOLDER]     writes FOLDER/headlights.png; without a folder, a window
"""

import os
import sys

import pyvista as pv

VISIBILITY = 60  # m
CANDELA = 18000  # of a low beam, in the middle
WHITE = 60  # cd/m^2, the luminance that is drawn white


def add_car(pl):
    """A car that drives along x, its lamps at x = 0."""
    paint = dict(color="firebrick", smooth_shading=False)
    pl.add_mesh(pv.Cube(bounds=(-4.3, 0.0, -0.9, 0.9, 0.3, 0.85)), **paint)
    pl.add_mesh(pv.Cube(bounds=(-3.6, -1.3, -0.8, 0.8, 0.85, 1.4)), **paint)
    for x in (-3.5, -0.8):
        for y in (-0.85, 0.85):
            pl.add_mesh(pv.Cylinder(center=(x, y, 0.32), direction=(0, 1, 0), radius=0.32,
                                    height=0.2), color="black")


def add_tube(pl, a, b, radius, color):
    pl.add_mesh(pv.Tube(pointa=a, pointb=b, radius=radius, n_sides=24), color=color)


def add_cyclist(pl, x, y):
    """Wheels, a frame, and someone who sits on it."""
    for offset in (-0.5, 0.5):
        pl.add_mesh(pv.Disc(center=(x + offset, y, 0.34), inner=0.29, outer=0.34,
                            normal=(0, 1, 0), c_res=40), color="dimgray")
    hub, seat, head, pedals, fork = (-0.5, 0.34), (-0.1, 0.85), (0.4, 0.8), (0.0, 0.3), (0.5, 0.34)
    for a, b in ((hub, seat), (seat, head), (head, fork), (seat, pedals), (head, pedals),
                 (head, (0.35, 1.05))):
        add_tube(pl, (x + a[0], y, a[1]), (x + b[0], y, b[1]), 0.025, "navy")
    add_tube(pl, (x - 0.1, y, 0.9), (x + 0.15, y, 1.45), 0.14, "orange")
    add_tube(pl, (x + 0.12, y, 1.38), (x + 0.36, y, 1.05), 0.05, "orange")
    add_tube(pl, (x - 0.1, y, 0.9), (x + 0.05, y, 0.35), 0.08, "black")
    pl.add_mesh(pv.Sphere(center=(x + 0.2, y, 1.66), radius=0.12), color="tan")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    pl = pv.Plotter(off_screen=folder is not None, window_size=(1280, 720), lighting="none")
    pl.background_color = (0.06, 0.07, 0.09)
    pl.add_mesh(pv.Plane(center=(10, 0, 0), i_size=80, j_size=7), color=(0.25, 0.25, 0.26))
    pl.add_mesh(pv.Plane(center=(10, 0, -0.02), i_size=80, j_size=60), color=(0.2, 0.24, 0.15))
    add_car(pl)
    add_cyclist(pl, 9, 0.2)
    for x in range(3, 40, 5):
        pl.add_mesh(pv.Cylinder(center=(x, 3.6, 0.5), direction=(0, 0, 1), radius=0.06, height=1),
                    color="white")

    pl.airlight.enable(visibility=VISIBILITY, anisotropy=0.7, white=WHITE, ambient=(2.2, 2.6, 3.4),
                       color_space="srgb", frames=8)
    for y in (-0.65, 0.65):
        pl.airlight.add_lamp((0.06, y, 0.65), CANDELA, unit="cd", color=(1, 0.95, 0.85),
                             target=(30, y, 0.45), cone_angle=11, radius=0.08, visible=True)

    pl.camera_position = [(13.5, -6.5, 2.0), (5.5, 0.6, 0.9), (0, 0, 1)]
    pl.camera.view_angle = 40
    pl.show(screenshot=os.path.join(folder, "headlights.png") if folder else None)


if __name__ == "__main__":
    main()
