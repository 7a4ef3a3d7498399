"""One HTML file that opens without a network: text, tables and drawings, and nothing that has to be fetched."""

from __future__ import annotations

from html import escape
from importlib import resources

from tutorstudent.study.page.sections import make_body, make_title
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.runs.results import Study


def make_page(study: Study) -> str:
    """Return the page of a study: its style, and the sections of `tutorstudent.study.page.sections`."""
    palette = Palette(study.plan.variants())
    style = resources.files("tutorstudent.study.page").joinpath("page.css").read_text(encoding="utf-8")
    dark = f"@media (prefers-color-scheme: dark) {{ :root {{ {palette.make_declarations(1)} }} }}"
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(make_title(study))}</title>\n"
        f"<style>\n{style}:root {{ {palette.make_declarations(0)} }}\n{dark}\n</style>\n"
        f"</head>\n<body>\n{make_body(study)}\n</body>\n</html>\n"
    )
