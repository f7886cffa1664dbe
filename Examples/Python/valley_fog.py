#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Morning fog in the valleys of Tennessee, and the shadows of the ridges in it.

The terrain is measured: the Jacksboro fault (Examples/Data/jacksboro_elevation.npz, from
matplotlib's sample data), drawn three times as high as it is. The fog thins out exponentially with
height. Lengths are kilometres.

The program prints the fog's optical depth straight down onto the lowest point and onto the highest,
in the raised terrain: three times that of fog as thick as this over the true one. The sun's
direction is chosen for the picture.
"""

import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

DATA = pathlib.Path(__file__).resolve().parents[1] / "Data" / "jacksboro_elevation.npz"
CELL = (0.0744, 0.0925)  # km: 3 seconds of arc at 36.6 degrees north, to the east and to the north
RAISED = 3.0  # factor of heights
FOG_HEIGHT, FOG = 0.17, 0.75  # scale height in km, and scattering per km at the base
FOG_BASE = 0.78  # km above the sea in the raised terrain
ANISOTROPY = 0.5
TO_SUN = (0.9, 0.26, -0.55)  # east, up, south
SUN = (10.0, 6.9, 4.0)  # irradiance, with 1 as white; red, green, blue
SKY = (0.10, 0.14, 0.22)  # radiance
EYE, TARGET, ANGLE = (4.5, 5.2, 29.0), (16.0, -0.7, 8.0), 27


def make_terrain():
    """Triangles of the elevation model: x east, y up, z south, from its north-western corner."""
    heights = np.load(DATA)["elevation"] * 1e-3 * RAISED
    rows, columns = heights.shape
    x, z = np.meshgrid(CELL[0] * np.arange(columns), CELL[1] * np.arange(rows))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack((x, heights, z), axis=-1).reshape(-1, 3), deep=True))
    grid = vtkStructuredGrid()
    grid.SetDimensions(columns, rows, 1)
    grid.SetPoints(points)
    surface, triangles, normals = vtkGeometryFilter(), vtkTriangleFilter(), vtkPolyDataNormals()
    surface.SetInputData(grid)
    triangles.SetInputConnection(surface.GetOutputPort())
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SplittingOff()
    return normals, heights


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser, (640, 360))
    options = parser.parse_args()
    terrain, heights = make_terrain()
    sun = vtkLight()
    airlight.vtkAirlight.SetIrradiance(sun, SUN)
    sun.SetPosition(TO_SUN)
    sun.SetFocalPoint(0, 0, 0)
    fog = airlight.vtkParticipatingMedium()
    fog.SetScattering(3 * [FOG])
    fog.SetDensityToExponentialHeight()
    fog.SetScaleHeight(FOG_HEIGHT * RAISED)
    fog.SetReferenceHeight(FOG_BASE)
    fog.SetAmbientRadiance(SKY)
    fog.SetPhaseFunctionToHenyeyGreenstein()
    fog.SetAnisotropy(ANISOTROPY)
    for name, height in (("lowest", heights.min()), ("highest", heights.max())):
        kept = [0.0, 0.0, 0.0]
        airlight.vtkAirlight.Transmittance(fog, (0, height, 0), (0, 1e3, 0), kept)
        print(f"optical depth of the fog above the {name} point: {-np.log(kept[1]):.3f}")

    renderer = vtkRenderer()
    renderer.SetBackground(0.30, 0.42, 0.66)
    renderer.SetBackground2(0.16, 0.30, 0.62)
    renderer.GradientBackgroundOn()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(terrain.GetOutputPort())
    ground = vtkActor()
    ground.SetMapper(mapper)
    ground.GetProperty().SetColor(0.13, 0.15, 0.06)
    ground.GetProperty().SetAmbientColor(np.multiply((0.13, 0.15, 0.06), SKY))
    ground.GetProperty().SetAmbient(1)
    renderer.AddActor(ground)
    renderer.AddLight(sun)
    sky = vtkLight()  # shows the relief of shaded slopes; the fog does not scatter it
    sky.SetLightTypeToHeadlight()
    sky.SetColor(SKY)
    sky.SetIntensity(1.3)
    airlight.vtkAirlightLight.SetScatters(sky, False)
    renderer.AddLight(sky)
    airlight.display.show_picture(renderer, fog, options, EYE, TARGET, ANGLE)


if __name__ == "__main__":
    main()
