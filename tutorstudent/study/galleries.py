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
    shown = "".join(f'<figure class="picture">{figure}</figure>' for figure in gallery.figures)
    note = f'<p class="note">{gallery.note}</p>'
    return f'<h3>{escape(gallery.title)}</h3>\n{note}\n<div class="{gallery.layout}">{shown}</div>'
