# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Python in ParaView's window: the macros as buttons, and a recorded trace that is run again."""

import pathlib
import re
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test
import windowtest as window

MACROS = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "ParaView" / "macros"
MENU = "menubar/menu_Macros"
EDITOR = "0pqPythonScriptEditor0"
SHOW_LIGHT = (f"{window.LIGHT}/InteractiveLight/show3DWidget", "set_boolean", "false")


def import_macro(name):
    return [(MENU, "activate", "actionMacroCreate"),
            ("FileOpenDialog", "filesSelected", str(MACROS / f"{name}.py"))]


def start_trace():
    return [("menubar/menuTools", "activate", "actionToolsStartStopTrace"),
            (window.DIALOG + "TraceOptionsDialog/widget/OKButton", "activate", "")]


def save_trace(path):
    return [("menubar/menuTools", "activate", "actionToolsStartStopTrace"),
            (f"{EDITOR}/PythonScriptEditorMenuBar/File", "activate", "Save &As..."),
            (f"{EDITOR}/FileOpenDialog", "filesSelected", str(path))]


def read_camera(state, kind):
    """Where the camera of the first view of a kind is, in a state file."""
    view = re.search(rf'<Proxy group="views" type="{kind}".*?</Proxy>', state, re.DOTALL)[0]
    return window.read_numbers(view, "CameraPosition")


class WindowScripts(window.TestCase):
    def test_macros(self):
        """A plain view becomes one in fog, seen from the same place; a lamp, which is dragged."""
        played, views = self.play(
            window.load_plugin() + window.make_source("SphereSource")
            + import_macro("ConvertToAirlight") + import_macro("AirlightLamp")
            + [("menubar/menu_View", "activate", "Light Inspector"), ("", "grab", "plain"),
               (MENU, "activate", "ConvertToAirlight"), ("", "grab", "fog"),
               (MENU, "activate", "AirlightLamp"), ("", "grab", "lamp"),
               *window.drag((0.5, 0.5), (0.3, 0.3)), ("", "grab", "dragged")], timeout=280)
        self.assertEqual(played.status, 0, played.text)
        for word in ("ERR|", "WARN|", "Traceback"):
            self.assertNotIn(word, played.text)
        self.assertEqual(len(views), 4, played.text)
        np.testing.assert_array_equal(read_camera(played.states["fog"], "AirlightRenderView"),
                                      read_camera(played.states["plain"], "RenderView"))
        for former, latter in (("plain", "fog"), ("fog", "lamp"), ("lamp", "dragged")):
            self.assertGreater(np.abs(views[latter] - views[former]).mean(), 0.5, latter)
        lamp, dragged = (window.read_numbers(played.states[name], "FocalPoint")
                         for name in ("lamp", "dragged"))
        self.assertGreater(np.abs(np.subtract(dragged, lamp)).max(), 0.1, "the widget is there")

    @unittest.skipIf(test.VERSION >= (5, 12), "ParaView's editor of scripts crashes in a playback")
    def test_trace(self):
        """A view, data, lamp and light as recorded: the script gives the same picture elsewhere."""
        path = test.OUTPUT / "recorded_trace.py"
        path.unlink(missing_ok=True)
        played, views = self.play(
            window.load_plugin() + start_trace() + window.make_view()
            + window.make_source("SphereSource")
            + [window.set_view("Lamp", True), window.set_view("PhaseFunction", "Rayleigh"),
               window.set_view("Region", "Box"),
               ("menubar/menu_View", "activate", "Light Inspector"),
               (f"{window.INSPECTOR}/addLight", "activate", ""),
               *window.drag((0.5, 0.5), (0.3, 0.3)), SHOW_LIGHT,
               *save_trace(path), ("", "grab", "traced"), window.CHECK_MESSAGES], timeout=280)
        self.assertEqual(played.status, 0, played.text)
        text = path.read_text(encoding="utf-8")
        for line in ("CreateView('AirlightRenderView')", ".Lamp = 1", ".PhaseFunction = 'Rayleigh'",
                     ".Region = 'Box'", "AddLight(view=", "light1.Position = "):
            self.assertIn(line, text)
        test.load_plugin()
        # A setting that pvpython begins with another value of.
        simple.GetSettingsProxy("ColorPalette").BackgroundColorMode = "Single Color"
        exec(compile(text, str(path), "exec"), {})  # a script of ParaView's own making
        view = test.find_view()
        height, width, _ = views["traced"].shape
        difference = np.abs(test.picture(view, "trace-run-again", (width, height))
                            - views["traced"])
        print(f"trace: largest difference {difference.max()}")
        self.assertGreater(views["traced"].std(), 10)
        self.assertLessEqual(difference.max(), 1)


if __name__ == "__main__":
    window.main()
