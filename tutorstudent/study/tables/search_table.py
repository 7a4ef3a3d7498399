"""The table of a search for the best constant level."""

from __future__ import annotations

from tutorstudent.study.pictures.maps import COLOURED_LEVELS, list_level_colours
from tutorstudent.study.plans.constant_level import Level, Searched
from tutorstudent.study.tables.cells import NOTHING, number
from tutorstudent.study.tables.table import Row, Table

TITLE = "The search for the best constant level"


def make_search_table(searched: Searched, environment: str) -> Table:
    """Return what every level came to in one environment; without rows where none was searched for."""
    rows = tuple(
        Row(_name_level(item.level), True, _make_cells(item))
        for item in searched.levels
        if item.environment == environment
    )
    seeds = ", ".join(map(str, searched.seeds))
    note = (
        f"Means over runs of their own ({'seeds' if len(searched.seeds) > 1 else 'seed'} {seeds}). Chosen is the "
        f"highest mean among the levels with at most {searched.limit(environment):.2%} of decisions violated; where "
        "none keeps to that, the level that violates least."
    )
    if searched.is_indifferent(environment):
        note += f" All levels came to the same {searched.goal}: the choice says nothing about it."
    return Table(TITLE, ("runs", searched.goal, "violated", ""), rows, note)


def colour_levels() -> dict[str, str]:
    """Return the colour of each row."""
    return {_name_level(level): list_level_colours()[level] for level in range(COLOURED_LEVELS + 1)}


def _name_level(level: int) -> str:
    return f"level {level}" if level else "level 0, the tutor alone"


def _make_cells(item: Level) -> tuple[str, ...]:
    goal = NOTHING if item.goal is None else number(item.goal)
    violated = NOTHING if item.violated is None else f"{item.violated:.2%}"
    return str(item.runs), goal, violated, "chosen" if item.chosen else ""
