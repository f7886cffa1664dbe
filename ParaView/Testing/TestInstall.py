# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin and the package as `cmake --install` puts them below a prefix draw what those of the
build folder draw."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import paraviewtest as test

SCENE = pathlib.Path(__file__).with_name("server_scene.py")
PLUGIN = pathlib.Path(os.environ["AIRLIGHT_PLUGIN"])
BUILD = next(folder for folder in PLUGIN.parents if (folder / "CMakeCache.txt").exists())


def draw(folder, plugin, package):
    """The pictures of a fresh ParaView, and what it says of the package."""
    path = os.pathsep.join([package, *filter(lambda p: "airlight" not in os.listdir(p),
                                             filter(os.path.isdir, sys.path))])
    environment = {**os.environ, "AIRLIGHT_PLUGIN": plugin, "AIRLIGHT_TEST_OUTPUT": folder,
                   "PYTHONPATH": path}
    program = ["pvpython", "-c", "import airlight.paraview; print(airlight.paraview.__file__, "
               "airlight.vtkAirlightPass().GetClassName())"]
    text = subprocess.run(program, env=environment, check=True, timeout=100,
                          stdout=subprocess.PIPE, text=True).stdout
    subprocess.run(["pvpython", str(SCENE)], env=environment, check=True, timeout=200)
    return np.array([test.read_png(f"{folder}/by-one-{step}.png")
                     for step in ("thin", "thick")]), text


@unittest.skipUnless(shutil.which("cmake"), "no cmake")
class Install(unittest.TestCase):
    def test_install(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", str(BUILD), "--prefix", prefix], check=True,
                           timeout=100, stdout=subprocess.DEVNULL)
            plugin = next(pathlib.Path(prefix).rglob("AirlightParaView.so"))
            package = next(pathlib.Path(prefix).rglob("airlight/paraview.py")).parents[1]
            # All stays in folders of ParaView's own, and nothing points back to the build folder.
            self.assertEqual(plugin.relative_to(prefix), PLUGIN.relative_to(BUILD))
            self.assertEqual(package.parent, plugin.parents[2])
            for library in pathlib.Path(prefix).rglob("*.so"):
                self.assertNotIn(str(BUILD / "lib").encode(), library.read_bytes(), library)
            installed, text = draw(prefix, str(plugin), str(package))
            self.assertEqual(text.split(), [f"{package}/airlight/paraview.py", "vtkAirlightPass"])
            built = next(BUILD.rglob("airlight/paraview.py")).parents[1]
            np.testing.assert_array_equal(installed, draw(prefix, str(PLUGIN), str(built))[0])


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
