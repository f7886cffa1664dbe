#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""From where an exit sign can be read during a fire: visibility on the plan of a hall.

    fire_visibility.py -o map.png --csv map.csv
    fire_visibility.py --data results.q --array Density -o map.png

Smoke comes from the small solver of fire_smoke.py, or from a file of FDS. The map shows the
visibility from eye height towards the sign: a constant K over the mean extinction along the line of
sight, K = 8 for signs that shine (T. Jin, "Visibility through fire smoke", J. Fire & Flammability
9, 1978), with contours of 10 m and 30 m. The CSV adds the contrast of the sign's letters with and
without the light that the smoke scatters, and the program compares the distance at which it falls to
1 % (Michelson's, 2 % of the background) with Jin's constant. K is that of smoke that does not
irritate the eyes.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkStripper
from vtkmodules.vtkFiltersModeling import vtkBandedPolyDataContourFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkRegularPolygonSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkBillboardTextActor3D, vtkLight, vtkPolyDataMapper, vtkRenderer)
import vtkmodules.vtkRenderingFreeType  # noqa: F401 draws text

import airlight
import airlight.display
from fire_smoke import FIRE, HEIGHT, LENGTH, WALL_END, WALL_X, WIDTH, read_results, solve_plume

EYE = 1.6  # m
SIGN = (LENGTH - 0.05, 11.0, 2.3)
LETTERS = 8.0  # W/(m^2 sr), of letters that shine
LAMPS = [(x, y, HEIGHT - 0.1) for x in (4.0, 12.0, 20.0) for y in (3.5, 10.5)]
LAMP = 40.0  # W/sr
AMBIENT = 0.25  # W/(m^2 sr), scattered by walls and more than once by smoke
ALBEDO, MEAN_COSINE = 0.25, 0.5  # of soot
LEVELS = (10.0, 30.0)  # m, of contours
BANDS = ((0, 5, "#b2182b"), (5, 10, "#ef8a62"), (10, 20, "#fddbc7"), (20, 30, "#d1e5f0"),
         (30, 50, "#67a9cf"))


def make_smoke(options):
    """The medium. Its density is the extinction in 1/m."""
    if options.data:
        data, array = read_results(options.data), options.array
    else:
        data, array = solve_plume(options.time), ""
    smoke = airlight.vtkParticipatingMedium()
    smoke.SetDensityImage(airlight.density_image(
        data, array, options.dimensions or (0, 0, 0), options.component, options.extinction))
    smoke.SetDensityToImage()
    smoke.SetScattering(3 * [ALBEDO])
    smoke.SetAbsorption(3 * [1 - ALBEDO])
    smoke.SetAmbientRadiance(3 * [AMBIENT])
    smoke.SetPhaseFunctionToHenyeyGreenstein()
    smoke.SetAnisotropy(MEAN_COSINE)
    return smoke


def make_lamps():
    lamps = [vtkLight() for _ in LAMPS]
    for lamp, place in zip(lamps, LAMPS):
        airlight.vtkAirlight.SetRadiantIntensity(lamp, 3 * [LAMP])
        lamp.SetPosition(place)
        lamp.SetFocalPoint(place[0], place[1], 0)
    return lamps


def make_plan(step):
    """The hall at eye height, with a point every `step` metres."""
    plan = vtkPlaneSource()
    plan.SetOrigin(0, 0, EYE)
    plan.SetPoint1(LENGTH, 0, EYE)
    plan.SetPoint2(0, WIDTH, EYE)
    plan.SetXResolution(round(LENGTH / step))
    plan.SetYResolution(round(WIDTH / step))
    plan.Update()
    return plan.GetOutput()


def probe_signs(smoke, points, viewpoint, lamps=()):
    """The points with the visibilities and contrasts along the lines to the viewpoint."""
    probe = airlight.vtkAirlightProbeFilter()
    probe.SetInputData(points)
    probe.SetMedium(smoke)
    probe.SetViewpoint(viewpoint)
    for lamp in lamps:
        probe.AddLight(lamp)
    probe.SightLinesOn()
    probe.SetMaximumVisibility(BANDS[-1][1])
    probe.SetSignRadiance(LETTERS)
    probe.Update()
    return probe.GetOutput()


def in_sight(points):
    """Whether the partition wall leaves the line from the point to the sign free."""
    share = (WALL_X - points[:, 0]) / (SIGN[0] - points[:, 0])
    return (points[:, 0] > WALL_X) | (points[:, 1] + share * (SIGN[1] - points[:, 1]) > WALL_END)


def measure(smoke, lamps, step):
    """A table with a row for each point of the plan: x, y, distance to the sign, whether it is in
    sight, mean extinction, visibility of signs that reflect and that shine, contrast with and
    without airlight."""
    places = vtk_to_numpy(make_plan(step).GetPoints().GetData()).astype(float)
    rows = []
    for place in places:
        # The eye is the point and the sign is seen from there: the airlight is what the eye gets.
        points = vtkPoints()
        points.SetDataTypeToDouble()
        points.InsertNextPoint(SIGN)
        sign = vtkPolyData()
        sign.SetPoints(points)
        data = probe_signs(smoke, sign, place, lamps).GetPointData()
        rows.append([data.GetArray(name).GetTuple1(0) for name in (
            "MeanExtinction", "ReflectingSignVisibility", "EmittingSignVisibility", "SignContrast",
            "SignContrastWithoutAirlight")])
    distance = np.linalg.norm(places - SIGN, axis=1)
    return np.column_stack([places[:, :2], distance, in_sight(places), rows])


def compare_with_jin(table):
    """Extinction times distance where the contrast with airlight falls to 1 %, for each bearing
    from the sign."""
    table = table[(table[:, 3] > 0) & (table[:, 7] > 0)]
    depth, contrast = table[:, 2] * table[:, 4], table[:, 7]
    near = np.abs(np.log(contrast / 0.01)) < 0.7
    return (np.median(depth[near]) if near.any() else np.nan), near.sum()


def add(renderer, mapper, colour=(0, 0, 0), width=1.0, z=0.0):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(0, 0, z)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    renderer.AddActor(actor)
    return actor


def add_shape(renderer, source, colour, z):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    add(renderer, mapper, colour, z=z)


def add_text(renderer, text, place, size, colour=(0, 0, 0), centred=True, background=False):
    actor = vtkBillboardTextActor3D()
    actor.SetInput(text)
    actor.SetPosition(place[0], place[1], 5)
    properties = actor.GetTextProperty()
    properties.SetFontSize(size)
    properties.SetColor(colour)
    properties.SetBold(True)
    if background:
        properties.SetBackgroundColor(1, 1, 1)
        properties.SetBackgroundOpacity(0.75)
    if centred:
        properties.SetJustificationToCentered()
        properties.SetVerticalJustificationToCentered()
    renderer.AddActor(actor)


def disc(place, radius):
    source = vtkRegularPolygonSource()
    source.SetNumberOfSides(40)
    source.SetRadius(radius)
    source.SetCenter(place[0], place[1], 0)
    return source


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(*bounds, 0, 0.01)
    return source


def hidden_part():
    """What the partition wall hides from the sign."""
    end = SIGN[1] + (WALL_END - SIGN[1]) * SIGN[0] / (SIGN[0] - WALL_X)  # on the wall x = 0
    points = vtkPoints()
    for place in ((0, 0), (WALL_X, 0), (WALL_X, WALL_END), (0, end)):
        points.InsertNextPoint(*place, 0)
    polygon = vtkCellArray()
    polygon.InsertNextCell(4, [0, 1, 2, 3])
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(polygon)
    source = vtkTrivialProducer()
    source.SetOutput(data)
    return source


def hex_colour(text):
    return tuple(int(text[i:i + 2], 16) / 255 for i in (1, 3, 5))


def add_bands(renderer, plan, scale):
    """Areas of the plan in the colours of BANDS, contours of LEVELS, and where the sign can just be
    read: where its distance is the visibility."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(BANDS))
    for i, (_, _, colour) in enumerate(BANDS):
        table.SetTableValue(i, *hex_colour(colour), 1)
    table.SetRange(0, len(BANDS) - 1)
    bands = vtkBandedPolyDataContourFilter()
    bands.SetInputData(plan)
    bands.SetNumberOfContours(len(BANDS) + 1)
    for i, level in enumerate([band[0] for band in BANDS] + [BANDS[-1][1] + 1]):
        bands.SetValue(i, level)
    bands.SetScalarModeToIndex()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(bands.GetOutputPort())
    mapper.SetScalarModeToUseCellData()
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    add(renderer, mapper, z=-EYE)
    for level in LEVELS:
        add_contour(renderer, plan, level, f"{level:.0f} m", (0, 0, 0), scale)
    reach = (vtk_to_numpy(plan.GetPointData().GetScalars())
             - np.linalg.norm(vtk_to_numpy(plan.GetPoints().GetData()) - SIGN, axis=1))
    limit = plan.NewInstance()
    limit.CopyStructure(plan)
    limit.GetPointData().SetScalars(numpy_to_vtk(reach, deep=True))
    add_contour(renderer, limit, 0, "limit of reading", (0, 0.45, 0.15), scale)


def add_contour(renderer, plan, level, text, colour, scale):
    contour = vtkContourFilter()
    contour.SetInputData(plan)
    contour.SetValue(0, level)
    lines = vtkStripper()
    lines.SetInputConnection(contour.GetOutputPort())
    lines.SetMaximumLength(10000)
    lines.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(lines.GetOutputPort())
    mapper.ScalarVisibilityOff()
    add(renderer, mapper, colour, 2.5 * scale, 0.5 - EYE)
    label_line(renderer, lines.GetOutput(), text, colour, scale)


def label_line(renderer, lines, text, colour, scale):
    """On the longest line, what is out of sight left out."""
    cells = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    starts = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    points = [np.array([lines.GetPoint(i) for i in part])
              for part in np.split(cells, starts[1:-1]) if len(part)]
    points = [part[in_sight(part)] for part in points]
    longest = max(points, key=len, default=[])
    if len(longest) > 10:
        add_text(renderer, text, longest[3 * len(longest) // 4], round(16 * scale), colour,
                 background=True)


def draw(plan, title, size):
    """A renderer with the map."""
    scale = size[0] / 960
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    add_bands(renderer, plan, scale)
    add_shape(renderer, hidden_part(), (0.62, 0.62, 0.62), 0.8)
    wall = 0.15
    for bounds in ((-wall, LENGTH + wall, -wall, 0), (-wall, LENGTH + wall, WIDTH, WIDTH + wall),
                   (-wall, 0, 0, WIDTH), (LENGTH, LENGTH + wall, 0, WIDTH),
                   (WALL_X - wall, WALL_X + wall, 0, WALL_END)):
        add_shape(renderer, box(*bounds), (0.1, 0.1, 0.1), 1)
    for place in LAMPS:
        add_shape(renderer, disc(place, 0.2), (0.1, 0.1, 0.1), 2)
        add_shape(renderer, disc(place, 0.14), (1, 0.9, 0.3), 3)
    add_shape(renderer, disc(FIRE, 0.5), (0.85, 0.1, 0), 2)
    add_text(renderer, "fire", (FIRE[0], FIRE[1] - 1.0), round(17 * scale))
    add_shape(renderer, box(LENGTH - 0.15, LENGTH + 0.45, SIGN[1] - 1, SIGN[1] + 1), (0, 0.5, 0.2),
              3)
    add_text(renderer, "EXIT", (LENGTH - 1.2, SIGN[1]), round(17 * scale), (0, 0.4, 0.15))
    add_text(renderer, title, (0, WIDTH + 1.0), round(21 * scale), centred=False)
    for i, (low, high, colour) in enumerate(BANDS + ((None, None, "#9e9e9e"),)):
        x = 4.05 * i
        add_shape(renderer, box(x, x + 0.8, -1.6, -0.9), hex_colour(colour), 1)
        text = ("not in sight" if low is None else f"above {low} m" if high == BANDS[-1][1]
                else f"{low} to {high} m")
        add_text(renderer, text, (x + 1.0, -1.5), round(16 * scale), centred=False)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(LENGTH / 2, WIDTH / 2, 40)
    camera.SetFocalPoint(LENGTH / 2, WIDTH / 2, 0)
    camera.SetParallelScale((LENGTH + 1.6) / 2 * size[1] / size[0])
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    airlight.display.add_picture_options(parser, (720, 510))
    parser.add_argument("--csv", help="table to write, a row for each point of the plan")
    parser.add_argument("--step", type=float, default=1.0, help="m, of the table's points; default: 1")
    parser.add_argument("--time", type=float, default=135.0, help="s after ignition; default: 135")
    parser.add_argument("--data", help="file of FDS, .q or .vtkhdf, instead of the solver")
    parser.add_argument("--array", default="", help="of the data: soot density [kg/m^3]")
    parser.add_argument("--component", type=int, help="of an array that has several, from 0")
    parser.add_argument("--dimensions", type=int, nargs=3, help="points on which data are sampled")
    parser.add_argument("--extinction", type=float, default=8700.0,
                        help="m^2/kg, mass extinction coefficient of soot; default: 8700")
    options = parser.parse_args()

    smoke, lamps = make_smoke(options), make_lamps()
    table = measure(smoke, lamps, options.step)
    seen = table[table[:, 3] > 0]
    readable = seen[:, 6] >= np.minimum(seen[:, 2], BANDS[-1][1])
    print(f"{len(seen)} of {len(table)} points have the sign in sight, {readable.sum()} can read it "
          f"(K = 8)")
    for level in LEVELS:
        print(f"visibility below {level:.0f} m at {np.mean(seen[:, 6] < level):.3f} of these points")
    depth, count = compare_with_jin(table)
    print(f"contrast of 1 % at extinction times distance {depth:.1f} ({count} points); Jin: 5 to 10")
    if options.csv:
        np.savetxt(options.csv, table, delimiter=",", comments="", fmt="%.6g", header=(
            "x,y,distance,in_sight,mean_extinction,visibility_reflecting,visibility_emitting,"
            "contrast,contrast_without_airlight"))
    plan = probe_signs(smoke, make_plan(0.1), SIGN)
    plan.GetPointData().SetActiveScalars("EmittingSignVisibility")
    when = f", {options.time:.0f} s after ignition" if not options.data else ""
    renderer = draw(plan, f"Visibility towards the exit sign at {EYE} m height{when} (K = 8)", options.size)
    window = airlight.display.open_window(renderer, size=options.size,
                                          offscreen=bool(options.output))
    airlight.display.show_or_write(window, options.output, redraw=False)


if __name__ == "__main__":
    main()
