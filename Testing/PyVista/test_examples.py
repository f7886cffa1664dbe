# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Each example writes a picture that is neither black nor washed out, and says nothing amiss."""

from pathlib import Path
import subprocess
import sys

from conftest import STRICT
import pytest
import pyvista as pv

EXAMPLES = sorted((Path(__file__).parents[2] / "Examples" / "PyVista").glob("*.py"))


def test_there_are_examples():
    assert len(EXAMPLES) >= 5


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example(example, tmp_path):
    done = subprocess.run([sys.executable, *STRICT, example, tmp_path], capture_output=True,
                          text=True, timeout=500)
    errors = [line for line in done.stderr.splitlines() if "bad X server connection" not in line]
    assert (done.returncode, errors) == (0, [])
    colours = pv.read(tmp_path / (example.stem + ".png")).active_scalars[:, :3]
    assert 10 < colours.mean() < 160
    assert colours.std() > 8
    assert (colours == 255).all(axis=1).mean() < 0.05
