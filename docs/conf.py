"""Sphinx settings of the documentation site (`make docs`)."""

import os
import sys
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS))
os.environ.setdefault("MPLBACKEND", "Agg")
os.environ.setdefault("INSTOBJ_STORE", str(DOCS.parent / ".instobj"))

import measured  # noqa: E402
from site_pages import GENERATED, write_generated_pages  # noqa: E402

project = "instobj"
author = "instobj contributors"
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_gallery.gen_gallery",
]
exclude_patterns = ["_build", "**.py", "gallery/**.ipynb", "gallery/**.py.md5"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}

html_theme = "furo"
html_title = "instobj"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
templates_path = []

myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence"]
suppress_warnings = ["myst.strikethrough", "config.cache"]

default_role = "code"

autodoc_typehints = "signature"
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
python_maximum_signature_line_length = 88
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

sphinx_gallery_conf = {
    "examples_dirs": ["../examples/gallery"],
    "gallery_dirs": ["gallery"],
    "filename_pattern": r"/\d\d_",
    "within_subsection_order": "FileNameSortKey",
    "download_all_examples": False,
    "show_signature": False,
    "remove_config_comments": True,
    "show_memory": False,
    "min_reported_time": 1,
    "abort_on_example_error": True,
    "copyfile_regex": r"none",
    "image_scrapers": ("matplotlib",),
    "write_computation_times": False,
    "reset_modules": ("matplotlib",),
    "default_thumb_file": str(DOCS / "paper_cube.png"),
}


def setup(app):
    """Pages made from the code and from results files are written before Sphinx looks for sources."""
    app.connect("config-inited", lambda app, config: write_generated_pages(DOCS / GENERATED))
    app.connect("config-inited", lambda app, config: measured.main())
