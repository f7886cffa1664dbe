# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Single scattering by the midpoint rule, what the examples' numbers are checked against.

All lengths in world units; the phase function is isotropic; no call of the library under test.
"""

import numpy as np


def middles(length, count):
    """The middles of so many parts of [0, length], along a new last axis."""
    return np.asarray(length)[..., None] * (np.arange(count) + 0.5) / count


def box_interval(bounds, origins, directions):
    """Where rays [..., 3] enter and leave a box; the same where they miss it."""
    low, high = np.reshape(bounds, (3, 2)).T
    with np.errstate(divide="ignore"):
        ends = np.array([(side - origins) / directions for side in (low, high)])
    enter = np.maximum(ends.min(axis=0).max(axis=-1), 0)
    return enter, np.maximum(ends.max(axis=0).min(axis=-1), enter)


class Grid:
    """Density between samples [z, y, x], linear along each axis; 0 outside."""

    def __init__(self, samples, origin, spacing):
        self.samples = np.pad(samples, 1)
        self.origin = np.subtract(origin, spacing)  # of the padding
        self.spacing = np.array(spacing)

    def __call__(self, points):
        place = (points - self.origin) / self.spacing
        most = np.array(self.samples.shape[::-1]) - 2
        low = np.floor(place).astype(int).clip(0, most)
        share = (place - low).clip(0, 1)
        density = 0
        for corner in np.ndindex(2, 2, 2):
            x, y, z = np.moveaxis(low + corner, -1, 0)
            density = density + self.samples[z, y, x] * np.where(corner, share, 1 - share).prod(-1)
        return density


def sunlit_airlight(density, bounds, eye, rays, to_sun, albedo, extinction, irradiance,
                    count=150, sun_count=50):
    """Radiance and transmittance of rays [..., 3] through a density in a box in the sun, and the
    largest optical depth towards the sun."""
    enter, leave = box_interval(bounds, eye, rays)
    t = enter[..., None] + middles(leave - enter, count)
    points = eye + t[..., None] * rays[..., None, :]
    local = extinction * density(points)
    step = (leave - enter)[..., None] / count
    depth = np.cumsum(local * step, axis=-1)
    way = box_interval(bounds, points, np.broadcast_to(to_sun, points.shape))[1]
    towards = points[..., None, :] + middles(way, sun_count)[..., None] * to_sun
    sun_depth = extinction * density(towards).mean(axis=-1) * way
    arriving = irradiance * np.exp(-sun_depth - (depth - local * step / 2))
    radiance = albedo / (4 * np.pi) * (local * step * arriving).sum(axis=-1)
    return radiance, np.exp(-depth[..., -1]), sun_depth[local > 0].max(initial=0)


def lamp_airlight(points, eye, lamp, intensity, scattering, extinction, lit):
    """Radiance [..., 3] from samples [..., n, 3] of unit weight, those that are lit."""
    r = np.linalg.norm(points - lamp, axis=-1)
    way = r + np.linalg.norm(points - eye, axis=-1)
    terms = np.where(lit, scattering / (4 * np.pi) * np.exp(-extinction * way) / r**2, 0)
    return terms.sum(axis=-1)[..., None] * np.array(intensity)
