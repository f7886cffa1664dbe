# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of vedo, trame and Jupyter share."""

import importlib.util
import os
import pathlib
import shutil
import subprocess

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Examples"

if "DISPLAY" not in os.environ:  # before VTK looks for a screen
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")


def missing(what, remedy):
    """Skips the test; fails it where AIRLIGHT_REQUIRE_ALL=1 says that all is installed."""
    message = f"{what} is missing: {remedy}"
    if os.environ.get("AIRLIGHT_REQUIRE_ALL") == "1":
        pytest.fail(message, pytrace=False)
    pytest.skip(message, allow_module_level=True)


def need_packages(*names):
    """Names of modules of PyPI's packages."""
    for name in names:
        if importlib.util.find_spec(name) is None:
            missing(f"the Python module {name}", "pip install -r Testing/Web/requirements.txt")


def need_program(package, *names):
    """The path of the first of the programs that is there."""
    for name in names:
        if found := shutil.which(name):
            return found
    return missing(f"the program {names[0]}", f"apt-get install {package}")


def load_example(path):
    """The example as a module, without running its main()."""
    spec = importlib.util.spec_from_file_location(path.parent.name + "_example", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def display(monkeypatch):
    """The DISPLAY of an X server: the present one, or one of its own without a screen."""
    if "DISPLAY" in os.environ:
        yield os.environ["DISPLAY"]
        return
    command = [need_program("xvfb", "Xvfb"), "-displayfd", "1", "-noreset",
               "-screen", "0", "1280x1024x24"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as server:
        try:
            monkeypatch.setenv("DISPLAY", ":" + server.stdout.readline().decode().strip())
            monkeypatch.delenv("VTK_DEFAULT_OPENGL_WINDOW", raising=False)
            yield os.environ["DISPLAY"]
        finally:
            server.terminate()
