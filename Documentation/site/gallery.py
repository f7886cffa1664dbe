# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: runs the examples and makes a page of each, with its pictures, output and source.

Results are kept. An example runs again if it or the installed Airlight has changed.
"""

import ast
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import airlight

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Folders of Examples/ whose programs are run, and the heading of each. Others are listed only.
RUN = {"PyVista": "PyVista", "Python": "VTK in Python"}
LISTED = {"ParaView": "ParaView", "vedo": "vedo", "trame": "trame", "Jupyter": "Jupyter"}
# Why some are not run.
NOT_RUN = {"cloud_beside_vtk": "It needs a `.vdb` or `.vti` file.",
           "fire_smoke": "It is a part of `fire_visibility.py`.",
           "openvdb_to_numpy": "It needs a `.vdb` file.",
           "plume_as_fog": "It needs a `.vdb` file."}
SUFFIXES = (".png", ".jpg", ".gif")
SECONDS = 3600  # at most for one example, on a slow machine


@dataclasses.dataclass
class Example:
    """A program of Examples/."""
    path: str  # in the repository
    pictures: list = dataclasses.field(default_factory=list)
    output: str = ""
    command: str = ""
    reason: str = ""  # why it was not run

    @property
    def name(self):
        return pathlib.PurePath(self.path).stem

    @property
    def label(self):
        return self.name.replace("_", " ").capitalize()

    @property
    def folder(self):
        return pathlib.PurePath(self.path).parts[1]

    @property
    def page(self):
        return f"examples/{self.folder.lower()}/{self.name}"

    def source(self):
        return (ROOT / self.path).read_text(encoding="utf-8")

    def arguments(self):
        """Those with which it writes pictures: an option -o, or a folder as its docstring says."""
        if re.search("""["']-o["']|add_picture_options""", self.source()):
            return ["-o", f"{self.name}.png"]
        return ["."] if re.search(rf"{self.name}\.py \[?FOLDER", self.source()) else []

    def texts(self):
        """(title, description) of its docstring."""
        doc = (ast.get_docstring(ast.parse(self.source())) or self.name).strip()
        first, _, rest = doc.partition("\n\n")
        title = re.sub(r"\s+", " ", first).rstrip(".")
        return title, rest


def environment():
    """Without a screen, and with VTK's window for that."""
    found = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    found.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    found["PYVISTA_OFF_SCREEN"] = "true"
    found["PYTHONHASHSEED"] = "0"
    return found


def fingerprint(example):
    """Changes with the example and with the installed package."""
    digest = hashlib.sha256(example.source().encode())
    for file in sorted(pathlib.Path(airlight.__file__).parent.rglob("*")):
        if file.is_file() and file.parent.name != "__pycache__":
            digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


def run(example, folder):
    """Runs it in a folder, unless the folder has its results. Raises if it fails."""
    words = example.arguments()
    example.command = " ".join(["python", f"{example.name}.py", *words])
    kept = folder / "result.json"
    mark = fingerprint(example)
    if not kept.exists() or json.loads(kept.read_text())["fingerprint"] != mark:
        if folder.exists():
            shutil.rmtree(folder)
        folder.mkdir(parents=True)
        print(f"running {example.path}", flush=True)
        done = subprocess.run([sys.executable, str(ROOT / example.path), *words], cwd=folder,
                              env=environment(), text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=SECONDS, check=False)
        if done.returncode:
            raise RuntimeError(f"{example.path} failed:\n{done.stdout}{done.stderr}")
        kept.write_text(json.dumps({"fingerprint": mark, "output": done.stdout}))
    example.output = json.loads(kept.read_text())["output"]
    example.pictures = sorted(file for file in folder.iterdir() if file.suffix in SUFFIXES)
    if words and not example.pictures:
        raise RuntimeError(f"{example.path} wrote no picture")


def run_examples(folder):
    """All examples, those of RUN with their results. Without a folder none is run."""
    examples = []
    for kind in [*RUN, *LISTED]:
        for path in sorted((ROOT / "Examples" / kind).glob("*.py")):
            example = Example(str(path.relative_to(ROOT)))
            if kind in LISTED:
                example.reason = f"It needs {LISTED[kind]}."
            elif example.name in NOT_RUN:
                example.reason = NOT_RUN[example.name]
            elif folder is None:
                example.reason = "This site was made to check its links."
            else:
                run(example, folder / kind / example.name)
            examples.append(example)
    return examples


def escape(text):
    return re.sub(r"([*_<\[])", r"\\\1", text)


def write_page(folder, example):
    title, description = example.texts()
    text = f"# {example.label}\n\n**{escape(title)}.**\n\n{description}\n\n"
    page = folder / (example.page + ".md")
    page.parent.mkdir(parents=True, exist_ok=True)
    for picture in example.pictures:
        shutil.copy(picture, page.parent / picture.name)
        label = picture.stem.replace("-", " ").replace("_", " ")
        if len(example.pictures) > 1:
            text += f"```{{figure}} {picture.name}\n:alt: {label}\n\n{label}\n```\n\n"
        else:
            text += f"![{label}]({picture.name})\n\n"
    if example.reason:
        text += f"This page was made without running the example. {example.reason}\n\n"
    else:
        text += f"Run as `{example.command}`.\n\n"
        if example.output.strip():
            text += f"It prints:\n\n```text\n{example.output.rstrip()}\n```\n\n"
    text += f"## Source\n\n`{example.path}`:\n\n````python\n{example.source()}````\n"
    page.write_text(text, encoding="utf-8")


def card(example):
    title = escape(example.texts()[0])
    lines = [f"::::{{grid-item-card}} {example.label}", f":link: {example.page[9:]}",
             ":link-type: doc"]
    if example.pictures:
        parent = pathlib.PurePath(example.page).parent.name
        lines.append(f":img-top: {parent}/{example.pictures[0].name}")
        lines.append(f":img-alt: {example.name.replace('_', ' ')}")
    return "\n".join([*lines, "", title, "::::"])


def write_pages(folder, examples):
    for example in examples:
        write_page(folder, example)
    text = ("# Gallery\n\nThe examples were run to make these pages, without a screen. Each page has\n"
            "the pictures, the output and the source. [More pictures](../gallery.md) show many kinds\n"
            "of VTK content in fog.\n")
    for kind, heading in {**RUN, **LISTED}.items():
        listed = [example for example in examples if example.folder == kind]
        listed.sort(key=lambda example: (not example.pictures, example.name))
        if listed:
            text += f"\n## {heading}\n\n:::::{{grid}} 1 2 2 3\n:gutter: 3\n\n"
            text += "\n\n".join(map(card, listed)) + "\n:::::\n"
    text += "\n```{toctree}\n:hidden:\n\n"
    text += "\n".join(example.page[9:] for example in examples) + "\n```\n"
    (folder / "examples" / "index.md").write_text(text, encoding="utf-8")
