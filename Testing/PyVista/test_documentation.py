# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The code of Documentation/pyvista.md runs as it stands there, and its table has all methods."""

import inspect
from pathlib import Path
import re

from conftest import OF_VTK
import pytest
import pyvista as pv

PAGE = (Path(__file__).parents[2] / "Documentation" / "pyvista.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```python\n(.*?)^```", PAGE, re.DOTALL | re.M)


def test_there_are_blocks():
    assert len(BLOCKS) >= 6


@pytest.mark.parametrize("index", range(len(BLOCKS)))
@pytest.mark.filterwarnings("error", OF_VTK)
def test_block(index, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pv, "OFF_SCREEN", True)
    exec(compile(BLOCKS[index], f"block {index}", "exec"), {})
    pv.close_all()


def public(cls):
    return {name for name, value in inspect.getmembers(cls) if not name.startswith("_")}


def test_tables_have_all_methods():
    component = type(pv.Plotter(off_screen=True).airlight)
    pv.close_all()
    names = public(component) | public(type(pv.Sphere().airlight))
    assert len(names) > 15
    for name in names:
        assert f"`{name}" in PAGE, name


@pytest.mark.parametrize("method", ["enable", "add_lamp", "add_sun", "buffer"])
def test_table_has_the_parameters(method):
    component = type(pv.Plotter(off_screen=True).airlight)
    pv.close_all()
    row = next(line for line in PAGE.splitlines() if line.startswith(f"| `{method}("))
    for parameter in list(inspect.signature(getattr(component, method)).parameters)[1:]:
        assert parameter in row


def test_docstrings_have_parameters_and_returns():
    for cls in (type(pv.Plotter(off_screen=True).airlight), type(pv.Sphere().airlight)):
        for name, method in inspect.getmembers(cls, inspect.isfunction):
            if name.startswith("_"):
                continue
            text = inspect.getdoc(method)
            assert "Returns\n-------" in text, name
            for parameter in list(inspect.signature(method).parameters)[1:]:
                assert re.search(rf"^{parameter} : ", text, re.M), (name, parameter)
    pv.close_all()
