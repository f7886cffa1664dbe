#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud in the sun as Airlight and as VTK's volume rendering draw it, beside the exact picture.

    cloud_beside_vtk.py CLOUD.vdb [-o PICTURE.png]
    cloud_beside_vtk.py CLOUD.vti [-o PICTURE.png]

All of them have the same density, extinction, sun and phase function. vtkAirlightReference gives
the light that is scattered once, to the digits that it states. VTK has volumetric shadows from
version 9.2 on; older ones draw its plain ray casting only. Brightness has no unit in VTK: each
picture of it has the factor that fits best, which favours it. The program prints the root mean
square of each picture's differences over the exact picture's mean, where the cloud is, and the time
of a frame; the picture shows them side by side, the exact one first.
"""

import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkLight, vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401 VTK's volume renderer

import airlight
import airlight.display
import plume_as_fog

ALBEDO = 0.99
ANISOTROPY = 0.5
TO_SUN = (-2.0, 1.5, 1.0)
IRRADIANCE = 10.0  # W/m^2
VIEW_ANGLE = 30.0
FRAMES = 3


def read_density(path, grid):
    if path.endswith(".vdb"):
        return plume_as_fog.read_density(path, grid)
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    if image.GetNumberOfPoints() == 0:
        raise SystemExit(1)  # VTK has reported the reason
    if image.GetPointData().GetScalars() is None:
        raise SystemExit(f"{path}: its points have no scalars, which would be the density")
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    np.maximum(values, 0, out=values)  # simulations overshoot
    image.Modified()
    return image


def find_extinction(image, depth):
    """That which gives the largest ways along one axis this optical depth."""
    longest = plume_as_fog.longest_way(image)
    if longest == 0:
        raise SystemExit("the density is 0 everywhere")
    return depth / longest


def make_renderer(bounds):
    renderer = vtkRenderer()
    renderer.SetBackground(0, 0, 0)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(TO_SUN)
    sun.SetFocalPoint(0, 0, 0)
    renderer.AddLight(sun)
    middle = np.array([bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]]) / 2
    radius = np.linalg.norm(np.array(bounds[1::2]) - middle)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle)
    camera.SetPosition(middle + (0, 0, 0.75 * radius / np.sin(np.radians(VIEW_ANGLE / 2))))
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetClippingRange(0.5 * radius, 8 * radius)
    return renderer, sun


def read_pixels(window, size):
    values = numpy_to_vtk(np.empty((0, 3), np.uint8), deep=True)
    window.GetPixelData(0, 0, size[0] - 1, size[1] - 1, False, values, 0)
    return vtk_to_numpy(values).reshape(size[1], size[0], 3)


def time_frame(window, camera):
    """The median of some frames in which the camera moves by a hair."""
    seconds = []
    for _ in range(FRAMES):
        camera.Azimuth(1e-3)
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        seconds.append(time.perf_counter() - start)
    camera.Azimuth(-1e-3 * FRAMES)
    return np.median(seconds)


def make_medium(image, extinction):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(3 * [ALBEDO * extinction])
    medium.SetAbsorption(3 * [(1 - ALBEDO) * extinction])
    medium.SetDensityImage(image)
    medium.SetDensityToImage()
    medium.SetPhaseFunctionToHenyeyGreenstein()
    medium.SetAnisotropy(ANISOTROPY)
    return medium


def draw_by_airlight(image, extinction, size):
    """The pass' picture, the exact one, and the seconds of both."""
    renderer, sun = make_renderer(image.GetBounds())
    airlight.vtkAirlight.SetIrradiance(sun, 3 * [IRRADIANCE])
    medium = make_medium(image, extinction)
    render_pass = airlight.vtkAirlightPass()
    render_pass.AddMedium(medium)
    renderer.SetPass(render_pass)
    window = airlight.display.open_window(renderer, size=size, offscreen=True)
    seconds = time_frame(window, renderer.GetActiveCamera())
    render_pass.RecordBuffersOn()
    window.Render()
    drawn = vtk_to_numpy(render_pass.GetBuffer("Radiance").GetPointData().GetScalars())
    drawn = drawn.reshape(size[1], size[0], 3).copy()
    exact, _, exact_seconds = plume_as_fog.render_reference(renderer, medium, size)
    return drawn, seconds, exact, exact_seconds


def make_volume(image, extinction, shadows):
    unit = 1 / extinction
    highest = image.GetPointData().GetScalars().GetRange()[1]
    opacity = vtkPiecewiseFunction()
    for density in np.linspace(0, highest, 257):
        opacity.AddPoint(density, 1 - np.exp(-density * extinction * unit))
    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(0, ALBEDO, ALBEDO, ALBEDO)
    volume = vtkVolume()
    volume_property = volume.GetProperty()
    volume_property.SetScalarOpacity(opacity)
    volume_property.SetScalarOpacityUnitDistance(unit)
    volume_property.SetColor(colour)
    volume_property.SetInterpolationTypeToLinear()
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(min(image.GetSpacing()) / 2)
    if shadows:
        volume_property.ShadeOn()
        volume_property.SetAmbient(0)
        volume_property.SetDiffuse(1)
        volume_property.SetSpecular(0)
        volume_property.SetScatteringAnisotropy(ANISOTROPY)
        mapper.SetVolumetricScatteringBlending(2)  # nothing but volumetric shadows
        mapper.SetGlobalIlluminationReach(1)  # through all of the volume
    volume.SetMapper(mapper)
    return volume


def draw_by_vtk(image, extinction, size, shadows):
    renderer, sun = make_renderer(image.GetBounds())
    renderer.AddVolume(make_volume(image, extinction, shadows))
    window = airlight.display.open_window(renderer, size=size, offscreen=True)
    # As bright as eight bits allow.
    for _ in range(12):
        brightest = read_pixels(window, size).max()
        if 160 <= brightest < 255 or not shadows:
            break
        factor = 0.5 if brightest == 255 else 200 / max(brightest, 1)
        sun.SetIntensity(factor * sun.GetIntensity())
        window.Render()
    picture = read_pixels(window, size) / 255
    return picture, time_frame(window, renderer.GetActiveCamera())


def fit(picture, exact):
    """With the factor that makes the sum of squares least."""
    return picture * (picture * exact).sum() / max((picture**2).sum(), 1e-300)


def write_picture(path, pictures):
    white = np.percentile(pictures[0].max(axis=-1), 99.5)
    pixels = np.concatenate([(part / white).clip(0, 1) ** (1 / 2.2) for part in pictures], axis=1)
    writer = vtkPNGWriter()
    writer.SetInputData(plume_as_fog.make_image((255 * pixels + 0.5).astype(np.uint8)))
    writer.SetFileName(path)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", help="a .vdb file, or a .vti file whose scalars are the density")
    parser.add_argument("grid", nargs="?", default="", help="of a .vdb file; default: the first")
    parser.add_argument("-o", "--output", help="picture to write, a PNG")
    parser.add_argument("--size", nargs=2, type=int, default=(240, 240), metavar=("W", "H"))
    parser.add_argument("--depth", type=float, default=6.0, help="the cloud's largest optical depth"
                        " along the axis where that is least; default: 6")
    options = parser.parse_args()
    if min(options.size) < 1 or not options.depth > 0:
        parser.error("--size and --depth must be above 0")
    image = read_density(options.file, options.grid)
    extinction = find_extinction(image, options.depth)
    drawn, seconds, exact, exact_seconds = draw_by_airlight(image, extinction, options.size)
    rows = [("vtkAirlightReference", exact, exact_seconds), ("vtkAirlightPass", drawn, seconds)]
    if hasattr(vtkGPUVolumeRayCastMapper, "SetVolumetricScatteringBlending"):
        picture, seconds = draw_by_vtk(image, extinction, options.size, True)
        rows.append(("VTK, volumetric shadows", fit(picture, exact), seconds))
    else:
        print("VTK has volumetric shadows from version 9.2 on")
    picture, seconds = draw_by_vtk(image, extinction, options.size, False)
    rows.append(("VTK, no shadows", fit(picture, exact), seconds))
    there = exact.max(axis=-1) > 1e-3 * exact.max()
    print(f"{'x'.join(map(str, image.GetDimensions()))} samples, "
          f"{'x'.join(map(str, options.size))} pixels, {100 * there.mean():.0f} % of them cloud")
    for name, picture, seconds in rows:
        error = np.sqrt(((picture - exact)[there]**2).mean()) / exact[there].mean()
        print(f"{name:24}error {error:8.2g}  seconds {seconds:8.3g}")
    if options.output:
        write_picture(options.output, [picture for _, picture, _ in rows])


if __name__ == "__main__":
    main()
