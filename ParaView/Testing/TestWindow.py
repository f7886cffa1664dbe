# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window with the plugin: it opens without a message. What a view draws is for TestView: in
a window on a virtual display even a view of ParaView's own has no picture."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
SKIPPED = 125  # by the script
# Runs inside the window, whose standard output is not the terminal's.
SCRIPT = """
import os
from paraview import simple
try:
    wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
    names = [probe.GetXMLName() for probe in (simple.AirlightProbe(Input=wavelet),)]
    names.append(simple.CreateView("AirlightRenderView").GetXMLName())
    with open({result!r}, "w") as file:
        file.write(" ".join(names))
finally:
    os._exit(0)
"""


class Window(unittest.TestCase):
    def test_window(self):
        with tempfile.TemporaryDirectory() as folder:
            result = pathlib.Path(folder, "result")
            script = pathlib.Path(folder, "script.py")
            script.write_text(SCRIPT.format(result=str(result)), encoding="utf-8")
            # Settings of the user's own would be read and written.
            environment = dict(os.environ, HOME=folder, XDG_CONFIG_HOME=folder,
                               XDG_RUNTIME_DIR=folder, QT_QPA_PLATFORM="xcb")
            done = subprocess.run([str(RUN), "--window", "--script", str(script)], timeout=200,
                                  env=environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, check=False)
            created = result.read_text(encoding="utf-8") if result.exists() else ""
        if done.returncode == SKIPPED:
            self.skipTest(done.stdout)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("No proxy that matches", done.stdout)
        self.assertNotIn("ERR|", done.stdout)
        self.assertNotIn("warning", done.stdout.lower())
        self.assertEqual(created, "AirlightProbe AirlightRenderView", done.stdout)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    result = unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result
    if result.skipped or not result.wasSuccessful():
        sys.exit(SKIPPED if result.skipped else 1)
