# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The medium, the lamps and the pass of one renderer."""

from __future__ import annotations

import math
from typing import Any
import weakref

import numpy as np
import pyvista as pv

from airlight import vtkAirlightLight, vtkAirlightPass, vtkParticipatingMedium

from . import provider
from .lamp import Lamp
from .pass_chain import PassChain
from .scene import background, measure
from .settings import Settings

# Radiance of a white surface at the scene's centre that faces a lamp whose intensity is derived.
DERIVED_RADIANCE = 1.1

# Defaults are derived again if the scene's diagonal changes by more than this factor.
REMEASURE = 1.5


class Subplot:
    """What plotter.airlight keeps for one renderer.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter, which is not kept alive.
    renderer : pyvista.Renderer
        The renderer, which is not kept alive.
    edges : SmoothEdges
        Shared by the subplots of a window.
    """

    def __init__(self, plotter: Any, renderer: Any, edges: Any) -> None:
        self._plotter = weakref.ref(plotter)
        self._renderer = weakref.ref(renderer)
        self._edges = edges
        self._chain = PassChain()
        self._observer: int | None = None
        self._diagonal: float | None = None
        self._background: tuple[float, ...] | None = None
        self._is_clear: bool | None = None
        self._center: Any = None
        self.settings = Settings()
        self.own_medium: vtkParticipatingMedium | None = None
        self.medium = vtkParticipatingMedium()
        self.render_pass = vtkAirlightPass()
        self.lamps: list[Lamp] = []
        self.enabled = False
        self.draws_at_once = False  # whatever the settings say, for a buffer
        self.is_provided = False  # a chain of pyvista-render-passes has the pass
        self._quieted: weakref.WeakValueDictionary = weakref.WeakValueDictionary()
        provider.register(renderer, self)

    @property
    def plotter(self) -> Any:
        """The plotter; RuntimeError if it is closed."""
        plotter = self._plotter()
        if plotter is None or plotter.render_window is None:
            raise RuntimeError("The plotter is closed: plotter.airlight can no longer be used. "
                               "Make a new Plotter, or keep this one by show(auto_close=False).")
        return plotter

    @property
    def renderer(self) -> Any:
        """The renderer; RuntimeError if the plotter is closed."""
        self.plotter
        return self._renderer()

    # Switching on and off

    def enable(self, settings: Settings, own_medium: vtkParticipatingMedium | None) -> None:
        """Put the subplot into a medium, with settings that are checked."""
        renderer = self.renderer
        medium = own_medium or vtkParticipatingMedium()
        if own_medium is None:
            settings.apply_to_medium(medium)
        provider.check(self.plotter, renderer)
        settings.apply_to_pass(self.render_pass)
        self.settings, self.own_medium, self.medium = settings, own_medium, medium
        self.render_pass.RemoveAllMedia()
        self.render_pass.SetMedium(medium)
        self.enabled = True
        self._diagonal = None
        self._is_clear = None
        for lamp in self.lamps:
            lamp.expose(settings.white)
        if settings.anti_aliasing is False:
            self._edges.release(renderer)
        elif settings.anti_aliasing == "msaa":
            self._edges.acquire_samples(renderer)
        else:
            self._edges.acquire(renderer)
        if self._observer is None:
            self._observer = renderer.AddObserver("StartEvent", _Prepare(self))
        self.prepare()
        self.refresh()

    def check(self, settings: Settings, own_medium: vtkParticipatingMedium | None,
              lamps: list[Lamp], *, enabled: bool) -> None:
        """Raise what enable() and add_lamp() would with these, before anything changes."""
        if enabled and own_medium is None:
            settings.apply_to_medium(vtkParticipatingMedium())
        if enabled:
            provider.check(self.plotter, self.renderer)
        self._check_units(lamps)

    def disable(self) -> None:
        """Draw the subplot as PyVista does."""
        if not self.enabled:
            return
        renderer = self._renderer()
        self.enabled = False
        self._remove_derived_lamp()
        if renderer is not None:
            if self._observer is not None:
                renderer.RemoveObserver(self._observer)
            self._edges.release(renderer)
            self._chain.remove(renderer, self.render_pass)
            window = renderer.GetRenderWindow()
            if window is not None and not self.is_provided:
                self.render_pass.ReleaseGraphicsResources(window)
        self._observer = None
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            self.refresh()

    def close(self) -> None:
        """Give up all that the renderer holds of Airlight."""
        self._plotter = lambda: None
        self.disable()
        self.lamps.clear()

    def refresh(self) -> None:
        """Render, if the plotter has been rendered before."""
        provider.invalidate(self.plotter, self.renderer)
        self.plotter.render()

    # Before each frame

    def prepare(self, *, in_frame: bool = False) -> None:
        """Bring lamps, derived values and the chain of passes up to date.

        Values that are derived before the first frame are derived again in it, since the camera
        may be placed until then.
        """
        renderer = self._renderer()
        if not self.enabled or renderer is None or renderer.GetSelector() is not None:
            return
        self._quiet_camera_lights(renderer)
        self._update_derived(in_frame and renderer.camera_set)
        self._update_tone_mapping()
        self._update_progressive(renderer.GetRenderWindow())
        if not self.is_provided:
            self._chain.install(renderer, self.render_pass)
        self._edges.update(renderer, self.render_pass)

    @property
    def refused(self) -> str | None:
        """Why the scene is drawn without the medium, or None."""
        return self._chain.refused

    @property
    def derived_lamp(self) -> Lamp | None:
        """The lamp that Airlight made, if it made one."""
        return next((lamp for lamp in self.lamps if lamp.is_derived), None)

    def _quiet_camera_lights(self, renderer: Any) -> None:
        """Say that lights of the camera are meant to light surfaces only, if nobody said else."""
        for light in renderer.GetLights():
            if id(light) in self._quieted or light.LightTypeIsSceneLight():
                continue
            self._quieted[id(light)] = light
            if not vtkAirlightLight.GetScatters(light):
                vtkAirlightLight.SetScatters(light, False)

    def _update_derived(self, is_final: bool) -> None:
        renderer = self._renderer()
        scene = measure(renderer)
        if scene is None:
            return
        has_changed = self._has_changed(scene)
        if self.own_medium is None:
            color = tuple(background(renderer))
            if has_changed or color != self._background:
                self.settings.derive_ambient(self.medium, color)
                self._background = color
            if has_changed:
                self.settings.derive_from_scene(self.medium, scene)
        self._update_derived_lamp(scene, has_changed)
        if has_changed and is_final:
            self._diagonal, self._center = scene.diagonal, scene.center

    def _update_tone_mapping(self) -> None:
        """Derive it when the medium becomes clear or is so no more: the user may change the pass."""
        is_clear = self.medium.GetVisibility() == math.inf
        if is_clear != self._is_clear:
            self.settings.derive_tone_mapping(self.render_pass, is_clear=is_clear)
            self._is_clear = is_clear

    def _update_progressive(self, window: Any) -> None:
        """Pictures off screen have no time after the first frame."""
        if self.settings.progressive:
            self.render_pass.SetProgressiveRefinement(
                not self.draws_at_once and window is not None
                and not window.GetOffScreenRendering())

    def _has_changed(self, scene: Any) -> bool:
        if self._diagonal is None:
            return True
        ratio = scene.diagonal / self._diagonal
        moved = np.linalg.norm(scene.center - self._center) > self._diagonal
        return bool(moved or not 1 / REMEASURE <= ratio <= REMEASURE)

    def _update_derived_lamp(self, scene: Any, has_changed: bool) -> None:
        if not self._needs_lamp():
            self._remove_derived_lamp()
            return
        lamp = self.derived_lamp
        if lamp is None:
            lamp = Lamp(pv.Light(positional=True, cone_angle=180.0), (0.0, 0.0, 0.0), "W/sr",
                        is_derived=True)
            self.lamps.append(lamp)
            has_changed = True
        if has_changed:
            lamp.light.position = scene.lamp_position
            lamp.light.focal_point = scene.center
            lamp.power = (self.derive_intensity(scene.lamp_position, scene),) * 3
            lamp.expose(self.settings.white)
        if not self._has_light(lamp.light):
            self._renderer().add_light(lamp.light)

    def _needs_lamp(self) -> bool:
        if self.settings.lamp is not None:
            return self.settings.lamp
        derived = self.derived_lamp
        own = derived.light if derived is not None else None
        return not any(light is not own and light.GetSwitch() and
                       vtkAirlightLight.GetScatters(light)
                       for light in self._renderer().GetLights())

    def _has_light(self, light: pv.Light) -> bool:
        return bool(self._renderer().GetLights().IsItemPresent(light))

    def _remove_derived_lamp(self) -> None:
        lamp = self.derived_lamp
        if lamp is not None:
            self.remove_lamp(lamp)

    # Lamps

    def derive_intensity(self, position: np.ndarray, scene: Any = None) -> float:
        """The intensity at which a lamp lights the scene's centre well, in units of white."""
        scene = scene or measure(self.renderer)
        if scene is None:
            raise ValueError("intensity is None, and there is no scene to derive it from: give an "
                             "intensity, or add meshes first.")
        distance = max(np.linalg.norm(position - scene.center), 0.1 * scene.diagonal)
        return float(DERIVED_RADIANCE * np.pi * distance**2 * self.settings.white)

    def add_lamp(self, lamp: Lamp) -> pv.Light:
        """Add a lamp to the renderer, and return its light."""
        renderer = self.renderer
        self._check_units([*self.lamps, lamp])
        lamp.expose(self.settings.white)
        self.lamps.append(lamp)
        renderer.add_light(lamp.light)
        self.prepare()
        self.refresh()
        return lamp.light

    @staticmethod
    def _check_units(lamps: list[Lamp]) -> None:
        given = [lamp for lamp in lamps if not lamp.is_derived]
        other = next((lamp for lamp in given if lamp.system != given[-1].system), None)
        if other is not None:
            raise ValueError(f"unit is {given[-1].unit!r} and there is a lamp in {other.unit!r}: "
                             "radiances of both units cannot be added. Give all lamps in watts "
                             "(W/sr, W/m^2), or all in lumens (cd, lx).")

    def find_lamp(self, light: Any) -> Lamp:
        """The lamp of a light; ValueError if it is none of this subplot."""
        for lamp in self.lamps:
            if lamp.light is light:
                return lamp
        raise ValueError(f"light is {light!r}, which add_lamp() and add_sun() of this subplot did "
                         "not return.")

    def find_airlight(self, name: str, light: Any) -> str:
        """The name of the buffer of a light's airlight."""
        if name != "Airlight":
            raise ValueError(f"name is {name!r} and light is given: give the name 'Airlight'.")
        lit = [each for each in self.renderer.GetLights() if each.GetSwitch()]
        for index, each in enumerate(lit):
            if each is light:
                return f"Airlight:{index}"
        raise ValueError(f"light is {light!r}: give a light of this subplot that is on.")

    def remove_lamp(self, lamp: Lamp) -> None:
        """Take a lamp from the renderer."""
        self.lamps = [each for each in self.lamps if each is not lamp]
        renderer = self._renderer()
        if renderer is None:
            return
        renderer.RemoveLight(lamp.light)
        kept = getattr(renderer, "_lights", None)  # PyVista's own list, which has no method for it
        if kept is not None:
            kept[:] = [light for light in kept if light is not lamp.light]
        lamp.light.renderers[:] = [each for each in lamp.light.renderers if each is not renderer]

    def adopt(self, render_pass: vtkAirlightPass) -> None:
        """Use the pass that a chain of pyvista-render-passes has."""
        self._chain.forget()
        self.render_pass = render_pass
        self.is_provided = True

    def forsake(self) -> None:
        """The chain of pyvista-render-passes has no pass of Airlight any more."""
        self.is_provided = False
        self.render_pass.SetDelegatePass(None)


class _Prepare:
    """An observer that does not keep its subplot alive."""

    def __init__(self, subplot: Subplot) -> None:
        self._subplot = weakref.ref(subplot)

    def __call__(self, *_event: Any) -> None:
        subplot = self._subplot()
        if subplot is not None:
            subplot.prepare(in_frame=True)
