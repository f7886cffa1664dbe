#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles the library's sources with the headers of VTK 9.7, and makes nothing.

The folder is that of the wheel's build. Its kit, made by vtk_sdk.py, has those headers beside the ones
of the wheel's VTK: from cvista-sdk, whose libraries have other names and are for other Pythons.
A function that VTK calls deprecated is an error here, so that the next version finds none.
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def include_folder(kit, package):
    """The folder vtk-9.x with the headers of a package of the kit."""
    [folder] = kit.glob(f"{package}/{package}/content/vtk-*.data/headers/vtk-*")
    return str(folder)


def library_commands(build):
    """The compiler's commands for the library, without those for Python's classes."""
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    return [shlex.split(command["command"]) for command in commands
            if "/Airlight.dir/" in command["file"] + command["command"]]


def check(command, current, following):
    """Compiles a file with the other headers; returns whether it can."""
    output = command.index("-o")
    command = [word.replace(current, following)
               for word in command[:output] + command[output + 2:]]
    return subprocess.run([*command, "-fsyntax-only", "-Werror=deprecated-declarations"],
                          check=False).returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path, help="the folder of the wheel's build")
    build = parser.parse_args().build.resolve()
    current, following = (include_folder(build / "vtk_sdk", package)
                          for package in ("vtk_sdk", "cvista_sdk"))
    commands = library_commands(build)
    if not commands or not all(any(current in word for word in command) for command in commands):
        sys.exit(f"check_next_vtk.py: {build} has no commands that name {current}; run"
                 " Utilities/wheel.sh --build.")
    os.chdir(build)
    with ThreadPoolExecutor(int(os.environ.get("AIRLIGHT_JOBS", os.cpu_count()))) as pool:
        passed = list(pool.map(lambda command: check(command, current, following), commands))
    print(f"{sum(passed)} of {len(passed)} groups of files compile with the headers of"
          f" {Path(following).name}")
    return not all(passed)


if __name__ == "__main__":
    sys.exit(main())
