# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkAirlightComparison against the judge of the reference scenes, compare.py."""

import pathlib
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import airlight

REFERENCE = pathlib.Path(__file__).resolve().parents[1] / "Data" / "Reference"
sys.path.insert(0, str(REFERENCE))
from compare import metrics, read_pfm  # noqa: E402


def make_image(pixels):
    """A vtkImageData of an array [height, width, channels] whose row 0 is the top."""
    height, width, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(pixels[::-1]).reshape(-1, channels)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return image


def compare(a, b, mask=None):
    comparison = airlight.vtkAirlightComparison()
    comparison.SetImageData(make_image(a))
    comparison.SetReferenceData(make_image(b))
    if mask is not None:
        comparison.SetMaskData(make_image(mask))
    comparison.SkipNonFiniteOn()
    comparison.Update()
    return comparison


class TestAirlightComparison(unittest.TestCase):
    def check(self, a, b, mask=None):
        comparison = compare(a, b, mask)
        table = comparison.GetMetrics()
        expected = metrics(a.astype(float), b.astype(float), mask)
        names = [table.GetColumnName(i) for i in range(table.GetNumberOfColumns())]
        self.assertEqual(names, list(expected) + ["PSNR"])
        for name, value in expected.items():
            self.assertLessEqual(abs(table.GetValueByName(0, name).ToDouble() - value),
                                 1e-9 * abs(value), name)
        counts = np.isfinite(a).all(-1) & (True if mask is None else mask[..., 0] > 0.5)
        error = (a[counts].astype(float) - b[counts].astype(float))
        psnr = 10 * np.log10(float(b[counts].max())**2 / (error**2).mean())
        self.assertAlmostEqual(table.GetValueByName(0, "PSNR").ToDouble(), psnr, 9)
        difference = vtk_to_numpy(comparison.GetDifference().GetPointData().GetScalars())
        difference = difference.reshape(a.shape)[::-1]
        np.testing.assert_allclose(difference[counts], error, rtol=1e-6, atol=1e-6)
        self.assertFalse(difference[~counts].any())

    def test_reference_scene(self):
        total = read_pfm(REFERENCE / "ref" / "S3_ground_occluders.total.pfm")
        mask = read_pfm(REFERENCE / "ref" / "S3_ground_occluders.shadowmask.pfm")
        random = np.random.default_rng(1)
        noisy = total * random.normal(1.01, 0.05, total.shape) + 1e-4
        broken = noisy.copy()
        broken[3, 4, 1] = np.nan
        broken[70:72, 80] = np.inf
        for a in (noisy, broken):
            self.check(a, total)
            self.check(a, total, mask)
            self.check(a.astype(np.float32), total.astype(np.float32), mask)

    def test_grey_bytes(self):
        random = np.random.default_rng(2)
        a, b = random.integers(0, 256, (2, 7, 5, 1), dtype=np.uint8)
        self.check(a, b)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
