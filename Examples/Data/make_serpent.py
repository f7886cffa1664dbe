#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Model the winged serpent of Figure 1: meshes/serpent.ply.

    python3 make_serpent.py

Needs numpy and VTK's Python modules. The serpent is a level set of a field: distances to round
cones (body, horns, spines, bones of the wings) and to thick triangles (the wings' skin), blended
where they meet, with scales pressed into the body. vtkFlyingEdges3D turns it into triangles and
vtkQuadricDecimation keeps those that matter. Lengths are metres, y is up, the feet stand on y = 0.
"""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkWindowedSincPolyDataFilter

import closing
import plymesh

TRIANGLES = 40000
CELL = 0.016  # of the grid
LOW, HIGH = np.array((-1.75, -0.1, -1.15)), np.array((1.75, 2.75, 1.0))
FAR = 0.3  # value of the field where nothing is near
BLEND = 0.035  # how far two parts that meet flow into each other

# The body from tail to head: x, y, z and radius.
BODY = np.array([
    (1.25, 1.10, 0.62, 0.012), (1.42, 0.86, 0.60, 0.03), (1.40, 0.50, 0.52, 0.06),
    (1.12, 0.17, 0.40, 0.10), (0.78, 0.17, 0.10, 0.13), (0.62, 0.55, -0.28, 0.15),
    (0.42, 0.92, -0.38, 0.17), (0.12, 0.78, -0.18, 0.18), (-0.02, 0.36, 0.22, 0.19),
    (-0.30, 0.19, 0.52, 0.19), (-0.78, 0.19, 0.48, 0.19), (-1.05, 0.23, 0.10, 0.19),
    (-0.90, 0.46, -0.30, 0.20), (-0.48, 0.86, -0.44, 0.21), (-0.14, 1.28, -0.30, 0.22),
    (-0.12, 1.68, -0.04, 0.18), (-0.34, 2.00, 0.12, 0.14), (-0.66, 2.06, 0.24, 0.13)])
SCALES = 9  # around the body
SHOULDER = np.array((-0.16, 1.30, -0.36))


def smooth_path(points, count):
    """Points on a Catmull-Rom spline through points, at equal steps of its parameter."""
    p = np.vstack([2 * points[0] - points[1], points, 2 * points[-1] - points[-2]])
    t = np.linspace(0, len(points) - 1 - 1e-9, count)
    i, u = t.astype(int), (t % 1)[:, None]
    a, b, c, d = (p[i + k] for k in range(4))
    return 0.5 * (2 * b + (c - a) * u + (2 * a - 5 * b + 4 * c - d) * u**2
                  + (3 * b - 3 * c + d - a) * u**3)


class Field:
    """A grid of values that are below 0 inside; parts are added one after the other."""

    def __init__(self):
        self.axes = [np.arange(low, high, CELL) for low, high in zip(LOW, HIGH)]
        self.values = np.full([len(axis) for axis in self.axes], FAR)

    def near(self, low, high, margin=FAR / 2):
        """Slices of the grid within a box and a margin, and the points there."""
        place = tuple(slice(*np.searchsorted(axis, (a - margin, b + margin)))
                      for axis, a, b in zip(self.axes, low, high))
        x, y, z = (axis[part] for axis, part in zip(self.axes, place))
        return place, np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1)

    def add(self, place, distance, blend=BLEND):
        """Unites a part with the rest: the polynomial smooth minimum."""
        old = self.values[place]
        overlap = np.maximum(blend - np.abs(old - distance), 0) / blend
        self.values[place] = np.minimum(old, distance) - overlap**2 * blend / 4

    def cone(self, a, b, ra, rb, blend=BLEND):
        """A rod with round ends, from a with radius ra to b with radius rb."""
        a, b = np.asarray(a, float), np.asarray(b, float)
        radius = max(ra, rb)
        place, points = self.near(np.minimum(a, b) - radius, np.maximum(a, b) + radius)
        t = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        axis = a + t[..., None] * (b - a)
        self.add(place, np.linalg.norm(points - axis, axis=-1) - ra - t * (rb - ra), blend)

    def chain(self, points, radii, blend=BLEND):
        for k in range(len(points) - 1):
            self.cone(points[k], points[k + 1], radii[k], radii[k + 1], blend)

    def skin(self, a, b, c, thickness, blend=BLEND):
        """A triangle with a thickness."""
        corners = np.array((a, b, c), float)
        place, p = self.near(corners.min(axis=0), corners.max(axis=0), 4 * thickness)
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal /= np.linalg.norm(normal)
        plane = np.abs((p - corners[0]) @ normal)
        edge, inside = np.full(plane.shape, np.inf), np.ones(plane.shape, bool)
        for k in range(3):
            start, along = corners[k], corners[(k + 1) % 3] - corners[k]
            t = np.clip((p - start) @ along / (along @ along), 0, 1)
            edge = np.minimum(edge, np.linalg.norm(p - start - t[..., None] * along, axis=-1))
            inside &= (p - start) @ np.cross(normal, along) >= 0
        self.add(place, np.where(inside, plane, edge) - thickness, blend)


def frames(path):
    """Directions along the path, and to its back: parallel transport, upright at the chest."""
    along = np.gradient(path, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    back = np.zeros_like(along)
    start = int(0.55 * len(path))
    up = np.array((0.0, 1.0, 0.0))
    for order in (range(start, len(path)), range(start, -1, -1)):
        previous = up
        for k in order:
            previous = previous - along[k] * (previous @ along[k])
            previous /= np.linalg.norm(previous)
            back[k] = previous
    back = 0.3 * back + up - along * (along @ up)[:, None]  # mostly upwards where it can be
    return along, back / np.linalg.norm(back, axis=1, keepdims=True)


def add_body(field):
    path = smooth_path(BODY, 420)
    points, radii = path[:, :3], path[:, 3]
    along, back = frames(points)
    side = np.cross(along, back)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    nearest = np.full(field.values.shape, FAR)
    for k in range(len(points)):
        place, p = field.near(points[k] - radii[k], points[k] + radii[k])
        way = p - points[k]
        distance = np.linalg.norm(way, axis=-1) - radii[k]
        closer = distance < nearest[place]
        angle = np.arctan2(way @ side[k], way @ back[k])
        s = (length[k] + way @ along[k]) / (6.0 * max(radii[k], 0.05) / SCALES)
        # A scale rises towards the tail, and its neighbours in the next row are half a scale off.
        across = np.abs(np.cos(SCALES / 2 * angle + np.floor(s) % 2 * np.pi / 2))
        belly = np.clip(np.cos(angle) + 0.75, 0, 1)
        rise = radii[k] * 0.055 * (belly * (1 - s % 1) * np.sqrt(across)
                                  + (1 - belly) * 0.6 * np.sin(np.pi * s)**2)
        nearest[place] = np.where(closer, distance - rise, nearest[place])
    field.values = np.minimum(field.values, nearest)
    step = 0
    for k in range(12, len(points) - 12):  # spines, larger on the chest
        if length[k] >= step:
            height = 0.06 + 0.75 * radii[k]
            foot = points[k] + 0.8 * radii[k] * back[k]
            tip = points[k] + (radii[k] + 0.55 * height) * back[k] - 0.45 * height * along[k]
            field.cone(foot, tip, 0.22 * radii[k] + 0.012, 0.010, 0.02)
            step = length[k] + 0.055 + 0.42 * radii[k]
    return points[-1]


def add_head(field, neck):
    along = np.array((-0.90, -0.22, 0.42))
    along /= np.linalg.norm(along)
    side = np.cross(along, (0, 1, 0.1))
    side /= np.linalg.norm(side)
    back = np.cross(side, along)

    def at(forward, up, out=0.0):
        return neck + 1.15 * (forward * along + up * back + out * side)

    field.cone(at(-0.02, 0.01), at(0.12, 0.03), 0.14, 0.15)  # skull
    field.cone(at(0.14, 0.02), at(0.46, -0.02), 0.115, 0.075)  # snout
    field.cone(at(0.06, -0.12), at(0.36, -0.30), 0.085, 0.042)  # jaw
    field.cone(at(0.47, 0.03), at(0.49, 0.07), 0.03, 0.02)
    for s in (-1, 1):
        field.cone(at(0.16, 0.10, s * 0.09), at(0.03, 0.14, s * 0.12), 0.03, 0.045, 0.02)  # brow
        field.cone(at(0.155, 0.06, s * 0.115), at(0.16, 0.06, s * 0.12), 0.035, 0.035, 0.006)
        field.cone(at(0.46, 0.03, s * 0.045), at(0.49, 0.05, s * 0.05), 0.025, 0.02, 0.01)
        horn = [at(-0.02, 0.12, s * 0.09), at(-0.18, 0.27, s * 0.15), at(-0.36, 0.33, s * 0.19),
                at(-0.55, 0.30, s * 0.20)]
        field.chain(horn, (0.05, 0.04, 0.028, 0.012), 0.02)
        for forward in (0.20, 0.30, 0.40, 0.47):  # teeth above and below
            field.cone(at(forward, -0.06, s * 0.055), at(forward, -0.13, s * 0.05), 0.018, 0.007,
                       0.008)
        for forward in (0.24, 0.33):
            below = -0.10 - 0.60 * (forward - 0.06)
            field.cone(at(forward, below, s * 0.035), at(forward, below + 0.09, s * 0.04), 0.016,
                       0.007, 0.008)
        for tip in ((-0.20, -0.02, 0.27), (-0.16, -0.14, 0.25)):  # frills
            field.cone(at(0.0, -0.03, s * 0.12), at(tip[0], tip[1], s * tip[2]), 0.04, 0.010, 0.02)


def add_wing(field, wrist, tips, elbow):
    """An arm, a fan of fingers, and skin between them whose edge is scalloped."""
    wrist, elbow = np.array(wrist), np.array(elbow)
    field.chain([SHOULDER, elbow, wrist], (0.10, 0.065, 0.05))
    claw = wrist + 0.22 * (wrist - elbow) / np.linalg.norm(wrist - elbow)
    field.cone(wrist, claw, 0.035, 0.01, 0.02)
    fingers = []
    for tip in tips:
        tip = np.array(tip)
        bow = (wrist + tip) / 2 + (0, 0.10, -0.06)
        finger = smooth_path(np.array((wrist, bow, tip)), 9)
        field.chain(finger, np.linspace(0.034, 0.014, 9), 0.015)
        fingers.append(finger)
    steps, across = np.linspace(0.05, 1, 9), np.linspace(0, 1, 13)
    for one, two in zip(fingers, fingers[1:]):
        reach = 1 - 0.42 * (4 * across * (1 - across))**0.8  # deepest between the fingers
        rows = np.array([[between(one, two, u, r * step) for u, r in zip(across, reach)]
                         for step in steps])
        for k, j in np.ndindex(len(steps) - 1, len(across) - 1):
            a, b, c, d = rows[k, j], rows[k, j + 1], rows[k + 1, j + 1], rows[k + 1, j]
            field.skin(a, b, c, 0.013, 0.004)
            field.skin(a, c, d, 0.013, 0.004)


def between(one, two, across, along):
    """A point of the skin between two fingers: 0 to 1 from one to two, and from wrist to tip."""
    place = along * (len(one) - 1)
    k = min(int(place), len(one) - 2)
    first, second = (f[k] + (place - k) * (f[k + 1] - f[k]) for f in (one, two))
    return first + across * (second - first)


def triangulate(field):
    """The surface where the field is 0."""
    image = vtkImageData()
    image.SetDimensions(field.values.shape)
    image.SetOrigin(LOW)
    image.SetSpacing(3 * [CELL])
    values = np.where(np.abs(field.values) < 1e-4 * CELL, 1e-4 * CELL, field.values)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(order="F"), deep=True))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    smooth = vtkWindowedSincPolyDataFilter()  # takes the grid's steps away
    smooth.SetInputConnection(contour.GetOutputPort())
    smooth.SetNumberOfIterations(12)
    smooth.SetPassBand(0.12)
    smooth.BoundarySmoothingOff()
    smooth.FeatureEdgeSmoothingOff()
    smooth.NormalizeCoordinatesOn()
    smooth.Update()
    surface = smooth.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float64)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return closing.weld(points, triangles[:, ::-1].astype(np.int64))


def main():
    field = Field()
    add_head(field, add_body(field))
    add_wing(field, (0.42, 2.25, -0.72), [(0.62, 2.60, -0.85), (1.30, 2.42, -0.72),
                                          (1.52, 1.92, -0.56), (1.30, 1.42, -0.46),
                                          (0.80, 1.12, -0.48)], (0.02, 1.78, -0.62))
    add_wing(field, (-0.98, 2.15, -0.82), [(-1.12, 2.58, -0.95), (-1.55, 2.05, -0.90),
                                           (-1.60, 1.55, -0.78), (-1.32, 1.10, -0.66),
                                           (-0.86, 0.98, -0.62)], (-0.52, 1.70, -0.66))
    points, triangles = triangulate(field)
    print(f"  {len(triangles)} triangles before decimation")
    points, triangles = closing.largest_part(points, triangles)
    points, triangles = closing.repair(*closing.decimate(points, triangles, TRIANGLES))
    points[:, 1] -= points[:, 1].min()
    plymesh.check("serpent.ply", points, triangles)
    here = os.path.dirname(os.path.abspath(__file__))
    plymesh.write_ply(os.path.join(here, "meshes", "serpent.ply"), points, triangles,
                      "winged serpent, made by make_serpent.py")


if __name__ == "__main__":
    main()
