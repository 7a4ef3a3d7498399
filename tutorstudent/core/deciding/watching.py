"""Watches decisions for a learner that does nothing, and says what is wrong and what to do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any, NamedTuple

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.reach import explain_unreachable
from tutorstudent.core.words.proposals import KindProposal
from tutorstudent.core.words.turn import Turn

ENOUGH = 200
"""Decisions after which a loop says what it saw."""
NEARLY_ALL = 0.9
"""Share of decisions in which a part fails that is of no use."""
CONSEQUENCES = {
    "conditions": "it counted as violated in each",
    "evaluator": "nothing was taught in these",
    "action": "the controller's own action was executed in these",
}
FALLEN_BACK = "the controller's own action was executed in these, or nothing was learned"


class Notice(NamedTuple):
    """Something that keeps a learner from having any effect."""

    kind: str
    """One word or two, the same for the same fault."""
    says: str
    """What was found and what to do, in sentences."""


class Watch:
    """Counts what decisions came to, and says what kept all of them from being amplified; each kind of fault once.

    It changes nothing and draws no random numbers.
    """

    def __init__(self, engine: Engine[Any, Any, Any]) -> None:
        self._engine = engine
        self.at_assembly = find_assembly_notices(engine)
        """What is wrong whatever the decisions will be; parts are asked here, and never while decisions go on."""
        self.decisions = 0
        self._levels = self._named = self._matched = 0
        self._failed: Counter[str] = Counter()
        self._messages: dict[str, str] = {}
        self._stopped: Counter[str] = Counter()
        self._violated: Counter[str] = Counter()

    def observe(self, turn: Turn[Any, Any]) -> None:
        """Take in one decision, after it was judged."""
        self.decisions += 1
        decision, shown = turn.decision, turn.decision.moment.tutor_action
        newest = {incident.part: f"{incident.kind}: {incident.message}" for incident in turn.incidents}
        self._failed.update(newest.keys())
        self._messages |= newest
        if isinstance(decision.proposal, KindProposal):
            self._named += 1
            self._matched += decision.proposal.kind == shown.kind
        if decision.resulting.level:
            self._levels += 1
        else:
            self._stopped[turn.limited_by] += 1
        if turn.outcome is not None:
            self._violated.update(turn.outcome.violated)

    def find_notices(self) -> list[Notice]:
        """Return what is wrong, as far as it can be told by now; nothing where all is well."""
        kinds = {notice.kind for notice in self.at_assembly}
        found = [*self.at_assembly]
        for notice in self._find_seen():
            if notice.kind not in kinds:
                kinds.add(notice.kind)
                found.append(notice)
        return found

    def _find_seen(self) -> Iterator[Notice]:
        failing = [part for part, times in self._failed.items() if times >= NEARLY_ALL * max(1, self.decisions)]
        yield from map(self._describe_failing, failing)
        yield from self._find_violated(failing)
        if (
            self.decisions
            and not self._levels
            and not set(failing) & {"tutor", "student", "selector", "amplifier", "action"}
        ):
            yield from self._find_stopped()

    def _describe_still(self, what: str) -> Notice:
        return Notice(
            "nothing to move",
            f"{what}: the controller's commands were at neutral or at their bounds, where there is nothing to amplify. "
            "If they do something there, declare another neutral or wider bounds, as in ts.scalar(0, 100, neutral=50). "
            f"Otherwise the change '{self._engine.amplifier.change.name}' returns 0, or executed() takes it back.",
        )

    def _describe_failing(self, part: str) -> Notice:
        effect = CONSEQUENCES.get(part.partition(".")[0], FALLEN_BACK)
        message = self._messages[part].rstrip(".")
        return Notice(
            f"{part} fails",
            f"{part} failed in {self._failed[part]} of {self.decisions} decisions; {effect}. The newest: {message}. "
            "Mend it, or name another part.",
        )

    def _find_violated(self, failing: list[str]) -> Iterator[Notice]:
        if not self._engine.student.learns:
            return
        for name, times in self._violated.items():
            if times == self.decisions and f"conditions.{name}" not in failing:
                yield Notice(
                    f"{name} violated",
                    f"condition '{name}' was violated after every one of {self.decisions} decisions, so that nothing "
                    "else could be learned than not to amplify. True means violated; turn it round if it says what "
                    "should be, or drop it if the controller alone always violates it.",
                )

    def _find_stopped(self) -> Iterator[Notice]:
        by = self._stopped.most_common(1)[0][0]
        engine, none = self._engine, f"none of {self.decisions} decisions was amplified"
        if by in ("cap", "factor"):
            yield Notice("level 1", f"{none}: {explain_limit(engine, by)}")
        elif by in ("nothing to move", "bounds", "executed"):
            yield self._describe_still(none)
        elif engine.student.learns and self._named and not self._matched:
            yield Notice(
                "kinds",
                f"{none}: student '{engine.student.name}' never named the tutor's kind, so that selector "
                f"'{engine.selector.name}' took level 0. Where there is one kind, use the codec 'level-ampbit' with "
                "the selector 'modifier'; else give the student longer, or other inputs.",
            )
        elif engine.student.learns and not self._failed["action"]:
            yield Notice(
                "nobody asked",
                f"{none}: student '{engine.student.name}' asked for no level above 0, and amplifier "
                f"'{engine.amplifier.name}' raised none. Use an amplifier that raises levels, as in "
                "amplifier: {use: learning-phase, decisions: 500}.",
            )


def find_assembly_notices(engine: Engine[Any, Any, Any]) -> list[Notice]:
    """Return what is wrong with an engine whatever its decisions will be."""
    limits, found = engine.limits, []
    is_single = len(engine.tutor.action.vocabulary.kinds) == 1
    if is_single and limits.factor is None and limits.slew is None and not limits.model_fields_set & {"factor", "slew"}:
        found.append(
            Notice(
                "no limits",
                "neither limits.factor nor limits.slew is set, so that a level may change the command at once by "
                f"{limits.cap:g} of its scale, whatever its size. For a command of one kind, a pipeline and ts.wrap "
                "take factor 1.3 and slew 1: Limits(factor=1.3, slew=1). Write None where you want none.",
            )
        )
    if by := explain_unreachable(engine.tutor.action, engine.amplifier, limits):
        found.append(Notice("level 1", f"nothing can ever be amplified: {explain_limit(engine, by)}"))
    return found


def explain_limit(engine: Engine[Any, Any, Any], by: str) -> str:
    """Return why a limit forbids even level 1, and what to do."""
    amplifier, limits = engine.amplifier, engine.limits
    change = f"with the change '{amplifier.change.name}' and amount {amplifier.amount:g}"
    if by == "cap":
        return f"{change} even level 1 exceeds limits.cap {limits.cap:g}. Raise the cap, or lower amplifier.amount."
    return (
        f"{change} even level 1 exceeds limits.factor {limits.factor:g} of such commands. Use change: multiplicative "
        "with an amount of at most factor - 1, as in amplifier: {use: learning-phase, decisions: 0, change: "
        "multiplicative}, or raise limits.factor, or write null for none."
    )
