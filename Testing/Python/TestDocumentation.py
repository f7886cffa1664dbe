# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Links of all pages lead somewhere, and the index lists all pages."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [page for folder in (".", "Documentation", "Documentation/release", "Examples/Data")
         for page in sorted((ROOT / folder).glob("*.md"))]


def read(page):
    """A page without its code."""
    return re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.M)


def anchors(page):
    """The names by which headings can be linked to, as code hosts make them."""
    headings = re.findall(r"^#+ +(.*?) *(?:\{.*\})?$", read(page), re.MULTILINE)
    plain = [re.sub(r"[^\w\- ]", "", heading.lower()) for heading in headings]
    return [heading.replace(" ", "-") for heading in plain]


class TestDocumentation(unittest.TestCase):
    def test_links(self):
        count = 0
        for page in PAGES:
            for link in re.findall(r"\]\(([^)\s]+)\)", read(page)):
                if "://" in link:
                    continue
                with self.subTest(page=page.name, link=link):
                    file, _, anchor = link.partition("#")
                    target = page.parent / file if file else page
                    self.assertTrue(target.exists())
                    if anchor:
                        self.assertIn(anchor, anchors(target))
                count += 1
        self.assertGreater(count, 50)

    def test_index(self):
        index = read(ROOT / "Documentation" / "README.md")
        for page in sorted((ROOT / "Documentation").glob("*.md")):
            if page.name != "README.md":
                self.assertIn(f"]({page.name})", index)


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
