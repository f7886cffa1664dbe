#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A lamp behind a sculpture in a smoky room: the shadows of its legs stand in the smoke.

    python3 smoke_room.py [FOLDER]     writes FOLDER/smoke_room.png; without a folder, a window
"""

import os
import sys

import pyvista as pv
from pyvista import examples

VISIBILITY = 12  # m
LAMP = (-0.24, 0.9, 1.05)  # m, behind the sculpture
INTENSITY = 20  # W/sr; a radiance of 1 W/(m^2 sr) is white


def make_sculpture():
    """An ant of one metre, on a pedestal of 80 cm."""
    ant = examples.load_ant().rotate_x(90).rotate_z(20)
    ant = ant.scale(1.5 / ant.length)
    low = ant.bounds.z_min
    return ant.translate((-ant.center[0], -ant.center[1], 0.8 - low))


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    pl = pv.Plotter(off_screen=folder is not None, window_size=(1200, 800), lighting="none")
    walls = {
        "floor": pv.Plane(center=(0, 0, 0), i_size=6, j_size=6),
        "ceiling": pv.Plane(center=(0, 0, 3), i_size=6, j_size=6),
        "back": pv.Plane(center=(0, 3, 1.5), direction=(0, 1, 0), i_size=3, j_size=6),
        "left": pv.Plane(center=(-3, 0, 1.5), direction=(1, 0, 0), i_size=3, j_size=6),
        "right": pv.Plane(center=(3, 0, 1.5), direction=(1, 0, 0), i_size=3, j_size=6),
    }
    for wall in walls.values():
        pl.add_mesh(wall, color="wheat")
    pl.add_mesh(pv.Cube(center=(0, 0, 0.4), x_length=0.9, y_length=0.5, z_length=0.8), color="tan")
    pl.add_mesh(make_sculpture(), color="saddlebrown", smooth_shading=True)

    pl.airlight.enable(visibility=VISIBILITY, anisotropy=0.6, ambient=0.03,
                       color_space="srgb")
    pl.airlight.add_lamp(LAMP, INTENSITY, color=(1.0, 0.9, 0.75))

    pl.camera_position = [(0.9, -3.4, 1.35), (0, 0, 1.2), (0, 0, 1)]
    pl.camera.view_angle = 50
    pl.show(screenshot=os.path.join(folder, "smoke_room.png") if folder else None)


if __name__ == "__main__":
    main()
