"""Triangle meshes as numpy arrays: binary PLY and the checks that the example meshes must pass."""

import numpy as np


FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])


def write_ply(path, points, triangles, comment):
    """Write a binary little-endian PLY that vtkPLYReader reads: float32 points, int32 triangles."""
    points = np.asarray(points, dtype="<f4")
    faces = np.empty(len(triangles), dtype=FACE)
    faces["count"] = 3
    faces["corners"] = triangles
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"comment {comment}\n"
        "comment metres, y up, triangles counter-clockwise seen from outside\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    with open(path, "wb") as ply:
        ply.write(header.encode("ascii"))
        ply.write(points.tobytes())
        ply.write(faces.tobytes())


def read_ply(path):
    """Points and triangles of a file that write_ply wrote."""
    with open(path, "rb") as ply:
        header, data = ply.read().split(b"end_header\n", 1)
    words = header.split()
    vertices, faces = (int(words[words.index(name) + 1]) for name in (b"vertex", b"face"))
    points = np.frombuffer(data, "<f4", 3 * vertices).reshape(-1, 3)
    triangles = np.frombuffer(data, FACE, faces, points.nbytes)["corners"]
    return points.astype(np.float64), triangles.astype(np.int64)


def half_edges(triangles):
    """All directed edges, each in its triangle's winding."""
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def unpaired_edges(triangles):
    """Directed edges that do not have exactly one partner running the other way."""
    edges = half_edges(triangles)
    base = int(edges.max()) + 1
    keys = edges[:, 0].astype(np.int64) * base + edges[:, 1]
    partners = edges[:, 1].astype(np.int64) * base + edges[:, 0]
    unique, counts = np.unique(keys, return_counts=True)
    at = np.minimum(np.searchsorted(unique, partners), len(unique) - 1)
    back = np.where(unique[at] == partners, counts[at], 0)
    here = counts[np.searchsorted(unique, keys)]
    return edges[(here != 1) | (back != 1)]


def areas_and_volume(points, triangles):
    """Triangle areas and the enclosed volume, positive when the triangles face outward."""
    corners = np.asarray(points, dtype=np.float64)[triangles]
    corners = corners - corners.reshape(-1, 3).mean(axis=0)
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    volume = np.einsum("ij,ij->", corners[:, 0], cross) / 6
    return np.linalg.norm(cross, axis=1) / 2, volume


def check(name, points, triangles):
    """Print a mesh's figures as stored; raise ValueError unless it is clean and closed."""
    points = np.asarray(points, dtype="<f4")
    areas, volume = areas_and_volume(points, triangles)
    low, high = points.min(axis=0), points.max(axis=0)
    unpaired = len(unpaired_edges(triangles))
    extent = ", ".join(f"{a} {l:.3f}..{h:.3f}" for a, l, h in zip("xyz", low, high))
    print(
        f"{name}: {len(points)} points, {len(triangles)} triangles, {extent}, "
        f"smallest triangle {areas.min():.2g} m2, volume {volume:.4g} m3, unpaired edges {unpaired}"
    )
    if not np.isfinite(points).all():
        raise ValueError(f"{name}: a coordinate is not finite")
    if areas.min() <= 0:
        raise ValueError(f"{name}: {(areas <= 0).sum()} degenerate triangles")
    if unpaired or volume <= 0:
        raise ValueError(f"{name}: not closed or not facing outward")
