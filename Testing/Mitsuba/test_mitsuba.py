# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkAirlightReference with all orders of light against Mitsuba 3, which shares nothing with it: the
difference of two pictures in their standard errors, pixel by pixel and in the mean.

    python3 -m pytest Testing/Mitsuba       (with airlight, vtk, numpy, mitsuba and pytest)
"""

import mitsuba
import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import airlight
from scenes import SCENES

SIDE = 20  # pixels
SEEDS = 24  # of Mitsuba's pictures, whose scatter is its standard error
mitsuba.set_variant("scalar_rgb")
Transform = mitsuba.ScalarTransform4f


def rgb(values):
    return {"type": "rgb", "value": list(values)}


def mitsuba_medium(medium):
    phase = {"type": "hg", "g": medium["g"]} if medium["g"] else {"type": "isotropic"}
    largest = max(medium["extinction"])  # colours are 1 at most
    middle, half = ((np.add if k else np.subtract)(medium["max"], medium["min"]) / 2
                    for k in (1, 0))
    return {"type": "cube", "to_world": Transform().translate(middle).scale(half),
            "bsdf": {"type": "null"},
            "interior": {"type": "homogeneous", "albedo": rgb(medium["albedo"]),
                         "sigma_t": rgb(np.array(medium["extinction"]) / largest),
                         "scale": largest, "phase": phase}}


def mitsuba_surface(surface):
    origin, first, second = (np.array(surface[name], float)
                             for name in ("origin", "first", "second"))
    a, b = (first - origin) / 2, (second - origin) / 2
    normal = np.cross(a, b) / np.linalg.norm(np.cross(a, b))
    matrix = np.eye(4)
    matrix[:3] = np.stack([a, b, normal, origin + a + b], axis=1)
    shape = {"type": "rectangle", "to_world": Transform(matrix),
             "bsdf": {"type": "twosided",
                      "nested": {"type": "diffuse", "reflectance": rgb(surface["albedo"])}}}
    if surface["shines"]:
        shape["emitter"] = {"type": "area", "radiance": rgb(3 * [surface["shines"]])}
    return shape


def mitsuba_lamp(lamp):
    if "position" in lamp:
        return {"type": "point", "position": list(lamp["position"]),
                "intensity": rgb(lamp["intensity"])}
    return {"type": "directional", "direction": list(lamp["towards"]),
            "irradiance": rgb(lamp["irradiance"])}


def by_mitsuba(scene, samples):
    """The mean of pictures and its standard error."""
    eye, aim, angle = scene["view"]
    parts = {"type": "scene", "integrator": {"type": "volpathmis", "max_depth": -1, "rr_depth": 20},
             "sensor": {"type": "perspective", "fov": angle, "fov_axis": "y",
                        "to_world": Transform().look_at(origin=list(map(float, eye)),
                                                        target=list(map(float, aim)), up=[0, 0, 1]),
                        "sampler": {"type": "independent", "sample_count": samples},
                        "film": {"type": "hdrfilm", "width": SIDE, "height": SIDE,
                                 "rfilter": {"type": "box"}, "pixel_format": "rgb",
                                 "component_format": "float32"}}}
    for kind, make in (("media", mitsuba_medium), ("surfaces", mitsuba_surface),
                       ("lamps", mitsuba_lamp)):
        for i, part in enumerate(scene[kind]):
            parts[f"{kind}{i}"] = make(part)
    loaded = mitsuba.load_dict(parts)
    pictures = np.array([np.array(mitsuba.render(loaded, spp=samples, seed=seed))[::-1]
                         for seed in range(SEEDS)], float)
    return pictures.mean(0), pictures.std(0, ddof=1) / np.sqrt(SEEDS)


def add_surface(renderer, surface):
    plane = vtkPlaneSource()
    plane.SetOrigin(surface["origin"])
    plane.SetPoint1(surface["first"])
    plane.SetPoint2(surface["second"])
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetDiffuseColor(surface["albedo"])
    actor.GetProperty().SetAmbientColor(1, 1, 1)
    actor.GetProperty().SetAmbient(surface["shines"])  # 1 at most
    renderer.AddActor(actor)


def by_airlight(scene, samples):
    renderer = vtkRenderer()
    renderer.SetBackground(0, 0, 0)
    camera = renderer.GetActiveCamera()
    eye, aim, angle = scene["view"]
    camera.SetPosition(eye)
    camera.SetFocalPoint(aim)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    camera.SetClippingRange(0.01, 100)
    for surface in scene["surfaces"]:
        add_surface(renderer, surface)
    for lamp in scene["lamps"]:
        light = vtkLight()
        if "position" in lamp:
            airlight.vtkAirlight.SetRadiantIntensity(light, lamp["intensity"])
            light.SetPosition(lamp["position"])
        else:
            airlight.vtkAirlight.SetIrradiance(light, lamp["irradiance"])
            light.SetPosition(-np.array(lamp["towards"], float))
            light.SetFocalPoint(0, 0, 0)
        renderer.AddLight(light)
    reference = airlight.vtkAirlightReference()
    reference.SetRenderer(renderer)
    for values in scene["media"]:
        medium = airlight.vtkParticipatingMedium()
        albedo, extinction = np.array(values["albedo"]), np.array(values["extinction"])
        medium.SetScattering(albedo * extinction)
        medium.SetAbsorption((1 - albedo) * extinction)
        medium.SetRegionToBox()
        medium.SetBounds(np.stack([values["min"], values["max"]], axis=1).ravel())
        if values["g"]:
            medium.SetPhaseFunctionToHenyeyGreenstein()
            medium.SetAnisotropy(values["g"])
        reference.AddMedium(medium)
    reference.SetSize(SIDE, SIDE)
    reference.SetScatteringOrders(0)
    reference.SetSamplesPerPixel(samples)
    reference.Update()
    points = reference.GetOutput().GetPointData()
    return [vtk_to_numpy(points.GetArray(name)).reshape(SIDE, SIDE, 3)
            for name in ("Radiance", "StandardError")]


@pytest.mark.parametrize("name", SCENES)
def test_agrees(name):
    ours, error = by_airlight(SCENES[name], 256)
    theirs, their_error = by_mitsuba(SCENES[name], 8)
    both = np.hypot(error, their_error)
    seen = both > 0
    chi2 = (((ours - theirs)[seen] / both[seen])**2).mean() * (SEEDS - 3) / (SEEDS - 1)
    mean = (ours - theirs).mean() / (np.sqrt((both**2).sum()) / both.size)
    noise = np.sqrt((both**2).sum()) / both.size / ours.mean()
    print(f"{name}: chi^2 per value {chi2:.3f}, mean {mean:+.2f} standard errors of {noise:.1%}")
    assert seen.mean() > 0.9
    assert 0.8 < chi2 < 1.2
    assert abs(mean) < 3.5
    assert noise < 0.02
