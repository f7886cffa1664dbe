# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the reference scenes by the pass of the Airlight that this Python has.

    python3 draw_reference_scenes.py FOLDER     writes the radiance of each into FOLDER/NAME.npy
"""

import sys
from pathlib import Path

import numpy as np

TESTING = Path(__file__).resolve().parents[1]
SCENES = TESTING / "Data" / "Reference" / "scenes"
sys.path[:0] = [str(TESTING / folder) for folder in ("Python", "Oracle", "Data/Reference")]
import oraclescene  # noqa: E402
import reference_scene  # noqa: E402


def draw(path):
    scene, size = reference_scene.read_scene(str(path))
    return oraclescene.LibraryScene(scene, size).draw(["Radiance"])["Radiance"]


def main():
    folder = Path(sys.argv[1])
    for path in sorted(SCENES.glob("*.json")):
        np.save(folder / f"{path.stem}.npy", draw(path))


if __name__ == "__main__":
    main()
