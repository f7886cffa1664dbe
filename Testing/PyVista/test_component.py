# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""plotter.airlight: switching on and off, defaults, several subplots."""

import numpy as np
import pytest
import pyvista as pv

import airlight


def test_found_by_entry_point(plotter):
    assert type(plotter.airlight).__name__ == "AirlightComponent"
    assert plotter.airlight is plotter.airlight


def test_plot_is_unchanged_while_off(make_plotter):
    pictures = []
    for touch in (False, True):
        plotter = make_plotter()
        plotter.add_mesh(pv.Sphere())
        if touch:
            assert not plotter.airlight.enabled
        pictures.append(plotter.screenshot())
    np.testing.assert_array_equal(*pictures)


def test_three_lines_make_fog(make_plotter):
    """The ball is paler than without fog, the fog is brighter towards the lamp, nothing is black,
    and little is clipped."""
    plotter = make_plotter()
    plotter.add_mesh(pv.Sphere(), color="red")
    clear = plotter.screenshot()
    plotter.airlight.enable()
    foggy = plotter.screenshot()
    ball = (slice(50, 70), slice(70, 90))
    saturation = [np.ptp(picture[ball].astype(int), axis=-1).mean() for picture in (clear, foggy)]
    assert saturation[1] < 0.7 * saturation[0]
    assert saturation[1] > 0.15 * saturation[0]  # but it is seen
    assert foggy[:20, :60].mean() > foggy[-20:, -60:].mean() + 20
    assert foggy.min() > 30
    assert (foggy == 255).all(axis=-1).mean() < 0.15


@pytest.mark.parametrize("background", ["black", "white", "slategray"])
def test_defaults_are_exposed_well(make_plotter, background):
    plotter = make_plotter()
    plotter.add_mesh(pv.Sphere(), color="tan")
    plotter.background_color = background
    plotter.airlight.enable()
    picture = plotter.screenshot()
    ball = picture[45:75, 65:95]
    assert 40 < ball.mean() < 225
    assert (picture == 255).all(axis=-1).mean() < 0.15


def test_chains(plotter):
    assert plotter.airlight.enable().disable() is plotter.airlight
    assert not plotter.airlight.enabled


def test_enable_and_disable(plotter):
    plain = plotter.screenshot()
    lights = len(plotter.renderer.lights)
    samples = plotter.render_window.GetMultiSamples()
    plotter.airlight.enable()
    assert plotter.airlight.enabled
    assert plotter.renderer.GetPass() is plotter.airlight.render_pass
    assert (plotter.screenshot() != plain).any()
    plotter.airlight.disable()
    assert plotter.renderer.GetPass() is None
    assert len(plotter.renderer.lights) == lights
    assert plotter.render_window.GetMultiSamples() == samples
    np.testing.assert_array_equal(plotter.screenshot(), plain)


def test_visibility_is_derived_from_the_view(plotter):
    """The far end of the scene keeps 30 % of its light."""
    plotter.airlight.enable()
    plotter.screenshot()
    far = plotter.camera.distance + plotter.renderer.length / 2
    extinction = plotter.airlight.medium.GetExtinction()[0]
    assert np.exp(-extinction * far) == pytest.approx(0.3, rel=1e-3)
    assert plotter.airlight.medium.GetAnisotropy() == 0.5


def test_derived_values_follow_a_larger_scene(plotter):
    plotter.airlight.enable()
    plotter.screenshot()
    before = plotter.airlight.medium.GetVisibility()
    plotter.add_mesh(pv.Sphere(radius=20))
    plotter.render()
    assert plotter.airlight.medium.GetVisibility() > 5 * before
    plotter.add_mesh(pv.Sphere(radius=0.1, center=(20.5, 0, 0)))
    after = plotter.airlight.medium.GetVisibility()
    plotter.render()
    assert plotter.airlight.medium.GetVisibility() == after


def test_enabled_before_meshes_are_added(make_plotter):
    plotter = make_plotter()
    plotter.airlight.enable()
    plotter.add_mesh(pv.Sphere())
    plotter.screenshot()
    assert 1 < plotter.airlight.medium.GetVisibility() < 100


def test_lamp_of_a_room_is_inside(make_plotter):
    plotter = make_plotter()
    plotter.add_mesh(pv.Box((0, 6, 0, 4, 0, 3)), color="white")
    plotter.camera_position = [(5, 3, 1.6), (1, 1, 1.2), (0, 0, 1)]
    plotter.airlight.enable()
    plotter.screenshot()
    lamp, = plotter.airlight.lamps
    np.testing.assert_allclose(lamp.position, (3, 2, 2.55))


def test_camera_may_be_placed_after_enable(make_plotter):
    found = []
    for enable_first in (True, False):
        plotter = make_plotter()
        plotter.add_mesh(pv.Box((0, 6, 0, 4, 0, 3)), color="white")
        if enable_first:
            plotter.airlight.enable()
            assert plotter.airlight.medium.GetVisibility() > 20  # as seen from afar
        plotter.camera_position = [(5, 3, 1.6), (1, 1, 1.2), (0, 0, 1)]
        if not enable_first:
            plotter.airlight.enable()
        plotter.screenshot()
        found.append((plotter.airlight.medium.GetVisibility(),
                      *plotter.airlight.lamps[0].position))
    assert found[0] == pytest.approx(found[1])  # rounding of scaled coefficients


def test_frames_without_changes_change_nothing(plotter):
    """Otherwise caches would be filled again in each frame."""
    plotter.airlight.enable().add_lamp((0, 0, 3))
    plotter.screenshot()
    plotter.render()
    times = [each.GetMTime() for each in (plotter.airlight.medium, plotter.airlight.render_pass,
                                          *plotter.renderer.lights)]
    plotter.render()
    assert times == [each.GetMTime() for each in (
        plotter.airlight.medium, plotter.airlight.render_pass, *plotter.renderer.lights)]


def test_settings_reach_medium_and_pass(plotter):
    plotter.airlight.enable(visibility=15, anisotropy=0.6, albedo=0.25, ambient="red",
                            region=(-1, 1, -2, 2, -3, 3), shadows="planes")
    medium = plotter.airlight.medium
    assert medium.GetVisibility() == pytest.approx(15)
    assert medium.GetAnisotropy() == 0.6
    assert medium.GetAlbedo() == pytest.approx((0.25,) * 3)
    assert medium.GetAmbientRadiance() == (1, 0, 0)
    assert medium.GetBounds() == (-1, 1, -2, 2, -3, 3)
    assert medium.GetRegion() == airlight.vtkParticipatingMedium.BOX
    render_pass = plotter.airlight.render_pass
    assert render_pass.GetShadowTechnique() == airlight.vtkAirlightPass.SHADOW_PLANES
    plotter.airlight.enable(shadows=False)
    assert render_pass.GetShadowTechnique() == airlight.vtkAirlightPass.NONE
    assert plotter.airlight.medium.GetRegion() == airlight.vtkParticipatingMedium.UNBOUNDED


def test_region_is_a_mesh_and_density_an_image(plotter):
    plotter.airlight.enable(region=pv.Sphere(radius=2))
    assert plotter.airlight.medium.GetRegion() == airlight.vtkParticipatingMedium.SURFACE
    image = pv.ImageData(dimensions=(3, 3, 3))
    image["soot"] = np.linspace(0, 1, 27)
    plotter.airlight.enable(visibility=3, density=image)
    assert plotter.airlight.medium.GetDensityImage() is image
    rgb = [0, 0, 0]
    airlight.vtkAirlight.Transmittance(plotter.airlight.medium, (0, 0, 0), (2, 0, 0), rgb)
    assert rgb[0] == pytest.approx(np.exp(-3.912 / 3 * 2 * (1 / 26)))


def test_arrays_of_the_density_colour_it(plotter):
    """An albedo and factors that are the same everywhere are as those of the medium."""
    image = pv.ImageData(dimensions=(3, 3, 3), spacing=(2, 2, 2), origin=(-2, -2, -2))
    image["soot"] = np.linspace(0.5, 1, 27)
    image["steam"] = np.tile([0.2, 0.5, 0.8], (27, 1))
    image["heat"] = np.full(27, 0.5)
    image.set_active_scalars("soot")

    def radiance():
        return np.array(plotter.airlight.buffer().point_data["Radiance"])

    common = {"visibility": 3, "density": image, "ambient": 0.1, "white": 2}
    plotter.airlight.enable(**common)
    white = radiance()
    plotter.airlight.enable(**common, albedo=(0.2, 0.5, 0.8), emission=(0.1, 0.2, 0.3))
    expected = radiance()
    plotter.airlight.enable(**common, albedo_array="steam", emission=(0.2, 0.4, 0.6),
                            emission_array="heat")
    found = radiance()
    assert np.abs(found - expected).max() < 1e-4 * expected.max()
    assert np.abs(white - expected).max() > 0.1 * expected.max()
    state = plotter.airlight.get_state()
    plotter.airlight.enable(**common)
    assert np.abs(radiance() - white).max() < 1e-6 * white.max()
    plotter.airlight.set_state(state)
    assert np.abs(radiance() - found).max() < 1e-6 * found.max()


def test_height_fog_begins_at_the_bottom(plotter):
    plotter.airlight.enable(scale_height=0.2)
    plotter.screenshot()
    assert plotter.airlight.medium.GetReferenceHeight() == pytest.approx(-0.5)


def test_own_medium(plotter):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(0.1, 0.2, 0.3)
    plotter.airlight.enable(medium=medium)
    plotter.screenshot()
    assert plotter.airlight.medium is medium
    assert medium.GetScattering() == (0.1, 0.2, 0.3)
    assert plotter.airlight.render_pass.GetMedium(0) is medium


def test_describe(plotter):
    assert plotter.airlight.describe() == "Airlight(off)"
    plotter.airlight.enable(visibility=15)
    assert plotter.airlight.describe() == (
        "Airlight(visibility=15, anisotropy=0.5 (derived), shadows=automatic, 1 lamp (derived))")


def test_subplots_are_apart(make_plotter):
    plotter = make_plotter(shape=(1, 2), window_size=(320, 120))
    for column, visibility in enumerate((None, 3)):
        plotter.subplot(0, column)
        plotter.add_mesh(pv.Sphere(), color="red")
        if visibility:
            plotter.airlight.enable(visibility=visibility)
    picture = plotter.screenshot()
    plain = make_plotter(shape=(1, 2), window_size=(320, 120))
    for column in (0, 1):
        plain.subplot(0, column)
        plain.add_mesh(pv.Sphere(), color="red")
    expected = plain.screenshot()
    left, right = picture[:, :155].astype(int), picture[:, 165:].astype(int)
    inside = expected[:, :155].astype(int)
    # multisampling is off in a window with a medium: edges of the other subplot may differ
    assert (abs(left - inside).max(axis=-1) > 8).mean() < 0.02
    assert abs(right - expected[:, 165:]).mean() > 20
    plotter.subplot(0, 0)
    assert not plotter.airlight.enabled
    plotter.subplot(0, 1)
    assert plotter.airlight.enabled


def test_buffer_of_each_subplot(make_plotter):
    plotter = make_plotter(shape=(1, 2), window_size=(320, 120))
    for column in (0, 1):
        plotter.subplot(0, column)
        plotter.add_mesh(pv.Sphere())
        plotter.airlight.enable(visibility=(3, 300)[column])
    clear = []
    for column in (0, 1):
        plotter.subplot(0, column)
        image = plotter.airlight.buffer("Transmittance")
        assert image.dimensions == (160, 120, 1)
        clear.append(np.max(image["Transmittance"]))
    assert clear[0] < 0.1 < clear[1]


def test_all_corners_of_a_frame_of_a_second_plotter(make_plotter):
    """Plotters do not share anything."""
    first, second = make_plotter(), make_plotter()
    for each in (first, second):
        each.add_mesh(pv.Sphere())
    first.airlight.enable()
    assert not second.airlight.enabled
    assert first.airlight.medium is not second.airlight.medium


def test_display(plotter):
    """Radiances above white fade to white, and edges are smooth."""
    plotter.add_mesh(pv.Sphere())
    plotter.airlight.enable(visibility=6)
    plotter.airlight.add_lamp((0, 0, 1), 40, radius=0.1)
    render_pass = plotter.airlight.render_pass
    neutral = plotter.screenshot(return_img=True)
    assert render_pass.GetToneMapping() == airlight.vtkAirlightPass.NEUTRAL_PBR
    plotter.airlight.enable(visibility=6, tone_mapping="clamp")
    clamped = plotter.screenshot(return_img=True)
    assert (neutral == 255).mean() < 0.5 * (clamped == 255).mean()
    plotter.airlight.enable(visibility=6, color_space="srgb", frames=8)
    encoded = plotter.screenshot(return_img=True)
    assert render_pass.GetSubpixelFrames() == 8
    assert encoded.mean() > neutral.mean()
    for clear in ({"visibility": float("inf")}, {"medium": airlight.vtkParticipatingMedium()}):
        plotter.airlight.enable(**clear)
        assert render_pass.GetToneMapping() == airlight.vtkAirlightPass.CLAMP
    plotter.airlight.medium.SetVisibility(3)
    render_pass.SetOutputColorSpaceToSRGB()  # of the user, which stays
    plotter.render()
    assert render_pass.GetOutputColorSpace() == airlight.vtkAirlightPass.SRGB
    assert render_pass.GetToneMapping() == airlight.vtkAirlightPass.NEUTRAL_PBR
    plotter.airlight.enable(visibility=6)
    plotter.airlight.add_sun((0, 0, -1), angular_diameter=0.53)
    state = plotter.airlight.get_state()
    assert state["lamps"][0]["radius"] == 0.1
    plotter.airlight.set_state(state)
    assert airlight.vtkAirlightLight.GetRadius(plotter.airlight.lamps[0]) == 0.1
    assert airlight.vtkAirlightLight.GetAngularDiameter(plotter.airlight.lamps[1]) == 0.53
    assert state["lamps"][1]["visible"] is False
    state["lamps"][0]["radius"] = -1
    with pytest.raises(ValueError, match="radius is -1.0"):
        plotter.airlight.set_state(state)


def test_visible_lamps(dark):
    """A lamp shows its intensity over its area, a sun its irradiance over its solid angle."""
    dark.add_mesh(pv.Sphere(radius=0.01, center=(5, 5, 0)))
    dark.camera_position = [(0, 0, 6), (0, 0, 0), (0, 1, 0)]
    dark.airlight.enable(visibility=float("inf"), lamp=False)

    def brightest():
        return dark.airlight.buffer("Radiance").active_scalars[:, 0].max()
    lamp = dark.airlight.add_lamp((0, 0, 0), 3, radius=0.5, visible=True)
    assert brightest() == pytest.approx(3 / (np.pi * 0.25), rel=1e-4)
    state = dark.airlight.get_state()
    dark.airlight.remove_lamp(lamp)
    assert brightest() < 1
    dark.airlight.set_state(state)
    assert brightest() == pytest.approx(3 / (np.pi * 0.25), rel=1e-4)
    dark.airlight.remove_lamp(dark.airlight.lamps[0])
    dark.airlight.add_sun((0, 0, 1), 3, angular_diameter=6, visible=True)
    disc = 2 * np.pi * (1 - np.cos(np.radians(3)))
    assert brightest() == pytest.approx(3 / disc, rel=1e-4)
    with pytest.raises(ValueError, match="visible is True"):
        dark.airlight.add_sun((0, 0, 1), visible=True)
    with pytest.raises(TypeError, match="visible is 'yes'"):
        dark.airlight.add_lamp((0, 0, 1), radius=1, visible="yes")


def test_progressive(plotter):
    """A window on the screen is refined; pictures off screen and buffers are complete at once."""
    plotter.airlight.enable(visibility=6, frames=4, progressive=True)
    render_pass = plotter.airlight.render_pass
    complete = plotter.screenshot(return_img=True)
    assert render_pass.GetAccumulatedFrames() == 4
    assert not render_pass.GetProgressiveRefinement()
    window = plotter.render_window
    window.SetOffScreenRendering(False)  # as if it were on a screen
    counts = []
    for _ in range(5):
        plotter.render()
        counts.append(render_pass.GetAccumulatedFrames())
    assert counts == [1, 2, 3, 4, 4]
    np.testing.assert_array_equal(plotter.screenshot(return_img=True), complete)
    plotter.airlight.buffer()
    assert render_pass.GetAccumulatedFrames() == 4
    plotter.render()
    assert render_pass.GetAccumulatedFrames() == 1  # as recording has changed
    plotter.airlight.set_state(plotter.airlight.get_state())
    plotter.airlight.enable(visibility=6, frames=4)
    assert not render_pass.GetProgressiveRefinement()
    with pytest.raises(TypeError, match="progressive is 'yes'"):
        plotter.airlight.enable(progressive="yes")
