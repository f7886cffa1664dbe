# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python program and the commands of the README, word for word, and looks at what they
rendered. Its C++ program is built by Testing/Consumer."""

import json
import os
import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import airlight

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("AIRLIGHT_PROGRAM")
SIZES = {"fog.pfm": b"PF\n160 120\n", "reference.pfm": b"PF\n160 120\n",
         "airlight.pfm": b"PF\n", "orders.pfm": b"PF\n40 30\n"}


def blocks_of(language):
    """The README's code in a language."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def write_model(file):
    """A triangle as binary glTF 2.0, by its specification."""
    positions = struct.pack("<9f", -1, 0, 0, 1, 0, 0, 0, 1.5, 0)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": len(positions)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [-1, 0, 0], "max": [1, 1.5, 0]}]}).encode()
    text += b" " * (-len(text) % 4)
    body = (struct.pack("<II", len(text), 0x4E4F534A) + text
            + struct.pack("<II", len(positions), 0x004E4942) + positions)
    file.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)


class TestReadme(unittest.TestCase):
    def run_interactive(self, words, folder):
        """A window opens and stays until it is closed."""
        with subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.STDOUT) as process:
            time.sleep(4)
            state = process.poll()
            process.terminate()
            text = process.communicate(timeout=30)[0]
        self.assertIsNone(state, text)
        self.assertNotIn("error", text.lower())

    @unittest.skipUnless(PROGRAM, "built without the programs")
    def test_commands(self):
        """What users type after the build. The scripts are what continuous integration runs."""
        wheel, build, commands, by_hand = blocks_of("sh")
        self.assertTrue(wheel.startswith("Utilities/wheel.sh --build"))  # its tests install it
        self.assertEqual(re.findall(r"^\S+", build, re.MULTILINE),
                         ["Utilities/demo.sh", "Utilities/test.sh"])
        self.assertTrue(by_hand.startswith("cmake -S . -B build && cmake --build build"))
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "build").mkdir()
            (folder / "build" / "bin").symlink_to(pathlib.Path(PROGRAM).parent)
            for part in ("Examples", "Testing"):
                (folder / part).symlink_to(ROOT / part)
            write_model(folder / "model.glb")
            written = set()
            for line in commands.splitlines():
                words = shlex.split(line)
                if "view" in words or "--live" in words:
                    self.run_interactive(words, folder)
                    continue
                done = subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, timeout=300,
                                      stderr=subprocess.STDOUT, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout)
                for file in re.findall(r"(?:-o|--difference) (\S+)", line):
                    first = file % 0 if "%" in file else file
                    content = (folder / first).read_bytes()
                    start = SIZES.get(file, b"\x89PNG\r\n")
                    self.assertTrue(content.startswith(start), (file, content[:20]))
                    written.add(file)
                if "compare" in words:
                    median = float(re.search(r"median=(\S+)", done.stdout).group(1))
                    self.assertLess(median, 1e-5)
            self.assertGreaterEqual(len(written), 7)

    def test_python_package(self):
        """The command that lists the classes, in the build folder that the demo leaves."""
        sentence = re.search(r"`PYTHONPATH=build/(\S+) python3 -m airlight` lists\nthe classes",
                             (ROOT / "README.md").read_text(encoding="utf-8"))
        self.assertIsNotNone(sentence)
        folder = re.sub(r"python3\.\d+", "python{}.{}".format(*sys.version_info), sentence.group(1))
        package = pathlib.Path(airlight.__file__).parents[1]
        self.assertEqual(package.parts[-3:], pathlib.Path(folder).parts)
        environment = dict(os.environ, PYTHONPATH=str(package))
        done = subprocess.run([sys.executable, "-m", "airlight"], env=environment, timeout=300,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("vtkAirlightPass", done.stdout)
        # The demo builds it, and fails if it does not load; continuous integration runs the demo.
        demo = (ROOT / "Utilities" / "demo.sh").read_text(encoding="utf-8")
        self.assertRegex(demo, r"(?m)^compile .*\bvtkAirlightPython$")
        self.assertRegex(demo, r"(?m)^PYTHONPATH=\S+ \"\$python\" -m airlight")

    def test_python_block(self):
        plotted, block = blocks_of("python")
        self.assertIn("pl.airlight.enable()", plotted)  # which the tests of PyVista run
        names = {}
        exec(block, names)  # pylint: disable=exec-used

        width, height = names["window"].GetSize()
        self.assertEqual(names["radiance"].GetDimensions(), (width, height, 1))
        radiance = vtk_to_numpy(names["radiance"].GetPointData().GetScalars())
        self.assertTrue(numpy.isfinite(radiance).all())
        # Fog fills the view and the lamp lights all of it: no pixel is dark.
        self.assertGreater(radiance.min(), 0.0)
        # The cone is in the view, and so is the air beside it.
        depth = vtk_to_numpy(names["fog_pass"].GetBuffer("Depth").GetPointData().GetScalars())
        self.assertTrue((depth > 0).any() and (depth == -1).any())


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
