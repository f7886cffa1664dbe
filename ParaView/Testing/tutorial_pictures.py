# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays the ten steps of Documentation/paraview.md in ParaView's window, for the page's pictures.

    cd Documentation/pictures
    ../../Utilities/paraview-test.sh --run ../../ParaView/Testing/tutorial_pictures.py

writes paraview-*.png here.
"""

import os
import pathlib
import sys
import tempfile

import numpy as np

import windowtest as window

COW = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Data" / "meshes" / "cow.ply"
SEARCH = f"{window.PANEL}/SearchBox/SearchLineEdit"
PLUGINS = np.s_[74:641, 166:966]  # the list of plugins: rows from the top, and columns
BOTTOM = (f"{window.PANEL}/scrollArea/qt_scrollarea_vcontainer/1QScrollBar0", "set_int", "5000")


def grab(name):
    return ("", "grab screen", name)


def set_line(widget, value):
    return [(widget, "set_string", str(value)), (widget, "key", "16777220")]  # Return


def add_light():
    """A spotlight behind the mesh, that falls off as real lamps do."""
    events = [("menubar/menu_View", "activate", "Light Inspector"),
              (f"{window.INSPECTOR}/addLight", "activate", ""),
              (f"{window.LIGHT}/InteractiveLight/positionalComboBox", "activated", "Positional")]
    for axis, value in zip("XYZ", (0.5, 1.2, -0.7)):
        events += set_line(f"{window.LIGHT}/InteractiveLight/worldPosition{axis}", value)
    events += set_line(f"{window.LIGHT}/InteractiveLight/coneAngle/DoubleLineEdit", 60)
    # The last term first: 0 0 0 is no attenuation.
    for i, value in ((2, 1), (0, 0)):
        events += set_line(f"{window.LIGHT}/Attenuation/DoubleLineEdit{i}", value)
    return events + set_line(f"{window.LIGHT}/LightIntensity/DoubleLineEdit0", 2)


EVENTS = [
    *window.load_plugin()[:-1], grab("plugin"), window.load_plugin()[-1],
    (f"{window.FRAME}/Close", "activate", ""), grab("views"),
    (window.new_view("AirlightRenderView"), "activate", ""),
    ("menubar/menu_File", "activate", "actionFileOpen"),
    ("FileOpenDialog", "filesSelected", str(COW)), window.APPLY,
    *window.drag((0.5, 0.5), (0.38, 0.55)), grab("first-view"),
    (SEARCH, "set_string", "lamp"), window.set_view("Lamp", True), BOTTOM, grab("lamp"),
    (SEARCH, "set_string", ""),
    *set_line(f"{window.VIEW}/VisibilityDistance/DoubleLineEdit0", 10),
    (SEARCH, "set_string", "visibility"), BOTTOM, grab("visibility"),
    (SEARCH, "set_string", ""), window.set_view("Lamp", False),
    *add_light(), grab("light"),
    *set_line(f"{window.VIEW}/SubpixelFrames/IntRangeWidget/LineEdit", 4),
    window.CHECK_MESSAGES]


def main():
    with tempfile.TemporaryDirectory() as folder, window.Screen(folder) as screen:
        played = screen.play(EVENTS, timeout=300)
    # Without the manager's folder, which is that of the machine.
    played.grabs["plugin"] = played.grabs["plugin"][PLUGINS]
    for name, pixels in played.grabs.items():
        window.keep(f"paraview-{name}", pixels)
    print(played.text)
    return played.status


if __name__ == "__main__":
    status = main()
    sys.stdout.flush()
    os._exit(status)
