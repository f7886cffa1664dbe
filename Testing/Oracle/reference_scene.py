#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""reference_scene.py SCENE.json OUTPUT_PREFIX: the pictures of a reference scene.

Reads the scenes of Testing/Data/Reference/scenes and writes OUTPUT_PREFIX.PART.pfm for the parts
total, inscatter, surface, transmittance, depth, mask and shadowmask (see README.md beside this
file). Takes one to three minutes a scene.
"""

import json
import os
import sys

import numpy as np

import meshes
import tracer

RAYS_AT_ONCE = 1000
COLOURS = {"total": "Radiance", "inscatter": "Airlight", "surface": "Surface",
           "transmittance": "Transmittance"}


def read_scene(path):
    """The tracer's scene of a file, and the picture's size."""
    with open(path) as file:
        values = json.load(file)
    folder = os.path.join(os.path.dirname(os.path.abspath(path)), "..")
    medium = dict(values["medium"])
    phase, bounds = medium.pop("phase"), medium.pop("bounds")
    if phase["type"] != "henyey_greenstein" or bounds["type"] != "box":
        raise ValueError(f"{path}: a phase function or region that is not known here")
    surfaces = []
    for surface in values["surfaces"]:
        points, faces = meshes.read_ply(os.path.join(folder, surface["mesh"]))
        surfaces.append({"points": points, "faces": faces, "albedo": surface["albedo"]})
    scene = {"camera": values["camera"], "lights": values["lights"], "surfaces": surfaces,
             "media": [{**medium, "phase": phase, "region": bounds}]}
    return scene, (values["image"]["width"], values["image"]["height"])


def trace(scene, size, places):
    """The tracer's arrays at places of the picture [n, 2], some at a time."""
    parts = [tracer.trace(scene, size, places[first:first + RAYS_AT_ONCE])
             for first in range(0, len(places), RAYS_AT_ONCE)]
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def middles(width, height):
    """Of all pixels [width * height, 2], row by row from the lowest."""
    y, x = np.mgrid[0:height, 0:width] + 0.5
    return np.stack([x.ravel(), y.ravel()], axis=1)


def stable(scene, size, places, picture):
    """Whether radiance and depth a quarter of a pixel aside, to four sides, are within 5 %."""
    steady = np.ones(len(places), bool)
    for corner in ((-0.25, -0.25), (0.25, -0.25), (-0.25, 0.25), (0.25, 0.25)):
        aside = trace(scene, size, places + corner)
        for name in ("Radiance", "Depth"):
            change = np.abs(aside[name] - picture[name])
            steady &= np.all(change <= 0.05 * np.abs(picture[name]), axis=1)
    return steady


def shadowed(picture, mask):
    """Which stable pixels lose more than 5 % of their radiance to shadows through the medium."""
    lost = picture["Unshadowed"] - picture["Airlight"]
    return mask & np.any(lost > 0.05 * (picture["Radiance"] + lost), axis=1)


def write_pfm(path, values, size):
    """[pixels, channels], the lowest row first, in single precision."""
    with open(path, "wb") as file:
        kind = "PF" if values.shape[1] == 3 else "Pf"
        file.write(f"{kind}\n{size[0]} {size[1]}\n-1.0\n".encode())
        file.write(values.astype("<f4").tobytes())


def main(scene_path, prefix):
    scene, size = read_scene(scene_path)
    places = middles(*size)
    picture = trace(scene, size, places)
    for part, name in COLOURS.items():
        write_pfm(f"{prefix}.{part}.pfm", picture[name], size)
    write_pfm(f"{prefix}.depth.pfm", picture["Depth"], size)
    mask = stable(scene, size, places, picture)
    write_pfm(f"{prefix}.mask.pfm", mask[:, None], size)
    if scene["surfaces"]:
        write_pfm(f"{prefix}.shadowmask.pfm", shadowed(picture, mask)[:, None], size)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
