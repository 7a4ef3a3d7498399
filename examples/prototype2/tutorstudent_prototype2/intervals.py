"""In which decisions does learning take place (Thesis 5.2.5)?

Prototype 2A, taught only about the decisions of one interval and about nothing before or after; beside it the whole
run, and a student that is never taught. The learning phase of the amplifier is the same for all (2500 decisions): it
raises levels whether or not anybody learns from it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import tutorstudent as ts
from tutorstudent.study import Environment, Run, Study, run_study
from tutorstudent_prototype2.contrast import by_seed
from tutorstudent_prototype2.pipelines import load
from tutorstudent_prototype2.running import plan_of
from tutorstudent_prototype2.sheets import NOTHING, Section, Sheet, add_sign, difference, markdown, number, spread
from tutorstudent_prototype2.summaries import INTERVALS, Summary, pair_up, summarize

PARTS = ((0.0, 0.1), (0.0, 0.25), (0.25, 0.5), (0.5, 0.75), (0.75, 1.0))
"""The intervals, as parts of a run; of 10,000 decisions the first thousand and the four quarters."""
ALONE, NEVER, WHOLE = "prototype2", "taught-never", "taught-whole"
MARKDOWN = "intervals.md"
HEADER = ("", "attractors", "less never's", "less whole's", "collided", "match, %", "level", "lessons")
COLUMNS = (
    "Taught about the decisions of an interval, never, or throughout; prototype2 is the tutor alone. Differences are "
    f"paired by seed, with the {INTERVALS}. Collided: decisions. Match: share of decisions in which the student named "
    "the tutor's kind of action. Level: mean over decisions. Lessons: mean over runs."
)


class Interval(NamedTuple):
    """Decisions that are taught about: [begin, end)."""

    begin: int
    end: int

    @property
    def name(self) -> str:
        """Names the variant."""
        return f"taught-{self.begin}-{self.end}"


def intervals_of(decisions: int) -> list[Interval]:
    """Return the intervals of a run.

    >>> [interval.name for interval in intervals_of(10000)][:3]
    ['taught-0-1000', 'taught-0-2500', 'taught-2500-5000']
    """
    return [Interval(round(begin * decisions), round(end * decisions)) for begin, end in PARTS]


def pipelines(scene: str, decisions: int) -> dict[str, ts.Pipeline]:
    """Return the tutor alone, and prototype 2A taught never, within each interval, and throughout."""
    learner = load("prototype2a", scene)
    within = {
        interval.name: learner.replaced({"evaluator": {"use": "interval", **interval._asdict()}})
        for interval in intervals_of(decisions)
    }
    never = learner.replaced({"evaluator": {"use": "interval", "begin": decisions}})
    return {ALONE: load(ALONE, scene), NEVER: never, **within, WHOLE: learner}


def intervals(scenes: Sequence[str], runs: int, decisions: int, workers: int, out: Path) -> tuple[Study, list[Section]]:
    """Run what has not been run yet, and write `MARKDOWN` beside the study's own report.

    Raises:
        PipelineError: The folder holds another study, or cannot be written.
    """
    plan = plan_of(pipelines(scenes[0], decisions), scenes, runs, decisions, controls=False)
    study = run_study(plan, out, workers)
    found = [_section(study, environment) for environment in study.plan.environments]
    (out / MARKDOWN).write_text(markdown(found, "In which decisions learning takes place (5.2.5)"), encoding="utf-8")
    return study, found


def _section(study: Study, environment: Environment) -> Section:
    runs = {variant.name: study.of(environment.name, variant.name) for variant in environment.variants}
    rows = tuple((name, *_row(name, runs)) for name in runs)
    return Section(Sheet(environment.name, HEADER, rows), (COLUMNS, *reading(runs)))


def _row(name: str, runs: dict[str, list[Run]]) -> list[str]:
    mine = runs[name]
    if not mine:
        return [NOTHING] * (len(HEADER) - 1)
    found = {
        key: summarize([run.summary.get(key, math.nan) for run in mine])
        for key in ("attractors", "collided", "match_rate", "mean_level", "taught")
    }
    return [
        spread(*found["attractors"][1:3]),
        NOTHING if name == NEVER else difference(_more(runs, name, NEVER)),
        NOTHING if name == WHOLE else difference(_more(runs, name, WHOLE)),
        spread(*found["collided"][1:3]),
        number(100 * found["match_rate"].mean),
        number(found["mean_level"].mean),
        NOTHING if name == ALONE else f"{found['taught'].mean:.0f}",
    ]


def reading(runs: dict[str, list[Run]]) -> list[str]:
    """Say which intervals have shown that teaching in them matters for attractors, and what of that is the whole's."""
    whole = _more(runs, WHOLE, NEVER)
    if whole is None or not _is_shown(whole):
        return ["Teaching throughout has not shown to differ from never teaching: there is no learning to divide."]
    said = [
        f"Teaching throughout is worth {add_sign(whole.mean)} attractors over never. Of that (each at 95 % by itself):"
    ]
    for name in runs:
        more = None if name in (ALONE, NEVER, WHOLE) else _more(runs, name, NEVER)
        if more is not None:
            word = f"{100 * more.mean / whole.mean:.0f} %" if _is_shown(more) else "nothing that shows"
            said.append(f"* {name}: {word}")
    return ["\n".join(said)]


def _is_shown(more: Summary) -> bool:
    return more.low > 0 or more.high < 0


def _more(runs: dict[str, list[Run]], name: str, than: str) -> Summary | None:
    return pair_up(by_seed(runs[name], "attractors"), by_seed(runs[than], "attractors"))
