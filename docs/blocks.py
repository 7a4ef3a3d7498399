"""Writes the parts of pages that come from the package or from stored results: ``python docs/blocks.py``.

A block stands between ``<!-- NAME: begin -->`` and ``<!-- NAME: end -->``. The tests say where one is out of date.
"""

from __future__ import annotations

import ast
import functools
from collections.abc import Callable, Mapping
from pathlib import Path

from tutorstudent_prototype2.calibration.command import CANDIDATES, LOOKS, PREDICTIONS
from tutorstudent_prototype2.calibration.summary import describe

DOCS = Path(__file__).parent
PACKAGE = DOCS.parent / "tutorstudent"
PREDICTED = "Prototype 2A under each of "
"""Begins the second half of what `tutorstudent-prototype2 calibration show` prints."""


def folders() -> str:
    """Return a table of all code folders, each with the sentence that its own `__init__.py` begins with."""
    rows = (f"| `{path.parent.relative_to(DOCS.parent)}` | {_summary(path)} |" for path in _inits())
    return "\n".join(["| folder | what is in it |", "|---|---|", *rows])


def fitted() -> str:
    """Return what the calibration says about the settings that it looked at."""
    return _shown().partition(PREDICTED)[0].strip()


def predicted() -> str:
    """Return what the calibration says about prototype 2A."""
    return "".join(_shown().partition(PREDICTED)[1:]).strip()


BLOCKS: Mapping[str, Mapping[str, Callable[[], str]]] = {
    "development.md": {"folders": folders},
    "reproduction.md": {"calibration, fitted": fitted, "calibration, predicted": predicted},
}
"""The function of each block, by page and name."""


def renewed(page: str) -> str:
    """Return the text of a page with every block made anew."""
    text = (DOCS / page).read_text(encoding="utf-8")
    for name, made in BLOCKS[page].items():
        begin, end = f"<!-- {name}: begin -->\n", f"\n<!-- {name}: end -->"
        before, _, rest = text.partition(begin)
        _, found, after = rest.partition(end)
        if not found:
            raise ValueError(
                f"docs/{page}: no block '{name}'; it stands between '{begin.strip()}' and '{end.strip()}'."
            )
        text = f"{before}{begin}{made()}{end}{after}"
    return text


def _inits() -> list[Path]:
    return sorted(PACKAGE.rglob("__init__.py"), key=lambda path: path.parent)


def _summary(path: Path) -> str:
    docstring = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    return " ".join(docstring.partition("\n\n")[0].split())


@functools.cache
def _shown() -> str:
    return "\n".join(describe(LOOKS, CANDIDATES, PREDICTIONS))


if __name__ == "__main__":
    for name in BLOCKS:
        (DOCS / name).write_text(renewed(name), encoding="utf-8")
