# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkAirlightReference against the reference scenes (Testing/Data/Reference), whole pictures.

    PYTHONPATH=build/lib/python3.11/dist-packages python3 Testing/Python/TestAirlightReference.py

No window: nothing is drawn.
"""

import json
import os
import time
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
from programtest import REFERENCE, metrics, read_pfm, reference_file, scene_file


def make_light(source):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    position = np.array(source.get("position", (0, 0, 0)), float)
    if source["type"] == "directional":
        airlight.vtkAirlight.SetIrradiance(light, source["irradiance"])
    else:
        airlight.vtkAirlight.SetRadiantIntensity(light, source["intensity"])
    if source["type"] == "spot":
        light.SetConeAngle(source["cone_half_angle_deg"])
        light.SetExponent(source["exponent"])
    light.SetPosition(position)
    light.SetFocalPoint(position + source.get("direction", (0, 0, 1)))
    return light


def make_actor(surface):
    reader = vtkPLYReader()
    reader.SetFileName(os.path.join(REFERENCE, surface["mesh"]))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.ComputePointNormalsOff()
    normals.ComputeCellNormalsOn()
    normals.SplittingOff()
    normals.ConsistencyOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetDiffuseColor(surface["albedo"])
    return actor


def make_medium(values):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(values["sigma_s"])
    medium.SetAbsorption(values["sigma_a"])
    medium.SetPhaseTolerance(1e-6)  # the reference knows the phase function exactly
    if values["phase"]["g"] != 0:
        medium.SetPhaseFunctionToHenyeyGreenstein()
        medium.SetAnisotropy(values["phase"]["g"])
    box = np.transpose([values["bounds"]["min"], values["bounds"]["max"]]).ravel()
    medium.SetRegionToBox()
    medium.SetBounds(box)
    return medium


def make_reference(name):
    """The scene of a file, for its own size."""
    with open(scene_file(name)) as file:
        scene = json.load(file)
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    for source in scene["lights"]:
        renderer.AddLight(make_light(source))
    for surface in scene["surfaces"]:
        renderer.AddActor(make_actor(surface))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(scene["camera"]["position"])
    camera.SetFocalPoint(scene["camera"]["focal_point"])
    camera.SetViewUp(scene["camera"]["view_up"])
    camera.SetViewAngle(scene["camera"]["view_angle_deg"])
    camera.SetClippingRange(0.01, 1000)
    reference = airlight.vtkAirlightReference()
    reference.SetRenderer(renderer)
    reference.SetMedium(make_medium(scene["medium"]))
    reference.SetSize(scene["image"]["width"], scene["image"]["height"])
    return reference


def get(reference, name):
    """[H, W, C], row 0 = top, as read_pfm() has it."""
    image = reference.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    return values.reshape(height, width, -1)[::-1]


class TestReferenceScenes(unittest.TestCase):
    PARTS = {"total": "Radiance", "inscatter": "Airlight", "surface": "Surface",
             "transmittance": "Transmittance"}

    def check(self, name, masks):
        reference = make_reference(name)
        start = time.perf_counter()
        reference.Update()
        print(f"{name}: {time.perf_counter() - start:.2f} s")
        for part, buffer in self.PARTS.items():
            expected = read_pfm(reference_file(name, part))
            for mask in masks:
                scores = metrics(get(reference, buffer), expected,
                                 read_pfm(reference_file(name, mask)))
                print(f"  {buffer}, {mask}: median {scores['median']:.1e}, "
                      f"p99 {scores['p99']:.1e}, largest {scores['max']:.1e}, "
                      f"dark {scores['dark_max_abs']:.1e}")
                with self.subTest(scene=name, part=part, mask=mask):
                    self.assertEqual(scores["nonfinite"], 0)
                    # The files hold single precision, whose last place is 6e-8.
                    self.assertLessEqual(scores["median"], 1e-7, scores)
                    self.assertLessEqual(scores["p99"], 2.5e-7, scores)
                    # Of darker surfaces 1e-3 of the brightest.
                    self.assertLessEqual(
                        scores["max"], 5e-6 if part == "surface" else 4e-7, scores)
                    self.assertLessEqual(abs(scores["bias"]), 3e-8, scores)
                    # Nothing leaks into what must be black.
                    bright = np.percentile(expected, 99)
                    self.assertLessEqual(scores["dark_max_abs"], 1e-6 * bright, scores)
        mask = read_pfm(reference_file(name, "mask")) > 0.5
        depth = get(reference, "Depth")[mask]
        np.testing.assert_allclose(depth, read_pfm(reference_file(name, "depth"))[mask], 1e-6)

    def test_isotropic(self):
        self.check("S1_point_iso", ["mask"])

    def test_forward_scattering(self):
        self.check("S2_point_hg_pos06", ["mask"])

    def test_shadows(self):
        self.check("S3_ground_occluders", ["mask", "shadowmask"])

    def test_spot(self):
        self.check("S5_spot_slats", ["mask", "shadowmask"])

    def test_sun(self):
        self.check("S6_sun_window", ["mask", "shadowmask"])


def make_image(bounds, size, density):
    """An image that fills the bounds; density: a function of arrays x, y, z of coordinates."""
    axes = [np.linspace(low, high, n) for (low, high), n in zip(bounds, size)]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    image = vtkImageData()
    image.SetDimensions(size)
    image.SetOrigin([axis[0] for axis in axes])
    image.SetSpacing([axis[1] - axis[0] for axis in axes])
    values = numpy_to_vtk(np.ascontiguousarray(density(x, y, z), float).ravel(), deep=True)
    values.SetName("density")
    image.GetPointData().SetScalars(values)
    return image


class TestDensityImages(unittest.TestCase):
    """Small pictures of the scenes with the density of their media from an image."""

    BUFFERS = ("Radiance", "Airlight", "Surface", "Transmittance", "LitLength")

    def compute(self, name, image=None, size=(40, 30)):
        reference = make_reference(name)
        reference.SetSize(size)
        if image:
            medium = reference.GetMedium(0)
            medium.SetRegionToUnbounded()  # the image bounds it
            medium.SetDensityImage(image)
            medium.SetDensityToImage()
        start = time.perf_counter()
        reference.Update()
        print(f"{name} {size}, {'image' if image else 'uniform'}: "
              f"{time.perf_counter() - start:.2f} s")
        return [get(reference, buffer) for buffer in self.BUFFERS]

    def box(self, name):
        bounds = make_reference(name).GetMedium(0).GetBounds()
        return [bounds[i:i + 2] for i in (0, 2, 4)]

    def test_constant(self):
        """A constant image is a uniform medium."""
        for name in ("S1_point_iso", "S3_ground_occluders", "S5_spot_slats", "S6_sun_window"):
            image = make_image(self.box(name), (7, 6, 9), lambda x, y, z: np.ones_like(x))
            for buffer, found, expected in zip(
                    self.BUFFERS, self.compute(name, image), self.compute(name)):
                floor = 1e-3 * np.percentile(expected, 99) + 1e-30
                errors = np.abs(found - expected) / np.maximum(np.abs(expected), floor)
                print(f"  {buffer}: median {np.median(errors):.1e}, largest {errors.max():.1e}")
                with self.subTest(scene=name, buffer=buffer):
                    self.assertLessEqual(np.median(errors), 1e-7)
                    self.assertLessEqual(errors.max(), 1e-5)

    def test_factor(self):
        """Half the density is half the coefficients."""
        name = "S3_ground_occluders"
        image = make_image(self.box(name), (3, 3, 3), lambda x, y, z: np.full_like(x, 0.5))
        found = self.compute(name, image)
        reference = make_reference(name)
        reference.SetSize(40, 30)
        medium = reference.GetMedium(0)
        medium.SetScattering(np.multiply(medium.GetScattering(), 0.5))
        medium.SetAbsorption(np.multiply(medium.GetAbsorption(), 0.5))
        reference.Update()
        for buffer, values in zip(self.BUFFERS, found):
            np.testing.assert_allclose(values, get(reference, buffer), 1e-5, 1e-9)

    def test_refined(self):
        """The same trilinear density on a finer grid, with twice the kinks, is the same."""
        name = "S5_spot_slats"

        def density(x, y, z):
            return 1 + 0.1 * x * y + 0.05 * z  # trilinear everywhere

        box = self.box(name)
        low = min(density(x, y, z) for x in box[0] for y in box[1] for z in box[2])
        coarse, fine = (make_image(box, size, lambda x, y, z: density(x, y, z) - low)
                        for size in ((3, 4, 5), (17, 13, 21)))
        for buffer, a, b in zip(
                self.BUFFERS, self.compute(name, coarse), self.compute(name, fine)):
            with self.subTest(buffer=buffer):
                self.assertGreater(b.max(), b.min())
                np.testing.assert_allclose(a, b, 1e-5, 1e-5 * b.max())


if __name__ == "__main__":
    unittest.main(argv=[__file__])
