# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The patches of Testing/Mutants still apply, and name tests that there are.

Utilities/mutants.sh runs them, which takes an hour. This test needs no Git, so that it works in an
archive of the sources, too.
"""

import fnmatch
import pathlib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Testing" / "Mutants"
LEAST = 48
LAYERS = ("Module/[A-Z]*", "Module/glsl/*", "Filters/*", "Rendering/*", "Rendering/*/glsl",
          "ParaView/*", "Examples/airlight/*", "Wrapping/*")


class Patch:
    """A patch: the lines before it, and for each file what its hunks replace by what."""

    def __init__(self, path):
        self.name = path.stem
        text = path.read_text(encoding="utf-8")
        self.head, _, body = text.partition("\n--- a/")
        self.head = self.head.splitlines()
        self.files = {}
        hunks = None
        for line in ("--- a/" + body).splitlines():
            if line.startswith("--- a/"):
                hunks = self.files.setdefault(line[6:], [])
            elif line.startswith("@@"):
                hunks.append(([], []))
            elif not line.startswith("+++ "):
                self.add(hunks[-1], line)

    @staticmethod
    def add(hunk, line):
        old, new = hunk
        if line[:1] != "+":
            old.append(line[1:])
        if line[:1] != "-":
            new.append(line[1:])

    def tests(self):
        lines = [line[7:] for line in self.head if line.startswith("Tests: ")]
        return lines[0].split("|") if len(lines) == 1 else []


def count(lines, part):
    """How often the lines have the part, a list of lines."""
    return sum(lines[i:i + len(part)] == part for i in range(len(lines) - len(part) + 1))


def has_test(name):
    kind, _, script = name.rpartition("-")
    if kind == "RandomScenes":  # Testing/Random/CMakeLists.txt
        return script in {"Open", "Faults", "Kept"} | {str(first) for first in range(0, 5000, 500)}
    return any((ROOT / folder / script).with_suffix(suffix).exists() for folder, suffix in (
        ("Testing/Cxx/Module", ".cxx"), ("Testing/Cxx/Filters", ".cxx"),
        ("Testing/Cxx/Rendering", ".cxx"), ("Testing/Cxx/Composition", ".cxx"),
        ("Testing/Cxx/Viewer", ".cxx"),
        ("Testing/Faults", ".cxx"), ("Testing/Python", ".py"), ("ParaView/Testing", ".py")))


class TestMutants(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.patches = [Patch(path) for path in sorted(FOLDER.glob("*.patch"))]

    def test_there_are_enough(self):
        self.assertGreaterEqual(len(self.patches), LEAST)
        folders = {file.rpartition("/")[0] for patch in self.patches for file in patch.files}
        for layer in LAYERS:
            with self.subTest(layer=layer):
                self.assertTrue(fnmatch.filter(folders, layer))

    def test_names(self):
        numbers = [patch.name[:3] for patch in self.patches]
        self.assertEqual(len(numbers), len(set(numbers)))
        for patch in self.patches:
            with self.subTest(mutant=patch.name):
                self.assertRegex(patch.name, r"^\d{3}-[a-z0-9-]+$")

    def test_they_say_what_and_who(self):
        for patch in self.patches:
            with self.subTest(mutant=patch.name):
                self.assertRegex(patch.head[0], r"^\w.*\.$")
                self.assertTrue(patch.tests())
                self.assertEqual([test for test in patch.tests() if not has_test(test)], [])

    def test_they_apply(self):
        """What a hunk replaces is there once, so that no place has to be guessed."""
        for patch in self.patches:
            with self.subTest(mutant=patch.name):
                self.assertTrue(patch.files)
                for file, hunks in patch.files.items():
                    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
                    for old, new in hunks:
                        self.assertNotEqual(old, new)
                        self.assertEqual(count(lines, old), 1, file + "\n" + "\n".join(old))

    def test_survivors_are_mutants(self):
        names = {patch.name for patch in self.patches}
        for line in (FOLDER / "survivors.txt").read_text(encoding="utf-8").splitlines():
            if line and not line.startswith("#"):
                name, _, reason = line.partition(" ")
                self.assertIn(name, names)
                self.assertTrue(reason.strip())


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
