"""Colours: one for each variant, the same in every picture and table, on light and on dark ground.

Pictures are drawn with stand-ins, which `svg` turns into variables of the page's style sheet, so that one drawing
suits both grounds. The hues are Okabe and Ito's, told apart by colour-blind readers; darker on light ground where they
would be too pale. No picture depends on colour alone: every panel and row carries its name.
"""

from __future__ import annotations

from collections.abc import Sequence

from tutorstudent.study.plans.plan import Variant

GIVEN = (
    ("#0072b2", "#56b4e9"),
    ("#c44e00", "#ff9d5c"),
    ("#00805d", "#2fd0a2"),
    ("#a8477f", "#eda6cd"),
    ("#5b4bb0", "#b3a8f5"),
    ("#7a6a00", "#e2d04a"),
)
CONTROLS = (
    ("#6b7280", "#a3abb8"),
    ("#2f8fbf", "#8fd0f0"),
    ("#b07900", "#f0bb4a"),
    ("#8a6242", "#d0a685"),
    ("#7d8a1e", "#c3cf6a"),
    ("#1f7a7a", "#6fcaca"),
    ("#7a5c8e", "#c3a6d9"),
    ("#9e4a3c", "#e39c8e"),
)
"""Pairs of a colour for light and one for dark ground."""

INK = "#010203"
FAINT = "#010204"
GROUND = "#010205"
STAND_INS = {INK: "var(--ink)", FAINT: "var(--line)", GROUND: "var(--panel)"}
"""What pictures are drawn with, and what the page makes of it."""

FLOOR = "#f6f4ee"
WALL = "#3b3b3b"
WAY = "#c9c4b8"
HARM = "#b3007a"
MAP_COLOURS = {"red": "#d1332e", "blue": "#2a62c9", "green": "#2c8a4b", "yellow": "#d9a400"}
"""Maps keep one ground of their own, because a trajectory's colour is a number there."""


class Palette:
    """The colours of a study's variants.

    >>> palette = Palette([Variant("2A", "", False, {}, {}), Variant("ramp", "", True, {}, {})])
    >>> palette.find_css("2A"), palette.find_stand_in("ramp")
    ('var(--v0)', '#fe0001')
    """

    def __init__(self, variants: Sequence[Variant]) -> None:
        given = [variant.name for variant in variants if not variant.control]
        controls = [variant.name for variant in variants if variant.control]
        self._index = {name: i for i, name in enumerate([*given, *controls])}
        self._pairs = [
            *(GIVEN[i % len(GIVEN)] for i in range(len(given))),
            *(CONTROLS[i % len(CONTROLS)] for i in range(len(controls))),
        ]

    def find_css(self, name: str) -> str:
        """Return a variant's colour for the page."""
        return f"var(--v{self._index[name]})"

    def find_stand_in(self, name: str) -> str:
        """Return the stand-in with which a variant is drawn."""
        return f"#fe{self._index[name]:04x}"

    def list_stand_ins(self) -> dict[str, str]:
        """Return what the page makes of every stand-in."""
        return STAND_INS | {self.find_stand_in(name): self.find_css(name) for name in self._index}

    def list_css(self) -> dict[str, str]:
        """Return every variant's colour for the page."""
        return {name: self.find_css(name) for name in self._index}

    def make_declarations(self, ground: int) -> str:
        """Return the style sheet's variables; ground 0 is light, 1 is dark."""
        return "".join(f"--v{i}:{pair[ground]};" for i, pair in enumerate(self._pairs))
