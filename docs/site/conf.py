"""How Sphinx makes a site of the pages in docs: `sh scripts/docs`.

The pages are plain Markdown that reads as well in the repository. What only a site needs is here:
navigation (`navigation.py`), the API reference (`api.py`), the check of links (`links.py`).
"""

from __future__ import annotations

import sys
from pathlib import Path

import glshim

sys.path.insert(0, str(Path(__file__).parent))

project = "glshim"
author = "the glshim contributors"
version = release = glshim.__version__
project_copyright = author

extensions = ["sphinx.ext.autodoc", "myst_parser", "navigation", "api", "links"]
exclude_patterns = ["site"]
source_suffix = {".md": "markdown"}
root_doc = "index"

myst_heading_anchors = 4
"""The anchors are those that other readers of Markdown make of headings."""
highlight_language = "text"

default_role = "code"  # docstrings have `names` as Markdown has them
add_module_names = False
autodoc_typehints_format = "short"
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
autodoc_type_aliases = {name: name for name in (
    "Floats", "Doubles", "Matrix", "Indices", "Flags", "Colour", "Uniform", "Place",
)}  # fmt: skip
maximum_signature_line_length = 100

html_theme = "furo"
html_title = f"glshim {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
