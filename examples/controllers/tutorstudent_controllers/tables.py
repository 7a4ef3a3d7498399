"""A study's folder as one table in Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

import tutorstudent as ts
from tutorstudent.study import Environment, Run, Study, load_plan, read_study
from tutorstudent_controllers.measures import MEASURES, Measure
from tutorstudent_controllers.paired import Difference, difference, verdict

PER = 10_000
MARGIN = 10.0
"""A harm that is at most this much more, in `PER` decisions, is not worse: the thesis's 0.1 %."""


def table(folder: Path) -> str:
    """Return the table of a study that stands in a folder named after its example.

    Raises:
        PipelineError: There is no such example, or no study in the folder.
    """
    if folder.name not in MEASURES:
        raise ts.PipelineError(f"{folder}: there is no example '{folder.name}'. Examples: {', '.join(MEASURES)}.")
    study = read_study(folder, load_plan(folder))
    environment = study.plan.environments[0]
    return "\n".join(_lines(study, environment, MEASURES[folder.name]))


def _lines(study: Study, environment: Environment, measures: Sequence[Measure]) -> Iterator[str]:
    gain, harm = measures[0], next(measure for measure in measures if measure.harm)
    per = PER / study.plan.decisions
    titles = [f"{measure.title} (to the tutor alone)" for measure in (gain, harm)]
    rest = [measure for measure in measures if measure not in (gain, harm)]
    yield _row(["", *titles, "harm", *(measure.title for measure in rest), "level", "runs"])
    yield _row(["---", *["---:"] * (len(titles) + len(rest) + 3)])
    alone = study.of(environment.name, environment.reference)
    for variant in environment.variants:
        runs = study.of(environment.name, variant.name)
        name = f"*{variant.name}*" if variant.control else f"**{variant.name}**"
        if not runs:
            yield _row([name, "no run is complete"])
            continue
        gained, harmed = _against(gain, runs, alone), _against(harm, runs, alone)
        cells = [f"{_spread(gain, runs)} {_add_sign(gained)}", f"{_spread(harm, runs)} {_add_sign(harmed)}"]
        said = verdict(_scale(harmed, per), MARGIN) if variant.name != environment.reference else ""
        others = [_spread(measure, runs) for measure in rest]
        level = np.mean([run.summary["mean_level"] for run in runs])
        yield _row([name, *cells, said, *others, f"{level:.1f}", str(len(runs))])


def _against(measure: Measure, runs: Sequence[Run], alone: Sequence[Run]) -> Difference:
    theirs = {run.seed: run.summary[measure.key] for run in alone}
    pairs = [(run.summary[measure.key], theirs[run.seed]) for run in runs if run.seed in theirs]
    return difference(*zip(*pairs, strict=True)) if pairs else Difference(0.0, None, None)


def _scale(found: Difference, by: float) -> Difference:
    interval = None if found.interval is None else (found.interval[0] * by, found.interval[1] * by)
    return Difference(found.mean * by, interval, None if found.upper is None else found.upper * by)


def _spread(measure: Measure, runs: Sequence[Run]) -> str:
    values = [run.summary[measure.key] for run in runs]
    return f"{np.mean(values):.4g} ± {np.std(values, ddof=1) if len(values) > 1 else 0:.2g}"


def _add_sign(found: Difference) -> str:
    if found.interval is None:
        return f"({found.mean:+.3g})"
    if found.mean == 0 and found.interval == (0, 0):
        return ""
    return f"({found.mean:+.3g} [{found.interval[0]:+.3g}, {found.interval[1]:+.3g}])"


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
