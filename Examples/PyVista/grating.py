#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sunlight through a grating: each slat has a shadow in the dust, and the shadow as a mesh.

    python3 grating.py [FOLDER]     writes FOLDER/grating.png; without a folder, a window
"""

import os
import sys

import pyvista as pv

ROOM = (0, 6, -3, 3, 0, 3)  # m; the dust is inside
IRRADIANCE = 14  # W/m^2; a radiance of 1 W/(m^2 sr) is white


def make_wall():
    """The wall at x = 0 with a window of slats."""
    parts = [pv.Cube(bounds=(-0.1, 0, -3, 3, 0, 0.9)), pv.Cube(bounds=(-0.1, 0, -3, 3, 2.5, 3)),
             pv.Cube(bounds=(-0.1, 0, -3, -1.3, 0.9, 2.5)),
             pv.Cube(bounds=(-0.1, 0, 1.3, 3, 0.9, 2.5))]
    return pv.merge(parts)


def make_slats():
    return pv.merge([pv.Cube(bounds=(-0.06, -0.02, y, y + 0.16, 0.9, 2.5))
                     for y in (-1.12, -0.72, -0.32, 0.08, 0.48, 0.88)])


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    pl = pv.Plotter(off_screen=folder is not None, window_size=(1200, 800), lighting="none")
    wall, slats = make_wall(), make_slats()
    pl.add_mesh(wall, color="linen")
    pl.add_mesh(slats, color="sienna")
    pl.add_mesh(pv.Plane(center=(3, 0, 0), i_size=6, j_size=6), color="burlywood")
    for y in (-3, 3):
        pl.add_mesh(pv.Plane(center=(3, y, 1.5), direction=(0, 1, 0), i_size=3, j_size=6),
                    color="linen")
    pl.add_mesh(pv.Plane(center=(3, 0, 3), i_size=6, j_size=6), color="linen")
    pl.add_mesh(pv.Sphere(radius=0.5, center=(2.5, 0.4, 0.5), theta_resolution=120,
                          phi_resolution=120), color="steelblue", smooth_shading=True)

    pl.airlight.enable(visibility=22, anisotropy=0.4, region=ROOM, ambient=0.06,
                       color_space="srgb", tone_mapping="clamp", frames=4)
    sun = pl.airlight.add_sun((1, 0.12, -0.55), IRRADIANCE, color=(1, 0.93, 0.8))

    shadow = slats.airlight.shadow_volume(sun, bounds=ROOM)
    print(f"the shadow of the slats has {shadow.n_cells} polygons; "
          f"the silhouette has {slats.airlight.silhouette(sun).n_lines} edges")
    pl.camera_position = [(5.4, -2.6, 1.7), (0.8, 0.6, 1.15), (0, 0, 1)]
    pl.camera.view_angle = 50
    pl.show(screenshot=os.path.join(folder, "grating.png") if folder else None)


if __name__ == "__main__":
    main()
