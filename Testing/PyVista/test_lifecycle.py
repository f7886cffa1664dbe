# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Closing, cleaning, pickling, importing, animations and exports."""

import gc
import pickle
import subprocess
import sys
import weakref

from conftest import STRICT
import numpy as np
import pytest
import pyvista as pv

import airlight


def run(code, **environment):
    """A new interpreter's exit code, output and errors, less VTK's line on a missing X server."""
    import os
    done = subprocess.run([sys.executable, *STRICT, "-c", code], capture_output=True,
                          text=True, env={**os.environ, **environment})
    errors = [line for line in done.stderr.splitlines() if "bad X server connection" not in line]
    return done.returncode, done.stdout, "\n".join(errors)


def test_airlight_does_not_import_pyvista():
    code, output, errors = run("import sys, airlight; print('pyvista' in sys.modules)")
    assert (code, output.strip(), errors) == (0, "False", "")


def test_pyvista_does_not_import_airlight():
    code, output, errors = run("import sys, pyvista as pv; p = pv.Plotter(off_screen=True); "
                               "print('airlight' in sys.modules, 'airlight' in dir(p)); p.close()")
    assert (code, output.strip(), errors) == (0, "False True", "")


@pytest.mark.parametrize("background", ["white", "black"])
def test_default_is_silent(tmp_path, background):
    code, _, errors = run(
        "import pyvista as pv\n"
        "pl = pv.Plotter(off_screen=True)\n"
        "pl.add_mesh(pv.Sphere())\n"
        f"pl.background_color = {background!r}\n"
        "pl.airlight.enable()\n"
        f"pl.show(screenshot={str(tmp_path / 'fog.png')!r})\n")
    assert (code, errors) == (0, "")
    assert pv.read(tmp_path / "fog.png").n_points > 0


def test_close_leaves_nothing():
    plotter = pv.Plotter(off_screen=True)
    plotter.add_mesh(pv.Sphere())
    plotter.airlight.enable().add_lamp((0, 0, 3), 5)
    plotter.screenshot()
    component = plotter.airlight
    render_pass = weakref.ref(component.render_pass)
    renderer = plotter.renderer
    plotter.close()
    assert renderer.GetPass() is None
    assert not renderer.HasObserver("StartEvent")
    references = [weakref.ref(plotter), weakref.ref(component)]
    del plotter, component, renderer
    gc.collect()
    assert [reference() for reference in references] == [None, None]
    assert render_pass() is None


def test_plotter_that_is_only_touched_is_collected():
    plotter = pv.Plotter(off_screen=True)
    plotter.airlight.enabled
    reference = weakref.ref(plotter)
    plotter.close()
    del plotter
    gc.collect()
    assert reference() is None


def test_disable_removes_the_observer(plotter):
    plotter.airlight.enable()
    assert plotter.renderer.HasObserver("StartEvent")
    plotter.airlight.disable()
    assert not plotter.renderer.HasObserver("StartEvent")
    for _ in range(3):
        plotter.airlight.enable()
    plotter.airlight.disable()
    assert not plotter.renderer.HasObserver("StartEvent")


def test_deep_clean(plotter):
    plotter.airlight.enable()
    plotter.screenshot()
    plotter.deep_clean()
    assert not plotter.renderer.HasObserver("StartEvent")
    assert not plotter.airlight.enabled
    plotter.deep_clean()
    plotter.close()


def test_use_after_close(plotter):
    component = plotter.airlight.enable()
    plotter.close()
    for use in (component.enable, component.disable, component.describe, component.buffer,
                component.get_state, lambda: component.medium,
                lambda: component.add_lamp((0, 0, 1))):
        with pytest.raises(RuntimeError, match="The plotter is closed"):
            use()
    plotter.close()


def test_clear(plotter):
    """clear() removes meshes and lights; the medium stays, and derives a lamp again."""
    plotter.airlight.enable()
    plotter.screenshot()
    plotter.clear()
    plotter.add_mesh(pv.Cube())
    plotter.render()
    assert plotter.airlight.enabled
    assert len(plotter.renderer.lights) == 1


def test_state_round_trip(make_plotter):
    plotters = [make_plotter(), make_plotter()]
    for plotter in plotters:
        plotter.add_mesh(pv.Sphere())
        plotter.camera_position = "xz"
    first, second = plotters
    first.airlight.enable(visibility=4, albedo=(1, 0.8, 0.6), shadows="planes", white=2,
                          region=(-3, 3, -3, 3, -3, 3))
    first.airlight.add_lamp((0, 1, 2), (5, 4, 3), target=(0, 0, 0), cone_angle=40)
    first.airlight.add_sun((1, 1, -1), 2)
    state = pickle.loads(pickle.dumps(first.airlight.get_state()))
    second.airlight.add_lamp((9, 9, 9), 1)
    assert second.airlight.set_state(state) is second.airlight
    assert second.airlight.get_state() == state
    np.testing.assert_array_equal(first.screenshot(), second.screenshot())
    assert len(second.airlight.lamps) == 2


def test_state_of_derived_settings_and_of_off(plotter):
    plotter.airlight.enable()
    plotter.screenshot()
    state = plotter.airlight.get_state()
    assert state["settings"]["visibility"] is None and state["lamps"] == []
    plotter.airlight.disable()
    off = plotter.airlight.get_state()
    plotter.airlight.set_state(state)
    assert plotter.airlight.enabled
    plotter.airlight.set_state(off)
    assert not plotter.airlight.enabled


def test_state_of_a_medium_and_of_data_sets(plotter):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(0.1, 0.2, 0.3)
    medium.SetAbsorption(0.3, 0.2, 0.1)
    medium.SetPhaseFunctionToRayleigh()
    medium.SetRegionToSphere()
    medium.SetRadius(4)
    plotter.airlight.enable(medium=medium)
    state = pickle.loads(pickle.dumps(plotter.airlight.get_state()))
    plotter.airlight.enable()
    plotter.airlight.set_state(state)
    assert plotter.airlight.medium is not medium
    for name in ("Scattering", "Absorption", "PhaseFunction", "Region", "Radius"):
        assert getattr(plotter.airlight.medium, "Get" + name)() == getattr(medium, "Get" + name)()
    plotter.airlight.enable(region=pv.Sphere(radius=2))
    state = pickle.loads(pickle.dumps(plotter.airlight.get_state()))
    plotter.airlight.set_state(state)
    assert plotter.airlight.medium.GetSurface().GetNumberOfPoints() == pv.Sphere().n_points


def test_open_gif(plotter, tmp_path):
    pytest.importorskip("imageio")
    plotter.airlight.enable()
    plotter.open_gif(str(tmp_path / "fog.gif"))
    for visibility in (20, 5):
        plotter.airlight.medium.SetVisibility(visibility)
        plotter.write_frame()
    plotter.close()
    from PIL import Image
    assert Image.open(tmp_path / "fog.gif").n_frames == 2


def test_change_of_the_medium_is_shown(plotter):
    plotter.airlight.enable(visibility=50)
    before = plotter.screenshot().astype(int)
    plotter.airlight.medium.SetVisibility(3)
    plotter.render()
    assert abs(plotter.screenshot() - before).mean() > 10


def test_change_of_a_derived_value_is_kept(plotter):
    plotter.airlight.enable()
    plotter.screenshot()
    medium = plotter.airlight.medium
    medium.SetAmbientRadiance(0.5, 0.25, 0.125)
    plotter.render()
    assert medium.GetAmbientRadiance() == (0.5, 0.25, 0.125)
    plotter.set_background("black")
    plotter.render()
    assert medium.GetAmbientRadiance() == (0, 0, 0)


def test_screenshot_in_another_size_and_transparent(plotter):
    plotter.airlight.enable()
    assert plotter.screenshot(window_size=(200, 100)).shape == (100, 200, 3)
    assert plotter.screenshot(scale=2).shape[0] in (200, 240)
    assert plotter.screenshot(transparent_background=True).shape[-1] == 4


@pytest.mark.parametrize("suffix", [".svg", ".pdf"])
def test_save_graphic(plotter, tmp_path, suffix):
    plotter.airlight.enable()
    plotter.save_graphic(tmp_path / ("fog" + suffix))
    assert (tmp_path / ("fog" + suffix)).stat().st_size > 0


@pytest.mark.parametrize("method, file", [("export_gltf", "a.gltf"), ("export_obj", "a.obj"),
                                          ("export_vrml", "a.wrl")])
def test_export_has_the_meshes(plotter, tmp_path, method, file):
    """Files of geometry have no medium; writing them neither fails nor ends it."""
    plotter.airlight.enable()
    plotter.screenshot()
    getattr(plotter, method)(tmp_path / file)
    assert (tmp_path / file).stat().st_size > 0
    assert plotter.airlight.enabled


@pytest.mark.parametrize("method", ["export_html", "export_vtksz"])
def test_export_for_browsers(plotter, tmp_path, method):
    """These need trame, which need not be there."""
    plotter.airlight.enable()
    plotter.screenshot()
    try:
        getattr(plotter, method)(tmp_path / "fog.out")
    except ImportError as error:
        assert "trame" in str(error)
    assert plotter.airlight.enabled
    assert plotter.screenshot().size


def test_buffer_before_show_in_a_window():
    """On the screen, buffer() draws without a window, and show() then works."""
    code, output, errors = run(
        "import os, pyvista as pv\n"
        "pl = pv.Plotter(window_size=(160, 120))\n"
        "pl.add_mesh(pv.Sphere())\n"
        "pl.airlight.enable()\n"
        "print(pl.airlight.buffer().dimensions)\n"
        "if os.environ.get('DISPLAY'):\n"
        "    pl.show(interactive=False, auto_close=False)\n"
        "    print(pl.screenshot().shape)\n"
        "pl.close()\n")
    assert (code, errors) == (0, "")
    assert output.startswith("(160, 120, 1)")
