# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Configures a project that takes Airlight as VTK takes its remote modules, and compiles a part."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["AIRLIGHT_SOURCE_DIR"])
CMAKE = os.environ["AIRLIGHT_CMAKE"]
ROOT_FILES = ("CMakeLists.txt", "vtk.module", "CMake", "Filters", "Module", "Rendering", "Testing")


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, timeout=150,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        raise AssertionError(f"{command}: {done.returncode}\n{done.stdout}")
    return done.stdout


def listed_classes():
    """The public classes of all folders, but those of OpenVDB, which VTK does not look for."""
    names = []
    for folder in ("Module", "Filters", "Rendering"):
        text = (SOURCE / folder / "sources.cmake").read_text(encoding="utf-8")
        found = re.search(r"^  CLASSES\n((?:    \w+\n?)+)", text, re.MULTILINE).group(1).split()
        names.extend(folder + "/" + name for name in found)
    return names


class TestRemoteModule(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="airlight-remote-"))
        self.root = self.folder / "vtk" / "Remote" / "Airlight"
        self.root.mkdir(parents=True)
        for name in ROOT_FILES:
            source = SOURCE / name
            copy = shutil.copytree if source.is_dir() else shutil.copy
            copy(source, self.root / name)
        shutil.copy(SOURCE / "Testing" / "RemoteModule" / "CMakeLists.txt", self.folder / "vtk")

    def tearDown(self):
        shutil.rmtree(self.folder)

    def test_configuration(self):
        build = self.folder / "build"
        text = (SOURCE / "vtk.module").read_text(encoding="utf-8")
        modules = ";".join(re.findall(r"VTK::(?!Airlight)(\w+)", text))
        run(CMAKE, "-G", os.environ["AIRLIGHT_GENERATOR"], "-S", self.folder / "vtk", "-B", build,
            f"-DVTK_DIR={os.environ['AIRLIGHT_VTK_DIR']}", f"-DAIRLIGHT_VTK_MODULES={modules}",
            "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_CXX_COMPILER_LAUNCHER={shutil.which('ccache') or ''}")
        commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
        compiled = {os.path.realpath(command["file"]): command for command in commands}
        for name in listed_classes():
            self.assertIn(os.path.realpath(self.root / (name + ".cxx")), compiled)
        tests = run("ctest", "--test-dir", build, "-N")
        self.assertIn("VTK::AirlightCxx-TestAirlight\n", tests)
        self.assertNotIn("Consumer", tests)  # that is for the project of its own
        # A class of each folder and generated text of shaders compile.
        for name in ("Module/vtkAirlight.cxx", "Filters/vtkLitIntervalsFilter.cxx"):
            command = compiled[os.path.realpath(self.root / name)]
            run("sh", "-c", f"cd '{command['directory']}' && {command['command']}")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
