# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The examples that have a purpose in their windows, and what they say to wrong options."""

import argparse
import os
import subprocess
import sys
import tempfile
import time
import unittest

from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

import airlight
import airlight.display
from exampletest import EXAMPLES, PROGRAMS, USES, read_picture
from keyboard import Keyboard


class TestExampleWindows(unittest.TestCase):
    def test_errors(self):
        """A picture that cannot be written, and options that there are not."""
        commands = [[sys.executable, EXAMPLES / "underwater_lamp.py"]]
        if PROGRAMS:
            commands.append([os.path.join(PROGRAMS, "UnderwaterLamp")])
        for command in commands:
            for options, word in ((["-o", "/nonexistent/x.png"], "/nonexistent/x.png"),
                                  (["--nonsense"], "--nonsense")):
                done = subprocess.run([*command, *options], check=False, text=True, timeout=120,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                self.assertGreater(done.returncode, 0)
                self.assertIn(word, done.stdout)

    def test_help(self):
        """All tell what they are for and of -o, without drawing anything."""
        commands = [[sys.executable, EXAMPLES / (name + ".py")] for name in USES]
        if PROGRAMS:
            commands += [[os.path.join(PROGRAMS, name.title().replace("_", ""))] for name in USES]
        for command in commands:
            text = subprocess.run([*command, "--help"], check=True, text=True, timeout=60,
                                  stdout=subprocess.PIPE, env={**os.environ, "DISPLAY": ""}).stdout
            self.assertIn("--output", text)
            self.assertGreater(len(text), 200)

    def test_display(self):
        """airlight.display where nothing can be shown or written."""
        window = airlight.display.open_window(vtkRenderer(), size=(20, 10), offscreen=True)
        self.assertEqual(window.GetSize(), (20, 10))
        with self.assertRaisesRegex(ValueError, "no interactor"):
            airlight.display.show(window)
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(OSError, "missing/x.png"):
                airlight.display.write_picture(window, folder + "/missing/x.png")
            drawn = []
            window.AddObserver("EndEvent", lambda *_: drawn.append(1))
            for redraw in (True, False):
                airlight.display.write_picture(window, folder + "/x.png", redraw)
                self.assertEqual(read_picture(folder + "/x.png").shape, (200, 3))
                self.assertEqual(len(drawn), 1, "the second picture is the first one")

    def test_no_display(self):
        """An error, before VTK ends the program or takes another window."""
        done = subprocess.run(
            [sys.executable, "-c", "import airlight.display as display\n"
             "from vtkmodules.vtkRenderingCore import vtkRenderer\n"
             "display.open_window(vtkRenderer())\n"], check=False, text=True, timeout=60,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env={**os.environ, "DISPLAY": ":987", "VTK_DEFAULT_OPENGL_WINDOW":
                 "vtkXOpenGLRenderWindow"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("no X server", done.stdout)
        self.assertIn("DISPLAY=:987", done.stdout)
        self.assertIn("xvfb-run", done.stdout)

    def test_picture(self):
        """airlight.display.show_picture() does what the options say, and makes a pass for it."""
        parser = argparse.ArgumentParser()
        airlight.display.add_picture_options(parser)
        with tempfile.TemporaryDirectory() as folder:
            options = parser.parse_args(["--size", "20x10", "--frames", "3", "-o",
                                         folder + "/x.png"])
            renderer = vtkRenderer()
            lamp = vtkLight()
            lamp.SetPosition(0, 3, 0)
            airlight.vtkAirlight.SetRadiantIntensity(lamp, (9, 6, 3))
            renderer.AddLight(lamp)
            fog = airlight.vtkParticipatingMedium()
            fog.SetVisibility(20)
            drawn = []
            renderer.AddObserver("EndEvent", lambda *_: drawn.append(1))
            made = airlight.display.show_picture(renderer, fog, options, (0, 0, 5), (0, 1, 0), 40,
                                                 up=(1, 0, 0))
            picture = read_picture(folder + "/x.png")
        self.assertEqual(picture.shape, (200, 3))
        self.assertEqual(len(drawn), 1, "once")
        self.assertGreater(picture.max(), 2 * picture.min())
        self.assertEqual((made.GetSubpixelFrames(), made.GetAccumulatedFrames()), (3, 3))
        camera = renderer.GetActiveCamera()
        self.assertEqual((camera.GetFocalPoint(), camera.GetViewUp(), camera.GetViewAngle()),
                         ((0, 1, 0), (1, 0, 0), 40))

    def test_windows(self):
        """Without -o an example opens a window until q is pressed."""
        commands = [[sys.executable, EXAMPLES / "depth_cueing.py"]]
        if PROGRAMS:
            commands.append([os.path.join(PROGRAMS, "DepthCueing")])
        for command in commands:
            with subprocess.Popen(command, text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE) as program:
                keyboard = Keyboard("Visualization Toolkit - OpenGL", 60)
                time.sleep(0.5)
                self.assertIsNone(program.poll())
                keyboard.press("q")
                output, errors = program.communicate(timeout=60)
                self.assertEqual((program.returncode, errors), (0, ""), command)
                self.assertGreater(len(output), 20)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
