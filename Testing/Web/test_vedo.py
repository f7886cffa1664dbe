# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Examples/vedo/fog.py: its picture, the airlight in it, and its window."""

import pathlib
import subprocess
import sys

import numpy as np
import pytest

from conftest import EXAMPLES, load_example, need_packages

need_packages("vedo", "PIL")

from PIL import Image  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkFiltersSources import vtkLineSource  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkLight  # noqa: E402

import airlight  # noqa: E402

EXAMPLE = EXAMPLES / "vedo" / "fog.py"
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Python"))  # keyboard.py


@pytest.fixture(scope="module", name="example")
def fixture_example():
    return load_example(EXAMPLE)


def draw(example, fog_pass):
    """The picture as vedo takes it, its bottom row first, and the pass's buffers."""
    fog_pass.RecordBuffersOn()
    plotter = example.make_plotter(fog_pass, offscreen=True)
    plotter.show(camera=example.CAMERA)
    picture = plotter.screenshot(asarray=True)[::-1].astype(float)
    rows, columns, _ = picture.shape
    buffers = {name: vtk_to_numpy(fog_pass.GetBuffer(name).GetPointData().GetScalars())
               .reshape(rows, columns, -1).astype(float)
               for name in ("Airlight", "Depth", "Radiance")}
    technique = fog_pass.GetEffectiveShadowTechnique()
    plotter.close()
    return picture, buffers, technique


def make_rays(camera, rows, columns):
    """Directions of the pixels' centres."""
    position, focal_point, up = (np.array(camera[name], dtype=float)
                                 for name in ("position", "focal_point", "viewup"))
    forward = (focal_point - position) / np.linalg.norm(focal_point - position)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    half = np.tan(np.radians(camera["view_angle"] / 2))
    x = ((np.arange(columns) + 0.5) / columns * 2 - 1) * half * columns / rows
    y = ((np.arange(rows) + 0.5) / rows * 2 - 1) * half
    rays = (forward + x[None, :, None] * right + y[:, None, None] * np.cross(right, forward))
    return rays / np.linalg.norm(rays, axis=2)[..., None]


class LitAirlight:
    """The lamp's airlight on the lit parts of rays, by the filter, in double precision."""

    def __init__(self, example, medium):
        self.lamp = vtkLight()
        airlight.vtkAirlight.SetRadiantIntensity(self.lamp, example.INTENSITY)
        self.lamp.SetPosition(example.LAMP)
        self.sight = vtkLineSource()
        self.filter = airlight.vtkLitIntervalsFilter()
        self.filter.SetInputConnection(self.sight.GetOutputPort())
        self.filter.SetInputData(1, example.make_trunks().dataset)
        self.filter.SetLight(self.lamp)
        self.filter.SetMedium(medium)

    def compute(self, begin, end):
        self.sight.SetPoint1(begin)
        self.sight.SetPoint2(end)
        self.filter.Update()
        values = self.filter.GetOutput().GetCellData().GetArray("Airlight")
        return vtk_to_numpy(values).reshape(-1, 3).sum(axis=0)


def test_writes_picture(tmp_path):
    path = tmp_path / "fog.png"
    done = subprocess.run([sys.executable, EXAMPLE, path], check=False, text=True, timeout=300,
                          capture_output=True)
    assert (done.returncode, done.stdout) == (0, "")
    assert "rror" not in done.stderr and "arn" not in done.stderr
    picture = np.asarray(Image.open(path).convert("RGB"), dtype=float)
    assert picture.shape == (675, 1200, 3)
    # The lamp is near the middle, warm and the brightest; little is black, little is white.
    brightness = picture.sum(axis=2)
    bright = np.argwhere(brightness > 0.97 * brightness.max()).mean(axis=0)
    assert np.all(np.abs(bright - (337, 607)) < 15)
    assert picture[..., 0].mean() > picture[..., 2].mean()
    assert 40 < picture.mean() < 120
    assert np.mean(picture.max(axis=2) < 5) < 0.01
    assert np.mean(picture.min(axis=2) > 250) < 0.02


def test_bad_picture(tmp_path):
    """An option that there is not."""
    done = subprocess.run([sys.executable, EXAMPLE, "--nonsense"], check=False, text=True,
                          timeout=120, capture_output=True, cwd=tmp_path)
    assert done.returncode == 2 and "--nonsense" in done.stderr


def test_airlight(example):
    """That of vtkAirlight without shadows, of vtkLitIntervalsFilter with them."""
    fog_pass = example.make_fog()
    picture, shadowed, technique = draw(example, fog_pass)
    assert technique == airlight.vtkAirlightPass.SHADOW_PLANES
    # The picture is the radiance with a gamma of 2.2 (FXAA changes edges only).
    encoded = 255 * np.clip(shadowed["Radiance"], 0, 1) ** (1 / 2.2)
    assert np.median(np.abs(picture - encoded)) < 1

    fog_pass = example.make_fog()
    fog_pass.SetShadowTechniqueToNone()
    _, unshadowed, technique = draw(example, fog_pass)
    assert technique == airlight.vtkAirlightPass.NONE
    rows, columns, _ = picture.shape
    rays = make_rays(example.CAMERA, rows, columns)
    medium, rgb = fog_pass.GetMedium(0), [0.0, 0.0, 0.0]
    eye = np.array(example.CAMERA["position"])
    open_errors, errors, shares = [], [], []
    lit = LitAirlight(example, medium)
    for row in range(5, rows, 67):
        for column in range(7, columns, 61):
            depth = unshadowed["Depth"][row, column, 0]
            ray, end = rays[row, column], depth if depth >= 0 else 200.0
            airlight.vtkAirlight.Ambient(medium, eye, ray, end, rgb)
            ambient = np.array(rgb)
            airlight.vtkAirlight.Inscatter(medium, example.LAMP, example.INTENSITY, eye, ray, 0,
                                           end, rgb)
            expected = ambient + rgb
            open_errors.append(np.abs(unshadowed["Airlight"][row, column] / expected - 1).max())
            expected = ambient + lit.compute(eye, eye + end * ray)
            errors.append(np.abs(shadowed["Airlight"][row, column] / expected - 1).max())
            shares.append(shadowed["Airlight"][row, column, 1] / (ambient[1] + rgb[1]))
    assert len(errors) == 200
    assert np.median(open_errors) < 2e-6 and max(open_errors) < 1e-3
    assert np.median(errors) < 2e-6 and np.quantile(errors, 0.95) < 1e-3
    # Trunks take a part of the lamp's light from many rays.
    assert np.mean(np.array(shares) < 0.97) > 0.2
    assert (unshadowed["Airlight"] - shadowed["Airlight"]).min() > -1e-4


def test_window(display):
    """Without a file name a window opens, until q is pressed."""
    from keyboard import Keyboard
    with subprocess.Popen([sys.executable, EXAMPLE], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True) as program:
        try:
            keyboard = Keyboard("Fog", 120)
            assert program.poll() is None
            keyboard.press("q")
            output, _ = program.communicate(timeout=60)
        finally:
            program.kill()
    assert program.returncode == 0
    assert "rror" not in output, output
