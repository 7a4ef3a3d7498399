"""The control ``best-constant``: which constant level a search found, and what that makes of a plan."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from tutorstudent.core.files.durable import write_whole
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.plans.plan import Environment, Plan, Variant

BEST = "best-constant"
TUTOR_ALONE = "tutor-alone"
FOLDER = "search"
"""Of the search, below the study's."""
TABLE = "table.json"


class Level(NamedTuple):
    """What the runs of one constant level came to in one environment."""

    environment: str
    level: int
    """0: the tutor alone."""
    runs: int
    """That are complete."""
    goal: float | None
    """Mean over them; None without any."""
    violated: float | None
    """Mean share of decisions."""
    chosen: bool = False


class Searched(NamedTuple):
    """The table of a search."""

    goal: str
    harm_budget: float
    seeds: tuple[int, ...]
    levels: tuple[Level, ...]

    def chosen(self, environment: str) -> Level | None:
        """Return the best level of an environment; None if no level has all its runs."""
        return next((item for item in self.levels if item.chosen and item.environment == environment), None)

    def limit(self, environment: str) -> float:
        """Return the share of decisions that may be violated: the budget, or the tutor's own where that is more."""
        own = [item.violated or 0.0 for item in self.levels if (item.environment, item.level) == (environment, 0)]
        return max([self.harm_budget, *own])

    def is_indifferent(self, environment: str) -> bool:
        """Return whether all levels of an environment came to the same, so that none is better than another."""
        tried = [item.goal for item in self.levels if item.environment == environment and item.level and item.runs]
        return len(tried) > 1 and len(set(tried)) == 1

    def complete(self) -> bool:
        """Return whether every run of the search has results."""
        return all(item.runs == len(self.seeds) for item in self.levels)


def name_candidate(level: int) -> str:
    """Return the name of a constant level in the search's plan; 0 is the tutor alone.

    >>> name_candidate(0), name_candidate(3)
    ('tutor-alone', 'level-3')
    """
    return f"level-{level}" if level else TUTOR_ALONE


def list_levels(environment: Environment) -> list[int]:
    """Return the levels that a search's environment tries, 0 among them: levels that are the same are tried once."""
    names = {variant.name for variant in environment.variants}
    return [level for level in range(len(names)) if name_candidate(level) in names]


def find_best(levels: Sequence[Level], limit: float, runs: int) -> Level | None:
    """Return the level with the highest goal among those within the limit; without one, the least violating level.

    Args:
        levels: Of one environment.
        limit: Share of decisions that may be violated.
        runs: Number of runs that a level must have to be chosen.
    """
    whole = [item for item in levels if item.level > 0 and item.runs == runs]
    within = [item for item in whole if _read_violated(item) <= limit]
    if within:
        return max(within, key=lambda item: (item.goal or 0.0, -_read_violated(item), -item.level))
    return min(whole, key=lambda item: (_read_violated(item), -(item.goal or 0.0), item.level), default=None)


def settle(plan: Plan, searched: Searched | None) -> Plan:
    """Return the plan with the control of the level that was found, in each environment that has one."""
    search = plan.search
    if search is None or searched is None:
        return plan
    pairs = zip(plan.environments, search.plan.environments, strict=True)
    return plan._replace(environments=tuple(_add_best(environment, tried, searched) for environment, tried in pairs))


def save_searched(searched: Searched, folder: Path) -> None:
    """Write the table below the folder of the study."""
    data = searched._asdict() | {"levels": [level._asdict() for level in searched.levels]}
    write_whole(folder / FOLDER / TABLE, json.dumps(data, indent=1) + "\n")


def load_searched(folder: Path) -> Searched | None:
    """Read the table of a study's search; None where the search has not ended.

    Raises:
        PipelineError: if it is damaged.
    """
    path = folder / FOLDER / TABLE
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        levels = tuple(Level(**level) for level in data["levels"])
        return Searched(data["goal"], data["harm_budget"], tuple(data["seeds"]), levels)
    except FileNotFoundError:
        return None
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise PipelineError(
            f"{path}: damaged ({type(error).__name__}: {error}). Remove it and go on with 'compare --resume'; "
            "it is made again from the runs of the search."
        ) from None


def _read_violated(item: Level) -> float:
    return item.violated or 0.0


def _add_best(environment: Environment, tried: Environment, searched: Searched) -> Environment:
    found = searched.chosen(environment.name)
    if found is None or BEST in [variant.name for variant in environment.variants]:
        return environment
    level = min(found.level, max(list_levels(tried)))  # an older search may have tried levels that are the same
    winner = next(variant for variant in tried.variants if variant.name == name_candidate(level))
    about = f"{winner.about} {_explain(found, searched)}"
    return environment._replace(
        variants=(*environment.variants, Variant(BEST, about, True, winner.pipeline, winner.counters))
    )


def _explain(found: Level, searched: Searched) -> str:
    limit = searched.limit(found.environment)
    seeds = ", ".join(map(str, searched.seeds))
    if _read_violated(found) > limit:
        kept = f"the one that violates least, since none keeps to {limit:.2%} of decisions"
    elif searched.is_indifferent(found.environment):
        kept = f"the one that violates least, or the lowest of those, since all came to the same mean '{searched.goal}'"
    else:
        kept = (
            f"the one with the highest mean '{searched.goal}' among those with at most {limit:.2%} of decisions "
            "violated"
        )
    return (
        f"Of levels 1 to {max(item.level for item in searched.levels if item.environment == found.environment)} "
        f"it is {kept}, in runs of their own "
        f"(seed{'s' if len(searched.seeds) > 1 else ''} {seeds})."
    )
