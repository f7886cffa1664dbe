# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/changelog.py and Utilities/check-version.py, on this project and on small ones with
faults."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import airlight

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROJECT = "cmake_minimum_required(VERSION 3.24)\nproject(Airlight\n  VERSION {}\n  LANGUAGES CXX)\n"


def run(script, *options):
    done = subprocess.run([sys.executable, ROOT / "Utilities" / script, *map(str, options)],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60,
                          check=False)
    return done.returncode, done.stdout


class TestReleases(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("CMakeLists.txt", PROJECT.format("0.3.0"))

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def note(self, name, text):
        self.write(f"Documentation/release/{name}.md", text)

    def changelog(self, *options):
        code, text = run("changelog.py", "--root", self.root, *options)
        file = self.root / "CHANGELOG.md"
        return code, text, file.read_text(encoding="utf-8") if file.exists() else ""

    def strays(self, *files):
        return run("check-version.py", "--root", self.root, *files)

    def test_version_of_package(self):
        text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"^  VERSION (.*)$", text, re.MULTILINE),
                         [airlight.__version__])

    def test_changelog_order(self):
        self.note("old", "<!-- version: 0.2.0 -->\n\n# B old\n\nSee [A](older.md), [t](../trust.md#x).\n")
        self.note("older", "<!-- version: 0.2.0 -->\n\n## A old\n\n### Part\n\nText.\n")
        self.note("ancient", "<!-- version: 0.1.10 -->\n\n# Ancient\n\nText.\n")
        self.note("early", "<!-- version: 0.1.9 -->\n\n# Early\n\nText.\n")
        self.note("new", "## New\n\n```sh\n# no heading\n```\n")
        code, _, text = self.changelog()
        self.assertEqual(code, 0)
        self.assertEqual(re.findall(r"^#{2,} .*$", text, re.MULTILINE), [
            "## 0.3.0 (unreleased)", "### New", "## 0.2.0", "### A old", "#### Part", "### B old",
            "## 0.1.10", "### Ancient", "## 0.1.9", "### Early"])
        self.assertIn("See [A](#a-old), [t](Documentation/trust.md#x).", text)
        self.assertIn("```sh\n# no heading\n```", text)

    def test_changelog_check(self):
        self.note("new", "## New\n\nText.\n")
        self.assertNotEqual(self.changelog("--check")[0], 0)  # there is none
        self.changelog()
        self.assertEqual(self.changelog("--check")[0], 0)
        self.note("newer", "## Newer\n\nText.\n")
        code, message, text = self.changelog("--check")
        self.assertEqual((code, "Newer" in text), (1, False))
        self.assertIn("run Utilities/changelog.py", message)

    def test_changelog_release(self):
        self.note("new", "## New\n\nText.\n")
        code, message, text = self.changelog("--release")
        self.assertEqual((code, message), (0, "1 notes are now of 0.3.0\n"))
        self.assertIn("\n## 0.3.0\n\n### New\n", text)
        self.note("later", "## Later\n\nText.\n")
        self.assertIn("\n## Unreleased\n\n### Later\n", self.changelog()[2])

    def test_changelog_faults(self):
        for name, text, message in (
                ("plain", "Text.\n", "plain.md begins with neither"),
                ("ahead", "<!-- version: 0.4.0 -->\n\n# Ahead\n", "after 0.3.0"),
                ("twin", "# New\n", "two notes are named 'New'")):
            with self.subTest(name):
                self.note("new", "## New\n")
                self.note(name, text)
                code, found, _ = self.changelog()
                self.assertEqual(code, 1)
                self.assertIn(message, found)
                (self.root / f"Documentation/release/{name}.md").unlink()

    def test_stray_versions(self):
        self.assertEqual(self.strays("CMakeLists.txt"), (0, ""))
        for name, text in (("ParaView/CMakeLists.txt", "project(AirlightParaView\n  VERSION 0.3.0\n"),
                           ("pyproject.toml", '[project]\nversion = "0.3.0"\n'),
                           ("airlight/__init__.py", '__version__ = "0.3.0"\n'),
                           ("a.cmake", 'set(Airlight_VERSION "0.3.0")\n'),
                           ("b.txt", 'target_compile_definitions(a PRIVATE AIRLIGHT_VERSION="0.3")\n'),
                           ("page.md", "`libvtkairlight0.2` and `libvtkairlight0.3`\n"),
                           ("other.md", "libvtkAirlight.so.0.2, airlight-0.3.0\n"),
                           ("wheel.md", "airlight-0.2.0-py3-none-any.whl, airlight==0.3.0\n")):
            with self.subTest(name):
                self.write(name, text)
                code, found = self.strays("CMakeLists.txt", name)
                self.assertEqual((code, found.count("\n")), (1, 1), found)
                self.assertTrue(found.startswith(name + ":"), found)
        self.write("CHANGELOG.md", "libvtkairlight0.1\n")
        self.assertEqual(self.strays("CMakeLists.txt", "CHANGELOG.md"), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
