# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Executes Examples/Jupyter/fog.ipynb and looks at its pictures and numbers."""

import base64
import io
import json
import os
import pathlib

import numpy as np
import pytest

from conftest import EXAMPLES, need_packages

need_packages("nbclient", "nbformat", "ipykernel", "pyvista", "matplotlib", "PIL")

import nbclient  # noqa: E402
import nbformat  # noqa: E402
from PIL import Image  # noqa: E402

NOTEBOOK = EXAMPLES / "Jupyter" / "fog.ipynb"

# A cell that the tests add: what the notebook's variables hold.
REPORT = """
import json
print(json.dumps({
    "largest_error": float(largest_error), "row_error": float(row_error),
    "transmittance": {str(v): [float(x) for x in transmittance[v]] for v in visibilities},
    "distances": [float(x) for x in distances],
    "gathered": {str(v): [float(x) for x in gathered[v]] for v in visibilities},
    "shadowed": [float(x) for x in shadowed], "unshadowed": [float(x) for x in unshadowed],
    "taken": [float(taken.min()), float(taken.max()), float((taken > 0.05).mean())],
    # Of means of four by four pixels, as single ones are dithered.
    "contrast": {str(v): float(np.abs(np.diff(p, axis=1)).mean() / p.mean()) for v, p in
                 [(v, sweep[f"Visibility {v} m"][:404].astype(float)
                   .reshape(101, 4, 180, 4, 3).mean(axis=(1, 3))) for v in visibilities]},
    "means": [float(p.mean()) for p in (clear, glow, fog)],
}))
"""


@pytest.fixture(scope="module", name="source")
def fixture_source():
    return nbformat.read(NOTEBOOK, as_version=4)


@pytest.fixture(scope="module", name="executed")
def fixture_executed(source, tmp_path_factory):
    """The notebook with its outputs, and the variables of REPORT."""
    notebook = nbformat.from_dict(source)
    notebook.cells.append(nbformat.v4.new_code_cell(REPORT))
    folder = tmp_path_factory.mktemp("notebook")
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": str(folder)}}).execute()
    report = json.loads(notebook.cells.pop().outputs[0].text)
    if "AIRLIGHT_KEEP" in os.environ:  # a folder for the pictures, to look at them
        for i, picture in enumerate(pictures(notebook)):
            picture.save(pathlib.Path(os.environ["AIRLIGHT_KEEP"]) / f"notebook-{i}.png")
    return notebook, report


def pictures(notebook):
    """All pictures of all cells."""
    return [Image.open(io.BytesIO(base64.b64decode(output.data["image/png"]))).convert("RGB")
            for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs
            if "image/png" in output.get("data", {})]


def test_source(source):
    """Committed without outputs, valid, and for a kernel that everyone has."""
    nbformat.validate(source)
    assert source.metadata.kernelspec.name == "python3"
    for cell in source.cells:
        if cell.cell_type == "code":
            assert cell.outputs == [] and cell.execution_count is None
    assert max(len(line) for cell in source.cells for line in cell.source.splitlines()) <= 100


def test_output(executed):
    """Cells that draw give a picture each; none gives an error or a warning."""
    notebook, _ = executed
    for cell in notebook.cells:
        if cell.cell_type != "code":
            continue
        kinds = [output.output_type for output in cell.outputs]
        assert "error" not in kinds
        assert "stderr" not in [output.get("name") for output in cell.outputs]
        drawn = sum("image/png" in output.get("data", {}) for output in cell.outputs)
        draws = "plt.show()" in cell.source or cell.source.split("\n")[-1].startswith("show(")
        assert drawn == (1 if draws and "def show" not in cell.source else 0), cell.source


def test_pictures(executed):
    """Six, none of which is uniform or empty; the panels of the first two differ."""
    notebook, _ = executed
    drawn = [np.asarray(picture, dtype=float) for picture in pictures(notebook)]
    assert len(drawn) == 6
    for picture in drawn:
        assert picture.std() > 10
        assert len(np.unique(picture @ (1, 256, 65536))) > 50  # colours
    for picture in drawn[:2]:  # three panels side by side
        panels = [panel for panel in np.array_split(picture[40:-20], 3, axis=1)]
        width = min(panel.shape[1] for panel in panels)
        for a, b in ((0, 1), (1, 2)):
            assert np.abs(panels[a][:, :width] - panels[b][:, :width]).mean() > 2


def test_numbers(executed):
    _, report = executed
    distances = np.array(report["distances"])
    for visibility, values in report["transmittance"].items():
        # Koschmieder: the contrast is 2 % at the visibility, with 3.912 for -ln 0.02.
        assert np.allclose(values, np.exp(-3.912 * distances / float(visibility)), rtol=1e-9,
                           atol=0)
    assert report["largest_error"] < 1e-12
    for values in report["gathered"].values():
        assert values[0] == 0 and np.all(np.diff(values) >= 0) and values[-1] > 0.01
    ends = [values[-1] for values in report["gathered"].values()]
    assert ends[2] < ends[0] < ends[1]  # of visibilities 60, 15 and 5 m
    # The picture's airlight is the integral; shadows only take light away.
    assert 0 < report["row_error"] < 2e-6
    shadowed, unshadowed = np.array(report["shadowed"]), np.array(report["unshadowed"])
    assert np.all(shadowed <= unshadowed * (1 + 1e-5))
    assert 0.03 < 1 - shadowed.sum() / unshadowed.sum() < 0.3
    least, most, area = report["taken"]
    assert least > -1e-4 and 0.1 < most < 0.5 and 0.05 < area < 0.4


def test_directions(executed):
    """Less visibility, less contrast; the fog's glow brightens the picture, shadows darken it."""
    _, report = executed
    contrast = list(report["contrast"].values())  # 60, 15, 5 m
    assert contrast[0] > 1.3 * contrast[1] > 1.3 ** 2 * contrast[2] > 0
    clear, glow, fog = report["means"]
    assert glow > fog > 1.1 * clear
