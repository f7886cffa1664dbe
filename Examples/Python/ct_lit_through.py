#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A CT scan lit through: a lamp in the pelvis, and the shadows of the bones in the tissue.

The soft tissue is a medium whose density rises with the scan's values (Examples/Data/torso_ct.npz,
from TotalSegmentator), from -160 to 40 Hounsfield units. Bones are a surface of constant density in
the scan, which is sharpened and closed first: samples 3 mm apart are too far for thin walls of
bone, and the surface would be full of holes. The thinnest part of each hip bone stays open. Lengths
are centimetres. The tissue is far clearer than it is, so that one sees through it.

The program prints the volume of the bones, with their marrow, and the optical depth from the lamp
to the belly.
"""

import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import (
    vtkFlyingEdges3D, vtkMassProperties, vtkPolyDataConnectivityFilter, vtkPolyDataNormals,
    vtkQuadricDecimation, vtkWindowedSincPolyDataFilter)
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkImagingMorphological import (
    vtkImageContinuousDilate3D, vtkImageContinuousErode3D)
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
import airlight.display

DATA = pathlib.Path(__file__).resolve().parents[1] / "Data" / "torso_ct.npz"
BONE = 140  # Hounsfield units, in the sharpened scan
SHARPER = 1.0  # times the difference from the mean, which a Gauss curve of 2 samples weighs
CLOSED = 3  # samples: gaps that are narrower are closed
LAMP = (18.3, 20.0, 10.0)  # left to right, back to front, up
INTENSITY = (650.0, 400.0, 230.0)  # with 1 as white; red, green, blue
SCATTERING = 0.04  # per centimetre, from 40 Hounsfield units on
ABSORPTION = (0.008, 0.025, 0.045)  # tissue is red
EYE, TARGET, ANGLE = (6.0, 82.0, 20.0), (18.3, 15.0, 15.5), 25


def make_image(values, spacing):
    """A vtkImageData of samples that are so many centimetres apart."""
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(3 * [spacing])
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return image


def read_scan():
    """The scan as an image of Hounsfield units, 0.3 cm apart, and as an array."""
    data = np.load(DATA)
    units = 8.0 * data["values"] - 1024
    return make_image(units, 0.1 * float(data["spacing"])), units


def outside(shape):
    """Which samples are not of the body, but of the couch under the back."""
    _, y, x = np.indices(shape)
    return ((x - 60) / 60)**2 + ((y - 50) / 46)**2 > 1


def blur(image, deviation):
    """Its mean, weighted by a Gauss curve of a deviation in samples."""
    smooth = vtkImageGaussianSmooth()
    smooth.SetInputData(image)
    smooth.SetStandardDeviation(deviation)
    smooth.SetRadiusFactors(2.5, 2.5, 2.5)
    smooth.Update()
    return smooth.GetOutput()


def close_walls(scan, units):
    """The scan as an image in which walls of bone have no gaps."""
    spacing = scan.GetSpacing()[0]
    units = np.where(outside(units.shape), -50, np.clip(units, -50, 400))
    mean = blur(make_image(units, spacing), 2.0).GetPointData().GetScalars()
    sharp = units + SHARPER * (units - vtk_to_numpy(mean).reshape(units.shape))
    dilate, erode = vtkImageContinuousDilate3D(), vtkImageContinuousErode3D()
    dilate.SetInputData(make_image(sharp, spacing))
    erode.SetInputConnection(dilate.GetOutputPort())
    for step in (dilate, erode):
        step.SetKernelSize(CLOSED, CLOSED, CLOSED)
    erode.Update()
    return blur(erode.GetOutput(), 0.6)


def make_bones(scan, units):
    """The largest connected surfaces of bone, and of nothing else: small parts are noise."""
    contour, smooth = vtkFlyingEdges3D(), vtkWindowedSincPolyDataFilter()
    contour.SetInputData(close_walls(scan, units))
    contour.SetValue(0, BONE)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    parts = vtkPolyDataConnectivityFilter()
    parts.SetInputConnection(contour.GetOutputPort())
    parts.SetExtractionModeToAllRegions()
    parts.Update()
    sizes = [parts.GetRegionSizes().GetValue(i) for i in range(parts.GetNumberOfExtractedRegions())]
    parts.SetExtractionModeToSpecifiedRegions()
    for region, size in enumerate(sizes):
        if size > 800:
            parts.AddSpecifiedRegion(region)
    smooth.SetInputConnection(parts.GetOutputPort())
    smooth.SetNumberOfIterations(30)
    smooth.SetPassBand(0.06)
    smooth.NormalizeCoordinatesOn()
    fewer = vtkQuadricDecimation()
    fewer.SetInputConnection(smooth.GetOutputPort())
    fewer.SetTargetReduction(0.8)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(fewer.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    return normals


def make_tissue(scan, units):
    """A medium as dense as the scan's soft tissue, without the couch and the bones' excess."""
    density = np.clip((units + 160) / 200, 0, 1)
    density[outside(density.shape)] = 0
    density = density[::2, ::2, ::2]  # airlight is smooth, and this is faster
    tissue = airlight.vtkParticipatingMedium()
    tissue.SetScattering(3 * [SCATTERING])
    tissue.SetAbsorption(ABSORPTION)
    tissue.SetDensityToImage()
    tissue.SetDensityImage(make_image(density, 2 * scan.GetSpacing()[0]))
    return tissue


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser, (640, 360))
    options = parser.parse_args()
    scan, units = read_scan()
    bones = make_bones(scan, units)
    tissue = make_tissue(scan, units)
    volume = vtkMassProperties()
    volume.SetInputConnection(bones.GetOutputPort())
    kept = [0.0, 0.0, 0.0]
    airlight.vtkAirlight.Transmittance(tissue, LAMP, (LAMP[0], 40, LAMP[2]), kept)
    print(f"{volume.GetVolume():.0f} cm^3 of bone; optical depth from the lamp to the front "
          f"{', '.join(f'{depth:.3f}' for depth in -np.log(kept))} in red, green and blue")

    renderer = vtkRenderer()
    renderer.SetBackground(0.002, 0.003, 0.006)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(bones.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.75, 0.70, 0.60)
    renderer.AddActor(actor)
    lamp = vtkLight()
    lamp.SetPosition(LAMP)
    airlight.vtkAirlight.SetRadiantIntensity(lamp, INTENSITY)
    airlight.vtkAirlightLight.SetRadius(lamp, 0.4)
    airlight.vtkAirlightLight.SetVisible(lamp, True)
    renderer.AddLight(lamp)
    fill = vtkLight()  # shows the bones' form; the tissue does not scatter it
    fill.SetLightTypeToHeadlight()
    fill.SetColor(0.35, 0.55, 1.0)
    fill.SetIntensity(0.3)
    airlight.vtkAirlightLight.SetScatters(fill, False)
    renderer.AddLight(fill)
    renderer.SetUseFXAA(options.frames == 1)
    airlight.display.show_picture(renderer, tissue, options, EYE, TARGET, ANGLE, up=(0, 0, 1))


if __name__ == "__main__":
    main()
