# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What users do in ParaView's window, action by action: after each, the output window is empty.

    Utilities/paraview-test.sh --run ParaView/Testing/TestWindowActions.py pictures

also keeps the window's picture after each action, to be looked at.
"""

import sys
import tempfile

import windowtest as window


def choose(name, entry):
    return [window.set_view(name, entry)]


def represent(name):
    return [(window.REPRESENTATION, "activated", name)]


ACTIONS = {
    "plugin": window.load_plugin(),
    "view": window.make_view(),
    "source": window.make_source("SphereSource"),
    "lamp": choose("Lamp", True),
    "map": choose("ShadowTechnique", "Shadow map"),
    "planes": choose("ShadowTechnique", "Shadow planes"),
    "no-shadows": choose("ShadowTechnique", "None"),
    "rayleigh": choose("PhaseFunction", "Rayleigh"),
    "mie": choose("PhaseFunction", "Mie hazy"),
    "box": choose("Region", "Box"),
    "sphere": choose("Region", "Sphere"),
    "cylinder": choose("Region", "Cylinder"),
    "unbounded": choose("Region", "Unbounded"),
    "coefficients": choose("Thickness", "Coefficients"),
    "visibility": choose("Thickness", "Visibility"),
    "exposure": choose("ToneMapping", "Reinhard"),
    "off": choose("Airlight", False),
    "on": choose("Airlight", True),
    "undo": [window.UNDO],
    "redo": [window.REDO],
    "wireframe": represent("Wireframe"),
    "points": represent("Points"),
    "no-lamp": choose("Lamp", False),
    "medium": represent("Medium"),
    "surface": represent("Surface"),
    "image": window.make_source("RTAnalyticSource"),
    "scatters": choose("VolumesScatter", True),
    "split": [(f"{window.FRAME}/SplitHorizontal", "activate", ""),
              (window.new_view("AirlightRenderView", 2), "activate", "")],
    "second-source": window.make_source("ConeSource"),
    "joined": [(f"{window.LAYOUT}/Frame.2/Close", "activate", "")],
    "comparative": window.make_view("AirlightComparativeView"),
    "comparative-source": window.make_source("CylinderSource"),
}


def make_events(pictures):
    events = []
    for name, action in ACTIONS.items():
        events += action
        if pictures:
            events.append(("", "grab screen", name))
        events.append(window.CHECK_MESSAGES)
    return events


class WindowActions(window.TestCase):
    def test_actions(self):
        played, _ = self.play(make_events(False), timeout=280)
        self.assertEqual(played.status, 0, played.text)
        for word in ("ERR|", "WARN|", "critical"):
            self.assertNotIn(word, played.text)


def keep_pictures():
    with tempfile.TemporaryDirectory() as folder, window.Screen(folder) as screen:
        played = screen.play(make_events(True), timeout=600)
    for name, pixels in played.grabs.items():
        window.keep(f"action-{name}", pixels)


if __name__ == "__main__":
    if "pictures" in sys.argv:
        keep_pictures()
    else:
        window.main()
