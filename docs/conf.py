"""Sphinx configuration; `make docs` builds the site, `make test` builds it with warnings as errors."""

from __future__ import annotations

import sys
from importlib import metadata
from pathlib import Path
from typing import Any

from sphinx.util import logging

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

import attributes  # noqa: E402 - stands beside this file
import complete  # noqa: E402
import reference  # noqa: E402

project = "tutorstudent"
author = "The tutorstudent founders"
version = release = metadata.version("tutorstudent")

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
exclude_patterns = ["_build"]
html_theme = "furo"
html_title = "tutorstudent"
html_static_path = ["_static"]
html_css_files = ["tables.css"]
smartquotes = False
default_role = "code"  # in docstrings, `name` is a name
copyright = "the tutorstudent founders, MIT licence"  # noqa: A001 - Sphinx reads this name

myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_default_options = {"members": True, "show-inheritance": True}
napoleon_google_docstring = True
nitpicky = False

reference.write(HERE / "reference")


def setup(app: Any) -> None:
    """Let the build warn of public names without a description, and render attributes as they are written."""
    app.connect("env-check-consistency", _check_names)
    attributes.Attributes().connect(app)


def _check_names(_app: Any, env: Any) -> None:
    for name in complete.not_rendered(env.get_domain("py").objects):
        logging.getLogger(__name__).warning("%s is public, and no page describes it; see docs/api.md", name)
