#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Assembles CHANGELOG.md from the release notes in Documentation/release.

Usage: Utilities/changelog.py             writes CHANGELOG.md
       Utilities/changelog.py --check     fails if CHANGELOG.md differs from the notes
       Utilities/changelog.py --release   writes the version of CMakeLists.txt into the notes that
                                          name none, then CHANGELOG.md

A note that belongs to a released version begins with the line "<!-- version: 0.1.0 -->". Notes
without it are unreleased. The newest version comes first; its notes are in the order of their
titles.
"""

import argparse
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
MARK = re.compile(r"\A<!-- version: (\d+\.\d+\.\d+) -->\n+")
HEADING = re.compile(r"^(#+) +(.*)$", re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCED = re.compile(r"^```.*?^```", re.DOTALL | re.MULTILINE)

HEAD = """# Changelog

<!-- Utilities/changelog.py writes this file. Edit the notes in Documentation/release instead. -->

[All release notes](Documentation/release) are here in one page, the newest version first.
"""


def project_version(root):
    """The version that project() in CMakeLists.txt has: the one place for it."""
    text = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.findall(r"^  VERSION (\d+\.\d+\.\d+)$", text, re.MULTILINE)
    if len(found) != 1:
        raise ValueError(f"CMakeLists.txt has {len(found)} lines '  VERSION x.y.z', not one")
    return found[0]


def as_numbers(version):
    return tuple(int(part) for part in version.split("."))


def outside_code(text, change):
    """text with change() applied to the parts that are not fenced code."""
    parts, end = [], 0
    for block in FENCED.finditer(text):
        parts += [change(text[end:block.start()]), block.group()]
        end = block.end()
    return "".join(parts) + change(text[end:])


def adapt(note, text):
    """The text of a note as a section of CHANGELOG.md: headings below the version's, and links."""
    top = min(len(heading[0]) for heading in HEADING.findall(FENCED.sub("", text)))

    def link(match):
        target, hash_sign, anchor = match.group(1).partition("#")
        if "://" in target or not target:
            return match.group()
        path = pathlib.PurePosixPath(os.path.normpath(f"Documentation/release/{target}"))
        if path.parent == pathlib.PurePosixPath("Documentation/release") and path.suffix == ".md":
            return f"](#{slug(title_of(note.with_name(path.name)))})"
        return f"]({path}{hash_sign}{anchor})"

    def change(part):
        part = HEADING.sub(lambda h: f"{'#' * (len(h.group(1)) - top + 3)} {h.group(2)}", part)
        return LINK.sub(link, part)

    return outside_code(text, change)


def read_note(path):
    """(the version or None, the text)."""
    text = path.read_text(encoding="utf-8")
    mark = MARK.match(text)
    return (mark.group(1), text[mark.end():]) if mark else (None, text)


def title_of(path):
    return HEADING.search(read_note(path)[1]).group(2).strip()


def slug(title):
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def assemble(root):
    """The text of CHANGELOG.md. Raises ValueError if a note is not as it should be."""
    versions, problems = {}, []
    for path in sorted((root / "Documentation" / "release").glob("*.md")):
        version, text = read_note(path)
        if not text.startswith("#"):
            problems.append(f"{path.name} begins with neither a heading nor a version")
            continue
        versions.setdefault(version, []).append((title_of(path), path, text))
    current = project_version(root)
    named = [as_numbers(version) for version in versions if version]
    if named and max(named) > as_numbers(current):
        problems.append(f"a note is of a version after {current}, that of CMakeLists.txt")
    titles = [title for notes in versions.values() for title, _, _ in notes]
    problems += [f"two notes are named '{title}'" for title in sorted(set(titles))
                 if titles.count(title) > 1]
    if problems:
        raise ValueError("; ".join(problems))
    unreleased = "Unreleased" if current in versions else f"{current} (unreleased)"
    text = HEAD
    for version in sorted(versions, key=lambda v: as_numbers(v) if v else (1 << 30,), reverse=True):
        text += f"\n## {version or unreleased}\n"
        for _, path, note in sorted(versions[version], key=lambda n: (n[0].lower(), n[1].name)):
            text += "\n" + adapt(path, note).strip() + "\n"
    return text


def mark_notes(root):
    """Writes the current version into the notes without one; returns their number."""
    count = 0
    for path in sorted((root / "Documentation" / "release").glob("*.md")):
        version, text = read_note(path)
        if version is None:
            mark = f"<!-- version: {project_version(root)} -->\n\n"
            path.write_text(mark + text, encoding="utf-8")
            count += 1
    return count


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("--release", action="store_true", help="give the notes the version")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help=argparse.SUPPRESS)
    options = parser.parse_args()
    changelog = options.root / "CHANGELOG.md"
    try:
        if options.release and not options.check:
            print(f"{mark_notes(options.root)} notes are now of {project_version(options.root)}")
        text = assemble(options.root)
    except ValueError as error:
        return f"error: {error}"
    if not options.check:
        changelog.write_text(text, encoding="utf-8")
    elif not changelog.exists() or changelog.read_text(encoding="utf-8") != text:
        return "error: CHANGELOG.md differs from the release notes: run Utilities/changelog.py"
    return 0


if __name__ == "__main__":
    sys.exit(main())
