# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings for the documentation site. Utilities/site.sh runs it on the prepared pages."""

import os

project = "Airlight"
author = "Airlight developers"
copyright = author  # noqa: A001 Sphinx's name
version = release = os.environ["AIRLIGHT_VERSION"]

extensions = ["myst_parser", "sphinx_design", "sphinx_copybutton"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
# Plain text in the headers of classes and in the pages uses no typographic replacements.
smartquotes = False
add_module_names = False
python_maximum_signature_line_length = 80
toc_object_entries_show_parents = "hide"
copybutton_exclude = ".linenos, .gp"

html_theme = "pydata_sphinx_theme"
html_title = "Airlight"
html_favicon = "_static/airlight.svg"
html_static_path = ["_static"]
html_css_files = ["airlight.css"]
html_extra_path = ["_extra"]  # Doxygen's pages
html_copy_source = False
html_show_sourcelink = False
html_theme_options = {
    "logo": {"text": f"Airlight {version}", "image_light": "_static/airlight.svg",
             "image_dark": "_static/airlight.svg", "alt_text": "Airlight"},
    "show_toc_level": 2,
    "header_links_before_dropdown": 6,
    "navigation_with_keys": False,
    "footer_start": ["copyright"],
    "footer_end": ["sphinx-version"],
}
html_context = {"default_mode": "auto"}
html_sidebars = {"index": [], "changelog": []}
