# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors name the parameter, the value and the remedy, and change nothing."""

import sys
import types

import numpy as np
import pytest
import pyvista as pv

import airlight
from airlight.pyvista.requirements import require_pyvista

from test_lifecycle import run

SMOKE = pv.ImageData(dimensions=(2, 2, 2))
SMOKE["soot"] = np.ones(8)
SMOKE["two"] = np.ones((8, 2))
SMOKE["large"] = np.full(8, 1.5)
SMOKE["bad"] = np.full(8, np.nan)
SMOKE.set_active_scalars("soot")


@pytest.mark.parametrize("arguments, error, message", [
    ({"visibility": -1}, ValueError, "visibility is -1.0: give the distance"),
    ({"visibility": float("nan")}, ValueError, "visibility is nan"),
    ({"visibility": "far"}, TypeError, "visibility is 'far', a str"),
    ({"visibility": True}, TypeError, "visibility is True"),
    ({"anisotropy": 1}, ValueError, "anisotropy is 1.0: .* from -0.99 to 0.99"),
    ({"albedo": 2}, ValueError, "albedo is 2: .* from 0 to 1"),
    ({"albedo": (1, 1)}, ValueError, "albedo"),
    ({"ambient": -1}, ValueError, "ambient is -1"),
    ({"ambient": "no colour"}, ValueError, "ambient is 'no colour'"),
    ({"region": (1, 0, 0, 1, 0, 1)}, ValueError, "region is .* minimum"),
    ({"region": "box"}, TypeError, "region is 'box'"),
    ({"region": pv.ImageData(dimensions=(2, 2, 2))}, TypeError, "region is a ImageData"),
    ({"region": pv.Plane()}, ValueError, "surface"),
    ({"density": 3}, TypeError, "density is 3: give a pyvista.ImageData"),
    ({"density": pv.ImageData(dimensions=(2, 2, 2))}, ValueError, "image"),
    ({"density": pv.ImageData(dimensions=(2, 2, 2)), "scale_height": 1}, ValueError, "give one of"),
    ({"emission": -1}, ValueError, "emission is -1"),
    ({"albedo_array": 3}, TypeError, "albedo_array is 3: give the name"),
    ({"albedo_array": "white"}, ValueError, "albedo_array is 'white' without a density"),
    ({"density": SMOKE, "albedo_array": "white"}, ValueError, "give one of .* arrays, 'soot'"),
    ({"density": SMOKE, "emission_array": "soot"}, ValueError, "without an emission"),
    ({"density": SMOKE, "albedo_array": "two"}, ValueError, "give one of one component or three"),
    ({"density": SMOKE, "albedo_array": "large"}, ValueError, "from 0 to 1"),
    ({"density": SMOKE, "albedo_array": "bad"}, ValueError, "from 0 to 1"),
    ({"visibility": float("inf"), "emission": 1}, ValueError, "emission in clear air"),
    ({"scale_height": 0}, ValueError, "scale_height is 0.0"),
    ({"reference_height": 0}, ValueError, "reference_height is given without scale_height"),
    ({"shadows": "soft"}, ValueError, "shadows is 'soft': give one of 'automatic'"),
    ({"lamp": "yes"}, TypeError, "lamp is 'yes'"),
    ({"white": 0}, ValueError, "white is 0.0"),
    ({"anti_aliasing": "fxaa"}, TypeError, "anti_aliasing is 'fxaa': give .*'msaa'"),
    ({"tone_mapping": "aces"}, ValueError, "tone_mapping is 'aces': give one of 'clamp'"),
    ({"color_space": "rgb"}, ValueError, "color_space is 'rgb': give one of 'linear', 'srgb'"),
    ({"frames": 0}, ValueError, "frames is 0.0: .* from 1 to 1024"),
    ({"frames": 2.5}, ValueError, "frames is 2.5"),
    ({"medium": 3}, TypeError, "medium is 3: give an airlight.vtkParticipatingMedium"),
    ({"medium": airlight.vtkParticipatingMedium(), "visibility": 3}, ValueError,
     "medium and visibility are both given"),
    ({"medium": airlight.vtkParticipatingMedium(), "albedo": 0.5}, ValueError,
     "medium and albedo are both given"),
])
def test_enable(plotter, arguments, error, message):
    with pytest.raises(error, match=message):
        plotter.airlight.enable(**arguments)
    assert not plotter.airlight.enabled
    assert plotter.renderer.GetPass() is None


@pytest.mark.parametrize("arguments, error, message", [
    ({"position": (0, 0)}, ValueError, "position is .*3 finite numbers"),
    ({"position": "top"}, TypeError, "position is 'top'"),
    ({"intensity": -1}, ValueError, "intensity is -1: give an intensity in W/sr"),
    ({"intensity": "bright"}, ValueError, "intensity"),
    ({"radius": -1}, ValueError, "radius is -1.0"),
    ({"unit": "lumen"}, ValueError, "unit is 'lumen': give one of 'W/sr', 'cd'"),
    ({"cone_angle": 30}, ValueError, "cone_angle is given without a direction"),
    ({"cone_angle": 90, "target": (0, 0, 0)}, ValueError, "cone_angle is 90.0"),
    ({"target": (0, 0, 1)}, ValueError, "the position of the lamp"),
    ({"target": (0, 0, 0), "direction": (0, 0, 1)}, ValueError, "both given"),
    ({"direction": (0, 0, 0)}, ValueError, "direction is"),
    ({"exponent": -1}, ValueError, "exponent is -1.0"),
    ({"color": "nothing"}, ValueError, "color is 'nothing'"),
    ({"ies": "missing.ies"}, FileNotFoundError, "missing.ies"),
    ({"ies": __file__}, ValueError, r"test_errors.py:\d+: the file has no line TILT="),
])
def test_add_lamp(plotter, arguments, error, message):
    lights = len(plotter.renderer.lights)
    with pytest.raises(error, match=message):
        plotter.airlight.add_lamp(**{"position": (0, 0, 1), "intensity": 1, **arguments})
    assert len(plotter.renderer.lights) == lights
    assert plotter.airlight.lamps == ()


def test_other_methods(plotter, make_plotter):
    with pytest.raises(ValueError, match="direction is"):
        plotter.airlight.add_sun((0, 0, 0))
    with pytest.raises(ValueError, match="unit is 'cd'"):
        plotter.airlight.add_sun((0, 0, 1), unit="cd")
    with pytest.raises(ValueError, match="did not return"):
        plotter.airlight.remove_lamp(pv.Light())
    with pytest.raises(RuntimeError, match="call plotter.airlight.enable"):
        plotter.airlight.buffer()
    plotter.airlight.enable()
    with pytest.raises(ValueError, match="name is 'Colour': give one of 'Radiance'"):
        plotter.airlight.buffer("Colour")
    with pytest.raises(TypeError, match="name is 3"):
        plotter.airlight.buffer(3)
    with pytest.raises(RuntimeError, match="no buffer 'Airlight:99'"):
        plotter.airlight.buffer("Airlight:99")
    with pytest.raises(ValueError, match="no scene to derive"):
        make_plotter().airlight.add_lamp((0, 0, 1))


@pytest.mark.parametrize("change", [
    lambda state: state.pop("lamps"),
    lambda state: state.update(more=1),
    lambda state: state["settings"].update(fog=1),
    lambda state: state["settings"].update(visibility=-1),
    lambda state: state["lamps"][0].pop("power"),
    lambda state: state["lamps"][0].update(unit="lumen"),
    lambda state: state.update(medium={}),
    lambda state: state["lamps"].append({**state["lamps"][0], "unit": "cd"}),
])
def test_set_state(plotter, change):
    plotter.airlight.enable(visibility=3).add_lamp((0, 0, 2), 3)
    state = plotter.airlight.get_state()
    broken = plotter.airlight.get_state()
    change(broken)
    with pytest.raises(ValueError):
        plotter.airlight.set_state(broken)
    assert plotter.airlight.get_state() == state


def test_state_of_a_medium_with_an_object(plotter):
    medium = airlight.vtkParticipatingMedium()
    medium.SetPhaseFunction(airlight.vtkDrainePhaseFunction())
    plotter.airlight.enable(medium=medium)
    with pytest.raises(ValueError, match="a phase function object"):
        plotter.airlight.get_state()


def test_accessors():
    line, medium, lamp = pv.Line(), airlight.vtkParticipatingMedium(), pv.Light()
    with pytest.raises(TypeError, match="medium is None"):
        line.airlight.transmittance(None)
    with pytest.raises(TypeError, match="light is 'lamp'"):
        line.airlight.inscatter(medium, "lamp")
    with pytest.raises(ValueError, match="The mesh has no lines"):
        pv.Sphere().airlight.transmittance(medium)
    with pytest.raises(TypeError, match="occluders is 3"):
        line.airlight.inscatter(medium, lamp, occluders=3)
    with pytest.raises(ValueError, match="both given"):
        pv.Sphere().airlight.shadow_volume(lamp, distance=1, bounds=(0, 1, 0, 1, 0, 1))
    with pytest.raises(ValueError, match="distance is -1"):
        pv.Sphere().airlight.shadow_volume(lamp, distance=-1)
    with pytest.raises(ValueError, match="bounds is"):
        pv.Sphere().airlight.shadow_volume(lamp, bounds=(1, 0, 0, 1, 0, 1))
    with pytest.raises(RuntimeError, match="no triangle"):
        line.airlight.silhouette((0, 0, 5))
    with pytest.raises(ValueError, match="light is"):
        pv.Sphere().airlight.silhouette((0, 0))
    lamp.position = (np.nan, 0, 0)
    with pytest.raises(RuntimeError):
        line.airlight.probe(medium, lamp)


def test_pyvista_is_too_old(monkeypatch):
    old = types.ModuleType("pyvista")
    old.__version__ = "0.44.2"
    monkeypatch.setitem(sys.modules, "pyvista", old)
    with pytest.raises(ImportError, match=r"needs PyVista 0.48 .*0\.44\.2.*pip install"):
        require_pyvista()


def test_pyvista_is_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match="airlight.pyvista needs PyVista 0.48 .*pip install"):
        require_pyvista()


def test_opengl_is_too_old():
    """OpenGL 3.2: the scene is drawn without the medium, and buffer() says why."""
    code, output, _ = run(
        "import pyvista as pv\n"
        "pl = pv.Plotter(off_screen=True, window_size=(160, 120))\n"
        "pl.add_mesh(pv.Sphere())\n"
        "pl.airlight.enable()\n"
        "try:\n"
        "    pl.airlight.buffer()\n"
        "except RuntimeError as error:\n"
        "    print(error)\n"
        "print(pl.screenshot().std() > 5)\n",
        MESA_GL_VERSION_OVERRIDE="3.2", MESA_GLSL_VERSION_OVERRIDE="150",
        LIBGL_ALWAYS_SOFTWARE="1")
    assert code == 0
    assert "OpenGL 3.3" in output
    assert output.rstrip().endswith("True")
