# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Buffers and accessors against Beer's law and vtkAirlight."""

import numpy as np
import pytest
import pyvista as pv

import airlight


@pytest.fixture
def medium():
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(0.1, 0.2, 0.3)
    medium.SetAbsorption(0.05, 0.0, 0.1)
    return medium


@pytest.fixture
def lamp():
    lamp = pv.Light(position=(2, 1, 0.5), positional=True)
    airlight.vtkAirlight.SetRadiantIntensity(lamp, (5, 4, 3))
    return lamp


def test_transmittance_of_lines(medium):
    """exp(-sigma d), of lines of 3, of 1 + 2 around a corner, and not of a vertex."""
    points = [(0.0, 0, 0), (3, 0, 0), (1, 0, 0), (1, 2, 0)]
    lines = pv.PolyData(points, verts=[1, 0], lines=[2, 0, 1, 3, 0, 2, 3])
    result = lines.airlight.transmittance(medium)
    expected = np.exp(-3 * np.array((0.15, 0.2, 0.4)))
    np.testing.assert_allclose(result["Transmittance"][1:], [expected, expected], rtol=1e-12)
    assert np.isnan(result["Transmittance"][0]).all()
    assert "Transmittance" not in lines.cell_data


def test_inscatter_of_lines(medium, lamp):
    lines = pv.line_segments_from_points([(0, 0, 0), (4, 0, 0), (0, 0, 0), (0, 0, 3)])
    result = lines.airlight.inscatter(medium, lamp)
    for cell, (direction, length) in enumerate((((1, 0, 0), 4), ((0, 0, 1), 3))):
        rgb = [0, 0, 0]
        airlight.vtkAirlight.Inscatter(medium, lamp, (0, 0, 0), direction, 0, length, rgb)
        assert result["Airlight"][cell] == pytest.approx(rgb, rel=1e-9)
    twice = lines.airlight.inscatter(medium, [lamp, lamp])
    np.testing.assert_allclose(twice["Airlight"], 2 * result["Airlight"])


def test_shadow_on_a_line(medium, lamp):
    """A wall between lamp and line: light reaches the line between x = 3 and its end alone."""
    line = pv.Line((0, 0, 0.5), (4, 0, 0.5))
    wall = pv.Rectangle([(-9, 0.5, -9), (2.5, 0.5, -9), (2.5, 0.5, 9)])
    parts = line.airlight.lit_intervals(medium, lamp, occluders=wall)
    assert parts.n_cells == 1
    assert parts["Start"][0] == pytest.approx(3)
    assert parts["Length"][0] == pytest.approx(1)
    rgb = [0, 0, 0]
    airlight.vtkAirlight.Inscatter(medium, lamp, (0, 0, 0.5), (1, 0, 0), 3, 4, rgb)
    assert line.airlight.inscatter(medium, lamp, occluders=[wall])["Airlight"][0] == \
        pytest.approx(rgb)


def test_probe(medium, lamp):
    image = pv.ImageData(dimensions=(2, 2, 2), origin=(1, 2, 3))
    result = image.airlight.probe(medium, lamp, viewpoint=(0, 0, 1))
    way = np.linalg.norm(image.points[0] - (0, 0, 1))
    assert result["Transmittance"][0] == pytest.approx(np.exp(-way * np.array((0.15, 0.2, 0.4))))
    r = np.linalg.norm(image.points[0] - lamp.position)
    assert result["DirectIrradiance"][0] == pytest.approx(
        np.array((5, 4, 3)) / r**2 * np.exp(-r * np.array((0.15, 0.2, 0.4))))
    assert isinstance(result, pv.ImageData)


@pytest.mark.parametrize("mesh", [
    pv.PolyData([(1.0, 2.0, 3.0)]), pv.ImageData(dimensions=(2, 2, 2)), pv.PointSet([(1.0, 2, 3)]),
    pv.ImageData(dimensions=(2, 2, 2)).cast_to_unstructured_grid(),
    pv.ImageData(dimensions=(2, 2, 2)).cast_to_structured_grid(),
    pv.ImageData(dimensions=(2, 2, 2)).cast_to_rectilinear_grid()], ids=lambda m: type(m).__name__)
def test_every_data_set_is_probed(mesh, medium, lamp):
    assert mesh.airlight.probe(medium, lamp)["Transmittance"].shape == (mesh.n_points, 3)


def test_shadow_volume_contains_the_shadow(lamp):
    """The shadow of a disc below a lamp at twice the height: a frustum of the volume
    h A (1 + 2 + 4)/3 with the base areas A and 4 A."""
    square = pv.Plane(i_size=1, j_size=1, center=(0, 0, 1), i_resolution=1, j_resolution=1)
    volume = square.airlight.shadow_volume((0, 0, 2), bounds=(-3, 3, -3, 3, 0, 3))
    closed = volume.triangulate().clean()
    assert closed.is_manifold
    assert closed.volume == pytest.approx((1 + 2 + 4) / 3)
    assert volume.bounds[:2] == pytest.approx((-1, 1))


def test_silhouette_of_a_ball():
    edges = pv.Sphere(theta_resolution=60, phi_resolution=60).airlight.silhouette((0, 0, 100))
    assert edges.n_lines == 60
    assert (edges["Weight"] == 2).all()
    np.testing.assert_allclose(np.linalg.norm(edges.points[:, :2], axis=1), 0.5, rtol=2e-3)


def test_shadow_volume_of_a_light_is_that_of_its_position(lamp):
    mesh = pv.Cube(center=(0, 0, -4))
    a, b = mesh.airlight.shadow_volume(lamp), mesh.airlight.shadow_volume(lamp.position)
    np.testing.assert_array_equal(a.points, b.points)


def test_accessor_takes_the_component(plotter):
    plotter.airlight.enable(visibility=3.912)
    line = pv.Line((0, 0, 0), (1, 0, 0))
    assert line.airlight.transmittance(plotter.airlight)["Transmittance"][0, 0] == \
        pytest.approx(np.exp(-1))


def rays(plotter):
    """The unit direction of each pixel's ray, bottom row first."""
    width, height = plotter.window_size
    camera = plotter.camera
    forward = np.array(camera.direction)
    right = np.cross(forward, camera.up)
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    half = np.tan(np.radians(camera.view_angle / 2))
    y, x = np.mgrid[:height, :width]
    x = (2 * (x + 0.5) / width - 1) * half * width / height
    y = (2 * (y + 0.5) / height - 1) * half
    directions = forward + x[..., None] * right + y[..., None] * up
    return directions / np.linalg.norm(directions, axis=-1, keepdims=True)


def test_radiance_of_the_sky_is_inscatter(dark):
    """Radiance, in an empty picture, is the airlight of the whole ray and the ambient part."""
    dark.add_mesh(pv.Sphere(radius=0.01, center=(0, 0, -50)))
    dark.airlight.enable(visibility=20, anisotropy=0, ambient=0.1)
    lamp = dark.airlight.add_lamp((1, 2, 0), (8, 6, 4))
    dark.camera_position = [(0, 0, 10), (0, 0, 0), (0, 1, 0)]
    radiance = np.asarray(dark.airlight.buffer("Radiance")["Radiance"]).reshape(120, 160, 3)
    directions = rays(dark)
    for row, column in ((5, 5), (60, 30), (100, 150), (80, 100)):
        rgb = [0, 0, 0]
        airlight.vtkAirlight.Inscatter(dark.airlight.medium, lamp, (0, 0, 10),
                                       directions[row, column].tolist(), 0, 1e6, rgb)
        assert radiance[row, column] == pytest.approx(np.array(rgb) + 0.1, rel=1e-4)


def test_transmittance_buffer_of_a_wall(dark):
    dark.add_mesh(pv.Plane(i_size=40, j_size=40))
    dark.airlight.enable(visibility=20)
    dark.camera_position = [(0, 0, 10), (0, 0, 0), (0, 1, 0)]
    depth = np.asarray(dark.airlight.buffer("Depth")["Depth"]).reshape(120, 160)
    np.testing.assert_allclose(depth, 10 / -rays(dark)[..., 2], rtol=1e-4)
    left = np.asarray(dark.airlight.buffer("Transmittance")["Transmittance"])[:, 1]
    np.testing.assert_allclose(left, np.exp(-3.912 / 20 * depth.ravel()), rtol=1e-4)


@pytest.mark.parametrize("name", ["Radiance", "Airlight", "Surface", "Transmittance", "Depth",
                                  "LitLength", "BoundaryCount", "ErrorBound", "Airlight:5"])
def test_buffers(plotter, name):
    plotter.airlight.enable(visibility=5).add_lamp((0, 0, 3), 10)  # after five lights of the kit
    image = plotter.airlight.buffer(name)
    assert isinstance(image, pv.ImageData)
    assert image.dimensions == (160, 120, 1)
    assert image.active_scalars_name == name
    assert np.isfinite(image[name]).all() and np.ptp(image[name]) > 0
    assert not plotter.airlight.render_pass.GetRecordBuffers()


def test_airlight_of_one_light(dark):
    dark.add_mesh(pv.Sphere())
    dark.airlight.enable(visibility=5, ambient=0)
    lamps = [dark.airlight.add_lamp((x, 0, 3), 10) for x in (-1, 1)]
    off = dark.airlight.add_lamp((0, 0, 3), 10)
    off.on = False
    parts = [dark.airlight.buffer("Airlight", light=lamp).active_scalars for lamp in lamps]
    total = dark.airlight.buffer("Airlight").active_scalars
    np.testing.assert_allclose(parts[0] + parts[1], total, rtol=1e-5, atol=1e-7)
    assert parts[0].max() > 0
    with pytest.raises(ValueError, match="that is on"):
        dark.airlight.buffer("Airlight", light=off)
    with pytest.raises(ValueError, match="'Depth' and light is given"):
        dark.airlight.buffer("Depth", light=lamps[0])
