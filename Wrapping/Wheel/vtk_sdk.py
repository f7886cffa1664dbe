#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Assembles a software development kit for the VTK that this Python has, on Linux.

A wheel of VTK has the libraries and no headers. The package vtk-sdk has the headers and the CMake
package, but PyPI has its wheels for macOS only. Both are made from one source, and the headers
differ in one file. So this script joins three things:

- headers and CMake package from a wheel of vtk-sdk,
- libraries from the installed package vtk,
- the programs that wrap classes for Python from cvista-sdk: those of VTK 9.7, which PyPI has for Linux.
  vtkPythonTypeAccess.h gives what the code that they write lacks in 9.5.

Prints the folder of the CMake package.
"""
import argparse
import importlib.util
import platform
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

SDK = ("vtk-sdk==9.5.0", "macosx_11_0_arm64", "310")
TOOLS = ("cvista-sdk==9.7.0.5", f"manylinux_2_28_{platform.machine()}", "312")


def download(requirement, tag, python, folder):
    """Fetches a wheel for another platform and unpacks it; returns the folder with its files."""
    name = requirement.split("==")[0].replace("-", "_")
    if not (folder / name).exists():
        subprocess.run(
            [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:",
             "--platform", tag, "--python-version", python, "--dest", folder, requirement],
            check=True)
        [wheel] = folder.glob(f"{name}-*.whl")
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(folder / f"{name}.new")
        (folder / f"{name}.new").rename(folder / name)
        wheel.unlink()
    return folder / name / name / "content"


def libraries():
    """The folder with the libraries of the installed package vtk."""
    package = importlib.util.find_spec("vtkmodules")
    if package is None:
        sys.exit("vtk_sdk.py: this Python has no vtk; install vtk>=9.5,<9.6.")
    folder = Path(package.origin).parent
    if not (folder / "libvtkCommonCore.so").exists():
        sys.exit(f"vtk_sdk.py: {folder} is no VTK from a wheel for Linux; install vtk from PyPI.")
    return folder


def adapt(text, library_folder, tools):
    """The CMake package for the libraries of Linux and the programs of cvista-sdk."""
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    text = re.sub(r"\$\{_IMPORT_PREFIX\}/build/[^/\"]*/vtkmodules/\.dylibs/(lib[\w.]*?)\.dylib",
                  rf"{library_folder}/\1.so", text)
    text = re.sub(r"@rpath/(lib[\w.]*?)\.dylib", r"\1.so", text)
    text = re.sub(r"(libvtkWrappingPythonCore)3\.\d+", rf"\g<1>{python}", text)
    text = re.sub(r"\$\{_IMPORT_PREFIX\}/bin/(vtkWrap(?:Python|PythonInit|Hierarchy))\"",
                  rf'{tools}/bin/\1-cvista"', text)
    text = text.replace(";-framework Cocoa", "")
    # Programs and plugins that are not used here, and not in the wheel of Linux.
    return re.sub(r"^list\(APPEND _cmake_import_check_files_for_.*\)$", "", text, flags=re.M)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="where the kit goes; kept if it is there")
    folder = parser.parse_args().folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    library_folder = libraries()
    tools = download(*TOOLS, folder)
    for program in (tools / "bin").iterdir():
        program.chmod(0o755)
    source = download(*SDK, folder)
    [headers] = source.glob("vtk-*.data/headers")
    package = headers / "cmake"
    original = headers / "cmake.original"
    if not original.exists():
        shutil.copytree(package, original)
    for name in ("VTK-targets.cmake", "VTK-targets-release.cmake"):
        (package / name).write_text(
            adapt((original / name).read_text(), library_folder, tools))
    config = next(headers.glob("vtk-*/vtkRenderingOpenGLConfigure.h"))
    config.write_text(
        config.read_text()
        .replace("#define VTK_USE_COCOA", "/* #undef VTK_USE_COCOA */")
        .replace("/* #undef VTK_USE_X */", "#define VTK_USE_X")
        .replace("/* #undef VTK_OPENGL_HAS_EGL */", "#define VTK_OPENGL_HAS_EGL"))
    shutil.copy(Path(__file__).with_name("vtkPythonTypeAccess.h"), config.parent)
    print(package)


if __name__ == "__main__":
    main()
