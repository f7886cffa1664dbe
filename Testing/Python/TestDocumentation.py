# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Links of all pages lead somewhere, the index lists all pages, and cited tests exist."""

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

    def test_claims(self):
        """Each claim of trust.md's table has tests that exist, and what they assert."""
        lists = "".join(file.read_text(encoding="utf-8") for folder in ("Testing", "ParaView")
                        for file in (ROOT / folder).rglob("CMakeLists.txt"))
        page = read(ROOT / "Documentation" / "trust.md")
        section = page.split("\n## Claims and their tests\n", 1)[1].split("\n## ", 1)[0]
        rows = re.findall(r"^\|(.*)\|(.*)\|(.*)\|$", section, re.MULTILINE)[2:]
        self.assertGreater(len(rows), 25)
        for claim, tests, asserted in rows:
            with self.subTest(claim=claim):
                names = re.findall(r"`([\w-]+)`", tests)
                self.assertTrue(names)
                self.assertTrue(asserted.strip())
                for name in names:
                    load = re.fullmatch("AirlightLoad-(.*)", name)
                    listed = rf"add_load_test\({load[1]} " if load else rf"\b{name}(\.cxx|\.py|,)"
                    self.assertTrue(re.search(listed, lists), f"no test is named {name}")


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
