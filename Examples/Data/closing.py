# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Decimate meshes and close them again, so that every edge belongs to exactly two triangles."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

import plymesh


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


def largest_part(points, triangles):
    """The connected part that has the most triangles."""
    label = np.arange(len(points))
    while True:  # each point takes the smallest label of its triangles, until none changes
        smallest = label[triangles].min(axis=1)
        following = label.copy()
        np.minimum.at(following, triangles.ravel(), np.repeat(smallest, 3))
        following = following[following]
        if np.array_equal(following, label):
            break
        label = following
    part = label[triangles[:, 0]]
    return drop_unused(points, triangles[part == np.bincount(part).argmax()])


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
