#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A cumulus cloud in the evening sun, which shades itself.

The density is computed here: spheres above a flat base, eroded by five octaves of noise. Lengths are kilometres. Light is scattered once; for the light that
is scattered more often stands an ambient radiance.

The program prints the largest optical depth of the cloud from above, and how much of the image's
base the cloud shades by half or more when the sun is overhead.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

import airlight
import airlight.display

SHAPE, CELL = (84, 132, 190), 0.0168  # points along z (depth), y (up) and x; km
EXTINCTION = 16.0  # per km in the cloud's core
ANISOTROPY = 0.55
BASE = 0.1  # km above the image's bottom
PUFFS = [(-0.9, 0.25, 0.0, 0.34), (-0.5, 0.42, 0.1, 0.46), (0.0, 0.55, 0.0, 0.56),
         (0.15, 0.98, -0.05, 0.44), (0.5, 0.40, 0.1, 0.46), (0.35, 0.75, 0.1, 0.36),
         (0.95, 0.24, -0.05, 0.34), (1.3, 0.14, 0.05, 0.22), (-1.25, 0.14, 0.0, 0.22)]
TO_SUN = (-0.85, 0.40, 0.10)
SUN = (56.0, 44.0, 31.5)  # irradiance, with 1 as white; red, green, blue
SKY = (0.13, 0.18, 0.28)  # radiance
EYE, TARGET, ANGLE = (-0.6, 0.15, 5.6), (0.0, 0.66, 0.0), 19.5


def noise(points, seed):
    """Smooth noise between -1 and 1 that varies over a length of 1."""
    grid = np.random.default_rng(seed).uniform(-1, 1, (32, 32, 32))
    low = np.floor(points).astype(int)
    u = points - low
    u = u * u * (3 - 2 * u)
    total = 0.0
    for corner in np.ndindex(2, 2, 2):
        weight = np.prod(np.where(corner, u, 1 - u), axis=-1)
        total = total + weight * grid[tuple(np.moveaxis((low + corner) % 32, -1, 0))]
    return total


def make_cloud():
    """The density as an array [z, y, x] and as an image."""
    z, y, x = (CELL * (np.arange(count) - (count - 1) * middle)
               for count, middle in zip(SHAPE, (0.5, 0.0, 0.5)))
    points = np.stack(np.meshgrid(z, y, x, indexing="ij")[::-1], axis=-1)
    turn = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]  # hides the noise's lattice
    billows, scaled = 0.0, 2.7 * points @ turn
    for k in range(5):
        billows = billows + 0.52**k * np.abs(noise(scaled + 7.3, k))
        scaled = 2 * scaled @ turn
    inside = np.full(points.shape[:-1], -1.0)
    for px, py, pz, radius in PUFFS:
        distance = np.linalg.norm(points - (px, BASE + py, pz), axis=-1)
        inside = np.maximum(inside, (radius - distance) / 0.3)
    above = np.clip((points[..., 1] - BASE) / 0.10, 0, 1)
    density = np.clip(2.6 * (inside + 0.42 - 0.75 * billows), 0, 1) * above
    image = vtkImageData()
    image.SetDimensions(SHAPE[::-1])
    image.SetOrigin(x[0], y[0], z[0])
    image.SetSpacing(3 * [CELL])
    image.GetPointData().SetScalars(numpy_to_vtk(density.ravel(), deep=True))
    return density, image


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser, (640, 360))
    options = parser.parse_args()
    density, image = make_cloud()
    cloud = airlight.vtkParticipatingMedium()
    cloud.SetScattering(3 * [EXTINCTION])
    cloud.SetDensityToImage()
    cloud.SetDensityImage(image)
    cloud.SetAmbientRadiance(SKY)
    cloud.SetPhaseFunctionToHenyeyGreenstein()
    cloud.SetAnisotropy(ANISOTROPY)
    x0, x1, y0, y1, z0, z1 = image.GetBounds()
    depths = []
    for x in np.linspace(x0, x1, 81)[:-1] + (x1 - x0) / 160:
        for z in np.linspace(z0, z1, 37)[:-1] + (z1 - z0) / 72:
            kept = [0.0, 0.0, 0.0]
            airlight.vtkAirlight.Transmittance(cloud, (x, y0, z), (x, y1, z), kept)
            depths.append(-np.log(kept[0]))
    print(f"optical depth from above at most {max(depths):.2f}; "
          f"{100 * np.mean(np.array(depths) > np.log(2)):.1f} % of the base in half shade")

    renderer = vtkRenderer()
    renderer.SetBackground(0.34, 0.47, 0.66)
    renderer.SetBackground2(0.07, 0.17, 0.42)
    renderer.GradientBackgroundOn()
    sun = vtkLight()
    airlight.vtkAirlight.SetIrradiance(sun, SUN)
    sun.SetPosition(TO_SUN)
    sun.SetFocalPoint(0, 0, 0)
    renderer.AddLight(sun)
    renderer.GetActiveCamera().SetClippingRange(0.1, 50)  # there is no surface
    airlight.display.show_picture(renderer, cloud, options, EYE, TARGET, ANGLE)


if __name__ == "__main__":
    main()
