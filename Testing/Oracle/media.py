# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Media: coefficients, phase function, region and density together.

A medium is a dict of "sigma_s" and "sigma_a" [1/length], and, if it is not isotropic, everywhere,
uniform and without ambient light, of "phase", "region", "density" and "ambient".
"""

import numpy as np

import density
import phase
import regions


class Medium:
    def __init__(self, description):
        self.sigma_s = np.array(description["sigma_s"], float)
        self.sigma_t = self.sigma_s + np.array(description["sigma_a"], float)
        self.phase = phase.make(description.get("phase", {"type": "isotropic"}))
        self.region = regions.make(description.get("region", {"type": "everywhere"}))
        self.density = density.make(description.get("density", {"type": "uniform"}))
        self.ambient = np.array(description.get("ambient", (0, 0, 0)), float)

    def is_endless(self):
        """A directional light has no way through such a medium that has a length: the library's
        convention is that it arrives unattenuated."""
        return (isinstance(self.region, regions.Everywhere)
                and isinstance(self.density, density.Uniform))

    def density_at(self, points, directions):
        """What is inside is found along any direction."""
        start, end = self.region.inside(points, directions, np.full(len(points), 1e-9))
        inside = (end - start).sum(axis=1) > 0.5e-9
        return np.where(inside, self.density.at(points), 0)

    def column(self, origins, directions, lengths):
        """The integral of the density along lines, as far as the region holds them."""
        starts, ends = self.region.inside(origins, directions, lengths)
        return sum((self.density.along(origins, directions, starts[:, i], ends[:, i])
                    for i in range(starts.shape[1])), np.zeros(len(origins)))

    def parts(self, origins, directions, lengths):
        """How many parts of each line the region holds [n]."""
        starts, ends = self.region.inside(origins, directions, lengths)
        return np.sum(ends > starts, axis=1)

    def ends(self, origin, direction):
        """Parameters of one ray between which the medium neither jumps nor has a kink."""
        found = self.region.inside(origin[None], direction[None], np.array([np.inf]))
        return np.concatenate([np.ravel(found), self.density.ends(origin, direction)])

    def kinks(self, light, origin, direction):
        """Parameters of one ray at which the column towards a light has a kink."""
        return np.concatenate([self.region.kinks(light, origin, direction),
                               self.density.kinks(light, origin, direction)])


def optical_depth(media, origins, directions, lengths):
    """Of all media together, per channel [n, 3]."""
    depth = np.zeros((len(origins), 3))
    for medium in media:
        column = medium.column(origins, directions, lengths)[:, None]
        with np.errstate(invalid="ignore"):
            depth += np.where(medium.sigma_t > 0, medium.sigma_t * column, 0)
    return depth
