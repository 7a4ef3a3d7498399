"""How worlds and observers are used."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import cycle, islice
from typing import Any

from tutorstudent.checks.outcome import expect
from tutorstudent.checks.roles.sound import expect_number
from tutorstudent.checks.standins import make_engine, play
from tutorstudent.checks.subject import FEWEST, SEED
from tutorstudent.checks.usage import Question, Usage
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.observers import Begin
from tutorstudent.core.words.errors import list_names


class WorldUsage(Usage):
    """Reset with a seed, then given sound actions; reset again where a trial ends."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return [(action,) for action in islice(cycle(self.subject.actions), FEWEST)]

    def begin(self, part: Any) -> None:
        part.reset(SEED)

    def ask(self, part: Any, question: Question) -> Any:
        step = part.step(*question)
        if getattr(step, "done", False) or getattr(step, "truncated", False):
            part.reset(SEED + 1)
        return step

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        expect(
            type(answer) is Step and isinstance(answer.events, Mapping),
            "step() returns a Step(state, events, done, truncated)",
            f"{type(answer).__name__}",
            "return tutorstudent.Step(state, {name: number, ...})",
        )
        declared = part.event_names
        for name, value in answer.events.items():
            expect(
                name in declared,
                f"events are those of event_names: {list_names(declared)}",
                f"the event {name!r}",
                "declare it in event_names, with how a run summarizes it",
            )
            expect_number(value, f"the event '{name}'")


class ObserverUsage(Usage):
    """Shown a short run of stand-ins; asked for its summary at the end of each decision."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return list(play(self.subject.actions))

    def begin(self, part: Any) -> None:
        engine, world = make_engine(self.subject.actions)
        part.begin(Begin(engine, world, len(self.make_usual())))

    def ask(self, part: Any, question: Question) -> Any:
        return part.observe(*question), part.summary()

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        values, summary = answer
        known = [measure.name for measure in part.measures]
        for name, value in (values or {}).items():
            expect(
                name in known,
                f"observe() returns its measures: {list_names(known)}",
                f"the number {name!r}",
                f"declare it: measures = [ts.Measure({name!r})]",
            )
            expect_number(value, f"'{name}' of observe()")
        expect(isinstance(summary, Mapping), "summary() returns a mapping", f"{summary!r}", "return {name: number}")
        for name, value in summary.items():
            expect(isinstance(name, str), "the names of summary() are words", f"{name!r}", "use strings")
            expect_number(value, f"'{name}' of summary()")
