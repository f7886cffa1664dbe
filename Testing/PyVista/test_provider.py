# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The provider for pyvista-render-passes, driven by a stand-in for that package's component.

The package needs Python 3.12 and VTK 9.7 and may not be there. The stand-in follows what its
documentation says of components and providers.
"""

from importlib.metadata import entry_points

import numpy as np
import pytest
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkLightsPass, vtkOpaquePass, vtkRenderPassCollection, vtkSequencePass, vtkTranslucentPass,
    vtkVolumetricPass)


class Component:
    """Builds a chain of one flat base and the providers of stage base."""

    def __init__(self, plotter, renderer):
        self.renderer = renderer
        self.settings = {"ssao": False, "edl": False, "shadows": False, "msaa": False}
        self.providers = {}
        self.built = []
        self.is_dirty = False
        renderer.AddObserver("StartEvent", lambda *_: self.is_dirty and self.apply())

    def add(self, provider):
        assert provider.veto(self.settings) is None
        self.providers[provider.name] = provider
        provider.bind(self.invalidate)
        self.invalidate()

    def remove(self, name):
        self.providers.pop(name).bind(None)
        self.invalidate()

    def invalidate(self):
        self.is_dirty = True

    def get_state(self):
        return dict(self.settings)

    def enable(self, name):
        for provider in self.providers.values():
            reason = provider.veto({**self.settings, name: True})
            if reason:
                raise ValueError(reason)
        self.settings[name] = True

    def apply(self):
        passes = vtkRenderPassCollection()
        for each in (vtkLightsPass, vtkOpaquePass, vtkTranslucentPass, vtkVolumetricPass):
            passes.AddItem(each())
        base = vtkSequencePass()
        base.SetPasses(passes)
        self.built = []
        for provider in self.providers.values():
            built = provider.build_pass("base", self.renderer, None, base)
            if built is not None:
                self.built.append(built)
                base = built
        self.renderer.SetPass(base if self.built else None)
        self.is_dirty = False


class Components:
    """What plotter.render_passes is."""

    def __init__(self, *components):
        self.components = components


@pytest.fixture
def component(plotter):
    component = Component(plotter, plotter.renderer)
    plotter.__dict__["render_passes"] = Components(component)
    entry, = entry_points(group="pyvista_render_passes.providers", name="airlight")
    component.add(entry.load()())
    yield component
    plotter.renderer.SetPass(None)
    for each in component.built:
        each.ReleaseGraphicsResources(plotter.render_window)
    del plotter.__dict__["render_passes"]


def test_protocol(component):
    provider = component.providers["airlight"]
    assert provider.stages == ("base",)
    assert provider.default_state() == provider.get_state() == {}
    provider.set_state({})


def test_nothing_while_off(plotter, component):
    plotter.screenshot()
    assert component.built == []
    assert plotter.renderer.GetPass() is None
    component.enable("ssao")


def test_wraps_the_base(plotter, component, make_plotter):
    """The picture is that of the component without a chain."""
    import pyvista as pv
    plotter.airlight.enable(visibility=4, anti_aliasing=False)
    picture = plotter.screenshot()
    assert plotter.renderer.GetPass() is component.built[0]
    assert plotter.airlight.render_pass is component.built[0]
    alone = make_plotter()
    alone.add_mesh(pv.Sphere())
    alone.airlight.enable(visibility=4, anti_aliasing=False)
    assert abs(picture.astype(int) - alone.screenshot()).max() <= 1
    assert np.ptp(plotter.airlight.buffer("Transmittance").active_scalars) > 0


def test_every_build_is_a_new_pass(plotter, component):
    plotter.airlight.enable(visibility=4, shadows="planes")
    plotter.screenshot()
    first = component.built[0]
    first.SetMemoryLimit(77)
    plotter.render_window.SetMultiSamples(4)
    component.invalidate()
    plotter.render()
    second = component.built[0]
    assert second is not first and plotter.airlight.render_pass is second
    assert second.GetMemoryLimit() == 77
    assert second.GetMultisampling()
    assert second.GetShadowTechnique() == first.GetShadowTechnique()
    assert second.GetMedium(0) is plotter.airlight.medium
    first.ReleaseGraphicsResources(plotter.render_window)


@pytest.mark.parametrize("name", ["ssao", "edl", "shadows"])
def test_veto(plotter, component, name):
    plotter.airlight.enable()
    with pytest.raises(ValueError, match="medium|shadows"):
        component.enable(name)
    component.enable("msaa")
    plotter.airlight.disable()
    component.enable(name)
    with pytest.raises(ValueError, match="plotter.airlight cannot be enabled"):
        plotter.airlight.enable()
    assert not plotter.airlight.enabled


def test_disable_and_remove(plotter, component):
    plotter.airlight.enable()
    plotter.screenshot()
    plotter.airlight.disable()
    plotter.render()
    assert component.built == [] and plotter.renderer.GetPass() is None
    plotter.airlight.enable()
    plotter.render()
    component.remove("airlight")
    plotter.render()
    plotter.render()
    assert plotter.renderer.GetPass() is plotter.airlight.render_pass
