# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes: arrays of points [n, 3] and of three indices each [m, 3]."""

import numpy as np

from geometry import unit


def rectangle(corner, a, b):
    """From a corner along two sides."""
    corner, a, b = (np.array(v, float) for v in (corner, a, b))
    return np.array([corner, corner + a, corner + a + b, corner + b]), [[0, 1, 2], [0, 2, 3]]


def box(low, high):
    points = np.array([[(low, high)[i >> axis & 1][axis] for axis in range(3)]
                       for i in range(8)], float)
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def octahedron(center, radii):
    """Three half diameters, along the axes."""
    points = np.array(center) + np.concatenate([np.diag(radii), -np.diag(radii)])
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    return points, faces


def ball(center, radius, halvings=1):
    """An octahedron whose faces are cut in four, some times, and moved to the sphere."""
    points, faces = octahedron((0, 0, 0), (1, 1, 1))
    for _ in range(halvings):
        triangles = points[np.array(faces)]
        a, b, c = (triangles[:, i] for i in range(3))
        ab, bc, ca = unit(a + b), unit(b + c), unit(c + a)
        triangles = np.concatenate([np.stack(t, 1) for t in (
            (a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
        points, faces = np.unique(triangles.reshape(-1, 3).round(14), axis=0, return_inverse=True)
        faces = faces.reshape(-1, 3)
    return np.array(center) + radius * points, faces


def read_ply(path):
    """An ASCII file of triangles and of points x, y, z, which are floats, of single precision."""
    with open(path) as file:
        lines = iter(file.read().splitlines())
    counts = {}
    for line in lines:
        words = line.split()
        if words[0] == "element":
            counts[words[1]] = int(words[2])
        if words[0] == "end_header":
            break
    points = [next(lines).split()[:3] for _ in range(counts["vertex"])]
    faces = [next(lines).split() for _ in range(counts["face"])]
    if any(face[0] != "3" for face in faces):
        raise ValueError(f"{path}: not a triangle")
    return np.array(points, np.float32).astype(float), np.array([face[1:4] for face in faces], int)
