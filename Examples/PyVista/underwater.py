#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A vehicle searches the sea floor: water takes the red within metres.

The absorption is that of pure water at 620, 540 and 470 nm (Pope and Fry, Applied Optics 36, 1997).

    python3 underwater.py [FOLDER]     writes FOLDER/underwater.png; without a folder, a window
"""

import os
import sys

import numpy as np
import pyvista as pv

import airlight

ABSORPTION = (0.276, 0.047, 0.011)  # 1/m
SCATTERING = 0.12  # 1/m
INTENSITY = 60  # W/sr


def make_water():
    water = airlight.vtkParticipatingMedium()
    water.SetAbsorption(ABSORPTION)
    water.SetScattering(3 * [SCATTERING])
    water.SetPhaseFunctionToHenyeyGreenstein()
    water.SetAnisotropy(0.75)
    water.SetAmbientRadiance(0.005, 0.04, 0.07)  # daylight from above, about
    return water


def make_floor():
    floor = pv.Plane(i_size=40, j_size=40, i_resolution=200, j_resolution=200)
    x, y = floor.points[:, 0], floor.points[:, 1]
    floor.points[:, 2] = (0.25 * np.sin(0.7 * x + 0.4 * y) + 0.2 * np.sin(0.9 * y - 0.3 * x)
                          + 0.04 * np.sin(5 * x + 2 * np.sin(y)))
    return floor.compute_normals()


def add_vehicle(pl, position):
    """A body with two floats and a lamp at its bow; it looks along x."""
    x, y, z = position
    body = pv.Capsule(center=position, direction=(1, 0, 0), radius=0.22, cylinder_length=0.8)
    pl.add_mesh(body, color="gold", smooth_shading=True)
    for side in (-0.42, 0.42):
        pl.add_mesh(pv.Capsule(center=(x - 0.1, y + side, z + 0.12), direction=(1, 0, 0),
                               radius=0.12, cylinder_length=0.9), color="orangered",
                    smooth_shading=True)
        pl.add_mesh(pv.Cube(center=(x - 0.1, y + side / 2, z + 0.1), x_length=0.3,
                            y_length=abs(side), z_length=0.05), color="gray")
    return x + 0.72, y, z - 0.08


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    pl = pv.Plotter(off_screen=folder is not None, window_size=(1200, 750), lighting="none")
    pl.background_color = (0.005, 0.04, 0.07)
    pl.add_mesh(make_floor(), color=(0.75, 0.68, 0.52), smooth_shading=True)
    for x, y, radius in ((3.2, -0.7, 0.45), (4.6, 0.9, 0.6), (2.2, 1.2, 0.25)):
        pl.add_mesh(pv.Icosphere(radius=radius, center=(x, y, 0.1), nsub=2), color="gray")
    for x in (1.5, 3.5, 5.5):
        pl.add_mesh(pv.Cylinder(center=(x, 0.1, 0.75), direction=(0, 0, 1), radius=0.05,
                                height=1.5), color="orangered")
    bow = add_vehicle(pl, (-0.8, -0.2, 1.35))

    pl.airlight.enable(medium=make_water(), color_space="srgb")
    pl.airlight.add_lamp(bow, INTENSITY, target=(4.5, 0.2, 0.2), cone_angle=32)
    pl.airlight.add_lamp((-0.6, -3.0, 3.2), 8)  # of the diver who takes the picture
    pl.camera_position = [(0.6, -5.0, 1.9), (1.2, 0, 0.8), (0, 0, 1)]
    pl.camera.view_angle = 50
    pl.show(screenshot=os.path.join(folder, "underwater.png") if folder else None)


if __name__ == "__main__":
    main()
