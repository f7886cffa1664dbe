# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Which parts of a ray triangles hide from a light, exactly, and which points.

Ray and light span a plane. A triangle meets it in a segment, and what the segment hides of the
ray is one interval. In the plane a point has two coordinates: `along`, the parameter of the point
of the ray that lies behind it as the light sees it, and `before`, above 0 for what is between the
light and the ray.
"""

import numpy as np

from geometry import line_triangles, norm


def segments(triangles, normal, anchor):
    """Ends [k, 2, 3] of the segments in which triangles meet a plane."""
    height = (triangles - anchor) @ normal
    ends = []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        a, b = height[:, i], height[:, j]
        with np.errstate(divide="ignore", invalid="ignore"):
            share = a / (a - b)
        point = triangles[:, i] + share[:, None] * (triangles[:, j] - triangles[:, i])
        ends.append(np.where(((a > 0) != (b > 0))[:, None], point, np.nan))
    ends = np.stack(ends, axis=1)
    there = np.isfinite(ends[..., 0])
    meets = there.sum(axis=1) == 2
    return ends[meets][there[meets]].reshape(-1, 2, 3)


def clip(segment, low, high):
    """Those parts of segments [k, 2, 2] whose second coordinate is in [low, high]."""
    a, b = segment[:, 0], segment[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = (np.array([low, high])[:, None] - a[:, 1]) / (b - a)[:, 1]
    inside = (a[:, 1] >= low) & (a[:, 1] <= high)
    flat = a[:, 1] == b[:, 1]
    ends = np.where(flat, np.where(inside, [[0], [1]], [[1], [0]]), np.sort(ends, axis=0))
    enter, leave = np.maximum(ends[0], 0), np.minimum(ends[1], 1)
    keep = enter < leave
    a, b, enter, leave = a[keep], b[keep], enter[keep, None], leave[keep, None]
    return np.stack([a + enter * (b - a), a + leave * (b - a)], axis=1)


def hidden_from_point(origin, direction, position, triangles):
    foot = (position - origin) @ direction
    aside = origin + foot * direction - position
    distance = norm(aside)
    if distance < 1e-9 and abs(foot) < 1e-9:  # the eye is the light: what it sees is lit
        return np.empty((0, 2))
    aside = aside / distance
    found = segments(triangles, np.cross(aside, direction), position)
    if not len(found):
        return np.empty((0, 2))
    # The light at (0, 0), the ray the line of second coordinate `distance`.
    flat = np.stack([(found - position) @ direction, (found - position) @ aside], axis=-1)
    flat = clip(flat, 0.0, distance)
    before = np.maximum(flat[..., 1], 0) + 0.0  # not a little below 0, nor -0
    with np.errstate(divide="ignore"):
        return np.sort(foot + distance * flat[..., 0] / before, axis=1)


def hidden_from_direction(origin, direction, to_light, triangles):
    normal = np.cross(direction, to_light)
    found = segments(triangles, normal / norm(normal), origin)
    if not len(found):
        return np.empty((0, 2))
    # point = origin + along direction + before to_light
    flat = (found - origin) @ np.linalg.pinv(np.stack([direction, to_light]))
    return np.sort(clip(flat, 0.0, np.inf)[..., 0], axis=1)


def merged(parts):
    """The union of intervals [k, 2], in order. Neighbouring triangles' meet but for rounding."""
    union = []
    for start, end in sorted(map(tuple, parts)):
        if union and start <= union[-1][1] + 1e-10 * (1 + abs(start)):
            union[-1][1] = max(union[-1][1], end)
        else:
            union.append([start, end])
    return np.array(union).reshape(-1, 2)


def hidden(light, origin, direction, triangles):
    """The parts [k, 2] of a ray, in order, that are in shadow."""
    if not len(triangles):
        return np.empty((0, 2))
    if hasattr(light, "position"):
        return merged(hidden_from_point(origin, direction, light.position, triangles))
    return merged(hidden_from_direction(origin, direction, light.to_light, triangles))


def is_lit(light, points, triangles):
    """Whether points of surfaces see the light; their own surface does not hide it."""
    if not len(triangles):
        return np.ones(len(points), bool)
    directions, distances = light.towards(points)
    t = line_triangles(points, directions, triangles)
    near = 1e-7 * (1 + norm(points))[:, None]
    with np.errstate(invalid="ignore"):
        return ~np.any((t > near) & (t < distances[:, None]), axis=1)
