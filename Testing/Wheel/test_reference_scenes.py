# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The reference scenes, drawn by the pass and computed by the filter, beside their kept answers."""

import sys
from pathlib import Path

import pytest

TESTING = Path(__file__).resolve().parents[1]
DATA = TESTING / "Data" / "Reference"
sys.path[:0] = [str(TESTING / folder) for folder in ("Python", "Oracle", "Data/Reference")]
import oraclescene  # noqa: E402
import reference_scene  # noqa: E402
from compare import metrics, read_pfm  # noqa: E402

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
