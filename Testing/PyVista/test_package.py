# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""CMake installs all files of the package, and its entry points lead somewhere."""

from importlib.metadata import entry_points
from pathlib import Path
import re

import pytest

ROOT = Path(__file__).parents[2]
GROUPS = ("pyvista.plotter_components", "pyvista.accessors", "pyvista_render_passes.providers")


def test_cmake_lists_all_files():
    text = (ROOT / "CMake" / "AirlightBuild.cmake").read_text(encoding="utf-8")
    listed = re.search(r"set\(AIRLIGHT_PYTHON_FILES\s+([^)]*)\)", text).group(1).split()
    folder = ROOT / "Wrapping" / "Python" / "airlight"
    assert listed == sorted(listed)
    assert set(listed) == {path.relative_to(folder).as_posix() for path in folder.rglob("*.py")}


@pytest.mark.parametrize("group", GROUPS)
def test_entry_points(group):
    found, = entry_points(group=group, name="airlight")
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert f'[project.entry-points."{group}"]\nairlight = "{found.value}"' in text
    assert found.load() is not None
