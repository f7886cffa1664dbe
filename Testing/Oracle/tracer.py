# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What single scattering shows of a scene: one ray a pixel, by quadrature in double precision.

A scene is a dict of a "camera", "media", "lights" and "surfaces" (see the modules of these names);
a surface has "points", "faces" and the "albedo" of its two Lambert sides.
"""

import numpy as np

import camera
import lights
import shadows
from geometry import dot, line_triangles, norm, unit
from media import Medium, optical_depth
from quadrature import integrate


class Surfaces:
    """All triangles of a scene, with the normal and the albedo of each."""

    def __init__(self, descriptions):
        parts = [np.asarray(s["points"], float)[np.asarray(s["faces"])] for s in descriptions]
        self.triangles = np.concatenate(parts) if parts else np.empty((0, 3, 3))
        albedo = [np.broadcast_to(s["albedo"], (len(part), 3))
                  for s, part in zip(descriptions, parts)]
        self.albedo = np.concatenate(albedo) if parts else np.empty((0, 3))
        a, b, c = (self.triangles[:, i] for i in range(3))
        self.normals = unit(np.cross(b - a, c - a))

    def first(self, origins, directions):
        """Distance of the first triangle on each ray and its number; infinity and -1 for none."""
        if not len(self.triangles):
            return np.full(len(origins), np.inf), np.full(len(origins), -1)
        t = line_triangles(origins, directions, self.triangles)
        with np.errstate(invalid="ignore"):
            t = np.where(t > 0, t, np.inf)
        face = t.argmin(axis=1)
        depth = t[np.arange(len(t)), face]
        return depth, np.where(np.isfinite(depth), face, -1)


class Rays:
    """Rays of a scene, up to their first surface."""

    def __init__(self, scene, size, pixels):
        self.media = [Medium(medium) for medium in scene["media"]]
        self.lights = [lights.make(light) for light in scene["lights"]]
        self.surfaces = Surfaces(scene["surfaces"])
        self.origins, self.directions = camera.rays(scene["camera"], size, pixels)
        self.depth, self.face = self.surfaces.first(self.origins, self.directions)
        self.count = len(self.depth)

    def at(self, ray, t):
        return self.origins[ray] + t[:, None] * self.directions[ray]

    def transmittance(self, ray, t):
        return np.exp(-optical_depth(self.media, self.origins[ray], self.directions[ray], t))

    def hidden(self, light, ray):
        return shadows.hidden(light, self.origins[ray], self.directions[ray],
                              self.surfaces.triangles)

    def lit_ends(self, light, ray):
        """The ends before the first surface of what is in shadow or outside a spot's cone."""
        ends = np.concatenate([self.hidden(light, ray).ravel(),
                               light.ends(self.origins[ray], self.directions[ray])])
        return np.sort(ends[(ends > 0) & (ends < (1 - 1e-7) * self.depth[ray])])

    def surface(self):
        """Radiance of the first surfaces behind the media, and the light's share in it [n, lights]
        that is not hidden: 1, 0, or 0 for a light behind the surface."""
        radiance = np.zeros((self.count, 3))
        lit = np.zeros((self.count, len(self.lights)))
        ray = np.flatnonzero(self.face >= 0)
        if not len(ray):
            return radiance, lit
        points = self.at(ray, self.depth[ray])
        normals = self.surfaces.normals[self.face[ray]]
        turned = -np.sign(dot(normals, self.directions[ray]))[:, None] * normals
        for i, light in enumerate(self.lights):
            cosine = np.maximum(dot(light.towards(points)[0], turned), 0)
            lit[ray, i] = shadows.is_lit(light, points, self.surfaces.triangles) & (cosine > 0)
            arriving = lights.arriving(light, self.media, points)
            radiance[ray] += (lit[ray, i] * cosine)[:, None] * arriving
        albedo = self.surfaces.albedo[self.face[ray]]
        radiance[ray] *= albedo / np.pi * self.transmittance(ray, self.depth[ray])
        return radiance, lit

    def airlight(self, light, shadowed=True):
        """What the media scatter of one light into the rays."""
        middles, distances = np.zeros(self.count), np.zeros(self.count)
        if hasattr(light, "position"):
            middles = dot(light.position - self.origins, self.directions)
            distances = norm(self.at(np.arange(self.count), middles) - light.position)
        turns = distances > 1e-9  # else x is t itself, else the angle at the light

        def place(ray, x):
            """The ray's parameter, and what it changes by with x."""
            h = distances[ray]
            with np.errstate(invalid="ignore", over="ignore"):
                return (np.where(turns[ray], middles[ray] + h * np.tan(x), x),
                        np.where(turns[ray], h / np.cos(x)**2, 1))

        def integrand(ray, x):
            t, change = place(ray, x)
            points = self.at(ray, t)
            seen = self.scattered(light, ray, points) * self.transmittance(ray, t)
            return seen * lights.arriving(light, self.media, points) * change[:, None]

        if not light.scatters:
            return np.zeros((self.count, 3))
        group, low, high = self.panels(light, shadowed)
        low, high = (np.where(turns[group], np.arctan2(end - middles[group], distances[group]), end)
                     for end in (low, high))
        return integrate(integrand, group, low, high, self.count)

    def scattered(self, light, ray, points):
        """Scattering coefficient times phase function, of all media."""
        towards, _ = light.towards(points)
        mu = dot(towards, self.directions[ray])
        return sum(medium.sigma_s * (medium.density_at(points, self.directions[ray])
                                     * medium.phase(mu))[:, None] for medium in self.media)

    def ambient(self):
        """What the media scatter of light that comes evenly from everywhere."""
        glowing = [medium for medium in self.media if medium.ambient.any()]
        if not glowing:
            return np.zeros((self.count, 3))

        def integrand(ray, t):
            points = self.at(ray, t)
            source = sum(m.sigma_s * m.ambient
                         * m.density_at(points, self.directions[ray])[:, None] for m in glowing)
            return source * self.transmittance(ray, t)

        return integrate(integrand, *self.panels(None, False), self.count)

    def panels(self, light, shadowed):
        """Parts of the rays, each with its ray's number, in which the integrand is smooth."""
        parts = [self.ray_panels(light, shadowed, ray) for ray in range(self.count)]
        group = np.repeat(np.arange(self.count), [len(part) for part in parts])
        return (group, *np.concatenate(parts).T)

    def ray_panels(self, light, shadowed, ray):
        origin, direction = self.origins[ray], self.directions[ray]
        ends = [ladder(0)]
        for medium in self.media:
            ends.append(medium.ends(origin, direction))
        if hasattr(light, "position"):
            ends.append(ladder((light.position - origin) @ direction))
        hidden = np.empty((0, 2))
        if light:
            ends.append(light.ends(origin, direction))
            ends += [medium.kinks(light, origin, direction) for medium in self.media]
            hidden = self.hidden(light, ray) if shadowed else hidden
        ends = np.unique(np.concatenate([*ends, hidden.ravel()]))
        end = min(self.depth[ray], FAR)
        ends = np.concatenate([[0], ends[(ends > 0) & (ends < end)], [end]])
        middle = (ends[1:] + ends[:-1]) / 2
        dark = np.any((middle[:, None] > hidden[:, 0]) & (middle[:, None] < hidden[:, 1]), axis=1)
        return np.stack([ends[:-1][~dark], ends[1:][~dark]], axis=1)


FAR = 1e9  # what lies beyond adds nothing to the scenes, whose size is 1 to 1000


def ladder(foot):
    """Distances from a foot that double from rung to rung."""
    rungs = 2.0**np.arange(-6, 30, 2)
    return np.concatenate([foot - rungs, [foot], foot + rungs])


def trace(scene, size, pixels):
    """Arrays [n, channels] by the names of vtkAirlightReference's output; besides "Unshadowed",
    the airlight without shadows."""
    rays = Rays(scene, size, pixels)
    ambient = rays.ambient()
    airlight = ambient + sum(rays.airlight(light) for light in rays.lights)
    unshadowed = airlight
    if len(rays.surfaces.triangles):
        unshadowed = ambient + sum(rays.airlight(light, False) for light in rays.lights)
    surface, _ = rays.surface()
    everything = np.arange(rays.count)
    return {"Airlight": airlight, "Surface": surface, "Radiance": airlight + surface,
            "Transmittance": rays.transmittance(everything, rays.depth), "Unshadowed": unshadowed,
            "Depth": np.where(rays.face >= 0, rays.depth, -1)[:, None]}


def seen(scene, size, pixels):
    """What pixels see, as numbers that jump where what they see does: the triangle, the lights that
    reach it, how many ends of shadows and cones and how many parts of media are before it."""
    rays = Rays(scene, size, pixels)
    ends = [[len(rays.lit_ends(light, ray)) for light in rays.lights]
            for ray in range(rays.count)]
    parts = [medium.parts(rays.origins, rays.directions, rays.depth) for medium in rays.media]
    return np.concatenate([rays.face[:, None], rays.surface()[1],
                           np.reshape(ends, (rays.count, -1)), np.transpose(parts)], axis=1)


def steady(scene, size, pixels, step=0.02):
    """Whether pixels see the same within so many pixels, to the corners of a square."""
    here = seen(scene, size, pixels)
    return np.all([np.all(seen(scene, size, np.add(pixels, step * np.array(corner))) == here, axis=1)
                   for corner in ((-1, -1), (1, -1), (-1, 1), (1, 1))], axis=0)
