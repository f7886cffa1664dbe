# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Lights, from plain numbers.

A light is a dict with a "type":
  "point": "position", "intensity" [W/sr] and, if it is not (0, 0, 1), "attenuation" (a, b, c);
  "spot": these and "direction" of its axis, "cone_half_angle_deg" and "exponent";
  "directional": "direction" in which light travels, "irradiance" [W/m^2] across it.
"scatters" is False for one that lights surfaces alone.
"""

import numpy as np

from geometry import dot, norm, real_roots, unit
from media import optical_depth


class PointLight:
    def __init__(self, description):
        self.position = np.array(description["position"], float)
        self.intensity = np.array(description["intensity"], float)
        self.attenuation = description.get("attenuation", (0, 0, 1))
        self.scatters = description.get("scatters", True)

    def towards(self, points):
        """Unit directions to the light and distances."""
        way = self.position - points
        distance = norm(way)
        return way / np.maximum(distance, 1e-300)[:, None], distance

    def irradiance(self, points):
        """Across the light's way, without medium or shadow [n, 3]."""
        distance = norm(self.position - points)
        a, b, c = self.attenuation
        return self.intensity / (a + b * distance + c * distance**2)[:, None]

    def ends(self, origin, direction):
        return []


class SpotLight(PointLight):
    """I cos(angle)^exponent inside the cone, nothing outside."""

    def __init__(self, description):
        super().__init__(description)
        self.axis = unit(description["direction"])
        self.cosine = np.cos(np.radians(description["cone_half_angle_deg"]))
        self.exponent = description["exponent"]

    def irradiance(self, points):
        way, _ = self.towards(points)
        cosine = -dot(way, self.axis)
        share = np.where(cosine > self.cosine, np.maximum(cosine, 0)**self.exponent, 0)
        return share[:, None] * super().irradiance(points)

    def ends(self, origin, direction):
        """Where the ray meets the double cone: (x.axis)^2 = cosine^2 x.x, x = point - light."""
        start = origin - self.position
        along, across = direction @ self.axis, start @ self.axis
        squared = self.cosine**2
        return real_roots(along**2 - squared,
                          2 * (along * across - squared * (start @ direction)),
                          across**2 - squared * (start @ start))


class DirectionalLight:
    def __init__(self, description):
        self.to_light = -unit(description["direction"])
        self.across = np.array(description["irradiance"], float)
        self.scatters = description.get("scatters", True)

    def towards(self, points):
        return np.broadcast_to(self.to_light, points.shape), np.full(len(points), np.inf)

    def irradiance(self, points):
        return np.broadcast_to(self.across, points.shape)

    def ends(self, origin, direction):
        return []


def make(description):
    kinds = {"point": PointLight, "spot": SpotLight, "directional": DirectionalLight}
    return kinds[description["type"]](description)


def arriving(light, media, points):
    """Irradiance across the light's way behind the media [n, 3], without shadows."""
    directions, distances = light.towards(points)
    if isinstance(light, DirectionalLight):
        media = [medium for medium in media if not medium.is_endless()]
    depth = optical_depth(media, points, directions, distances)
    return light.irradiance(points) * np.exp(-depth)
