# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Output of FDS as smoke: a Plot3D file written here, of the layout that FDS writes, and a VTKHDF
file, through VTK's readers, vtkAirlightDensityImage and the filter that gives visibility;
airlight.density_image() and its errors."""

import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid

import airlight

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"
SIZE = (9, 7, 6)  # points
SPACING = (0.5, 0.5, 0.4)  # m


def record(data):
    """Fortran's unformatted record: its length before and after it."""
    return struct.pack("<i", len(data)) + data + struct.pack("<i", len(data))


def write_plot3d(folder, quantities):
    """name.xyz and name.q of one mesh, as FDS: nodes, no blanking, five quantities, x fastest."""
    header = record(struct.pack("<3i", *SIZE))
    places = np.meshgrid(*(np.arange(n) * h for n, h in zip(SIZE, SPACING)), indexing="ij")
    places = np.concatenate([place.ravel(order="F") for place in places]).astype("<f4")
    blanks = np.ones(np.prod(SIZE), "<i4")
    path = pathlib.Path(folder)
    (path / "fire.xyz").write_bytes(header + record(places.tobytes() + blanks.tobytes()))
    values = np.concatenate([q.ravel(order="F") for q in quantities]).astype("<f4")
    (path / "fire.q").write_bytes(
        header + record(struct.pack("<4f", 0, 0, 0, 0)) + record(values.tobytes()))
    return str(path / "fire.q")


def write_vtkhdf(folder, name, values):
    """name.vtkhdf: an image of point data, version 1.0 of VTK's file format."""
    path = str(pathlib.Path(folder) / "fire.vtkhdf")
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF", track_order=True)
        root.attrs["Version"] = (1, 0)
        root.attrs.create("Type", b"ImageData", dtype=h5py.string_dtype("ascii", len("ImageData")))
        root.attrs["WholeExtent"] = [i for n in SIZE for i in (0, n - 1)]
        root.attrs["Origin"] = (0.0, 0.0, 0.0)
        root.attrs["Spacing"] = SPACING
        root.attrs["Direction"] = np.eye(3).ravel()
        points = root.create_group("PointData")
        points.attrs.create("Scalars", name.encode(),
                            dtype=h5py.string_dtype("ascii", len(name)))
        points.create_dataset(name, data=values.transpose().astype("<f4"))  # x fastest
    return path


def make_soot():
    """kg/m^3 at the nodes, linear along each axis, so that interpolation is exact."""
    x, y, z = np.meshgrid(*(np.arange(n) * h for n, h in zip(SIZE, SPACING)), indexing="ij")
    return (1 + 0.5 * x + 0.25 * y + z) * 1e-5


class TestFireResults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(EXAMPLES))
        cls.addClassCleanup(sys.path.remove, str(EXAMPLES))

    def read(self, component):
        """The image of soot from a Plot3D file in which it is one of five quantities."""
        from fire_smoke import read_results
        soot = make_soot()
        quantities = [np.full(SIZE, 20.0) for _ in range(5)]
        quantities[component] = soot
        with tempfile.TemporaryDirectory() as folder:
            data = read_results(write_plot3d(folder, quantities))
        array = ("Density", "Momentum", "Momentum", "Momentum", "StagnationEnergy")[component]
        number = component - 1 if array == "Momentum" else None
        return airlight.density_image(data, array, SIZE, number, 8700)

    def test_plot3d(self):
        for component in range(5):
            image = self.read(component)
            self.assertEqual(image.GetDimensions(), SIZE)
            np.testing.assert_allclose(image.GetSpacing(), SPACING, rtol=1e-6)
            values = vtk_to_numpy(image.GetPointData().GetScalars())
            np.testing.assert_allclose(values, 8700 * make_soot().ravel(order="F"), rtol=1e-5)

    def test_vtkhdf(self):
        from fire_smoke import read_results
        with tempfile.TemporaryDirectory() as folder:
            data = read_results(write_vtkhdf(folder, "SOOT DENSITY", make_soot()))
        image = airlight.density_image(data, "SOOT DENSITY", factor=8700)
        self.assertEqual(image.GetDimensions(), SIZE)
        np.testing.assert_allclose(image.GetSpacing(), SPACING)
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        np.testing.assert_allclose(values, 8700 * make_soot().ravel(order="F"), rtol=1e-6)

    def test_visibility(self):
        """8 over the mean of a linear extinction, which is that in the middle of the line."""
        smoke = airlight.vtkParticipatingMedium()
        smoke.SetDensityImage(self.read(0))
        smoke.SetDensityToImage()
        smoke.SetAbsorption(1, 1, 1)
        points = vtkPoints()
        points.InsertNextPoint(3.5, 2.5, 1.5)
        sign = vtkPolyData()
        sign.SetPoints(points)
        probe = airlight.vtkAirlightProbeFilter()
        probe.SetInputData(sign)
        probe.SetMedium(smoke)
        probe.SetViewpoint(0.5, 0.5, 0.5)
        probe.SightLinesOn()
        probe.Update()
        extinction = 8700e-5 * (1 + 0.5 * 2 + 0.25 * 1.5 + 1)
        found = probe.GetOutput().GetPointData().GetArray("EmittingSignVisibility").GetTuple1(0)
        self.assertAlmostEqual(found, 8 / extinction, delta=1e-4 * 8 / extinction)

    def test_example(self):
        """The example draws its map from such a file; a soot of 0 is clear air."""
        with tempfile.TemporaryDirectory() as folder:
            path = write_plot3d(folder, [make_soot()] + 4 * [np.zeros(SIZE)])
            done = subprocess.run(
                [sys.executable, EXAMPLES / "fire_visibility.py", "--data", path, "--array",
                 "Density", "--dimensions", "9", "7", "6", "--step", "2", "-o", folder + "/m.png"],
                check=False, capture_output=True, text=True, timeout=120)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("points have the sign in sight", done.stdout)
            self.assertTrue((pathlib.Path(folder) / "m.png").stat().st_size > 1000)

    def test_other_file(self):
        from fire_smoke import read_results
        with self.assertRaisesRegex(ValueError, "'fire.s3d' is neither"):
            read_results("fire.s3d")


class TestDensityImage(unittest.TestCase):
    def make_image(self, values):
        image = vtkImageData()
        image.SetDimensions(2, 2, 2)
        array = numpy_to_vtk(np.array(values, float), deep=True)
        array.SetName("soot")
        image.GetPointData().AddArray(array)
        return image

    def test_image(self):
        image = airlight.density_image(self.make_image(range(8)), "soot")
        self.assertEqual(image.GetPointData().GetScalars().GetTuple1(5), 5)

    def test_components(self):
        source = self.make_image(np.arange(16).reshape(8, 2))
        source.GetPointData().GetArray(0).SetComponentName(1, "smoke")
        for component in (1, "smoke"):
            image = airlight.density_image(source, "soot", component=component, factor=2)
            self.assertEqual(image.GetPointData().GetScalars().GetTuple1(3), 14)

    def test_errors(self):
        for values, text in ((7 * [1.0] + [np.nan], "the value nan at point 7"),
                             (7 * [1.0] + [-1.0], "the value -1 at point 7"),
                             (np.ones((8, 3)), "3 components")):
            with self.assertRaisesRegex(ValueError, "^The input has .*" + text):
                airlight.density_image(self.make_image(values), "soot")
        for options, text in (({"array": "dust"}, "no array 'dust'"),
                              ({"array": "soot", "dimensions": (1, 2, 3)}, r"^Dimensions \(1, 2, 3"),
                              ({"array": "soot", "factor": -1.0}, "^Factor -1 must be")):
            with self.assertRaisesRegex(ValueError, text):
                airlight.density_image(self.make_image(8 * [1.0]), **options)
        with self.assertRaisesRegex(ValueError, "no cells"):
            airlight.density_image(vtkUnstructuredGrid())


if __name__ == "__main__":
    unittest.main(argv=[__file__])
