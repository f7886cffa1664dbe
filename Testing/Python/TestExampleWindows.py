# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The examples that have a purpose in their windows, and what they say to wrong options."""

import inspect
import os
import subprocess
import sys
import time
import unittest

from exampletest import EXAMPLES, PROGRAMS, USES, load_example
from keyboard import Keyboard


class TestExampleWindows(unittest.TestCase):
    def test_errors(self):
        """A picture that cannot be written, and options that there are not."""
        commands = [[sys.executable, EXAMPLES / "underwater_lamp.py"]]
        if PROGRAMS:
            commands.append([os.path.join(PROGRAMS, "DaylightRoom")])
        for command in commands:
            for options, word in ((["-o", "/nonexistent/x.png"], "/nonexistent/x.png"),
                                  (["--nonsense"], "usage")):
                done = subprocess.run([*command, *options], check=False, text=True, timeout=120,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                self.assertGreater(done.returncode, 0)
                self.assertIn(word, done.stdout)

    def test_windows(self):
        """Without -o examples open a window until q is pressed, all by the same lines."""
        ways = {}
        for name in USES:
            lines = inspect.getsource(load_example(name).show).splitlines()
            ways.setdefault("\n".join(lines), name)
        self.assertLessEqual(len(ways), 2)
        commands = [[sys.executable, EXAMPLES / (name + ".py")] for name in ways.values()]
        if PROGRAMS:
            commands.append([os.path.join(PROGRAMS, "DaylightRoom")])
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
