"""Pictures that belong together, with what has to be known to read them, as HTML."""

from __future__ import annotations

from html import escape
from typing import NamedTuple


class Gallery(NamedTuple):
    """Pictures in a row, or in several."""

    title: str
    note: str
    """How to read them, HTML."""
    layout: str
    """Class of the style sheet: ``pair``, ``wide``, ``film`` or ``film maps``."""
    figures: list[str]
    """HTML elements."""


def gallery_html(gallery: Gallery) -> str:
    """Return a gallery with its heading."""
    return f"<h3>{escape(gallery.title)}</h3>\n{_body(gallery)}"


def folded_html(title: str, galleries: list[Gallery]) -> str:
    """Return galleries that are shown when the reader asks for them."""
    bodies = "\n".join(gallery_html(gallery) for gallery in galleries)
    return f"<details><summary>{escape(title)}</summary>\n{bodies}\n</details>"


def _body(gallery: Gallery) -> str:
    shown = "".join(f'<figure class="picture">{figure}</figure>' for figure in gallery.figures)
    return f'<p class="note">{gallery.note}</p>\n<div class="{gallery.layout}">{shown}</div>'
