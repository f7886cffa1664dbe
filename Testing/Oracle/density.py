# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""How dense a medium is inside its region, and the integral of that along parts of lines.

at(points) is the density without unit; along(origins, directions, start, end) its integral from
start to end along n lines [n, 3]; ends(origin, direction) are parameters of one line between
which the density is smooth and easy to integrate, kinks(light, origin, direction) those at which
the integral towards a light has a kink.
"""

import numpy as np

from regions import behind_edges, box_edges


class Smooth:
    def kinks(self, light, origin, direction):
        return []


class Uniform(Smooth):
    def at(self, points):
        return np.ones(len(points))

    def along(self, origins, directions, start, end):
        return end - start

    def ends(self, origin, direction):
        return []


class ExponentialHeight(Smooth):
    """exp(-(height - reference)/scale), which overflows far below: there no light is left at any
    density, and that of 300 scale heights below stands for all."""

    def __init__(self, scale, reference=0, up=(0, 1, 0)):
        self.scale, self.reference = scale, reference
        self.up = np.array(up, float) / np.linalg.norm(up)

    def at(self, points):
        return np.exp(np.minimum(-(points @ self.up - self.reference) / self.scale, 300))

    def along(self, origins, directions, start, end):
        """From the denser end on, density falls as exp(-rate s): rho (1 - exp(-rate L))/rate."""
        rise = directions @ self.up
        rate = np.abs(rise) / self.scale
        length = end - start
        denser = np.where(rise > 0, start, end)
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            climb = np.where(rise == 0, 0, denser * rise)
            density = np.exp(-(origins @ self.up + climb - self.reference) / self.scale)
            path = np.where(rate * length < 1e-13, length, -np.expm1(-rate * length) / rate)
            path = np.where(rate == 0, length, path)
            return np.where((length > 0) & (density > 0), density * path, 0)

    def ends(self, origin, direction):
        rise = direction @ self.up
        if abs(rise) < 1e-12:
            return []
        heights = self.reference + self.scale * np.arange(-12, 41, 2)
        return (heights - origin @ self.up) / rise


class Image:
    """Trilinear between values [z, y, x] at points; 0 outside of them.

    The point (i, j, k) is at origin + direction @ ((i, j, k) * spacing).
    """

    def __init__(self, values, origin, spacing, direction=((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        self.values = np.array(values, float)
        self.origin = np.array(origin, float)
        self.to_index = np.linalg.inv(np.array(direction, float) @ np.diag(spacing))
        self.most = np.array(self.values.shape[::-1]) - 1.0
        corners = np.moveaxis(np.indices((2, 2, 2)), 0, -1) * self.most * spacing
        self.edges = box_edges(self.origin + corners @ np.array(direction, float).T)

    def kinks(self, light, origin, direction):
        """Where it leaves through another face; within the image it has none."""
        return behind_edges(self.edges, light, origin, direction)

    def interpolated(self, index):
        low = np.clip(np.floor(index), 0, self.most - 1).astype(int)
        share = np.clip(index - low, 0, 1)
        x, y, z = np.moveaxis(low, -1, 0)
        density = 0
        for corner in np.ndindex(2, 2, 2):
            weight = np.where(corner, share, 1 - share).prod(axis=-1)
            density = density + weight * self.values[z + corner[2], y + corner[1], x + corner[0]]
        return density

    def at(self, points):
        index = (points - self.origin) @ self.to_index.T
        there = np.all((index >= 0) & (index <= self.most), axis=-1)
        return np.where(there, self.interpolated(index), 0)

    def crossings(self, origins, directions):
        """Parameters [n, k] at which lines cross the planes of the points; infinite for none."""
        start = (origins - self.origin) @ self.to_index.T
        step = directions @ self.to_index.T
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = [(np.arange(self.most[axis] + 1) - start[:, axis, None]) / step[:, axis, None]
                    for axis in range(3)]
        ends = np.concatenate(ends, axis=1)
        return np.where(np.isnan(ends), np.inf, ends)

    def along(self, origins, directions, start, end):
        """In a cell a cubic of the line's parameter, for which two Gauss nodes are exact."""
        ends = self.crossings(origins, directions)
        first = np.where(np.isfinite(ends), ends, np.inf).min(axis=1)
        last = np.where(np.isfinite(ends), ends, -np.inf).max(axis=1)
        start, end = np.maximum(start, first), np.minimum(end, last)
        end = np.maximum(start, end)
        start, end = (np.where(np.isfinite(e), e, 0) for e in (start, end))
        ends = np.sort(np.clip(ends, start[:, None], end[:, None]), axis=1)
        ends = np.concatenate([start[:, None], ends, end[:, None]], axis=1)
        middle, half = (ends[:, 1:] + ends[:, :-1]) / 2, np.diff(ends, axis=1) / 2
        total = 0
        for node in (-np.sqrt(1 / 3), np.sqrt(1 / 3)):
            t = middle + node * half
            points = origins[:, None] + t[..., None] * directions[:, None]
            total = total + (half * self.at(points)).sum(axis=1)
        return total

    def ends(self, origin, direction):
        return self.crossings(origin[None], direction[None])[0]


def make(description):
    kind = description["type"]
    if kind == "uniform":
        return Uniform()
    values = {key: value for key, value in description.items() if key != "type"}
    return {"exponential_height": ExponentialHeight, "image": Image}[kind](**values)
