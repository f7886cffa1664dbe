#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Prepares the sources of the documentation site: Utilities/site.sh calls it before Sphinx.

The pages of the repository are copied with their links adapted. The gallery is made by running the
examples, the pages of the Python package from its stubs and headers.
"""

import argparse
import pathlib
import shutil

import api
import gallery
import pages

HERE = pathlib.Path(__file__).resolve().parent


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=pathlib.Path, help="folder for Sphinx's sources, emptied")
    parser.add_argument("--pictures", type=pathlib.Path,
                        help="folder in which the examples run; results are kept. None: they do not")
    parser.add_argument("--doxygen", type=pathlib.Path, required=True,
                        help="folder with the C++ reference")
    options = parser.parse_args()
    if options.source.exists():
        shutil.rmtree(options.source)
    options.source.mkdir(parents=True)
    shutil.copy(HERE / "conf.py", options.source)
    shutil.copytree(HERE / "_static", options.source / "_static")
    shutil.copytree(options.doxygen, options.source / "_extra" / "doxygen")

    examples = gallery.run_examples(options.pictures)
    site = pages.Site(options.source, examples)
    site.copy_pages()
    gallery.write_pages(options.source, examples)
    api.write_pages(options.source / "python")
    site.write_sources()
    site.write_navigation()


if __name__ == "__main__":
    main()
