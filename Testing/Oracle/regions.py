# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where a medium is: the parts of lines inside everywhere, a box, a sphere or a closed mesh.

inside(origins, directions, lengths) gives the ends [n, k] of up to k parts of each line, between 0
and its length, which may be infinite. Parts that are not there have length 0. Directions are unit.

kinks(light, origin, direction) are parameters of one ray at which the light's way inside has a
kink, as it begins to leave through another face, or to touch a sphere.
"""

import itertools

import numpy as np

from geometry import dot, line_triangles, real_roots


def clipped(enter, leave, lengths):
    enter = np.clip(enter, 0, lengths[:, None])
    return enter, np.maximum(np.minimum(leave, lengths[:, None]), enter)


def behind_edges(edges, light, origin, direction):
    """Where a ray meets the planes through a light and edges [k, 2, 3]."""
    start = edges[:, 0]
    normals = np.cross(edges[:, 1] - start, light.towards(start)[0])
    with np.errstate(divide="ignore", invalid="ignore"):
        return -dot(origin - start, normals) / (normals @ direction)


def box_edges(corners):
    """The twelve edges between corners [x, y, z, 3], each index 0 or 1."""
    pairs = itertools.combinations(itertools.product((0, 1), repeat=3), 2)
    return np.array([(corners[a], corners[b]) for a, b in pairs
                     if np.sum(np.not_equal(a, b)) == 1])


class Everywhere:
    def kinks(self, light, origin, direction):
        return []

    def inside(self, origins, directions, lengths):
        return np.zeros((len(origins), 1)), lengths[:, None]


class Box:
    def __init__(self, low, high):
        self.low, self.high = np.array(low, float), np.array(high, float)
        ends = np.transpose([self.low, self.high])
        corners = [[[(x, y, z) for z in ends[2]] for y in ends[1]] for x in ends[0]]
        self.edges = box_edges(np.array(corners))

    def kinks(self, light, origin, direction):
        return behind_edges(self.edges, light, origin, direction)

    def inside(self, origins, directions, lengths):
        with np.errstate(divide="ignore", invalid="ignore"):
            a = (self.low - origins) / directions
            b = (self.high - origins) / directions
        along = np.isnan(a) | np.isnan(b)  # 0/0, along a face: the slab of this axis holds the line
        enter = np.where(along, -np.inf, np.minimum(a, b)).max(axis=1)
        leave = np.where(along, np.inf, np.maximum(a, b)).min(axis=1)
        leave = np.maximum(leave, enter)
        return clipped(enter[:, None], leave[:, None], lengths)


class Sphere:
    def __init__(self, center, radius):
        self.center, self.radius = np.array(center, float), radius

    def kinks(self, light, origin, direction):
        """Where the light's way touches: |(center - light) x (point - light)| is the radius times
        |point - light|, or |(point - center) x to_light| the radius."""
        if hasattr(light, "position"):
            way = self.center - light.position
            start, step = np.cross(way, origin - light.position), np.cross(way, direction)
            far, farther = self.radius * (origin - light.position), self.radius * direction
        else:
            start, step = (np.cross(v, light.to_light) for v in (origin - self.center, direction))
            far, farther = self.radius * light.to_light, np.zeros(3)
        return real_roots(step @ step - farther @ farther, 2 * (start @ step - far @ farther),
                          start @ start - far @ far)

    def inside(self, origins, directions, lengths):
        foot = dot(self.center - origins, directions)
        aside = origins + foot[:, None] * directions - self.center
        half = np.sqrt(np.maximum(self.radius**2 - dot(aside, aside), 0))
        return clipped((foot - half)[:, None], (foot + half)[:, None], lengths)


class Mesh:
    """Inside is what a line that comes from infinity reaches after an odd number of triangles."""

    def __init__(self, points, faces):
        self.triangles = np.asarray(points, float)[np.asarray(faces)]
        edges = {tuple(sorted(pair)) for face in faces
                 for pair in itertools.combinations(map(int, face), 2)}
        self.edges = np.asarray(points, float)[np.array(sorted(edges))]

    def kinks(self, light, origin, direction):
        return behind_edges(self.edges, light, origin, direction)

    def inside(self, origins, directions, lengths):
        t = line_triangles(origins, directions, self.triangles)
        t = np.sort(np.where(t > 0, t, np.inf), axis=1)
        odd = np.isfinite(t).sum(axis=1) % 2 == 1
        ends = np.concatenate([np.zeros((len(t), 1)), t, np.full((len(t), 2), np.inf)], axis=1)
        ends = np.where(odd[:, None], ends[:, :-1], ends[:, 1:])
        most = 2 * ((np.isfinite(ends).sum(axis=1).max(initial=0) + 1) // 2)
        ends = np.minimum(ends[:, :most], lengths[:, None])
        ends = np.where(np.isfinite(ends), ends, 0)
        return ends[:, 0::2], ends[:, 1::2]


def make(description):
    kind = description["type"]
    if kind == "everywhere":
        return Everywhere()
    if kind == "box":
        return Box(description["min"], description["max"])
    if kind == "sphere":
        return Sphere(description["center"], description["radius"])
    return {"mesh": Mesh}[kind](description["points"], description["faces"])
