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
from vtkmodules.util.numpy_support import vtk_to_numpy
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
                    self.assertLessEqual(scores["median"], 1e-4, scores)
                    self.assertLessEqual(scores["p99"], 1e-3, scores)
                    # The files hold single precision; nothing leaks into what must be black.
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


if __name__ == "__main__":
    unittest.main(argv=[__file__])
