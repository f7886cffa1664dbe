# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The filters from ParaView's server manager, against numbers from derivations."""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import paraviewtest as test

WRITE = os.environ.get("AIRLIGHT_WRITE_OPENVDB")


def fetch(source, port=0):
    source.UpdatePipeline()
    return servermanager.Fetch(source, idx=port)


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def set_medium(source, scattering, absorption):
    source.Thickness = "Coefficients"
    source.Scattering = [scattering] * 3
    source.Absorption = [absorption] * 3


class Filters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        test.load_plugin()

    def test_silhouette_edges(self):
        """A square plate seen at an angle has its four sides as silhouette."""
        plate = simple.Plane(XResolution=4, YResolution=4)
        edges = fetch(simple.SilhouetteEdges(Input=plate, LightPosition=[0.3, 0.2, 2.0]))
        points = vtk_to_numpy(edges.GetPoints().GetData())
        ends = [[edges.GetCell(i).GetPointId(k) for k in (0, 1)]
                for i in range(edges.GetNumberOfCells())]
        self.assertEqual(len(ends), 4 * 4)
        np.testing.assert_allclose(np.abs(points[ends]).max(axis=-1), 0.5, atol=1e-7)

    def test_shadow_planes(self):
        """The shadow's border below a plate is the plate, magnified."""
        plate = simple.Plane()
        planes = simple.ShadowPlanes(Input=plate, LightPosition=[0, 0, 1])
        planes.Extent = "Bounds"
        planes.Bounds = [-10, 10, -10, 10, -3, 1]
        data = fetch(planes)
        self.assertEqual(data.GetNumberOfCells(), 4)
        points = vtk_to_numpy(data.GetPoints().GetData())
        low = points[np.isclose(points[:, 2], -3)]
        # The lamp is 1 above the plate of half width 0.5, the bottom 4 below it.
        np.testing.assert_allclose(np.abs(low[:, :2]), 0.5 * 4, rtol=1e-6)
        self.assertEqual(len(low), 8)
        # Each cap is a part of its own: the plate, and the shadow's end in the bottom of the box.
        for name, part, height, area in (("LightCap", 1, 0, 1), ("FarCap", 2, -3, 4 * 4)):
            planes.SetPropertyWithName(name, 1)
            data = fetch(planes)
            planes.SetPropertyWithName(name, 0)
            parts = cell_array(data, "Part")
            self.assertEqual(set(parts), {0, part}, name)
            corners = [vtk_to_numpy(data.GetCell(i).GetPoints().GetData()).copy()
                       for i in np.flatnonzero(parts == part)]
            np.testing.assert_allclose(np.concatenate(corners)[:, 2], height, atol=1e-6)
            areas = [abs(x @ np.roll(y, 1) - y @ np.roll(x, 1)) / 2 for x, y, _ in
                     (points.T for points in corners)]
            np.testing.assert_allclose(sum(areas), area, rtol=1e-6)

    def test_lit_intervals(self):
        """A line under a lamp and a plate: what is lit, and the airlight by the midpoint rule."""
        line = simple.Line(Point1=[-4, 0, 0], Point2=[4, 0, 0], Resolution=1)
        plate = simple.Plane(Origin=[-0.5, 1, -0.5], Point1=[0.5, 1, -0.5], Point2=[-0.5, 1, 0.5])
        found = simple.LitIntervals(Input=line, Occluders=[plate])
        found.LampPosition = [0, 2, 0]
        found.LampColor = [1, 0.5, 0.25]
        found.LampIntensity = 2.0
        set_medium(found, 0.2, 0.05)
        data = fetch(found)
        self.assertEqual(data.GetNumberOfCells(), 2)
        # The plate is half as far from the lamp as the line: its shadow is from -1 to 1.
        np.testing.assert_allclose(cell_array(data, "Start"), [0, 5], atol=1e-9)
        np.testing.assert_allclose(cell_array(data, "End"), [3, 8], atol=1e-9)
        np.testing.assert_allclose(cell_array(data, "Length"), [3, 3], atol=1e-9)
        # Times 4 pi, of the cosine mu of the scattering angle. The first two have no anisotropy.
        k = found.Anisotropy = 0.5
        phases = {"Isotropic": lambda mu: 1,
                  "Rayleigh": lambda mu: 0.75 * (1 + mu**2),
                  "Schlick": lambda mu: (1 - k**2) / (1 - k * mu)**2}
        for name, phase in phases.items():
            found.PhaseFunction = name
            airlight = cell_array(fetch(found), "Airlight")
            for part, start in enumerate((0, 5)):
                t = start + 3 * (np.arange(20000) + 0.5) / 20000
                r = np.hypot(t - 4, 2)
                # I = pi colour intensity, of which 1/(4 pi) times the phase goes to the eye.
                sent = phase((4 - t) / r) * np.exp(-0.25 * (t + r)) / r**2
                expected = 0.2 / 4 * sent.mean() * 3 * 2 * np.array([1, 0.5, 0.25])
                np.testing.assert_allclose(airlight[part], expected, rtol=1e-4, err_msg=name)
        # Without the occluder all is lit.
        found.Occluders = []
        self.assertEqual(fetch(found).GetNumberOfCells(), 1)

    def test_probe(self):
        """Irradiance and transmittance of points below a lamp, one of them in a plate's shadow."""
        line = simple.Line(Point1=[0, 0, 0], Point2=[4, 0, 0], Resolution=4)
        plate = simple.Plane(Origin=[-0.4, 1, -0.4], Point1=[0.4, 1, -0.4], Point2=[-0.4, 1, 0.4])
        probe = simple.AirlightProbe(Input=line, Occluders=[plate])
        probe.Viewpoint = [2, 0, 3]
        probe.LampPosition = [0, 2, 0]
        set_medium(probe, 0.1, 0.1)
        data = fetch(probe)
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        r = np.linalg.norm(points - (0, 2, 0), axis=1)
        expected = np.pi / r**2 * np.exp(-0.2 * r)
        expected[0] = 0  # right below the plate
        array = vtk_to_numpy(data.GetPointData().GetArray("DirectIrradiance"))
        np.testing.assert_allclose(array[:, 0], expected, rtol=1e-6)
        way = np.linalg.norm(points - (2, 0, 3), axis=1)
        array = vtk_to_numpy(data.GetPointData().GetArray("Transmittance"))
        np.testing.assert_allclose(array[:, 2], np.exp(-0.2 * way), rtol=1e-9)
        # The anisotropy waits until the phase function has one.
        probe.PhaseFunction = "Isotropic"
        probe.Anisotropy = 0.5
        isotropic = vtk_to_numpy(fetch(probe).GetPointData().GetArray("Radiance")).copy()
        probe.PhaseFunction = "Henyey-Greenstein"
        forward = vtk_to_numpy(fetch(probe).GetPointData().GetArray("Radiance"))
        self.assertGreater(np.abs(forward / isotropic - 1).max(), 0.05)

    def test_linked_with_a_view(self):
        """A filter's lamp and medium follow those of a light and a view by property links."""
        view = simple.CreateView("AirlightRenderView")
        lamp = test.add_lamp(view)
        probe = simple.AirlightProbe(Input=simple.Line(Point1=[0, 0, 0], Point2=[4, 0, 0]))
        for source, name, target, copy in (
                (view, "Thickness", probe, "Thickness"), (view, "Scattering", probe, "Scattering"),
                (view, "Absorption", probe, "Absorption"),
                (lamp, "LightPosition", probe, "LampPosition")):
            link = servermanager.vtkSMPropertyLink()
            link.AddLinkedProperty(source.SMProxy, name, 1)
            link.AddLinkedProperty(target.SMProxy, copy, 2)
            servermanager.ProxyManager().RegisterLink(f"{name}-{copy}", link)
        view.Thickness = "Coefficients"
        view.Scattering = [0.2, 0.2, 0.2]
        view.Absorption = [0.1, 0.1, 0.1]
        lamp.Position = [0, 3, 0]
        data = fetch(probe)
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        r = np.linalg.norm(points - (0, 3, 0), axis=1)
        array = vtk_to_numpy(data.GetPointData().GetArray("DirectIrradiance"))
        np.testing.assert_allclose(array[:, 0], np.pi / r**2 * np.exp(-0.3 * r), rtol=1e-6)
        simple.Delete(view)

    def test_comparison(self):
        """Two images of which one is 1 % brighter everywhere."""
        image = simple.Wavelet(WholeExtent=[0, 7, 0, 7, 0, 0])
        brighter = simple.Calculator(Input=image, ResultArrayName="RTData",
                                     Function="1.01*RTData")
        found = simple.AirlightComparison(Input=brighter, Reference=image)
        table = fetch(found, 0)
        column = table.GetColumnByName("bias")
        # The mean difference as a share of the reference's mean.
        self.assertAlmostEqual(column.GetTuple1(0), 0.01, delta=1e-5)
        difference = vtk_to_numpy(fetch(found, 1).GetPointData().GetScalars())
        data = vtk_to_numpy(fetch(image).GetPointData().GetScalars())
        np.testing.assert_allclose(difference.ravel(), 0.01 * data.ravel(), rtol=1e-3)

    @unittest.skipUnless(WRITE, "built without OpenVDB")
    def test_density_reader(self):
        """A file that ParaView opens by its name: a ball of fog, its sum, and its place."""
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([WRITE, folder + "/"], check=True, timeout=60)
            reader = simple.OpenDataFile(folder + "/types.vdb")
            self.assertEqual(reader.GetXMLName(), "OpenVDBDensityReader")
            reader.GridName = "fog"
            image = fetch(reader)
        values = vtk_to_numpy(image.GetPointData().GetArray("fog"))
        # The volumes of balls, 4/3 pi r^3, averaged over the radii 1.2 to 1.5 between which the fog rises.
        expected = np.pi / 3 * (1.5**4 - 1.2**4) / 0.3
        self.assertAlmostEqual(values.sum() * 0.1**3 / expected, 1, delta=2e-3)
        self.assertEqual(values[image.FindPoint(1, 2, 3)], 1)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
