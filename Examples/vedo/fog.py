#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A vedo scene in fog: a lamp among the trunks of a forest.

    python fog.py          # opens a window; q closes it
    python fog.py fog.png  # writes the picture, without a screen

One line puts a vedo.Plotter into fog: plotter.renderer.SetPass(fog_pass).
"""

import argparse
import os

import numpy as np
import vedo

import airlight

LAMP = (0.7, 8.0, 1.9)  # m; z is up, the view is along y
INTENSITY = (46, 34, 19)  # W/sr
CAMERA = {"position": (-0.8, -2.5, 3.2), "focal_point": (0.6, 8, 1.9), "viewup": (0, 0, 1),
          "view_angle": 50}


def make_trunks():
    """Trunks on a distorted lattice, some way off the camera and the lamp."""
    random = np.random.default_rng(3)
    trunks = []
    for x in np.arange(-11, 12, 2.2):
        for y in np.arange(2.5, 26, 2.2):
            place = np.array((x, y)) + random.uniform(-0.8, 0.8, 2)
            radius, lean = random.uniform(0.1, 0.24), random.uniform(-0.35, 0.35, 2)
            if abs(place[0]) < 0.2 * place[1] or np.hypot(*(place - LAMP[:2])) < 1.2:
                continue
            foot, top = (*place, -0.2), (*(place + lean), 11)
            trunks.append(vedo.Cylinder([foot, top], r=radius, res=24, cap=False))
    return vedo.merge(trunks)


def make_fog():
    fog = airlight.vtkParticipatingMedium()
    fog.SetVisibility(50)  # metres
    fog.SetPhaseFunctionToHenyeyGreenstein()
    fog.SetAnisotropy(0.6)  # droplets scatter forward
    fog.SetAmbientRadiance(0.008, 0.014, 0.024)  # the night sky
    fog_pass = airlight.vtkAirlightPass()
    fog_pass.SetMedium(fog)
    fog_pass.SetShadowTechniqueToShadowPlanes()  # exact shadows, although trunks are many
    fog_pass.EncodedOutputOn()  # gamma, for the eye
    return fog_pass


def make_plotter(fog_pass, offscreen=False):
    trunks = make_trunks().compute_normals().c((0.35, 0.29, 0.24))
    ground = vedo.Plane(pos=(0, 20, 0), s=(80, 80)).c((0.22, 0.22, 0.17))
    for mesh in (trunks, ground):
        mesh.lighting("default", ambient=0, diffuse=1, specular=0)
    bulb = vedo.Sphere(LAMP, r=0.12).c((1.0, 0.9, 0.7)).lighting("off")
    airlight.vtkAirlightPass.SetCastsShadow(bulb.actor, False)  # the lamp is inside it
    lamp = vedo.Light(LAMP)
    airlight.vtkAirlight.SetRadiantIntensity(lamp, INTENSITY)

    vedo.settings.multi_samples = 0  # the pass does not use them
    vedo.settings.use_fxaa = True  # but this, for smooth edges
    plotter = vedo.Plotter(size=(1200, 675), bg="black", title="Fog", offscreen=offscreen)
    plotter.renderer.SetPass(fog_pass)  # the one line
    plotter.add(trunks, ground, bulb, lamp)
    return plotter


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture", nargs="?", help="a PNG to write; default: a window")
    options = parser.parse_args()
    if options.picture and "DISPLAY" not in os.environ:  # then VTK does not look for a screen
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")

    plotter = make_plotter(make_fog(), offscreen=bool(options.picture))
    plotter.show(camera=CAMERA)
    if options.picture:
        plotter.screenshot(options.picture)
    plotter.close()


if __name__ == "__main__":
    main()
