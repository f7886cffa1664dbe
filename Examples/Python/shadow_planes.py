#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Shows the shadow planes of a model in the light of a point light, as translucent polygons.

Usage: shadow_planes.py [MODEL.ply] [--subdivide N] [-o PICTURE.png]

Without -o the window stays open. Blue: the planes, clipped to a box that stands on the floor. Red:
the silhouette from which they start. Dark: their far caps on the floor, the shadow of the model.
The silhouette follows the edges of triangles: that of a coarse mesh of triangles that is subdivided
once or twice is smoother.
"""

import argparse
import pathlib

import airlight
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkThreshold, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor,
    vtkWindowToImageFilter)
import vtkmodules.vtkInteractionStyle  # the mouse
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer

MESHES = pathlib.Path(__file__).resolve().parent.parent / "Data" / "meshes"


def read_model(path, subdivisions):
    reader = vtkPLYReader()
    reader.SetFileName(path)
    if not subdivisions:
        return reader
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    smooth = vtkLoopSubdivisionFilter()
    smooth.SetInputConnection(triangles.GetOutputPort())
    smooth.SetNumberOfSubdivisions(subdivisions)
    return smooth


def add_actor(renderer, algorithm, colour, opacity=1.0, lit=False):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetLineWidth(3)
    actor.GetProperty().SetLighting(lit)
    renderer.AddActor(actor)


def make_scene(renderer, reader):
    reader.Update()
    x0, x1, y0, y1, z0, z1 = reader.GetOutput().GetBounds()
    size = max(x1 - x0, y1 - y0, z1 - z0)
    middle = (0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (z0 + z1))
    lamp = (middle[0] - 0.9 * size, y1 + 0.9 * size, middle[2] + 0.3 * size)
    floor = y0 - 0.35 * size
    box = (middle[0] - 1.3 * size, middle[0] + 2.3 * size, floor, lamp[1],
           middle[2] - 1.3 * size, middle[2] + 1.3 * size)

    planes = airlight.vtkShadowPlanesFilter()
    planes.SetInputConnection(reader.GetOutputPort())
    planes.SetLightPosition(lamp)
    planes.SetExtentToBounds()
    planes.SetBounds(box)
    planes.FarCapOn()
    parts = []
    for part in (planes.PLANE, planes.FAR_CAP):
        threshold = vtkThreshold()
        threshold.SetInputConnection(planes.GetOutputPort())
        threshold.SetInputArrayToProcess(0, 0, 0, 1, "Part")
        threshold.SetLowerThreshold(part)
        threshold.SetUpperThreshold(part)
        parts.append(vtkGeometryFilter())
        parts[-1].SetInputConnection(threshold.GetOutputPort())
    edges = airlight.vtkSilhouetteEdgesFilter()
    edges.SetInputConnection(reader.GetOutputPort())
    edges.SetLightPosition(lamp)
    ground = vtkPlaneSource()
    below = floor - 0.005 * size  # not in the same place as the caps
    ground.SetOrigin(box[0], below, box[5])
    ground.SetPoint1(box[1], below, box[5])
    ground.SetPoint2(box[0], below, box[4])
    bulb = vtkSphereSource()
    bulb.SetCenter(lamp)
    bulb.SetRadius(0.03 * size)

    shaded = vtkPolyDataNormals()
    shaded.SetInputConnection(reader.GetOutputPort())
    add_actor(renderer, shaded, (0.85, 0.8, 0.7), lit=True)
    add_actor(renderer, ground, (0.75, 0.75, 0.78))
    add_actor(renderer, bulb, (1.0, 0.9, 0.3))
    add_actor(renderer, parts[0], (0.1, 0.3, 0.8), opacity=0.06)
    add_actor(renderer, parts[1], (0.25, 0.25, 0.3))
    add_actor(renderer, edges, (0.9, 0.2, 0.1))
    renderer.SetBackground(0.95, 0.95, 0.95)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle[0] + 0.35 * size, middle[1] + 0.14 * size, middle[2])
    camera.SetPosition(middle[0] + 1.3 * size, middle[1] + 1.5 * size, middle[2] + 4.8 * size)
    renderer.ResetCameraClippingRange()
    return planes


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model", nargs="?", default=str(MESHES / "cow.ply"))
    parser.add_argument("--subdivide", type=int, default=0, choices=range(4), metavar="N",
                        help="smooth the model by Loop's subdivision, 0 to 3 times (default 0)")
    parser.add_argument("-o", "--output", help="write a PNG and leave")
    options = parser.parse_args()
    if not pathlib.Path(options.model).is_file():
        parser.error(f"{options.model}: there is no such file")
    renderer = vtkRenderer()
    window = vtkRenderWindow()
    window.SetSize(1280, 800)
    window.SetMultiSamples(8)
    window.AddRenderer(renderer)
    window.SetOffScreenRendering(bool(options.output))
    planes = make_scene(renderer, read_model(options.model, options.subdivide))
    window.Render()
    print(f"{planes.GetOutput().GetNumberOfPolys()} polygons")
    if not options.output:
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        interactor.Start()
        return
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(options.output)
    writer.Write()


if __name__ == "__main__":
    main()
