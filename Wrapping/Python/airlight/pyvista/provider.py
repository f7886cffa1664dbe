# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Airlight in the pass chain of the package pyvista-render-passes.

That package builds one chain of passes for each subplot, from providers that it finds by the entry
point ``pyvista_render_passes.providers``. The provider wraps the scene's base into a pass of
Airlight where plotter.airlight is enabled, with its settings.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any
import weakref

from airlight import vtkAirlightPass

# The subplots of plotter.airlight by their renderers.
_SUBPLOTS: weakref.WeakKeyDictionary = weakref.WeakKeyDictionary()

# Settings of the chain that the medium does not compose with, and why. The chain puts them above
# the base, whose surfaces they then no longer see.
REFUSED = {
    "ssao": "SSAO needs the surfaces of the pass below it, and that one is the medium: use "
            "plotter.enable_ssao(), which Airlight puts below the medium",
    "edl": "eye-dome lighting above the medium darkens the fog by the depths behind it: use "
           "plotter.enable_eye_dome_lighting(), which Airlight puts below the medium",
    "shadows": "VTK's shadow maps replace the opaque stage, and Airlight casts the shadows on "
               "surfaces itself: leave them off",
}

# Properties that a new pass takes over from the one before.
PROPERTIES = (
    "ShadowTechnique", "ShadowMapResolution", "MaximumBoundariesPerPixel", "NumberOfSteps",
    "SurfaceShadows", "TranslucentShadows", "VolumeShadows", "ScatteredSurfaceLight",
    "LinearInput", "Exposure", "AutomaticExposure", "ToneMapping", "OutputColorSpace", "Dithering",
    "Annotations", "DebugView", "LightRadius", "MemoryLimit", "RecordBuffers", "SubpixelFrames",
    "Multisampling", "ProgressiveRefinement", "UseEnvironmentTexture",
)


def register(renderer: Any, subplot: Any) -> None:
    """Let providers find the subplot of a renderer."""
    _SUBPLOTS[renderer] = subplot


def _find_component(plotter: Any, renderer: Any) -> Any:
    """The component of pyvista-render-passes for a renderer that has our provider, or None."""
    components = plotter.__dict__.get("render_passes")  # not made here
    for component in getattr(components, "components", ()):
        if component.renderer is renderer and AirlightProvider.name in component.providers:
            return component
    return None


def check(plotter: Any, renderer: Any) -> None:
    """Raise ValueError if the chain of a renderer has effects that a medium refuses."""
    component = _find_component(plotter, renderer)
    reason = _reason(component.get_state()) if component is not None else None
    if reason:
        raise ValueError(f"plotter.airlight cannot be enabled: {reason}.")


def invalidate(plotter: Any, renderer: Any) -> None:
    """Let the chain of a renderer, if there is one, be built again."""
    component = _find_component(plotter, renderer)
    if component is not None:
        component.invalidate()


def _reason(settings: Mapping[str, Any]) -> str | None:
    return next((reason for name, reason in REFUSED.items() if settings.get(name)), None)


class AirlightProvider:
    """Wraps the base of a pass chain into the medium of plotter.airlight.

    The settings are those of plotter.airlight, whose ``get_state()`` has them; the provider has
    none of its own.
    """

    name = "airlight"
    stages = ("base",)

    def __init__(self) -> None:
        self._renderer: Any = lambda: None

    def _subplot(self) -> Any:
        renderer = self._renderer()
        return None if renderer is None else _SUBPLOTS.get(renderer)

    def bind(self, invalidate: Callable[[], object] | None) -> None:
        """Receive the method of the component that builds the chain again; None on removal."""
        if invalidate is None:
            subplot = self._subplot()
            if subplot is not None:
                subplot.forsake()
            self._renderer = lambda: None
            return
        renderer = getattr(getattr(invalidate, "__self__", None), "renderer", None)
        if renderer is not None:
            self._renderer = weakref.ref(renderer)

    def build_pass(self, stage: str, renderer: Any, chain: Any, delegate: Any) -> Any:
        """A new pass that draws ``delegate`` in the medium, or None if there is no medium."""
        self._renderer = weakref.ref(renderer)
        subplot = self._subplot()
        if stage not in self.stages or subplot is None or not subplot.enabled:
            return None
        before, render_pass = subplot.render_pass, vtkAirlightPass()
        for name in PROPERTIES:
            getattr(render_pass, "Set" + name)(getattr(before, "Get" + name)())
        for i in range(before.GetNumberOfMedia()):
            render_pass.AddMedium(before.GetMedium(i))
        render_pass.SetDelegatePass(delegate)
        subplot.adopt(render_pass)
        return render_pass

    def default_state(self) -> dict[str, Any]:
        """No settings."""
        return {}

    def get_state(self) -> dict[str, Any]:
        """No settings."""
        return {}

    def set_state(self, state: Mapping[str, Any]) -> None:
        """Ignore the state."""

    def veto(self, settings: Mapping[str, Any]) -> str | None:
        """Why the settings do not go together with the medium, or None."""
        subplot = self._subplot()
        return None if subplot is None or not subplot.enabled else _reason(settings)
