# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the wheel has, and what it says where something is missing."""

import importlib.metadata
import os
import re
import subprocess
import sys
from pathlib import Path

import airlight
import pytest
from vtkmodules.vtkRenderingCore import vtkLight

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = Path(airlight.__file__).parent
CLASSES = [name for name in dir(airlight) if name.startswith("vtk")]


def run(code, **environment):
    """Runs a line of Python in a process of its own: exit status, output and errors."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120,
                          check=False, env={**os.environ, **environment})
    return done.returncode, done.stdout, done.stderr


def test_installed():
    assert "site-packages" in str(PACKAGE)


def test_version():
    project = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"^  VERSION (\S+)$", project, re.MULTILINE).group(1)
    assert airlight.__version__ == version
    assert importlib.metadata.version("airlight") == version


def test_stubs():
    assert (PACKAGE / "py.typed").exists()
    stubs = (PACKAGE / "vtkAirlight.pyi").read_text(encoding="utf-8")
    assert len(CLASSES) > 20
    for name in CLASSES:
        assert f"class {name}(" in stubs
    assert "def SetVisibility(self, distance:float) -> None: ..." in stubs


def test_licence():
    files = [str(file) for file in importlib.metadata.files("airlight")]
    assert any(file.endswith("licenses/LICENSE") for file in files)


def test_commands():
    script = Path(sys.executable).with_name("airlight")
    for command in ([str(script)], [sys.executable, "-m", "airlight"]):
        done = subprocess.run([*command, "--version"], capture_output=True, text=True, timeout=120,
                              check=True)
        assert done.stdout.startswith(f"airlight {airlight.__version__}, VTK 9.")
        assert done.stderr == ""


def test_properties():
    """VTK's names in Python's manner, which the wrapping of newer versions gives."""
    medium = airlight.vtkParticipatingMedium(visibility=12.0)
    assert medium.GetVisibility() == pytest.approx(12.0)
    medium.scattering = (0.1, 0.2, 0.3)
    assert medium.GetScattering() == (0.1, 0.2, 0.3)
    assert medium.scattering == (0.1, 0.2, 0.3)
    with pytest.raises(AttributeError):
        del medium.visibility
    with pytest.raises(TypeError):
        medium.visibility = "far"
    probe = airlight.vtkAirlightProbeFilter()
    lights = [vtkLight(), vtkLight()]
    probe.lights = lights
    assert probe.number_of_lights == 2
    probe.lights = lights[:1]
    assert probe.GetNumberOfLights() == 1
    with pytest.raises(TypeError):
        probe.lights = 3


def test_another_vtk():
    status, _, errors = run(
        "from vtkmodules.vtkCommonCore import vtkVersion\n"
        "import vtkmodules.vtkCommonCore as core\n"
        "class Other:\n"
        "    @staticmethod\n"
        "    def GetVTKVersion(): return '9.7.2'\n"
        "core.vtkVersion = Other\n"
        "import airlight\n")
    assert status == 1
    assert "built for VTK 9.5, and this Python has VTK 9.7.2" in errors
    assert 'pip install "vtk~=9.5.0"' in errors


@pytest.mark.parametrize("cause", [
    "vtkAirlight.so: undefined symbol: _ZN9vtkObject3NewEv",
    "libvtkCommonCore-9.5.so: cannot open shared object file: No such file or directory"])
def test_another_abi(cause):
    """A VTK of the same version, as conda's, whose libraries have other names or symbols."""
    status, _, errors = run(
        "import sys\n"
        "class Loader:\n"
        "    def find_spec(self, name, *rest):\n"
        "        if name == 'airlight.vtkAirlight':\n"
        f"            raise ImportError({cause!r})\n"
        "sys.meta_path.insert(0, Loader())\n"
        "import airlight\n")
    assert status == 1
    assert f"ImportError: {cause}. This Python has a VTK" in errors
    assert 'pip install --force-reinstall "vtk~=9.5.0"' in errors


def test_system_library():
    status, _, errors = run(
        "import sys\n"
        "class Loader:\n"
        "    def find_spec(self, name, *rest):\n"
        "        if name == 'airlight.vtkAirlight':\n"
        "            raise ImportError('libGL.so.1: cannot open shared object file')\n"
        "sys.meta_path.insert(0, Loader())\n"
        "import airlight\n")
    assert status == 1
    assert "apt install libxrender1 libgl1 libegl1" in errors


def test_no_vtk():
    status, _, errors = run(
        "import importlib.util as util\n"
        "find = util.find_spec\n"
        "util.find_spec = lambda name, *rest: None if name == 'vtkmodules' else find(name, *rest)\n"
        "import airlight\n")
    assert status == 1
    assert "airlight needs VTK 9.5" in errors
    assert "pip install" in errors


def test_openvdb():
    """The wheel reads no .vdb files, and says what to do."""
    with pytest.raises(AttributeError, match="built without OpenVDB.*python3-airlight"):
        airlight.vtkOpenVDBDensityReader()
    with pytest.raises(AttributeError, match="no attribute 'vtkFog'"):
        airlight.vtkFog()
