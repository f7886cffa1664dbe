# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Lamps and suns of plotter.airlight."""

from pathlib import Path

import numpy as np
import pytest
import pyvista as pv

import airlight

IES = Path(__file__).parents[1] / "Data" / "Photometry" / "streetlight.ies"


def intensity(light):
    rgb = [0, 0, 0]
    airlight.vtkAirlight.GetRadiantIntensity(light, rgb)
    return rgb


def test_lamp_is_a_light_of_the_plotter(plotter):
    lamp = plotter.airlight.add_lamp((0, 2.8, 0), 100)
    assert isinstance(lamp, pv.Light)
    assert lamp in plotter.renderer.lights
    assert intensity(lamp) == pytest.approx([100] * 3)
    assert lamp.position == (0, 2.8, 0)
    assert lamp.positional


def test_derived_lamp_gives_way(plotter):
    plotter.airlight.enable()
    plotter.screenshot()
    derived, = plotter.airlight.lamps
    lamp = plotter.airlight.add_lamp((0, 0, 3), 30)
    assert plotter.airlight.lamps == (lamp,)
    assert derived not in plotter.renderer.lights
    plotter.airlight.remove_lamp(lamp)
    plotter.render()
    assert len(plotter.airlight.lamps) == 1 and plotter.airlight.lamps[0] is not lamp


def test_light_of_pyvista_replaces_the_derived_lamp(plotter):
    plotter.airlight.enable()
    plotter.add_light(pv.Light(position=(2, 2, 2), positional=True))
    plotter.screenshot()
    assert plotter.airlight.lamps == ()


def test_lamp_is_derived_or_not_on_request(make_plotter):
    plotter = make_plotter()
    plotter.add_mesh(pv.Sphere())
    plotter.airlight.enable(lamp=False)
    plotter.screenshot()
    assert plotter.airlight.lamps == ()
    plotter.airlight.enable(lamp=True)
    plotter.airlight.add_sun((0, 0, -1))
    assert len(plotter.airlight.lamps) == 2


def test_spot_is_dark_beside_its_cone(dark):
    """The radiance of a plane below a spotlight of 30 degrees at a height of 1: W/sr over pi in
    the middle, nothing beyond tan(30 degrees) = 0.577."""
    dark.add_mesh(pv.Plane(i_size=4, j_size=4), color="white", ambient=0, diffuse=1, specular=0)
    lamp = dark.airlight.enable(visibility=1e9, ambient=0).add_lamp(
        (0, 0, 1), 2, target=(0, 0, 0), cone_angle=30)
    dark.camera_position = [(0, 0, 5), (0, 0, 0), (0, 1, 0)]
    dark.camera.parallel_projection = True
    dark.camera.parallel_scale = 1
    assert lamp.cone_angle == 30 and lamp.exponent == 0
    image = dark.airlight.buffer("Radiance")
    radiance = np.asarray(image["Radiance"]).reshape(120, 160, 3)
    assert radiance[60, 80] == pytest.approx([2 / np.pi] * 3, rel=2e-3)
    row = radiance[60, :, 0]
    x = (np.arange(160) + 0.5 - 80) / 60
    assert (row[abs(x) > 0.62] == 0).all()
    assert (row[abs(x) < 0.53] > 0.3).all()


def test_sun_lights_by_its_irradiance(dark):
    dark.add_mesh(pv.Plane(i_size=4, j_size=4), color="white", ambient=0, diffuse=1, specular=0)
    sun = dark.airlight.enable(visibility=1e9, ambient=0).add_sun((0, 0, -2), 1.5)
    dark.camera_position = [(0, 0, 2), (0, 0, 0), (0, 1, 0)]
    assert not sun.positional
    radiance = dark.airlight.buffer("Radiance")["Radiance"]
    assert np.median(radiance) == pytest.approx(1.5 / np.pi, rel=1e-3)


def test_white_is_exposure(dark):
    """With 100 cd/m^2 as white, the lamp has a hundredth of its intensity, and the buffer the
    luminance."""
    dark.add_mesh(pv.Plane(i_size=4, j_size=4), color="white", ambient=0, diffuse=1, specular=0)
    dark.airlight.enable(visibility=1e9, ambient=0, white=100)
    lamp = dark.airlight.add_lamp((0, 0, 1), 200, unit="cd")
    assert intensity(lamp) == pytest.approx([2] * 3)
    dark.camera_position = [(0, 0, 5), (0, 0, 0), (0, 1, 0)]
    luminance = dark.airlight.buffer("Radiance")["Radiance"]
    assert np.max(luminance) == pytest.approx(200 / np.pi, rel=2e-3)
    dark.airlight.enable(visibility=1e9, ambient=0, white=50)
    assert intensity(lamp) == pytest.approx([4] * 3)


def test_photometric_file(plotter):
    lamp = plotter.airlight.add_lamp((0, 0, 3), ies=IES)
    maximum = airlight.vtkAirlightLight.GetPhotometryMaximum(lamp)
    assert maximum > 0
    assert intensity(lamp) == pytest.approx([maximum] * 3)
    assert lamp.focal_point == (0, 0, 2)


def test_color_and_derived_intensity(plotter):
    lamp = plotter.airlight.add_lamp((0, 0, 2), color="red")
    # a white surface in the scene's centre has the radiance 1.1
    assert intensity(lamp) == pytest.approx([1.1 * np.pi * 4, 0, 0])


def test_units_do_not_mix(plotter):
    plotter.airlight.add_lamp((0, 0, 2), 3)
    with pytest.raises(ValueError, match="unit is 'cd'"):
        plotter.airlight.add_lamp((0, 0, 2), 3, unit="cd")
    with pytest.raises(ValueError, match="unit is 'lx'"):
        plotter.airlight.add_sun((0, 0, -1), 3, unit="lx")
    assert len(plotter.airlight.lamps) == 1


def test_switched_off_lamp_stays_off(plotter):
    lamp = plotter.airlight.add_lamp((0, 0, 2), 3)
    lamp.on = False
    plotter.airlight.enable()
    assert not lamp.on


def test_lights_of_the_camera_are_left_as_they_are(plotter):
    light = plotter.renderer.lights[1]
    airlight.vtkAirlightLight.SetScatters(light, True)
    plotter.airlight.enable()
    plotter.screenshot()
    assert airlight.vtkAirlightLight.GetScatters(light)
    assert plotter.airlight.lamps == ()  # that light scatters
