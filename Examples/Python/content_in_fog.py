#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Many kinds of VTK content in the same fog and the same light.

    content_in_fog.py FOLDER [NAME ...]

Writes FOLDER/content-NAME.png for each kind of content, or only for the named kinds.
Documentation/gallery.md shows the pictures. Each kind is one function below, which adds its props
to a renderer. Fog and light are the same for all kinds, and the props are not prepared for them.
"""

import math
import os
import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401 text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401 volumes
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIntArray, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPiecewiseFunction, vtkPlane, vtkPolyData, vtkSphere)
from vtkmodules.vtkFiltersCore import vtkElevationFilter, vtkTubeFilter
from vtkmodules.vtkFiltersSources import (
    vtkArrowSource, vtkConeSource, vtkCubeSource, vtkParametricFunctionSource, vtkPlaneSource,
    vtkPointSource, vtkSphereSource, vtkSuperquadricSource)
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricSpline
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor, vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkCompositePolyDataMapper, vtkGlyph3DMapper, vtkLight,
    vtkPointGaussianMapper, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkTexture, vtkVolume, vtkVolumeProperty, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

import airlight


def add(renderer, source, colour=(0.8, 0.45, 0.2), place=(0, 0, 0)):
    """Adds an actor with the output of the source."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    return add_mapper(renderer, mapper, colour, place)


def add_mapper(renderer, mapper, colour=(0.8, 0.45, 0.2), place=(0, 0, 0)):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(place)
    actor.GetProperty().SetColor(colour)
    renderer.AddActor(actor)
    return actor


def sphere(radius, resolution=48):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return source


def box(x, y, z):
    source = vtkCubeSource()
    source.SetXLength(x)
    source.SetYLength(y)
    source.SetZLength(z)
    return source


def square(origin, point1, point2):
    source = vtkPlaneSource()
    source.SetOrigin(origin)
    source.SetPoint1(point1)
    source.SetPoint2(point2)
    return source


# ---- The contents -------------------------------------------------------------------------------


def surfaces(renderer):
    """Flat, Gouraud and Phong shading."""
    for i in range(3):
        actor = add(renderer, sphere(0.6, 16), place=(1.6 * (i - 1), 1.2, 0))
        actor.GetProperty().SetInterpolation(i)
        actor.GetProperty().SetSpecular(0.6)
        actor.GetProperty().SetSpecularPower(30)


def physically_based(renderer):
    """Physically based materials: a dielectric, a rough and a smooth metal."""
    for i, (metallic, roughness) in enumerate([(0, 0.4), (1, 0.6), (1, 0.3)]):
        actor = add(renderer, sphere(0.6), place=(1.6 * (i - 1), 1.2, 0))
        actor.GetProperty().SetInterpolationToPBR()
        actor.GetProperty().SetMetallic(metallic)
        actor.GetProperty().SetRoughness(roughness)


def textured(renderer):
    """A texture."""
    canvas = vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetNumberOfScalarComponents(3)
    canvas.SetExtent(0, 255, 0, 255, 0, 0)
    for i in range(64):
        x, y = i % 8, i // 8
        canvas.SetDrawColor(*((230, 200, 120) if (x + y) % 2 else (40, 80, 160)))
        canvas.FillBox(32 * x, 32 * x + 31, 32 * y, 32 * y + 31)
    texture = vtkTexture()
    texture.SetInputConnection(canvas.GetOutputPort())
    texture.InterpolateOn()
    actor = add(renderer, square((-1.2, 0.3, -1.0), (1.0, 0.3, -1.8), (-1.2, 2.3, -1.4)), (1, 1, 1))
    actor.SetTexture(texture)


def scalars(renderer):
    """Scalars through a lookup table, with edges."""
    shape = vtkSuperquadricSource()
    shape.ToroidalOn()
    shape.SetSize(1.1)
    shape.SetThetaResolution(32)
    shape.SetPhiResolution(32)
    elevation = vtkElevationFilter()
    elevation.SetInputConnection(shape.GetOutputPort())
    elevation.SetLowPoint(0, -0.4, 0)
    elevation.SetHighPoint(0, 0.4, 0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(elevation.GetOutputPort())
    actor = add_mapper(renderer, mapper, place=(0, 1.2, 0))
    actor.RotateX(50)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.1, 0.1, 0.1)


def translucent(renderer):
    """Translucent surfaces in front of and behind an opaque one."""
    add(renderer, sphere(0.35), (0.9, 0.9, 0.9), (0, 1.2, 0))
    for i, colour in enumerate([(0.9, 0.2, 0.1), (0.1, 0.7, 0.2), (0.2, 0.3, 0.9)]):
        actor = add(renderer, sphere(0.8), colour, (0.8 * (i - 1), 1.2, 0.6 * (i - 1)))
        actor.GetProperty().SetOpacity(0.4)


def glyphs(renderer):
    """Glyphs of two sources; each casts a shadow."""
    points = vtkPolyData()
    points.SetPoints(vtkPoints())
    directions = vtkFloatArray()
    directions.SetName("directions")
    directions.SetNumberOfComponents(3)
    which = vtkIntArray()
    which.SetName("which")
    for i in range(21):
        x, y = i % 7 - 3, i // 7
        points.GetPoints().InsertNextPoint(0.7 * x, 0.5 + 0.75 * y, 0.2 * math.sin(i))
        directions.InsertNextTuple3(1, 0.5 * math.sin(x + y), 0.4 * math.cos(2 * x - y))
        which.InsertNextValue(i % 2)
    points.GetPointData().AddArray(directions)
    points.GetPointData().AddArray(which)
    arrow, cone = vtkArrowSource(), vtkConeSource()
    arrow.SetTipResolution(16)
    cone.SetResolution(16)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(points)
    mapper.SetSourceConnection(0, arrow.GetOutputPort())
    mapper.SetSourceConnection(1, cone.GetOutputPort())
    mapper.SetOrientationArray("directions")
    mapper.SetSourceIndexArray("which")
    mapper.SourceIndexingOn()
    mapper.SetScaleFactor(0.5)
    mapper.ScalarVisibilityOff()
    add_mapper(renderer, mapper)


def composite(renderer):
    """A composite data set, with all blocks in one mapper."""
    blocks = vtkMultiBlockDataSet()
    for i in range(4):
        block = box(0.5, 0.5 + 0.4 * i, 0.5)
        block.SetCenter(0.9 * i - 1.35, 0.25 + 0.2 * i, 0.3 * (i % 2))
        block.Update()
        blocks.SetBlock(i, block.GetOutput())
    mapper = vtkCompositePolyDataMapper()
    mapper.SetInputDataObject(blocks)
    add_mapper(renderer, mapper, (0.4, 0.7, 0.5))


def lines(renderer):
    """Lines of several widths, lines drawn as tubes, and tubes."""
    for i in range(5):
        knots = vtkPoints()
        for k in range(7):
            knots.InsertNextPoint(
                0.7 * (k - 3), 0.6 + 0.4 * i + 0.15 * math.sin(k + i), 0.5 * math.cos(k + 2 * i))
        spline = vtkParametricSpline()
        spline.SetPoints(knots)
        curve = vtkParametricFunctionSource()
        curve.SetParametricFunction(spline)
        curve.SetUResolution(80)
        source = curve
        if i >= 3:
            source = vtkTubeFilter()
            source.SetInputConnection(curve.GetOutputPort())
            source.SetRadius(0.05)
            source.SetNumberOfSides(12)
        prop = add(renderer, source, (0.9, 0.6 - 0.1 * i, 0.1 + 0.2 * i)).GetProperty()
        prop.SetLineWidth(1 + 2 * i)
        prop.SetRenderLinesAsTubes(i == 2)


def splats(renderer):
    """Point Gaussians, each seen through the fog in front of it."""
    cloud = vtkPointSource()
    cloud.SetNumberOfPoints(400)
    cloud.SetRadius(1.1)
    cloud.SetCenter(0, 1.3, 0)
    mapper = vtkPointGaussianMapper()
    mapper.SetInputConnection(cloud.GetOutputPort())
    mapper.SetScaleFactor(0.05)
    mapper.EmissiveOff()
    mapper.ScalarVisibilityOff()
    actor = add_mapper(renderer, mapper, (0.9, 0.5, 0.2))
    actor.ForceTranslucentOn()  # blended in any order; VTK draws opaque splats as they come
    actor.GetProperty().SetAmbient(0.4)


def cutaway(renderer):
    """A clipping plane; clipped parts cast no shadow."""
    plane = vtkPlane()
    plane.SetOrigin(0, 1.2, 0)
    plane.SetNormal(-0.6, -0.5, -0.6)
    actor = add(renderer, sphere(0.9), place=(0, 1.2, 0))
    actor.GetMapper().AddClippingPlane(plane)
    add(renderer, sphere(0.3), (0.3, 0.5, 0.9), (0, 1.2, 0))


def unlit(renderer):
    """Unlit props and wireframes: the fog attenuates them, but no light shades them."""
    actor = add(renderer, sphere(0.7, 24), place=(-0.9, 1.2, 0))
    actor.GetProperty().LightingOff()
    actor = add(renderer, sphere(0.7, 24), (0.2, 0.5, 0.9), (0.9, 1.2, 0))
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetRepresentationToWireframe()


def volume(renderer):
    """A vtkVolume next to a surface."""
    function = vtkSphere()
    function.SetRadius(0.2)
    sample = vtkSampleFunction()
    sample.SetImplicitFunction(function)
    sample.SetModelBounds(-1, 1, 0.2, 2.2, -1, 1)
    function.SetCenter(0, 1.2, 0)
    sample.SetSampleDimensions(48, 48, 48)
    sample.ComputeNormalsOff()
    sample.SetOutputScalarTypeToFloat()
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputConnection(sample.GetOutputPort())
    colours = vtkColorTransferFunction()
    colours.AddRGBPoint(0, 0.9, 0.3, 0.1)
    colours.AddRGBPoint(0.9, 0.3, 0.5, 0.9)
    opacities = vtkPiecewiseFunction()
    opacities.AddPoint(0, 0.9)
    opacities.AddPoint(0.9, 0)
    prop = vtkVolumeProperty()
    prop.SetColor(colours)
    prop.SetScalarOpacity(opacities)
    prop.SetScalarOpacityUnitDistance(0.3)
    prop.SetInterpolationTypeToLinear()
    cloud = vtkVolume()
    cloud.SetMapper(mapper)
    cloud.SetProperty(prop)
    renderer.AddVolume(cloud)
    add(renderer, sphere(0.3), place=(1.5, 0.8, 0.5))


def annotations(renderer):
    """Axes in the scene are in the fog; 2D annotations are not."""
    axes = vtkAxesActor()
    axes.SetTotalLength(1.5, 1.5, 1.5)
    renderer.AddActor(axes)
    table = vtkLookupTable()
    table.Build()
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("K")
    bar.SetNumberOfLabels(3)
    bar.SetMaximumWidthInPixels(60)
    bar.UnconstrainedFontSizeOn()
    bar.GetTitleTextProperty().SetFontSize(18)
    bar.GetLabelTextProperty().SetFontSize(12)
    renderer.AddActor(bar)
    text = vtkTextActor()
    text.SetInput("Annotation")
    text.GetTextProperty().SetFontSize(20)
    text.SetPosition(10, 10)
    renderer.AddActor(text)
    add(renderer, sphere(0.6), place=(-0.9, 1.2, -0.5))


CONTENTS = [
    surfaces, physically_based, textured, scalars, translucent, glyphs, composite, lines, splats,
    cutaway, unlit, volume, annotations]


# ---- Fog, light and window ----------------------------------------------------------------------


def make_renderer():
    """Floor, wall, fog, a light above, and a weak headlight that does not scatter."""
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    grey = (0.75, 0.75, 0.75)
    add(renderer, square((-9, 0, 9), (9, 0, 9), (-9, 0, -4)), grey)
    add(renderer, square((-9, 0, -4), (9, 0, -4), (-9, 9, -4)), grey)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.6, 2.2, 8)
    camera.SetFocalPoint(0, 1.3, 0)
    camera.SetViewAngle(32)
    camera.SetClippingRange(0.1, 40)

    lamp = vtkLight()
    airlight.vtkAirlight.SetRadiantIntensity(lamp, (60, 55, 46))  # W/sr
    lamp.SetLightTypeToSceneLight()
    lamp.SetPosition(-1.6, 4.6, -0.4)
    renderer.AddLight(lamp)
    eye = vtkLight()
    eye.SetLightTypeToHeadlight()
    eye.SetIntensity(0.4)
    renderer.AddLight(eye)

    fog = airlight.vtkParticipatingMedium()
    fog.SetScattering(0.09, 0.095, 0.1)
    fog.SetAbsorption(0.005, 0.005, 0.005)
    fog.SetAmbientRadiance(0.02, 0.022, 0.025)
    fog_pass = airlight.vtkAirlightPass()
    fog_pass.SetMedium(fog)
    fog_pass.SetLightScatters(eye, False)
    renderer.SetPass(fog_pass)
    return renderer


def render(content, path):
    """Renders one kind of content and writes the picture."""
    renderer = make_renderer()
    content(renderer)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(400, 300)
    window.AddRenderer(renderer)
    window.Render()
    shot = vtkWindowToImageFilter()
    shot.SetInput(window)
    shot.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shot.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main(arguments):
    if not arguments:
        sys.exit(__doc__)
    folder, names = arguments[0], arguments[1:]
    known = {content.__name__.replace("_", "-"): content for content in CONTENTS}
    for name in names:
        if name not in known:
            sys.exit(f"There is no content {name!r}. There are: {', '.join(known)}.")
    os.makedirs(folder, exist_ok=True)
    for name in names or known:
        render(known[name], os.path.join(folder, f"content-{name}.png"))


if __name__ == "__main__":
    main(sys.argv[1:])
