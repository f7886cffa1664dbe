#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write jacksboro_elevation.npz from matplotlib's sample data.

Usage: convert_elevation.py jacksboro_fault_dem.npz
"""

import pathlib
import sys

import numpy as np


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    elevation = np.load(sys.argv[1])["elevation"].astype(np.int16)
    print(f"{elevation.shape[1]} x {elevation.shape[0]} heights from {elevation.min()} to "
          f"{elevation.max()} m")
    np.savez_compressed(pathlib.Path(__file__).parent / "jacksboro_elevation.npz",
                        elevation=elevation)


if __name__ == "__main__":
    main()
