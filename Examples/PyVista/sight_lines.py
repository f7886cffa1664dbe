#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a driver sees in a smoky tunnel: sight lines, coloured by the light that is left on them.

The program prints, for each sign, the transmittance of its sight line, the veil in front of it,
and whether its contrast is above 2 %.

    python3 sight_lines.py [FOLDER]     writes FOLDER/sight_lines.png; without a folder, a window
"""

import os
import sys

import numpy as np
import pyvista as pv

import airlight

VISIBILITY = 20  # m
EYE = (0.0, 0.0, 1.3)  # m
SIGNS = [(x, 2.2 * side, 2.6)
         for x, side in ((6, 1), (12, -1), (18, 1), (24, -1), (30, 1), (36, -1))]
SIGN = 0.5  # W/(m^2 sr), the radiance of a sign
WALL = 0.02  # that of the wall behind it


def make_tunnel():
    """Half of a cylinder, open towards the camera."""
    tunnel = pv.CylinderStructured(radius=[4.0], height=42, center=(19, 0, 0), direction=(1, 0, 0),
                                   theta_resolution=60, z_resolution=2).extract_surface(
                                       algorithm="dataset_surface")
    return tunnel.clip("z", origin=(0, 0, 0), invert=False).clip("y", origin=(0, -0.5, 0),
                                                                 invert=False)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    pl = pv.Plotter(off_screen=folder is not None, window_size=(1200, 700), lighting="none")
    pl.background_color = "black"
    pl.add_mesh(make_tunnel(), color="gray")
    pl.add_mesh(pv.Plane(center=(19, 0, 0), i_size=42, j_size=8), color=(0.3, 0.3, 0.3))
    truck = pv.Cube(bounds=(13, 19, -2.8, -0.9, 0.4, 2.2))
    pl.add_mesh(truck, color="steelblue")
    for x, y, z in SIGNS:
        pl.add_mesh(pv.Cube(center=(x, y, z), x_length=0.1, y_length=0.8, z_length=0.5),
                    color=(SIGN, SIGN, 0.1), lighting=False)

    pl.airlight.enable(visibility=VISIBILITY, anisotropy=0.5, albedo=0.4, ambient=0,
                       region=(-2, 40, -4, 4, 0, 4), color_space="srgb",
                       tone_mapping="clamp")
    lamps = [pl.airlight.add_lamp((x, 0, 3.9), 16, color=(1, 0.9, 0.7)) for x in range(4, 40, 8)]

    lines = pv.line_segments_from_points([p for sign in SIGNS for p in (EYE, sign)])
    lines = lines.airlight.transmittance(pl.airlight)
    veils = lines.airlight.inscatter(pl.airlight, lamps, occluders=truck)["Airlight"][:, 1]
    left = lines["Transmittance"][:, 1]
    contrast = (SIGN - WALL) * left / (WALL * left + veils)
    for sign, share, veil, value in zip(SIGNS, left, veils, contrast):
        is_hidden = len(truck.ray_trace(EYE, sign)[0]) > 0
        verdict = "hidden by the truck" if is_hidden else "seen" if value > 0.02 else "not seen"
        print(f"sign at {np.linalg.norm(np.subtract(sign, EYE)):4.1f} m: {100 * share:4.1f} % of "
              f"its light, veil {veil:.3f}, contrast {value:5.2f}: {verdict}")

    lines["light left, %"] = 100 * left
    tubes = pl.add_mesh(lines.tube(radius=0.04), scalars="light left, %", cmap="plasma",
                        clim=(0, 50), lighting=False, scalar_bar_args={"color": "white"})
    airlight.vtkAirlightPass.SetCastsShadow(tubes, False)
    pl.add_mesh(pv.Sphere(center=EYE, radius=0.2), color="white", lighting=False)
    pl.camera_position = [(-7, -13, 8), (13, 0.5, 1.2), (0, 0, 1)]
    pl.camera.view_angle = 40
    pl.show(screenshot=os.path.join(folder, "sight_lines.png") if folder else None)


if __name__ == "__main__":
    main()
