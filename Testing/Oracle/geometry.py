# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors in arrays [..., 3], and where lines meet triangles."""

import numpy as np


def dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def norm(a):
    return np.sqrt(dot(a, a))


def unit(a):
    a = np.asarray(a, float)
    return a / norm(a)[..., None]


def line_triangles(origins, directions, triangles):
    """Parameters [n, m] at which n lines pass m triangles [m, 3, 3]; not a number where they miss.

    Moeller and Trumbore (1997): the barycentric coordinates by Cramer's rule.
    """
    first = triangles[:, 0]
    u, v = triangles[:, 1] - first, triangles[:, 2] - first
    across = np.cross(directions[:, None], v)
    with np.errstate(divide="ignore", invalid="ignore"):
        scale = 1 / dot(u, across)
        start = origins[:, None] - first
        a = scale * dot(start, across)
        turned = np.cross(start, u)
        b = scale * dot(directions[:, None], turned)
        t = scale * dot(v, turned)
        return np.where((a >= 0) & (b >= 0) & (a + b <= 1) & np.isfinite(t), t, np.nan)


def rotation(axis, degrees):
    """The matrix that turns about an axis (Rodrigues)."""
    x, y, z = unit(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def real_roots(quadratic, linear, constant):
    """Where a polynomial of degree 2 at most is 0."""
    roots = np.roots([quadratic, linear, constant])
    return roots[np.isreal(roots)].real
