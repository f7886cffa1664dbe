#!/usr/bin/env python3
"""Write figure1.json and its meshes: a scene in the spirit of Figure 1 of Biri et al. 2006.

    python3 make_figure1.py

Needs numpy, and meshes/cow.ply and meshes/serpent.ply from their scripts here. The serpent stands at
the origin on its plinth, so the hall's floor lies below y = 0. Every mesh is closed and faces
outward; solids that stand on each other overlap by SINK.
"""

import json
import math
import os

import numpy as np

import plymesh

FLOOR = -0.35  # the hall's floor; the plinth's top is y = 0
SINK = 0.01  # how deep a solid stands in the one below it

LIGHT = (-1.4, 3.5, 1.0)
INTENSITY = (140.0, 126.0, 104.0)  # W/sr

SIDES = 24  # of a pillar's shaft; a multiple of 8 gives the square rings their corners
ROD = 0.006  # half the width of the rods that carry the louvre


def merge(parts):
    """Several meshes as one."""
    points, triangles, offset = [], [], 0
    for part_points, part_triangles in parts:
        points.append(part_points)
        triangles.append(part_triangles + offset)
        offset += len(part_points)
    return np.vstack(points), np.vstack(triangles)


def move(mesh, offset, yaw=0.0):
    """Turn a mesh by yaw degrees about y, then shift it."""
    c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
    return mesh[0] @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T + offset, mesh[1]


def box(low, high):
    """An axis-aligned solid box."""
    return lattice(*([low[axis], high[axis]] for axis in range(3)), np.ones((1, 1, 1), dtype=bool))


def lattice(x, y, z, solid):
    """The surface of the solid cells of a rectilinear grid: one closed mesh without T-junctions."""
    lines = [np.asarray(a, dtype=np.float64) for a in (x, y, z)]
    filled = np.pad(solid, 1)
    shape = np.array([len(a) for a in lines])
    triangles = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            step = np.zeros(3, dtype=int)
            step[axis] = 2 * side - 1
            for cell in np.argwhere(solid):
                if filled[tuple(cell + 1 + step)]:
                    continue
                corner = cell.copy()
                corner[axis] += side
                du, dv = np.eye(3, dtype=int)[[u, v]]
                quad = [corner, corner + du, corner + du + dv, corner + dv][:: 2 * side - 1]
                a, b, c, d = (np.ravel_multi_index(q, shape) for q in quad)
                triangles += [(a, b, c), (a, c, d)]
    points = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3)
    used, index = np.unique(np.array(triangles), return_inverse=True)
    return points[used], index.reshape(-1, 3)


def pillar(height, radius):
    """A closed solid: a round shaft between square base and capital, lofted through rings."""
    angles = 2 * math.pi * np.arange(SIDES) / SIDES
    circle = np.stack([np.cos(angles), -np.sin(angles)], axis=1)
    square = circle / np.abs(circle).max(axis=1, keepdims=True)
    base, top = FLOOR - SINK, FLOOR + height
    rings = [
        (square, 1.55, base),
        (square, 1.55, FLOOR + 0.22),
        (circle, 1.45, FLOOR + 0.22),
        (circle, 1.45, FLOOR + 0.30),
        (circle, 1.12, FLOOR + 0.40),
        (circle, 1.00, FLOOR + 0.52),
        (circle, 0.98, FLOOR + 0.5 * height),
        (circle, 0.88, top - 0.55),
        (circle, 1.02, top - 0.50),
        (circle, 1.02, top - 0.44),
        (circle, 0.90, top - 0.40),
        (circle, 1.30, top - 0.20),
        (square, 1.50, top - 0.20),
        (square, 1.50, top),
    ]
    points = [np.insert(radius * scale * outline, 1, y, axis=1) for outline, scale, y in rings]
    points += [[[0, base, 0]], [[0, top, 0]]]
    upper = SIDES * (len(rings) - 1)
    bottom, cap = upper + SIDES, upper + SIDES + 1
    triangles = []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        for ring in range(0, upper, SIDES):
            a, b, c, d = ring + i, ring + j, ring + SIDES + j, ring + SIDES + i
            triangles += [(a, b, c), (a, c, d)]
        triangles += [(bottom, j, i), (cap, upper + i, upper + j)]
    return np.vstack(points), np.array(triangles)


def louvre(width, depth, slats, thickness=0.05, frame=0.08):
    """A frame in the x-z plane filled with slats along z, as wide as the gaps between them."""
    slat_edges = np.linspace(frame - width / 2, width / 2 - frame, 2 * slats + 2)
    x = np.concatenate([[-width / 2], slat_edges, [width / 2]])
    z = [-depth / 2, frame - depth / 2, depth / 2 - frame, depth / 2]
    solid = np.ones((len(x) - 1, 1, len(z) - 1), dtype=bool)
    solid[1:-1:2, 0, 1] = False
    return lattice(x, [-thickness / 2, thickness / 2], z, solid)


def hanging_louvre(centre, tilt, width, depth, slats):
    """A louvre tilted by tilt degrees about z; its four rods keep clear of the light's image."""
    points, triangles = louvre(width, depth, slats)
    c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    rods = []
    for x in (-0.95, 0.25):
        for z in (-1, 1):
            top = turn @ [x * width / 2, 0, z * (depth / 2 - 0.04)] + centre
            low, high = top - [ROD, 0.005, ROD], [top[0] + ROD, 6.0, top[2] + ROD]
            rods.append(box(low, high))
    return merge([(points @ turn.T + centre, triangles)] + rods)


def meshes(folder):
    """The scene's surfaces but the serpent: name, mesh, albedo."""
    yield "figure1_floor", box([-8, FLOOR - 0.2, -5], [8, FLOOR, 14]), [0.50, 0.48, 0.45]
    yield "figure1_wall", box([-8, FLOOR - SINK, -5.3], [8, 6, -5 + SINK]), [0.55, 0.50, 0.42]
    front, back = (-3.8, -1.9, 1.9, 3.8), (-2.85, -0.95, 0.95, 2.85)
    places = [(x, -2.0) for x in front] + [(x, -3.6) for x in back]
    pillars = merge([move(pillar(4.4, 0.30), [x, 0, z]) for x, z in places])
    yield "figure1_pillars", pillars, [0.60, 0.56, 0.50]
    louvre_centre = [-2.05, 2.75, 0.95]
    yield "figure1_louvre", hanging_louvre(louvre_centre, -38, 1.8, 0.9, 5), [0.35, 0.22, 0.12]
    lower = box([-1.85, FLOOR - SINK, -1.1], [1.85, -0.15, 1.1])
    upper = box([-1.65, -0.15 - SINK, -0.9], [1.65, 0, 0.9])
    yield "figure1_plinth", merge([lower, upper]), [0.45, 0.45, 0.48]
    cow = plymesh.read_ply(os.path.join(folder, "cow.ply"))
    yield "figure1_cow", move(cow, [2.3, FLOOR, 0.95], -52), [0.70, 0.66, 0.60]


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    folder = os.path.join(here, "meshes")
    surfaces = [{"mesh": "meshes/serpent.ply", "albedo": [0.35, 0.55, 0.38]}]
    for name, mesh, albedo in meshes(folder):
        plymesh.check(name, *mesh)
        plymesh.write_ply(os.path.join(folder, name + ".ply"), *mesh, "made by make_figure1.py")
        surfaces.append({"mesh": f"meshes/{name}.ply", "albedo": albedo})
    light = {"type": "point", "position": list(LIGHT), "intensity": list(INTENSITY)}
    scene = {
        "name": "figure1",
        "description": "Foggy hall: point light over a serpent, shafts through a louvre, pillars.",
        "image": {"width": 1280, "height": 720},
        "camera": {
            "position": [-0.4, 1.7, 10.5],
            "focal_point": [-0.55, 1.4, 0.0],
            "view_up": [0, 1, 0],
            "view_angle_deg": 26.0,
        },
        "medium": {
            "sigma_s": [0.11, 0.11, 0.115],
            "sigma_a": [0.005, 0.005, 0.006],
            "phase": {"type": "henyey_greenstein", "g": 0.0},
            "bounds": {"type": "box", "min": [-30, -10, -30], "max": [30, 30, 30]},
        },
        "lights": [light],
        "surfaces": surfaces,
    }
    with open(os.path.join(here, "figure1.json"), "w", encoding="ascii", newline="\n") as file:
        json.dump(scene, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
