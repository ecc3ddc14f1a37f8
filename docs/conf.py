"""Sphinx configuration; `make docs` builds with warnings as errors."""

import sys
from importlib import metadata
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "extensions"))

project = "gantline"
author = "The gantline authors"
project_copyright = "The gantline authors; Apache-2.0"
release = version = metadata.version("gantline")

extensions = [
    "gantline_docs",
    "gantline_evidence",
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
]
exclude_patterns = ["extensions"]
nitpicky = False

myst_enable_extensions = ["dollarmath", "amsmath", "deflist", "fieldlist", "colon_fence"]
myst_heading_anchors = 3
myst_dmath_double_inline = True

# MathJax as a part of the built pages, so that formulas need no network. It draws SVG, since browsers let
# pages that are opened as files load scripts but no fonts. Formulas too long for the page break
# at a sign, or scroll.
_packages = "../viewer/node_modules"
html_static_path = [
    "static",
    f"{_packages}/mathjax/tex-svg.js",
    f"{_packages}/mathjax/a11y/assistive-mml.js",
    f"{_packages}/@mathjax/mathjax-newcm-font/svg",
]
mathjax_path = "tex-svg.js"
mathjax4_config = {
    "loader": {
        "source": {"a11y/assistive-mml": "[mathjax]/assistive-mml.js"},
        "versionWarnings": False,  # they ask for names of folders that are not kept here
    },
    "output": {"displayOverflow": "linebreak"},
    "svg": {"dynamicPrefix": "[mathjax]/dynamic"},
    "options": {
        "menuOptions": {
            "settings": {"enrich": False, "speech": False, "braille": False, "assistiveMml": True}
        }
    },
}

autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_format = "short"
napoleon_google_docstring = True
napoleon_numpy_docstring = False

html_theme = "furo"
html_css_files = ["pages.css"]
html_title = f"gantline {release}"
html_copy_source = False
html_show_sphinx = False
