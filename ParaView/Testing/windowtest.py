# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window on a screen of its own, driven by ParaView's test playback.

    with windowtest.Screen(folder) as screen:
        played = screen.play(windowtest.load_plugin() + [windowtest.CHECK_MESSAGES])

An event is (object, command, argument): what a widget is made to do, by its path of names below the
main window, or by DIALOG and its own. One that finds no widget makes the playback fail and lists the
names that there are.
"""

import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple
import unittest
from xml.sax.saxutils import quoteattr

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

import paraviewtest as test

PLUGIN = os.environ.get("AIRLIGHT_PLUGIN", "")
RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
SKIPPED = 125  # by the script

PANEL = "propertiesDock/propertiesPanel"
LAYOUT = ("centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/"
          "Container")
FRAME = f"{LAYOUT}/Frame.0"
PROPERTIES = f"{PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents"
MESSAGES = "outputWidgetDock/outputWidget/stackedWidget/page_2/consoleWidget/0QTextEdit0"

VIEW = f"{PROPERTIES}/ViewFrame/ProxyPanel"
REPRESENTATION = (f"{PROPERTIES}/DisplayFrame/ProxyPanel/Representation/"
                  "displayRepresentationWidget/comboBox")
INSPECTOR = "lightInspectorDock/lightInspectorPanel"
LIGHT = (f"{INSPECTOR}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/LightContainer0/"
         "1pqProxyWidget0")
DIALOG = "!"  # before the name of a dialog that is not below the main window

APPLY = (f"{PANEL}/Accept", "activate", "")
UNDO = ("menubar/menu_Edit", "activate", "actionEditUndo")
UNDOES = test.VERSION < (5, 12)  # later the playback undoes nothing, in ParaView's own views either
REDO = ("menubar/menu_Edit", "activate", "actionEditRedo")
CHECK_MESSAGES = (MESSAGES, "check plainText", "")  # that the output window is empty


class Played(NamedTuple):
    """What a playback left: exit status, text of all outputs, and the screen and the state file's text
    at each grab."""

    status: int
    text: str
    grabs: dict
    states: dict


def load_plugin(plugin=PLUGIN):
    """As users do: Tools, Manage Plugins, Load New."""
    dialog = "PluginManagerDialog"
    file_dialog = "pqFileDialog" if test.VERSION < (5, 12) else "1pqFileDialog0"
    return [("menubar/menuTools", "activate", "actionManage_Plugins"),
            (f"{dialog}/splitter/localGroup/loadLocal", "activate", ""),
            (f"{dialog}/{file_dialog}", "filesSelected", str(plugin)),
            (f"{dialog}/buttonBox/1QPushButton0", "activate", "")]


def new_view(name, frame=0):
    """The entry of the list that an empty frame of the layout shows."""
    return (f"{LAYOUT}/Frame.{frame}/CentralWidgetFrame/EmptyView/scrollArea/qt_scrollarea_viewport/"
            f"widgetFoo/ConvertActionsFrame/{name}")


def make_view(name="AirlightRenderView"):
    """Close the layout's view, and choose another from the list that is then shown."""
    return [(f"{FRAME}/Close", "activate", ""), (new_view(name), "activate", "")]


def set_view(name, value):
    """A check box of the view's properties, or the entry of a list."""
    if isinstance(value, bool):
        return (f"{VIEW}/{name}/CheckBox", "set_boolean", "true" if value else "false")
    return (f"{VIEW}/{name}/ComboBox", "activated", value)


def drag(start, end):
    """The mouse in the view, from a place to another: shares of its width and height."""
    widget = f"{FRAME}/CentralWidgetFrame/Viewport"
    return [(widget, "mouseMove", "({},{},0,0,0)".format(*start)),
            (widget, "mousePress", "({},{},1,1,0)".format(*start)),
            (widget, "mouseMove", "({},{},1,0,0)".format(*end)),
            (widget, "mouseRelease", "({},{},1,0,0)".format(*end))]


def make_source(name):
    return [("menubar/menuSources/Alphabetical", "activate", name), APPLY]


def make_filter(name):
    return [("menubar/menuFilters/Alphabetical", "activate", name), APPLY]


def save_view(path):
    """File, Save Screenshot."""
    return [("menubar/menu_File", "activate", "actionFileSaveScreenshot"),
            ("SaveScreenshotFileDialog", "filesSelected", str(path)),
            ("SaveScreenshotDialog/widget/OKButton", "activate", "")]


def save_state(path):
    """File, Save State."""
    return [("menubar/menu_File", "activate", "actionFileSaveServerState"),
            ("FileSaveServerStateDialog", "filesSelected", str(path))]


def to_xml(events):
    lines = ['<?xml version="1.0" ?>', "<pqevents>"]
    for name, command, argument in events:
        names = [name[1:]] if name.startswith(DIALOG) else ["pqClientMainWindow", name]
        target = quoteattr("/".join(filter(None, names)))
        if command.startswith("check "):
            lines.append(f"  <pqcheck object={target} property={quoteattr(command[6:])} "
                         f"arguments={quoteattr(argument)} />")
        else:
            lines.append(f"  <pqevent object={target} command={quoteattr(command)} "
                         f"arguments={quoteattr(argument)} />")
    return "\n".join([*lines, "</pqevents>", ""])


def read_xwd(path):
    """The picture of a screen, [height, width, 3] of bytes: 32 bits a pixel, blue first."""
    data = pathlib.Path(path).read_bytes()
    header = struct.unpack(">25I", data[:100])
    width, height, stride, colours = header[4], header[5], header[12], header[19]
    start = header[0] + 12 * colours
    pixels = np.frombuffer(data, np.uint8, stride * height, start).reshape(height, stride)
    return pixels[:, :4 * width].reshape(height, width, 4)[..., 2::-1].copy()


class Screen:
    """A virtual screen that ParaView's window fills, and whose picture can be read at any time."""

    def __init__(self, folder, size=(1152, 762)):
        self.folder = pathlib.Path(folder)
        self.size = size
        self.server = None
        self.display = None

    def __enter__(self):
        if not shutil.which("Xvfb"):
            raise FileNotFoundError("Xvfb")
        reading, writing = os.pipe()
        width, height = self.size
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24",
             "-fbdir", str(self.folder), "-noreset", "-nolisten", "tcp"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as stream:
            self.display = ":" + stream.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait(20)

    def grab(self):
        return read_xwd(self.folder / "Xvfb_screen0")

    def play(self, events, arguments=(), timeout=140):
        """Start ParaView without the user's settings, play the events, and end it.

        An event ("", "grab", NAME) keeps the screen's picture, the state and a screenshot of the view
        by this name; "grab screen" leaves out the latter.
        """
        script = self.folder / "events.xml"
        names = [argument for _, command, argument in events if command in ("grab", "grab screen")]
        script.write_text(to_xml(list(self._expand(events))), encoding="utf-8")
        log = self.folder / "output.txt"
        environment = dict(os.environ, DISPLAY=self.display, HOME=str(self.folder),
                           XDG_CONFIG_HOME=str(self.folder), XDG_RUNTIME_DIR=str(self.folder),
                           QT_QPA_PLATFORM="xcb", PQOBJECTNAMING_MATCH_LIMIT="20")
        with open(log, "w", encoding="utf-8") as stream:
            process = subprocess.Popen(
                [str(RUN), "--empty-window", "--dr", "--test-directory", str(self.folder),
                 "--test-script", str(script), "--exit", *arguments],
                env=environment, stdout=stream, stderr=subprocess.STDOUT, start_new_session=True)
            try:
                grabs, states = self._wait(process, names, time.monotonic() + timeout)
            finally:
                if process.poll() is None:
                    os.killpg(process.pid, 9)
        return Played(process.wait(), log.read_text(encoding="utf-8", errors="replace"), grabs,
                      states)

    def _expand(self, events):
        """For a grab, ParaView writes its state, waits until the screen is read, and saves its view,
        which would hide the frame of the view for a while."""
        for event in events:
            if event[1] in ("grab", "grab screen"):
                yield ("", "pause", "500")
                yield from save_state(self.folder / f"grab-{event[2]}.pvsm")
                yield ("", "pause", "1500")
                if event[1] == "grab":
                    yield from save_view(self.folder / f"grab-{event[2]}.png")
            else:
                yield event

    def _wait(self, process, names, end):
        grabs, states = {}, {}
        while process.poll() is None and time.monotonic() < end:
            for name in names:
                state = self.folder / f"grab-{name}.pvsm"
                if name not in grabs and state.exists():
                    time.sleep(0.7)
                    grabs[name] = self.grab()
                    states[name] = state.read_text(encoding="utf-8")
            time.sleep(0.1)
        return grabs, states


def read_numbers(state, name):
    """The numbers of the first property of a name in a state file's text."""
    found = re.search(rf'<Property name="{name}" .*?</Property>', state, re.DOTALL)
    return [float(value) for value in re.findall(r'index="\d+" value="([^"]*)"', found[0])]


def keep(name, pixels):
    """A picture of the screen, to be looked at."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(np.ascontiguousarray(pixels[::-1]).reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(test.OUTPUT / f"{name}.png"))
    writer.SetInputData(image)
    writer.Write()


class TestCase(unittest.TestCase):
    """A test that plays events in a window; skipped where there is none."""

    def setUp(self):
        if not shutil.which("Xvfb"):
            self.skipTest("no Xvfb")

    def play(self, events, **options):
        with tempfile.TemporaryDirectory() as folder, Screen(folder) as screen:
            played = screen.play(events, **options)
            views = {name: test.read_png(pathlib.Path(folder, f"grab-{name}.png"))
                     for name in played.grabs}
        if played.status == SKIPPED:
            self.skipTest(played.text)
        for name, pixels in played.grabs.items():
            keep(f"window-{name}", pixels)
        return played, views


def main():
    """Run a file's tests; exit as ctest expects."""
    result = unittest.main(module="__main__", argv=sys.argv, exit=False).result
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not result.wasSuccessful():
        sys.exit(1)
    if result.skipped:
        sys.exit(SKIPPED)
