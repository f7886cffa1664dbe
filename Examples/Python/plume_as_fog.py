#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A smoke plume of an OpenVDB file beside the homogeneous medium of equal optical depth.

    plume_as_fog.py PLUME.vdb [GRID] [-o PICTURE.png]

The sun shines on the plume. The program computes a picture from the density, cell by cell, and one
of a box of homogeneous smoke with the plume's bounds. Equal optical depth means that the mean
transmittance is the same over the pixels that see the plume. In a box in the sun, airlight has a
closed form, which vtkAirlightPass draws and vtkAirlightReference computes. The program prints times
and differences side by side. The picture shows the density, the homogeneous box, and their
difference: orange if the box is brighter, blue if it is darker.
"""

import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer

import airlight

ALBEDO = 0.9
IRRADIANCE = 10.0  # W/m^2
TO_SUN = (-2.0, 1.5, 1.0)
VIEW_ANGLE = 30.0
METRICS = ("relMSE", "median", "p99", "bias", "PSNR")


def read_density(path, grid):
    reader = airlight.vtkOpenVDBDensityReader()
    reader.SetFileName(path)
    reader.SetGridName(grid)
    reader.Update()
    image = reader.GetOutput()
    if image.GetNumberOfPoints() == 0:
        raise SystemExit(1)  # VTK has reported the reason
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    np.maximum(values, 0, out=values)  # simulations overshoot
    image.Modified()
    return image


def longest_way(image):
    """The largest integral of the density along the grid axis for which it is least."""
    density = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    return min(density.sum(axis=2 - i).max() * image.GetSpacing()[i] for i in range(3))


def make_medium(extinction):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(3 * [ALBEDO * extinction])
    medium.SetAbsorption(3 * [(1 - ALBEDO) * extinction])
    return medium


def make_plume(image, extinction):
    medium = make_medium(extinction)
    medium.SetDensityImage(image)
    medium.SetDensityToImage()
    return medium


def make_box(bounds, extinction):
    medium = make_medium(extinction)
    medium.SetBounds(bounds)
    medium.SetRegionToBox()
    return medium


def make_renderer(bounds):
    """The sun, and a camera that sees the whole box; the background is black."""
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    airlight.vtkAirlight.SetIrradiance(sun, 3 * [IRRADIANCE])
    sun.SetPosition(TO_SUN)
    sun.SetFocalPoint(0, 0, 0)
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(sun)
    low, high = np.reshape(bounds, (3, 2)).T
    middle, diagonal = (low + high) / 2, np.linalg.norm(high - low)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle)
    distance = 0.5 * diagonal / np.sin(np.radians(VIEW_ANGLE / 2))
    camera.SetPosition(middle + distance * np.array((0.28, 0.0, 0.96)))
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetClippingRange(0.01 * distance, distance + diagonal)
    return renderer


# ---- Pictures, as arrays [height, width, 3] whose row 0 is the bottom row ------------------------


def render_reference(renderer, medium, size):
    """Radiance and transmittance of the reference, and its computing time in seconds."""
    reference = airlight.vtkAirlightReference()
    reference.SetRenderer(renderer)
    reference.SetMedium(medium)
    reference.SetSize(size)
    start = time.perf_counter()
    reference.Update()
    seconds = time.perf_counter() - start
    data = reference.GetOutput().GetPointData()
    return [vtk_to_numpy(data.GetArray(name)).reshape(size[1], size[0], 3)
            for name in ("Radiance", "Transmittance")] + [seconds]


def render_pass(renderer, medium, size):
    """The same for the pass. The first frame compiles the shaders and is not timed."""
    fog_pass = airlight.vtkAirlightPass()
    fog_pass.SetMedium(medium)
    fog_pass.RecordBuffersOn()
    renderer.SetPass(fog_pass)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size)
    window.AddRenderer(renderer)
    for _ in range(2):
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        seconds = time.perf_counter() - start
    buffers = [fog_pass.GetBuffer(name) for name in ("Radiance", "Transmittance")]
    return [vtk_to_numpy(buffer.GetPointData().GetScalars()).reshape(size[1], size[0], 3).copy()
            for buffer in buffers] + [seconds]


def make_image(array):
    height, width, channels = array.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(array).reshape(-1, channels)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return image


def compare(array, expected, mask):
    comparison = airlight.vtkAirlightComparison()
    comparison.SetImageData(make_image(array))
    comparison.SetReferenceData(make_image(expected))
    comparison.SetMaskData(make_image(mask[..., None].astype(float)))
    comparison.Update()
    table = comparison.GetMetrics()
    return {name: table.GetValueByName(0, name).ToDouble() for name in METRICS}


def write_picture(path, plume, box):
    white = np.percentile(plume.max(axis=-1), 99.5)
    parts = [(part / white).clip(0, 1) ** (1 / 2.2) for part in (plume, box)]
    difference = (box - plume).mean(axis=-1) / white
    parts.append(np.stack([difference, 0.25 * abs(difference), -difference], -1)
                 .clip(0, 1) ** (1 / 2.2))
    writer = vtkPNGWriter()
    writer.SetInputData(make_image((255 * np.concatenate(parts, axis=1) + 0.5).astype(np.uint8)))
    writer.SetFileName(path)
    writer.Write()


# ---- The homogeneous medium ----------------------------------------------------------------------


def match_extinction(lengths, transmittance):
    """The extinction that gives rays of these lengths this mean transmittance."""
    low, high = 0.0, 1 / lengths.mean()
    while np.exp(-high * lengths).mean() > transmittance:
        high *= 2
    for _ in range(60):  # bisects down to the last bit
        middle = (low + high) / 2
        if np.exp(-middle * lengths).mean() > transmittance:
            low = middle
        else:
            high = middle
    return high


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", help="the .vdb file")
    parser.add_argument("grid", nargs="?", default="", help="its grid; default: the first")
    parser.add_argument("-o", "--output", help="picture to write, a PNG")
    parser.add_argument("--arrays", help="radiances and transmittances to write, an .npz")
    parser.add_argument("--size", nargs=2, type=int, default=(160, 240), metavar=("W", "H"))
    parser.add_argument("--depth", type=float, default=4.0, help="the plume's largest optical depth"
                        " along the grid's axis where that is least; default: 4")
    options = parser.parse_args()
    if min(options.size) < 1 or not options.depth > 0:
        parser.error("--size and --depth must be above 0")

    image = read_density(options.file, options.grid)
    if longest_way(image) == 0:
        parser.error(f"{options.file}: the density is 0 everywhere")
    bounds, size = image.GetBounds(), options.size
    renderer = make_renderer(bounds)
    extinction = options.depth / longest_way(image)
    plume, plume_t, plume_s = render_reference(renderer, make_plume(image, extinction), size)
    seen = plume_t[..., 0] < 0.99
    if not seen.any():
        parser.error("no pixel sees the plume: increase --depth or --size")
    mean = plume_t[seen, 0].mean()

    # The transmittance of a thin medium gives the length of each ray in the box.
    thin = 1e-3 * extinction
    _, thin_t, _ = render_reference(renderer, make_box(bounds, thin), size)
    matched = match_extinction(-np.log(thin_t[seen, 0]) / thin, mean)
    box = make_box(bounds, matched)
    exact, exact_t, exact_s = render_reference(renderer, box, size)
    drawn, drawn_t, drawn_s = render_pass(renderer, box, size)

    print(f"{seen.sum()} of {seen.size} pixels see the plume, mean transmittance {mean:.4f}")
    print(f"extinction at density 1: {extinction:.4g}, of the homogeneous box: {matched:.4g}")
    print(f"{'':33}{'seconds':>10}" + "".join(f"{name:>10}" for name in METRICS))
    print(f"{'density, reference':33}{plume_s:10.3f}")
    for name, seconds, picture, expected in (
            ("homogeneous, reference", exact_s, exact, plume),
            ("homogeneous, pass", drawn_s, drawn, plume),
            ("homogeneous, pass to reference", None, drawn, exact)):
        scores = compare(picture, expected, seen)
        print(f"{name:33}" + (" " * 10 if seconds is None else f"{seconds:10.3f}") +
              "".join(f"{scores[score]:10.3g}" for score in METRICS))
    if options.output:
        write_picture(options.output, plume, exact)
    if options.arrays:
        camera = renderer.GetActiveCamera()
        np.savez(options.arrays, plume=plume, plume_t=plume_t, exact=exact, exact_t=exact_t,
                 drawn=drawn, drawn_t=drawn_t, seen=seen, extinction=extinction, matched=matched,
                 bounds=bounds, eye=camera.GetPosition(), focal_point=camera.GetFocalPoint())


if __name__ == "__main__":
    main()
