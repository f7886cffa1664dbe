# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where a medium is: the parts of lines inside everywhere, a box, a sphere, a cylinder or a closed
mesh.

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


class Cylinder:
    """In coordinates [x, y, z] from its centre whose z is the axis."""

    def __init__(self, center, axis, radius, height):
        self.center, self.radius, self.half = np.array(center, float), radius, height / 2
        z = np.array(axis, float) / np.linalg.norm(axis)
        x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
        x /= np.linalg.norm(x)
        self.turn = np.transpose([x, np.cross(z, x), z])

    def kinks(self, light, origin, direction):
        """Where the light's way passes through a rim, or touches the wall."""
        o, d = (origin - self.center) @ self.turn, direction @ self.turn
        at = hasattr(light, "position")
        source = ((light.position - self.center) if at else light.to_light) @ self.turn
        found = []
        for end in (-self.half, self.half):
            # The way meets the plane z = end at (start + t step)/(low + t slope), in x and y. It
            # meets the rim if that is at the radius from the axis.
            if at:
                low, slope = source[2] - o[2], -d[2]
                start = source[:2] * low + (o - source)[:2] * (source[2] - end)
                step = source[:2] * slope + d[:2] * (source[2] - end)
            else:
                low, slope = source[2], 0.0
                start = o[:2] * source[2] + source[:2] * (end - o[2])
                step = d[:2] * source[2] - source[:2] * d[2]
            r2 = self.radius**2
            found.extend(real_roots(step @ step - r2 * slope**2,
                                    2 * (start @ step - r2 * low * slope),
                                    start @ start - r2 * low**2))
        # The wall, in x and y: |source x p| is the radius times |p - source|, or times |source| for
        # parallel light.
        across = [source[0] * v[1] - source[1] * v[0] for v in (o, d)]
        far, farther = ((o - source)[:2], d[:2]) if at else (source[:2], np.zeros(2))
        found.extend(real_roots(
            across[1]**2 - self.radius**2 * (farther @ farther),
            2 * (across[0] * across[1] - self.radius**2 * (far @ farther)),
            across[0]**2 - self.radius**2 * (far @ far)))
        return found

    def inside(self, origins, directions, lengths):
        o, d = (origins - self.center) @ self.turn, directions @ self.turn
        a = np.sum(d[:, :2]**2, axis=1)
        b = np.sum(o[:, :2] * d[:, :2], axis=1)
        c = np.sum(o[:, :2]**2, axis=1) - self.radius**2
        with np.errstate(divide="ignore", invalid="ignore"):
            root = np.sqrt(b**2 - a * c)
            wall = np.stack([(-b - root) / a, (-b + root) / a])
            ends = np.stack([(-self.half - o[:, 2]) / d[:, 2], (self.half - o[:, 2]) / d[:, 2]])
        whole = [[-np.inf], [np.inf]]
        along = a < 1e-30  # the ray: inside the wall or not at all
        wall = np.where(along, np.where(c <= 0, whole, np.nan), wall)
        across = d[:, 2] == 0
        ends = np.where(across, np.where(np.abs(o[:, 2]) <= self.half, whole, np.nan),
                        np.sort(ends, axis=0))
        enter, leave = np.maximum(wall[0], ends[0]), np.minimum(wall[1], ends[1])
        missed = ~(leave > enter)  # NaN, too
        enter, leave = np.where(missed, 0, enter), np.where(missed, 0, leave)
        return clipped(enter[:, None], leave[:, None], lengths)


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
    if kind == "cylinder":
        return Cylinder(description["center"], description["axis"], description["radius"],
                        description["height"])
    return {"mesh": Mesh}[kind](description["points"], description["faces"])
