"""A pipeline whose levels come from outside: its own tutor, conditions, limits and world, but no student."""

from __future__ import annotations

from typing import Any, NamedTuple

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.files.assembly import Assembler
from tutorstudent.core.files.defaults import add_change, make_defaults
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.gym.outside import Ahead, Held, Outside


class Driven(NamedTuple):
    """An engine with the two parts through which levels come from outside."""

    engine: Engine[Any, Any, Any]
    tutor: Ahead
    student: Outside[Any, Any]


def drive(pipeline: Pipeline) -> Driven:
    """Build the engine of a pipeline with stand-ins for student, selector and amplifier; limits and all else stay.

    Raises:
        TutorStudentError: if it cannot be built; the message says where and what to do.
    """
    data, assembler = pipeline.document.data, Assembler(pipeline.document, pipeline.registry)
    student = data.get("student")
    if not isinstance(student, dict) or "encoder" not in student:
        raise PipelineError(
            f"{pipeline.document.locate(('student',))}: the student names no encoder, so there is nothing to observe; "
            "add one, as in 'student: {use: backprop, encoder: prototype2-bits}'."
        )
    if "tutor" not in data:
        raise PipelineError(f"{pipeline.document.name}: there is no 'tutor'; name one, as in 'tutor: {{use: ...}}'.")
    tutor = assembler.make_part("tutor", data["tutor"], ("tutor",))
    amplifier = add_change(data.get("amplifier", make_defaults(tutor)["amplifier"]), tutor, pipeline.registry)
    outside: Outside[Any, Any] = Outside(
        encoder=assembler.make_part("encoder", student["encoder"], ("student", "encoder")),
    )
    ahead = Ahead(tutor=tutor)
    held: Held[Any] = Held(amplifier=assembler.make_part("amplifier", amplifier, ("amplifier",)))
    engine = pipeline.replaced({"selector": "modifier"}).engine(tutor=ahead, student=outside, amplifier=held)
    return Driven(engine, ahead, outside)
