#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks which room includes which: see "Rooms" in CONTRIBUTING.md.

Usage: Utilities/check-includes.py [--counts]

Fails with a list of the includes that the rules forbid. --counts prints figures of the structure.
"""

import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
TOPS = ("Module", "Filters", "Rendering")
# A room may include the rooms of the rows above its own, not those of its own row.
LAYERS = (
    ("OpenGL",),
    ("Scene", "Casters", "Translucency"),
    ("ShadowVolumes", "ShadowMaps", "MapperShaders"),
    ("Inscatter", "Composite"),
    ("Frame",),
    ("Pass",),
    ("",),  # the public classes
)
RANK = {room: rank for rank, rooms in enumerate(LAYERS) for room in rooms}
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.MULTILINE)
CODE = (".h", ".cxx", ".inl")


def place(path):
    """(top folder, room) of a file; the room is empty for public classes."""
    parts = path.relative_to(ROOT).parts
    if parts[0] not in TOPS:
        return parts[0], ""
    rooms = [part for part in parts[1:-1] if part != "glsl"]
    if "glsl" in parts and parts[0] == "Module":
        return parts[0], "glsl"
    return parts[0], rooms[0] if rooms else ""


def files():
    """All code and shaders of the library, and what is outside and may be included."""
    found = []
    for top in TOPS:
        found += [p for p in sorted((ROOT / top).rglob("*")) if p.suffix in CODE + (".glsl",)]
    return found


class Tree:
    """Finds the file that an include names."""

    def __init__(self, paths):
        self.by_name = collections.defaultdict(list)
        for path in paths:
            relative = path.relative_to(ROOT)
            below = "/".join(relative.parts[1:])
            self.by_name[below].append(path)
            if "glsl" in relative.parts:
                self.by_name[path.stem + ".h"].append(path)  # the header made of it
                self.by_name[below.replace("glsl/", "", 1)].append(path)

    def find(self, name, source):
        found = self.by_name.get(name, [])
        same = [path for path in found if place(path)[0] == place(source)[0]]
        return (same or found or [None])[0]


def allowed(source, target):
    """Whether `source` may include `target`, and the rule if it may not."""
    from_top, from_room = place(source)
    to_top, to_room = place(target)
    if TOPS.index(to_top) > TOPS.index(from_top):
        return f"{from_top} may not include {to_top}"
    if from_top != "Rendering" or to_top != "Rendering" or from_room == to_room:
        return None
    if RANK[to_room] >= RANK[from_room]:
        name = to_room or "the public classes"
        return f"{from_room or 'a public class'} may not include {name}"
    return None


def strings(path, text):
    """Words that only one room may name."""
    top, room = place(path)
    if room != "OpenVDB" and re.search(r"#\s*include\s*<openvdb/", text):
        yield "only Filters/OpenVDB includes OpenVDB"
    if top == "Rendering" and room != "OpenGL" and re.search(r"binding\s*=\s*\d", text):
        yield "only Rendering/OpenGL names a binding point"
    if room != "MapperShaders" and re.search(r'"//VTK::|[^/]//VTK::\w+::(Dec|Impl)', text):
        yield "only Rendering/MapperShaders names VTK's GLSL"
    # The location of a key, under which users look it up, is the class that gives it.
    text = text.replace('Location = "vtkAirlightPass"', "")
    if top != "Rendering" and re.search(r'"vtkAirlight(Pass|PolyDataMapper)"', text):
        yield "a class of Rendering is named by a string"


def check(paths):
    tree = Tree(paths)
    findings = []
    for path in paths:
        text = path.read_text(encoding="utf-8")
        name = path.relative_to(ROOT)
        findings += [f"{name}: {rule}" for rule in strings(path, text)]
        for include in INCLUDE.findall(text):
            target = tree.find(include, path)
            rule = allowed(path, target) if target else None
            if rule:
                findings.append(f"{name}: includes {include}: {rule}")
    return findings


def counts(paths):
    """Figures of the structure."""
    sources = collections.Counter()
    classes = collections.Counter()
    lone = []
    for path in paths:
        if path.suffix == ".cxx":
            sources[path.parent.relative_to(ROOT)] += 1
            text = path.read_text(encoding="utf-8")
            for name in set(re.findall(r"^[\w:&*<> ]*?\b(\w+)(?:::Internals)?::~?\w+\(", text, re.MULTILINE)):
                classes[name] += 1
            if not path.with_suffix(".h").exists():
                lone.append(str(path.relative_to(ROOT)))
    for folder, count in sorted(sources.items()):
        print(f"{count:4} sources in {folder}")
    print(f"{len(lone)} sources without a header of their name: {' '.join(lone)}")
    print("in more than two sources:", *sorted(
        f"{name} ({count})" for name, count in classes.items() if count > 2))
    for folder in ("Testing/Cxx/Module", "Testing/Cxx/Filters", "Testing/Cxx/Rendering",
                   "Testing/Cxx/Composition", "Testing/Cxx/Viewer", "Testing/Support"):
        print(f"{len(list((ROOT / folder).glob('*.*')))} files in {folder}")


def main():
    paths = files()
    if sys.argv[1:] == ["--counts"]:
        counts(paths)
    elif sys.argv[1:]:
        print(__doc__)
        return 2
    findings = check(paths)
    print("\n".join(findings) or "no forbidden include")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
