# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The medium with PyVista's effects, which replace the renderer's pass, in any order."""

import math
import warnings

import numpy as np
import pytest
import pyvista as pv
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkOverlayPass, vtkRenderPassCollection, vtkRenderStepsPass, vtkSequencePass,
    vtkSobelGradientMagnitudePass, vtkToneMappingPass)

EFFECTS = {
    "ssaa": (lambda p: p.enable_anti_aliasing("ssaa"), lambda p: p.disable_anti_aliasing()),
    "msaa": (lambda p: p.enable_anti_aliasing("msaa"), lambda p: p.disable_anti_aliasing()),
    "blur": (lambda p: p.add_blurring(), lambda p: p.remove_blurring()),
    "ssao": (lambda p: p.enable_ssao(radius=0.3), lambda p: p.disable_ssao()),
    "edl": (lambda p: p.enable_eye_dome_lighting(), lambda p: p.disable_eye_dome_lighting()),
    "peeling": (lambda p: p.enable_depth_peeling(), lambda p: p.disable_depth_peeling()),
    "lines": (lambda p: p.enable_hidden_line_removal(), lambda p: p.disable_hidden_line_removal()),
}


def chain(plotter):
    """The names of the renderer's passes, outermost first."""
    step, names = plotter.renderer.GetPass(), []
    while step is not None:
        names.append(step.GetClassName())
        step = step.GetDelegatePass() if hasattr(step, "GetDelegatePass") else None
    return names


@pytest.mark.parametrize("name", EFFECTS)
def test_effect_after_enable(plotter, name):
    switch_on, switch_off = EFFECTS[name]
    plotter.airlight.enable(ambient=0.5, visibility=5)
    before = plotter.screenshot()
    switch_on(plotter)
    plotter.render()
    assert "vtkAirlightPass" in chain(plotter)
    during = plotter.screenshot().astype(int)
    assert abs(during - before).mean() < 12  # still in fog
    switch_off(plotter)
    plotter.render()
    assert chain(plotter) == ["vtkAirlightPass"]
    after = plotter.screenshot().astype(int)
    assert abs(after - before).mean() < 1


@pytest.mark.parametrize("name", EFFECTS)
def test_effect_before_enable(plotter, name):
    EFFECTS[name][0](plotter)
    plain = plotter.screenshot()
    passes = chain(plotter)
    plotter.airlight.enable(ambient=0.5, visibility=5)
    assert abs(plotter.screenshot().astype(int) - plain).mean() > 20
    plotter.airlight.disable()
    assert chain(plotter) == passes
    assert abs(plotter.screenshot().astype(int) - plain).mean() < 1


def edge_error(picture, exact):
    """The root mean square of the differences."""
    return np.sqrt(np.mean((picture.astype(float) - exact) ** 2))


@pytest.mark.parametrize("way", ["argument", "effect"])
def test_multisampling(make_plotter, way):
    """Half of the error of a single frame, as the argument or PyVista's own call asks for it."""
    def screenshot(asked=None, **options):
        plotter = make_plotter()
        plotter.add_mesh(pv.Cube())
        plotter.airlight.enable(visibility=5, **options)
        if asked:
            plotter.enable_anti_aliasing(asked)
        picture = plotter.screenshot()
        assert plotter.airlight.render_pass.GetMultisampling() == bool(
            asked or options.get("anti_aliasing"))
        assert not (asked and plotter.renderer.GetUseFXAA())
        return picture
    exact = screenshot(frames=64, anti_aliasing=False)
    plain = screenshot(anti_aliasing=False)
    smooth = screenshot(anti_aliasing="msaa") if way == "argument" else screenshot("msaa")
    assert edge_error(smooth, exact) < 0.6 * edge_error(plain, exact)


def test_multisampling_leaves_the_window_as_it_was(make_plotter):
    for samples in (8, 0):
        plotter = make_plotter(shape=(1, 2))
        plotter.enable_anti_aliasing("msaa", multi_samples=samples)
        window = plotter.render_window
        plotter.airlight.enable()
        assert window.GetMultiSamples() == 0
        plotter.subplot(0, 1)
        plotter.airlight.enable(anti_aliasing="msaa")
        assert window.GetMultiSamples() == (samples or 4)
        plotter.airlight.enable()
        assert window.GetMultiSamples() == 0
        plotter.airlight.enable(anti_aliasing="msaa")
        plotter.airlight.disable()
        assert window.GetMultiSamples() == 0
        plotter.subplot(0, 0)
        plotter.airlight.disable()
        assert window.GetMultiSamples() == samples


def test_depth_of_field(plotter):
    """VTK's depth of field draws its first frame black, with and without a medium."""
    plotter.airlight.enable()
    before = plotter.screenshot()
    plotter.enable_depth_of_field()
    for _ in range(3):
        plotter.render()
    assert chain(plotter) == ["vtkDepthOfFieldPass", "vtkAirlightPass"]
    assert abs(plotter.screenshot().astype(int) - before).mean() < 12


def test_order_of_the_chain(plotter):
    plotter.airlight.enable()
    plotter.enable_eye_dome_lighting()
    plotter.enable_ssao(radius=0.3)
    plotter.enable_anti_aliasing("ssaa")
    plotter.screenshot()
    assert chain(plotter) == ["vtkSSAAPass", "vtkAirlightPass", "vtkEDLShading", "vtkSSAOPass",
                              "vtkRenderStepsPass"]


def test_ssao_below_the_medium_is_that_of_pyvista(make_plotter):
    """A corner in clear air."""
    pictures = []
    for medium in (False, True):
        plotter = make_plotter()
        plotter.add_mesh(pv.Cube())
        plotter.add_mesh(pv.Plane(center=(0, 0, -0.5), i_size=4, j_size=4))
        plotter.enable_anti_aliasing("msaa", multi_samples=0)
        plotter.enable_ssao(radius=0.5)
        if medium:
            plotter.airlight.enable(visibility=math.inf, lamp=False, shadows=False,
                                    anti_aliasing=False)
        pictures.append(plotter.screenshot().astype(int))
    assert abs(pictures[0] - pictures[1]).max() <= 1


def test_shadow_maps_are_left_out_with_a_reason(plotter):
    plotter.airlight.enable()
    before = plotter.screenshot()
    plotter.enable_shadows()
    with pytest.warns(UserWarning, match="shadow maps .* are left out"):
        plotter.render()
    np.testing.assert_array_equal(plotter.screenshot(), before)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plotter.render()  # warned once
    plotter.disable_shadows()
    plotter.render()
    assert chain(plotter) == ["vtkAirlightPass"]


def test_unknown_pass_is_left_alone_with_a_reason(plotter):
    plotter.airlight.enable()
    foreign = vtkSobelGradientMagnitudePass()
    foreign.SetDelegatePass(vtkRenderStepsPass())
    plotter.screenshot()
    plotter.renderer.SetPass(foreign)
    with pytest.warns(UserWarning, match="vtkSobelGradientMagnitudePass.*without the medium"):
        plotter.render()
    assert plotter.renderer.GetPass() is foreign
    assert "not drawn" in plotter.airlight.describe()
    with pytest.raises(RuntimeError, match="vtkSobelGradientMagnitudePass"):
        plotter.airlight.buffer()
    plotter.renderer.SetPass(None)
    plotter.render()
    assert chain(plotter) == ["vtkAirlightPass"]
    assert "not drawn" not in plotter.airlight.describe()
    foreign.ReleaseGraphicsResources(plotter.render_window)


def test_chain_of_the_user_is_kept(plotter):
    plotter.airlight.enable(anti_aliasing=False)
    plotter.airlight.render_pass.EncodedOutputOn()
    plotter.airlight.render_pass.AnnotationsOff()
    tone = vtkToneMappingPass()
    tone.SetDelegatePass(plotter.airlight.render_pass)
    passes = vtkRenderPassCollection()
    passes.AddItem(tone)
    passes.AddItem(vtkOverlayPass())
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    plotter.renderer.SetPass(sequence)
    plotter.screenshot()
    assert plotter.renderer.GetPass() is sequence
    sequence.ReleaseGraphicsResources(plotter.render_window)


def test_picking_is_that_of_pyvista(make_plotter):
    """Hardware selection sees the meshes through the fog."""
    plotter = make_plotter()
    actor = plotter.add_mesh(pv.Sphere())
    plotter.airlight.enable(visibility=0.1)
    plotter.screenshot()
    from vtkmodules.vtkRenderingCore import vtkHardwareSelector, vtkProp
    selector = vtkHardwareSelector()
    selector.SetRenderer(plotter.renderer)
    selector.SetArea(75, 55, 85, 65)
    selection = selector.Select()
    assert selection.GetNumberOfNodes() == 1
    assert selection.GetNode(0).GetProperties().Get(vtkHardwareSelector.PROP() if hasattr(
        vtkHardwareSelector, "PROP") else selection.GetNode(0).PROP()) is actor
    assert isinstance(actor, vtkProp)
    plotter.render()
    assert plotter.airlight.enabled
