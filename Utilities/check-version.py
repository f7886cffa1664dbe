#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the version is written once, in project() of CMakeLists.txt.

Usage: Utilities/check-version.py

Everything else derives it: the library, the Debian packages, the wheel, the ParaView plugin and
--version. Fails with a list of lines that set a version of their own, and of file and package names
with another version. Release notes and the changelog, which speak of the past, and the test of this
script, which has faults, are left out.
"""

import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
LEFT_OUT = ("Documentation/release/", "CHANGELOG.md", "Testing/Python/TestReleases.py")
TEXT = (".md", ".txt", ".cmake", ".in", ".py", ".toml", ".cfg", ".sh", ".yml", ".yaml", ".json",
        ".h", ".cxx", ".xml", ".module", ".plugin", ".rst")
# Lines that give Airlight a version.
SETS = re.compile(r"""^\ +VERSION\ +"?\d+\.\d+ | ^project\(\S+\ +VERSION\ +\d
                  | (?<!\.)__version__\ *=\ *["']\d | ^version\ *=\ *["']\d
                  | AIRLIGHT_VERSION\w*["']?\ *[=\s]\ *["']?\d
                  | [Aa]irlight\w*_VERSION\w*\ +"?\d""", re.VERBOSE)
# Names of files and packages that contain it.
NAMES = re.compile(r"(?:libvtkairlight|libvtkAirlight\.so\.|\bairlight[-=]{1,2})(\d+(?:\.\d+)+)")


def read_version(root):
    lines = (root / "CMakeLists.txt").read_text(encoding="utf-8").splitlines()
    found = [(number, line.split()[1]) for number, line in enumerate(lines, 1)
             if re.fullmatch(r"  VERSION \d+\.\d+\.\d+", line)]
    if len(found) != 1:
        sys.exit(f"error: CMakeLists.txt has {len(found)} lines '  VERSION x.y.z', not one")
    return found[0]


def find_strays(root, names):
    place, version = read_version(root)
    for name in names:
        if name.startswith(LEFT_OUT) or not name.endswith(TEXT):
            continue
        lines = (root / name).read_text(encoding="utf-8", errors="replace").splitlines()
        for number, line in enumerate(lines, 1):
            if SETS.search(line) and (name, number) != ("CMakeLists.txt", place):
                yield f"{name}:{number}: sets a version: {line.strip()}"
            for found in NAMES.findall(line):
                if found not in (version, version.rsplit(".", 1)[0]):
                    yield f"{name}:{number}: names version {found}, but it is {version}"


def list_files(root):
    done = subprocess.run(["git", "ls-files"], cwd=root, text=True, check=True,
                          stdout=subprocess.PIPE)
    return [name for name in done.stdout.splitlines() if (root / name).is_file()]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help=argparse.SUPPRESS)
    parser.add_argument("files", nargs="*", help="default: those that Git has")
    options = parser.parse_args()
    strays = list(find_strays(options.root, options.files or list_files(options.root)))
    print(*strays, sep="\n", end="\n" if strays else "")
    return 1 if strays else 0


if __name__ == "__main__":
    sys.exit(main())
