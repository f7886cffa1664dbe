# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Six scenes for vtkAirlightReference and for Mitsuba 3. Lengths are of the world; `view` is a
position, a point to look at and an angle in degrees, so small that radiance hardly varies in a pixel.

Lamps are outside media: inside, Mitsuba's estimates have no finite variance.
"""

BOX = {"min": (-1, -1, 0), "max": (1, 1, 2), "albedo": (0.9, 0.8, 0.6), "extinction": (0.5, 1, 1.5),
       "g": 0.0}


def rectangle(origin, first, second, albedo, shines=0.0):
    """The normal, first x second, is on the side from which it shines."""
    return {"origin": origin, "first": first, "second": second, "albedo": albedo, "shines": shines}


FLOOR = rectangle((-2, -2, -0.01), (2, -2, -0.01), (-2, 2, -0.01), (0.4, 0.6, 0.8))


def room(albedo):
    """Walls around (-1.5, -1.5, -0.5) to (1.5, 1.5, 2.5) but for the one at the least y."""
    a, b, c, d = -1.5, 1.5, -0.5, 2.5
    return [rectangle((a, a, c), (b, a, c), (a, b, c), albedo),
            rectangle((a, a, d), (a, b, d), (b, a, d), albedo),
            rectangle((a, a, c), (a, b, c), (a, a, d), albedo),
            rectangle((b, a, c), (b, a, d), (b, b, c), albedo),
            rectangle((a, b, c), (b, b, c), (a, b, d), albedo)]


SCENES = {
    "a lamp above a box": {
        "view": ((4, 0.5, 2), (0, 0.1, 1), 8), "media": [BOX], "surfaces": [],
        "lamps": [{"position": (0.3, 0.2, 3), "intensity": (10, 9, 8)}]},
    "sun on a box that scatters forward, above a floor": {
        "view": ((4, 0.5, 2), (0, 0.1, 1), 8), "media": [dict(BOX, g=0.5)], "surfaces": [FLOOR],
        "lamps": [{"towards": (-0.5, 0.2, -1), "irradiance": (3, 3, 3)}]},
    "two lamps on a floor through a box that scatters backward": {
        "view": ((3, 0.5, 4), (0, 0.1, 0.2), 8), "media": [dict(BOX, g=-0.4)], "surfaces": [FLOOR],
        "lamps": [{"position": (0.3, 0.2, 3), "intensity": (5, 1, 1)},
                  {"position": (-2.5, 1, 2), "intensity": (1, 8, 8)}]},
    "a room without a medium": {
        "view": ((0.3, -4, 1.2), (0.1, 0, 0.9), 8), "media": [], "surfaces": room((0.7, 0.5, 0.3)),
        "lamps": [{"position": (0.4, -0.5, 1.6), "intensity": (1, 1, 1)}]},
    "a room with a box": {
        "view": ((0.3, -4, 1.2), (0.1, 0, 0.9), 8),
        "media": [dict(BOX, min=(-0.8, -0.6, 0.1), max=(0.7, 0.9, 1.4))],
        "surfaces": room((0.7, 0.7, 0.5)),
        "lamps": [{"position": (0.4, -0.5, 2.1), "intensity": (2, 2, 2)}]},
    "a wall that shines on a box": {
        "view": ((4, 0.5, 2), (0, 0.1, 1), 8), "media": [BOX],
        "surfaces": [FLOOR, rectangle((-1.5, -2, 0), (-1.5, 2, 0), (-1.5, -2, 3), (0.5, 0.5, 0.5), 1)],
        "lamps": [{"position": (0.3, 0.2, 3), "intensity": (1, 1, 1)}]},
}
