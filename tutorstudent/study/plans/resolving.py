"""A pipeline with every value written out, and whether two of them are the same."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from typing import Any, NamedTuple

from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.deciding.reach import HIGHEST_USEFUL, find_highest
from tutorstudent.core.files.pipeline import Built, Pipeline, describe
from tutorstudent.core.files.plainvalues import make_plain
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import Document
from tutorstudent.core.roles.interfaces import SLOTS
from tutorstudent.core.roles.leaves import Encoder
from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.observers import Entries
from tutorstudent.core.running.runner import make_trial_seed

Values = Mapping[str, Any]
UNAMPLIFIED = ("world", "tutor", "conditions", "observers", "on_tutor_failure")
"""The keys that matter where nothing is amplified."""


class Resolved(NamedTuple):
    """What a pipeline says, defaults included."""

    values: dict[str, Any]
    amount: float
    """Amplification per level."""
    change: dict[str, Any]
    """How an amplification becomes a distance."""
    encoder: dict[str, Any] | None
    """What the student looks at, where it has an encoder."""
    counters: dict[str, str]
    """What its observers count, such as ``attractors``, and the situation whose entries that is."""
    highest_level: int = HIGHEST_USEFUL
    """Up to the thesis's eight, what the limits allow; constant levels beyond it are one and the same."""
    goal_event: str = ""
    """What its world counts for achievement; empty where it does not say."""


def resolve(pipeline: Pipeline) -> Resolved:
    """Build the whole pipeline once, so that mistakes are found before anything runs, and write its values out.

    Raises:
        TutorStudentError: if it cannot be built; the message says where and what to do.
    """
    with _build(pipeline) as (engine, world, observers):
        encoders = [part for _, part in engine.student.parts() if isinstance(part, Encoder)]
        return Resolved(
            describe(engine, world, pipeline),
            float(engine.amplifier.amount),
            make_plain(engine.amplifier.change.describe(), "amplifier.change"),
            make_plain(encoders[0].describe(), "student.encoder") if encoders else None,
            {observer.counted: observer.situation for observer in observers if isinstance(observer, Entries)},
            find_highest(engine.tutor.action, engine.amplifier, engine.limits, HIGHEST_USEFUL),
            world.goal_event,
        )


def complete(name: str, values: Values, registry: Registry) -> dict[str, Any]:
    """Return the values with the defaults of the engine's parts filled in."""
    with closing(reread(name, values, registry).engine()) as engine:
        return dict(values) | {slot: make_plain(getattr(engine, slot).describe(), f"{name}: {slot}") for slot in SLOTS}


def reread(name: str, values: Values, registry: Registry) -> Pipeline:
    """Return the pipeline with these values."""
    return Pipeline(Document(name, dict(values)), registry)


def draw_sketch(pipeline: Pipeline) -> Sketch:
    """Return a drawing of the pipeline's world at the beginning of a run."""
    with _build(pipeline) as (_, world, _observers):
        try:
            world.reset(make_trial_seed(pipeline.header.seed, 0))
            return world.sketch()
        except BaseException as error:  # the runs say what is wrong with it
            if is_owners(error):
                raise
            return Sketch()


@contextmanager
def _build(pipeline: Pipeline) -> Iterator[Built]:
    """Build a pipeline; what it raises when it is closed after that costs nothing."""
    done = False
    try:
        with pipeline.built() as built:
            yield built
            done = True
    except BaseException as error:
        if not done or is_owners(error):
            raise


def is_tutor_alone(values: Values) -> bool:
    """Return whether resolved values can never amplify anything."""
    return bool(values["student"]["use"] == "silent" and values["amplifier"]["use"] == "never")


def find_learner(resolved: Mapping[str, Resolved]) -> str | None:
    """Return the name of the first pipeline that can amplify; None if all are tutors alone."""
    return next((name for name, found in resolved.items() if not is_tutor_alone(found.values)), None)


def is_same(one: Values, other: Values) -> bool:
    """Return whether two resolved pipelines do the same, whatever their seed and number of decisions.

    A tutor that is never amplified is one and the same with any selector, evaluator, amount and limits.
    """
    return _find_essence(one) == _find_essence(other)


def _find_essence(values: Values) -> dict[str, Any]:
    if is_tutor_alone(values):
        return {key: values[key] for key in UNAMPLIFIED}
    return {key: value for key, value in values.items() if key not in ("seed", "decisions")}
