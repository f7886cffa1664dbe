#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the links of a built site: each leads to a file of the site, and to an anchor in it.

Usage: links.py FOLDER [--external]

Links to other sites are counted and listed; --external also fetches them.
"""

import argparse
import html.parser
import pathlib
import sys
import urllib.error
import urllib.parse
import urllib.request

ATTRIBUTES = {"a": ("href",), "link": ("href",), "img": ("src",), "script": ("src",),
              "source": ("src",), "iframe": ("src",), "object": ("data",)}
SECONDS = 20


class Page(html.parser.HTMLParser):
    """The links, pictures and anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.pictures, self.anchors = [], [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors.update(value for key in ("id", "name") if (value := values.get(key)))
        for key in ATTRIBUTES.get(tag, ()):
            if values.get(key) is not None:
                self.links.append(values[key])
                if tag == "img":
                    self.pictures.append(values[key])

    handle_startendtag = handle_starttag


class Site:
    """All pages of a folder."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        # Below _static are the theme's templates.
        self.pages = {path: Page(path) for path in sorted(self.folder.rglob("*.html"))
                      if "_static" not in path.relative_to(self.folder).parts}

    def resolve(self, page, link):
        """(the file that an internal link leads to, its anchor); the file is None outside."""
        parts = urllib.parse.urlsplit(link)
        path = urllib.parse.unquote(parts.path)
        if path.startswith("/"):
            return None, ""
        target = (page.parent / path).resolve() if path else page
        if target.is_dir():
            target /= "index.html"
        inside = self.folder in target.parents
        return (target if inside else None), urllib.parse.unquote(parts.fragment)

    def problems(self):
        """(number of internal links, what is wrong with them, {external link: a page})."""
        count, wrong, external = 0, [], {}
        for path, page in self.pages.items():
            name = path.relative_to(self.folder)
            for link in page.links:
                if urllib.parse.urlsplit(link).scheme:
                    if link.startswith("http"):
                        external.setdefault(link, name)
                    continue
                count += 1
                target, anchor = self.resolve(path, link)
                if target is None:
                    wrong.append(f"{name}: {link} leads out of the site")
                elif not target.is_file():
                    wrong.append(f"{name}: {link}: there is no such file")
                elif (anchor and target in self.pages
                      and anchor not in self.pages[target].anchors):
                    wrong.append(f"{name}: {link}: there is no such anchor")
        return count, wrong, external


def fetch(link):
    """None, or why a link to another site does not work."""
    request = urllib.request.Request(link, headers={"User-Agent": "airlight-links"})
    try:
        with urllib.request.urlopen(request, timeout=SECONDS):
            return None
    except (urllib.error.URLError, OSError, ValueError) as error:
        return str(error)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--external", action="store_true", help="fetch links to other sites, too")
    options = parser.parse_args()
    site = Site(options.folder)
    count, wrong, external = site.problems()
    for link, page in sorted(external.items()):
        print(f"external: {link} in {page}")
        if options.external:
            reason = fetch(link)
            if reason:
                wrong.append(f"{page}: {link}: {reason}")
    print(f"{len(site.pages)} pages, {count} internal links, {len(external)} external links, "
          f"{len(wrong)} wrong")
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return 1 if wrong or not site.pages else 0


if __name__ == "__main__":
    sys.exit(main())
