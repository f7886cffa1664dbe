# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What casts shadows through the medium and what does not, as the README lists it.

A lamp above a prop, and the air below it: whether the airlight there is that without shadows, to the
last bit.
"""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPiecewiseFunction, vtkPolyData)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkAssembly, vtkColorTransferFunction, vtkGlyph3DMapper, vtkLight, vtkLODProp3D,
    vtkPointGaussianMapper, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume,
    vtkVolumeProperty)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401 draws volumes

import airlight

try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as BlocksMapper
except ImportError:  # from VTK 9.5 on
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as BlocksMapper

PLACE = (0.0, 1.2, 0.0)


def make_sphere():
    source = vtkSphereSource()
    source.SetCenter(PLACE)
    source.SetThetaResolution(16)
    source.SetPhiResolution(16)
    return source


def make_mapper(source=None):
    mapper = vtkPolyDataMapper()
    source = source or make_sphere()
    mapper.SetInputConnection(source.GetOutputPort())
    return mapper


def make_actor(mapper=None):
    actor = vtkActor()
    actor.SetMapper(mapper or make_mapper())
    return actor


def make_point():
    points = vtkPoints()
    points.InsertNextPoint(PLACE)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def make_wireframe():
    actor = make_actor()
    actor.GetProperty().SetRepresentationToWireframe()
    return actor


def make_points():
    actor = make_actor()
    actor.GetProperty().SetRepresentationToPoints()
    actor.GetProperty().SetPointSize(9)
    return actor


def make_lines(tubes=False):
    source = vtkLineSource()
    source.SetPoint1(-1, PLACE[1], 0)
    source.SetPoint2(1, PLACE[1], 0)
    actor = make_actor(make_mapper(source))
    actor.GetProperty().SetLineWidth(9)
    actor.GetProperty().SetRenderLinesAsTubes(tubes)
    return actor


def make_volume():
    image = vtkImageData()
    image.SetDimensions(5, 5, 5)
    image.SetSpacing(0.25, 0.25, 0.25)
    image.SetOrigin(-0.5, PLACE[1] - 0.5, -0.5)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ones(125, np.float32), deep=True))
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 1)
    opacity.AddPoint(2, 1)
    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(1, 1, 1, 1)
    properties = vtkVolumeProperty()
    properties.SetScalarOpacity(opacity)
    properties.SetColor(colour)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(properties)
    return volume


def make_lod_prop():
    prop = vtkLODProp3D()
    prop.AddLOD(make_mapper(), 0.0)
    return prop


def make_splat():
    mapper = vtkPointGaussianMapper()
    mapper.SetInputData(make_point())
    mapper.SetScaleFactor(0.4)
    mapper.EmissiveOff()
    return make_actor(mapper)


def make_glyphs(table=False):
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(make_point())
    source = vtkSphereSource()
    source.SetRadius(0.5)
    mapper.SetSourceConnection(source.GetOutputPort())
    if table:
        source.Update()
        tree = vtkMultiBlockDataSet()
        tree.SetBlock(0, source.GetOutput())
        mapper.SetSourceTableTree(tree)
        mapper.UseSourceTableTreeOn()
    mapper.OrientOff()
    mapper.ScalingOff()
    return make_actor(mapper)


def make_assembly(part):
    assembly = vtkAssembly()
    assembly.AddPart(part)
    return assembly


def make_composite():
    source = make_sphere()
    source.Update()
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, source.GetOutput())
    mapper = BlocksMapper()
    mapper.SetInputDataObject(blocks)
    return make_actor(mapper)


def make_transformed():
    actor = make_actor()
    turn = vtkTransform()
    turn.Scale(-1, 1, 2)
    actor.SetUserTransform(turn)
    return actor


def make_flipped():
    source = make_sphere()
    flipped = vtkReverseSense()
    flipped.SetInputConnection(source.GetOutputPort())
    flipped.ReverseCellsOn()
    return make_actor(make_mapper(flipped))


def make_open():
    source = make_sphere()
    source.SetEndPhi(90)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort())
    return make_actor(make_mapper(normals))


def make_translucent():
    actor = make_actor()
    actor.GetProperty().SetOpacity(0.5)
    return actor


def make_coloured_glass():
    """Translucent by its colours alone."""
    source = make_sphere()
    source.Update()
    data = source.GetOutput()
    colours = np.full((data.GetNumberOfPoints(), 4), 128, np.uint8)
    data.GetPointData().SetScalars(numpy_to_vtk(colours, deep=True))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    return make_actor(mapper)


class TestCasters(unittest.TestCase):
    def draw(self, prop, technique):
        renderer = vtkRenderer()
        renderer.AutomaticLightCreationOff()
        renderer.AddViewProp(prop)
        lamp = vtkLight()
        airlight.vtkAirlight.SetRadiantIntensity(lamp, (20, 20, 20))
        lamp.SetPosition(0, 4, 0)
        renderer.AddLight(lamp)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 8)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetClippingRange(0.1, 100)
        fog = airlight.vtkParticipatingMedium()
        fog.SetScattering(0.1, 0.1, 0.1)
        fog_pass = airlight.vtkAirlightPass()
        fog_pass.SetMedium(fog)
        fog_pass.SetShadowTechnique(technique)
        fog_pass.RecordBuffersOn()
        renderer.SetPass(fog_pass)
        window = vtkRenderWindow()
        window.OffScreenRenderingOn()
        window.SetSize(48, 36)
        window.AddRenderer(renderer)
        window.Render()
        values = vtk_to_numpy(fog_pass.GetBuffer("Airlight").GetPointData().GetScalars()).copy()
        window.Finalize()
        # Below the prop.
        return values.reshape(36, 48, 3)[:15]

    def check(self, make, technique, casts):
        shadowed = self.draw(make(), technique)
        plain = self.draw(make(), airlight.vtkAirlightPass.NONE)
        self.assertGreater(plain.min(), 0)
        if casts:
            self.assertLess((shadowed / plain).min(), 0.95)
        else:
            np.testing.assert_array_equal(shadowed, plain)

    def test_cast(self):
        for make in (make_actor, make_transformed, make_flipped, make_open, make_composite,
                     make_translucent, make_coloured_glass, make_glyphs, make_lod_prop,
                     lambda: make_assembly(make_actor())):
            with self.subTest(make=make.__name__):
                self.check(make, airlight.vtkAirlightPass.SHADOW_PLANES, True)

    def test_coloured_glass(self):
        """Casts as glass of the same opacity; not in maps, which know of light and dark only."""
        glass = make_coloured_glass()
        technique = airlight.vtkAirlightPass.SHADOW_PLANES
        by_colours = self.draw(glass, technique)
        glass.GetMapper().ScalarVisibilityOff()
        glass.GetProperty().SetOpacity(128 / 255)
        np.testing.assert_allclose(by_colours, self.draw(glass, technique), rtol=1e-5)
        self.check(make_coloured_glass, airlight.vtkAirlightPass.SHADOW_MAP, False)

    def test_cast_nothing(self):
        for make in (make_volume, make_lines, lambda: make_lines(True), make_points,
                     make_wireframe):
            for technique in (airlight.vtkAirlightPass.SHADOW_PLANES,
                              airlight.vtkAirlightPass.SHADOW_MAP):
                with self.subTest(make=make.__name__, technique=technique):
                    self.check(make, technique, False)

    def test_cast_in_maps(self):
        for make in (make_splat, lambda: make_glyphs(True), lambda: make_assembly(make_splat())):
            with self.subTest(make=make.__name__):
                self.check(make, airlight.vtkAirlightPass.SHADOW_PLANES, False)
                self.check(make, airlight.vtkAirlightPass.SHADOW_MAP, True)
                self.check(make, airlight.vtkAirlightPass.AUTOMATIC, True)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
