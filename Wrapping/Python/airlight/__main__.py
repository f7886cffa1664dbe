# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m airlight: says what the package is, or its version."""

import argparse

from vtkmodules.vtkCommonCore import vtkVersion

import airlight


def main():
    parser = argparse.ArgumentParser(
        prog="python3 -m airlight", description="Prints help(airlight) in short.")
    parser.add_argument(
        "--version", action="version",
        version=f"airlight {airlight.__version__}, VTK {vtkVersion.GetVTKVersion()}")
    parser.parse_args()
    print(airlight.__doc__)


if __name__ == "__main__":
    main()
