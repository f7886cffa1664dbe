#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Turn TotalSegmentator's example CT scan into torso_ct.npz.

    pip download --no-deps --no-binary :all: totalsegmentator==2.18.0
    python3 convert_ct.py totalsegmentator-2.18.0.tar.gz

Needs numpy and VTK's Python modules. The scan has 122 x 101 x 112 voxels of 3 mm. It is kept in
steps of 8 Hounsfield units from -1024 to 1016: HU = 8 value - 1024.
"""

import argparse
import os
import tarfile
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

MEMBER = "tests/reference_files/example_ct.nii.gz"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("package", help="totalsegmentator-2.18.0.tar.gz")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, tarfile.open(options.package) as tar:
        root = tar.getnames()[0].split("/")[0]
        path = os.path.join(folder, "ct.nii.gz")
        with open(path, "wb") as file:
            file.write(tar.extractfile(f"{root}/{MEMBER}").read())
        reader = vtkNIFTIImageReader()
        reader.SetFileName(path)
        reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    units = values * reader.GetRescaleSlope() + reader.GetRescaleIntercept()
    stored = np.clip(np.round((units + 1024) / 8), 0, 255).astype(np.uint8)
    here = os.path.dirname(os.path.abspath(__file__))
    np.savez_compressed(os.path.join(here, "torso_ct.npz"), values=stored, spacing=3.0)
    print(f"{stored.shape[::-1]} voxels, {units.min():.0f} to {units.max():.0f} HU")


if __name__ == "__main__":
    main()
