"""What came out of a run, whether it is complete or not."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any, NamedTuple

from pydantic import ValidationError

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.deciding.watching import Notice
from tutorstudent.core.files.pipeline import Built
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.running.whereabouts import DECIDE, OBSERVE, Whereabouts
from tutorstudent.core.words.errors import TutorStudentError, quote, say_error
from tutorstudent.core.words.measures import Measure


class Failure(NamedTuple):
    """What ended a run before its last decision."""

    error: BaseException
    problem: str
    """A sentence with the decision and who is to blame."""

    @classmethod
    def explain(cls, error: BaseException, built: Built, at: Whereabouts) -> Failure:
        """Return an exception of the loop with its sentence."""
        names = name_parts(built)
        who = names["tutor"] if at.place == DECIDE else at.describe(names)  # what all others raise is an incident
        if at.place == OBSERVE:
            who = _find_observer(error) or who
        if is_owners(error):
            said = "interrupted" if isinstance(error, KeyboardInterrupt) else "ended from outside"
        elif isinstance(error, TutorStudentError):
            said = str(error)
        else:
            said = f"{who} {_say_unsound(error) or f'raised {say_error(error)}'}"
        before = f"decision {at.decision}: "
        return cls(error, said if said.startswith(before) else f"{before}{said}")

    @property
    def is_owners(self) -> bool:
        """Whether it is a stop from outside."""
        return is_owners(self.error)


def _find_observer(error: BaseException) -> str:
    """Return the innermost observer that an exception went through."""
    found, trace = "", error.__traceback__
    while trace is not None:
        owner = trace.tb_frame.f_locals.get("self")
        if isinstance(owner, Observer):
            found = f"observer '{owner.name}': {trace.tb_frame.f_code.co_name}()"
        trace = trace.tb_next
    return found


def _say_unsound(error: BaseException) -> str:
    """Return what is wrong with an action that could not be made; nothing for any other error."""
    if isinstance(error, ValidationError):
        first = error.errors(include_url=False)[0]
        name, said = ".".join(map(str, first["loc"])), f"{first['msg'][:1].lower()}{first['msg'][1:]}"
        return (
            f"made no {error.title}: '{name}' is {quote(first['input'])}; {said}. Clip it, or widen the bounds of the "
            "action class."
        )
    if isinstance(error, TypeError) and "BaseModel.__init__() takes 1 positional argument" in str(error):
        return "made an action without the names of its components; write them, as in Force(value=0.5)."
    return ""


def name_parts(built: Built) -> dict[str, str]:
    """Return world and tutor as messages call them."""
    return {"world": f"world '{built.world.name}'", "tutor": f"tutor '{built.engine.tutor.name}'"}


class Finished(NamedTuple):
    """What came out of a run."""

    engine: Engine[Any, Any, Any]
    resolved: dict[str, Any]
    """The pipeline with every option written out."""
    plugins: dict[str, str]
    """The distribution that each part comes from, by role and name."""
    summary: dict[str, float]
    """What the observers counted; NaN for what is no number."""
    decisions: Arrays
    measures: tuple[Measure, ...] = ()
    """What the world, the observers and every run declare."""
    failure: Failure | None = None
    """What ended it too early; the decisions are those before."""
    notes: tuple[str, ...] = ()
    """What went wrong after the last decision."""
    notices: tuple[Notice, ...] = ()
    """What kept the learner from having any effect."""


def make_record(finished: Finished, versions: dict[str, str]) -> dict[str, Any]:
    """Return what ``run.json`` says of a run."""
    engine, failure = finished.engine, finished.failure
    lacking = (
        {} if failure is None else {"problem": failure.problem, "decided": len(finished.decisions.get("kind", ()))}
    )
    return lacking | {
        "complete": failure is None,
        "versions": versions,
        "plugins": finished.plugins,
        "seed": finished.resolved["seed"],
        "decisions": finished.resolved["decisions"],
        "summary": {key: value if math.isfinite(value) else None for key, value in finished.summary.items()},
        "measures": [asdict(measure) for measure in finished.measures],
        "notices": [notice._asdict() for notice in finished.notices],
        "incident_counts": {f"{part}: {kind}": count for (part, kind), count in sorted(engine.incident_counts.items())},
        "newest_incidents": [incident._asdict() for incident in engine.incidents],
    }
