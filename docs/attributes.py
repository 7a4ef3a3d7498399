"""Keeps the sentences of attributes as they are: Napoleon takes what stands before a colon for a type."""

from __future__ import annotations

from typing import Any

KINDS = ("attribute", "data", "property")
ALIAS = "Alias for field number"
"""What Python writes of the fields of a named tuple; it says nothing."""


class Attributes:
    """Connects one handler before Napoleon's, which keeps a paragraph, and one after it, which gives it back."""

    def __init__(self) -> None:
        self._kept: list[str] = []

    def connect(self, app: Any) -> None:
        """Hang both into a Sphinx application, round Napoleon's priority of 500."""
        app.connect("autodoc-process-docstring", self.keep, priority=400)
        app.connect("autodoc-process-docstring", self.give_back, priority=600)

    def keep(self, _app: Any, what: str, _name: str, _obj: Any, _options: Any, lines: list[str]) -> None:
        """Remember a docstring of one paragraph; forget one that says nothing."""
        text = "\n".join(lines).strip()
        if text.startswith(ALIAS):
            lines.clear()
        self._kept = lines[:] if what in KINDS and "\n\n" not in text else []

    def give_back(self, _app: Any, _what: str, _name: str, _obj: Any, _options: Any, lines: list[str]) -> None:
        """Put back what was remembered."""
        if self._kept:
            lines[:] = self._kept
