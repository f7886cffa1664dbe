#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Turn Keenan Crane's cow "Spot" into meshes/cow.ply.

    python3 convert_spot.py spot.zip

spot.zip is on the author's page, https://www.cs.cmu.edu/~kmcrane/Projects/ModelRepository/. Needs
numpy and VTK's Python modules. The cow is only scaled, placed and turned: metres, y up, standing on y = 0, facing +z.
"""

import argparse
import os
import zipfile

import numpy as np

import closing
import plymesh

HEIGHT = 1.1  # metres


def parse_obj(text):
    """Points and triangles of a Wavefront OBJ file of triangles."""
    rows = [line.split() for line in text.splitlines()]
    points = np.array([row[1:4] for row in rows if row[:1] == ["v"]], dtype=np.float64)
    faces = [[corner.split("/")[0] for corner in row[1:4]] for row in rows if row[:1] == ["f"]]
    return points, np.array(faces, dtype=np.int64) - 1


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    here = os.path.dirname(os.path.abspath(__file__))
    parser.add_argument("archive", help="spot.zip")
    options = parser.parse_args()
    with zipfile.ZipFile(options.archive) as archive:
        points, triangles = parse_obj(archive.read("spot/spot_triangulated.obj").decode("ascii"))
    points = closing.stand(points * (-1, 1, -1), 1, HEIGHT)
    plymesh.check("cow.ply", points, triangles)
    plymesh.write_ply(os.path.join(here, "meshes", "cow.ply"), points, triangles,
                      "Spot by Keenan Crane, public domain")


if __name__ == "__main__":
    main()
