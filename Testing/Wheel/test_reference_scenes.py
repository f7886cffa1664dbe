# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The reference scenes, drawn by the pass and computed by the filter, beside their kept answers."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

TESTING = Path(__file__).resolve().parents[1]
DATA = TESTING / "Data" / "Reference"
sys.path[:0] = [str(TESTING / folder) for folder in ("Python", "Oracle", "Data/Reference")]
import oraclescene  # noqa: E402
import reference_scene  # noqa: E402
from compare import metrics, read_pfm  # noqa: E402
from draw_reference_scenes import draw  # noqa: E402

NAMES = sorted(path.stem for path in (DATA / "scenes").glob("*.json"))
PARTS = {"total": "Radiance", "inscatter": "Airlight", "transmittance": "Transmittance"}


def answer(name, part):
    """[rows, columns, channels], the lowest row first."""
    return read_pfm(DATA / "ref" / f"{name}.{part}.pfm")[::-1]


def compare(name, pictures, size, largest_median, largest_p99):
    mask = answer(name, "mask")
    for part, buffer in PARTS.items():
        expected = answer(name, part)
        found = pictures[buffer].reshape(size[1], size[0], -1)
        scores = metrics(found, expected, mask)
        print(name, part, {key: f"{scores[key]:.1e}" for key in ("median", "p99", "dark_max_abs")})
        assert scores["nonfinite"] == 0
        assert scores["median"] <= largest_median
        assert scores["p99"] <= largest_p99
        assert scores["dark_max_abs"] <= 1e-6 * expected.max()


@pytest.mark.parametrize("name", NAMES)
def test_pass(name):
    scene, size = reference_scene.read_scene(str(DATA / "scenes" / f"{name}.json"))
    pictures = oraclescene.LibraryScene(scene, size).draw(PARTS.values())
    compare(name, pictures, size, 2e-6, 1e-4)


def test_filter():
    name = "S3_ground_occluders"
    scene, size = reference_scene.read_scene(str(DATA / "scenes" / f"{name}.json"))
    pictures = oraclescene.LibraryScene(scene, size).compute(PARTS.values())
    compare(name, pictures, size, 2e-6, 1e-4)


@pytest.fixture(scope="module")
def other_pictures(tmp_path_factory):
    """The same scenes with the VTK of the build tree, which needs an X server."""
    python, path = (os.environ.get(f"AIRLIGHT_OTHER_{name}") for name in ("PYTHON", "PYTHONPATH"))
    if not (python and path and "DISPLAY" in os.environ):
        pytest.skip("the test needs an X server, and the Airlight of a build tree")
    folder = tmp_path_factory.mktemp("other")
    script = Path(__file__).with_name("draw_reference_scenes.py")
    environment = {key: value for key, value in os.environ.items()
                   if key not in ("VTK_DEFAULT_OPENGL_WINDOW", "LD_LIBRARY_PATH")}
    subprocess.run([python, script, folder], check=True, env={**environment, "PYTHONPATH": path})
    return {file.stem: np.load(file) for file in folder.glob("*.npy")}


@pytest.mark.parametrize("name", NAMES)
def test_same_as_with_other_vtk(name, other_pictures):
    """99.9 % of the pixels have the same radiance within 1e-5 with both versions of VTK."""
    found = draw(DATA / "scenes" / f"{name}.json")
    expected = other_pictures[name]
    assert found.shape == expected.shape and expected.max() > 0
    off = (np.abs(found - expected) > 1e-5 * np.abs(expected)).any(axis=-1)
    print(name, f"{off.mean():.1e} of the pixels differ")
    assert off.mean() <= 1e-3
