# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""airlight.headless_window(): pictures without a screen, and what it says where it cannot."""

import os
import re
import subprocess
import sys

import airlight
import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)


def make_scene():
    source = vtkSphereSource()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    lamp = vtkLight()
    airlight.vtkAirlight.SetRadiantIntensity(lamp, (2, 2, 2))
    lamp.SetPosition(0.3, 1.5, 1)
    renderer.AddLight(lamp)
    medium = airlight.vtkParticipatingMedium()
    medium.SetVisibility(15)
    render_pass = airlight.vtkAirlightPass()
    render_pass.SetMedium(medium)
    render_pass.RecordBuffersOn()
    renderer.SetPass(render_pass)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 4)
    camera.SetClippingRange(1, 10)
    return renderer, render_pass


def radiance(render_pass):
    return vtk_to_numpy(render_pass.GetBuffer("Radiance").GetPointData().GetScalars()).copy()


def run(code, **environment):
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120,
                          check=False, env={**os.environ, **environment})


def test_newest():
    renderer, _ = make_scene()
    window = airlight.headless_window(renderer, size=(64, 48))
    window.Render()
    assert window.GetSize() == (64, 48)
    version = re.search(r"OpenGL version string: +(\d+\.\d+)", window.ReportCapabilities())
    assert tuple(map(int, version.group(1).split("."))) >= (4, 3)


def test_same_as_other_windows():
    """Whatever window VTK takes here, of X or EGL."""
    renderer, render_pass = make_scene()
    other = vtkRenderWindow()
    other.SetOffScreenRendering(True)
    other.SetMultiSamples(0)
    other.SetSize(64, 48)
    other.AddRenderer(renderer)
    other.Render()
    expected = radiance(render_pass)
    renderer, render_pass = make_scene()
    window = airlight.headless_window(renderer, size=(64, 48))
    window.Render()
    assert expected.max() > 1e-3
    assert np.array_equal(radiance(render_pass), expected)
    for _ in range(2):  # in turn
        other.Render()
        window.Render()
    assert np.array_equal(radiance(render_pass), expected)


def test_two_windows():
    scenes = [make_scene() for _ in range(2)]
    windows = [airlight.headless_window(renderer, size=(32, 24)) for renderer, _ in scenes]
    for window in (*windows, *windows):
        window.Render()
    first, second = [radiance(render_pass) for _, render_pass in scenes]
    assert first.max() > 1e-3
    assert np.array_equal(first, second)
    del windows[0], window
    scenes[1][0].GetActiveCamera().Azimuth(40)
    windows[0].Render()
    assert not np.array_equal(radiance(scenes[1][1]), second)


def test_no_such_device():
    count = airlight.vtkAirlightHeadlessWindow().GetNumberOfDevices()
    assert count >= 1
    for device in (-1, count):
        with pytest.raises(RuntimeError, match=f"no device {device}: choose one from 0 to {count - 1}"):
            airlight.headless_window(device=device)


def test_no_egl(tmp_path):
    """A library of that name that is none."""
    (tmp_path / "libEGL.so.1").write_text("no library")
    done = run("import airlight\nairlight.headless_window()", LD_LIBRARY_PATH=str(tmp_path))
    assert done.returncode == 1
    assert "RuntimeError: The library libEGL.so.1 is missing: install it" in done.stderr


@pytest.mark.parametrize("plot", [False, True])
def test_no_display(plot):
    """Neither X server nor EGL, where VTK's first frame would crash."""
    code = ("import airlight.display\n"
            "from vtkmodules.vtkRenderingCore import vtkRenderer\n"
            "airlight.display.open_window(vtkRenderer(), offscreen=True)\n")
    if plot:
        code = "import pyvista as pv\npv.Plotter(off_screen=True).airlight.enable()\n"
    done = run(code, DISPLAY="", VTK_DEFAULT_OPENGL_WINDOW="vtkXOpenGLRenderWindow")
    assert done.returncode == 1
    assert "RuntimeError: VTK has nothing to draw with: no X server" in done.stderr
    assert "airlight.headless_window(), or run under xvfb-run" in done.stderr


def test_window_without_context():
    """A window that VTK's users make themselves: one error, no crash."""
    done = run("import airlight\n"
               "from vtkmodules.vtkRenderingCore import vtkRenderer\n"
               "window = airlight.vtkAirlightHeadlessWindow()\n"
               "window.SetDeviceIndex(99)\n"
               "window.AddRenderer(vtkRenderer())\n"
               "window.Render()\n"
               "window.Render()\n"
               "print(window.SupportsOpenGL())\n")
    assert done.returncode == 0
    assert done.stdout == "0\n"
    assert done.stderr.count("EGL has no device 99") == 1


def test_old_opengl():
    """The pass says what it needs, and falls back."""
    done = run("import airlight\n"
               "from vtkmodules.vtkRenderingCore import vtkRenderer, vtkLight\n"
               "renderer = vtkRenderer()\n"
               "lamp = vtkLight()\n"
               "lamp.SetPosition(0, 1, 0)\n"
               "renderer.AddLight(lamp)\n"
               "medium = airlight.vtkParticipatingMedium()\n"
               "medium.SetVisibility(10)\n"
               "render_pass = airlight.vtkAirlightPass()\n"
               "render_pass.SetMedium(medium)\n"
               "render_pass.SetShadowTechniqueToShadowPlanes()\n"
               "renderer.SetPass(render_pass)\n"
               "airlight.headless_window(renderer).Render()\n",
               MESA_GL_VERSION_OVERRIDE="3.3", MESA_GLSL_VERSION_OVERRIDE="330")
    assert done.returncode == 0
    message = " ".join(done.stderr.split())
    assert "OpenGL 4.3" in message
    assert "headless_window" in message
