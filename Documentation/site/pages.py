# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The repository's Markdown pages as pages of the site.

A page is copied and its relative links are adapted: to other pages, to pictures, to the gallery for
an example, and else to a page that shows the linked file or lists the linked folder.
"""

import os
import pathlib
import re
import shutil

ROOT = pathlib.Path(__file__).resolve().parents[2]
INDEX = "Documentation/README.md"
PICTURES = (".png", ".jpg", ".gif", ".svg")
LINK = re.compile(r"(!?\[[^\]\[]*\]\()([^)\s]+)(\))")
# A picture that is the text of a link has brackets in brackets.
FENCED = re.compile(r"^```.*?^```[^\n]*$", re.DOTALL | re.MULTILINE)
LANGUAGES = {".py": "python", ".cxx": "cpp", ".h": "cpp", ".sh": "bash", ".json": "json",
             ".cmake": "cmake", ".glsl": "glsl", ".ipynb": "json"}


def repository_pages():
    """{path in the repository: the page of the site, without .md}."""
    names = {"README.md": "index", INDEX: "documentation", "CONTRIBUTING.md": "contributing",
             "CHANGELOG.md": "changelog"}
    for path in sorted((ROOT / "Documentation").glob("*.md")):
        names.setdefault(f"Documentation/{path.name}", path.stem)
    return names


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def relative(target, page):
    """A link from a page of the site to a file of it, both without leading slash."""
    return os.path.relpath(target, os.path.dirname(page) or ".").replace(os.sep, "/")


class Site:
    """Copies pages and collects the files that they link to."""

    def __init__(self, folder, examples):
        self.folder = folder
        self.pages = repository_pages()
        self.examples = {example.path: example for example in examples}
        # Pictures that an example has just drawn replace those of the same name.
        self.drawn = {picture.name: picture for example in examples
                      for picture in example.pictures}
        for example in examples:
            if len(example.pictures) == 1:
                self.drawn[f"use-{example.name.replace('_', '-')}.png"] = example.pictures[0]
        self.sources = []

    def write(self, page, text):
        path = self.folder / (page + ".md")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def copy_pages(self):
        for path, page in self.pages.items():
            self.write(page, self.adapt(read(path), path, page))

    def adapt(self, text, path, page):
        """The text of a page of the repository, with links as the site needs them."""
        def change(match):
            target, hash_sign, anchor = match.group(2).partition("#")
            if "://" in target or target.startswith("mailto:") or not target:
                return match.group()
            linked = os.path.normpath(os.path.join(os.path.dirname(path), target))
            goal = relative(self.place(linked), page)
            return f"{match.group(1)}{goal}{hash_sign}{anchor}{match.group(3)}"

        parts, end = [], 0
        for block in FENCED.finditer(text):
            parts += [LINK.sub(change, text[end:block.start()]), block.group()]
            end = block.end()
        return "".join(parts) + LINK.sub(change, text[end:])

    def place(self, linked):
        """Where the site has a file or folder of the repository."""
        if linked in self.pages:
            return self.pages[linked] + ".md"
        if linked == "Documentation/release":
            return "changelog.md"
        if linked in self.examples:
            return self.examples[linked].page + ".md"
        if not (ROOT / linked).exists():
            raise FileNotFoundError(f"{linked}, which a page links to")
        if linked.endswith(PICTURES):
            target = self.folder / "pictures" / os.path.basename(linked)
            target.parent.mkdir(exist_ok=True)
            shutil.copy(self.drawn.get(target.name, ROOT / linked), target)
            return f"pictures/{target.name}"
        if linked not in self.sources:
            self.sources.append(linked)
        return f"sources/{linked}.md"

    def write_sources(self):
        """A page for each linked file or folder that is none. Their links may add others."""
        done = 0
        while done < len(self.sources):
            path = self.sources[done]
            page = f"sources/{path}"
            if (ROOT / path).is_dir():
                text = self.list_folder(path, page)
            elif path.endswith(".md"):
                text = self.adapt(read(path), path, page)
            else:
                language = LANGUAGES.get(pathlib.PurePath(path).suffix, "text")
                text = f"# {path}\n\n````{{code-block}} {language}\n{read(path)}\n````\n"
            self.write(page, "---\norphan: true\n---\n\n" + text)
            done += 1

    def list_folder(self, path, page):
        lines = [f"# {path}", ""]
        for file in sorted((ROOT / path).iterdir()):
            name = f"{path}/{file.name}"
            if file.suffix in LANGUAGES or file.suffix == ".md":
                lines.append(f"- [{file.name}]({relative(self.place(name), page)})")
            elif file.suffix or file.name == "CMakeLists.txt":
                lines.append(f"- {file.name}")
        return "\n".join(lines) + "\n"

    def write_navigation(self):
        """What the top of the site has, and the order of the pages: that of the index."""
        listed = [page for path, page in self.pages.items()]
        index = read(INDEX)
        order = sorted((page for page in listed if page not in ("index", "documentation", "guide",
                                                                "changelog")),
                       key=lambda page: (index.find(f"({page}.md)") % 10**9, page))
        self.append("documentation", [(page, None) for page in order])
        self.append("index", [("guide", None), ("examples/index", "Gallery"),
                              ("python/index", "Python"), ("cxx", "C++"),
                              ("documentation", None), ("changelog", None)])
        self.write("cxx", CXX)

    def append(self, page, entries):
        lines = [f"{title} <{name}>" if title else name for name, title in entries]
        file = self.folder / (page + ".md")
        file.write_text(file.read_text(encoding="utf-8") + "\n```{toctree}\n:hidden:\n\n"
                        + "\n".join(lines) + "\n```\n", encoding="utf-8")


CXX = """# C++ reference

Doxygen makes the C++ reference from the headers.

<p><a class="sd-btn sd-btn-primary" href="doxygen/index.html">Open the C++ reference</a></p>

Classes and methods have the same names in C++ and in Python: the pages of [Python](python/index.md)
show them, too. In the build folder, `cmake --build . --target doc` makes the same reference;
[packages](packages.md) describes how to install headers and library.
"""
