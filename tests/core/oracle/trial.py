"""Runs pipelines of plotted parts and has every decision judged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from random import Random
from typing import Any

from tests.core.oracle.behaviours import BLAMED, EVERYTHING
from tests.core.oracle.cast import State, parts
from tests.core.oracle.judge import Breach, Claim, Last, Rules, Said, judge
from tests.core.oracle.learner import Heard
from tests.core.oracle.plot import Deed, Plot
from tests.core.oracle.shapes import SHAPES
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.limits import Limits

MakeEngine = Callable[..., Any]


class Tally:
    """What was seen over many trials."""

    def __init__(self) -> None:
        self.decisions = self.clean = self.amplified = 0
        self.deeds: Counter[tuple[str, str]] = Counter()
        self.breaches: Counter[tuple[str, str]] = Counter()
        """Breaches by name and by what was done in that decision."""
        self.examples: dict[tuple[str, str], str] = {}
        """For each of them, what was seen first."""

    def note(self, breach: Breach, deeds: Sequence[Deed], rules: Rules) -> None:
        """Remember a breach."""
        during = " + ".join(f"{deed.slot} {deed.name}" for deed in deeds) or "nothing hostile"
        self.breaches[breach.name, during] += 1
        self.examples.setdefault((breach.name, during), f"{breach.text} ({rules._replace(shape=rules.shape.action)})")

    def report(self) -> str:
        """Return one line for each sort of breach."""
        return "\n".join(f"{n} x {key[0]} during {key[1]}: {self.examples[key]}" for key, n in self.breaches.items())


def draw_rules(random: Random) -> Rules:
    """Return what some owner might have written."""
    return Rules(
        shape=random.choice(SHAPES),
        cap=random.choice((0.1, 0.3, 0.5, 0.8, 0.8, 2.0)),
        factor=random.choice((None, None, 1.0, 1.1, 1.3, 2.5)),
        slew=random.choice((None, None, 1, 2, 5)),
        amount=random.choice((0.1, 0.1, 0.05, 0.25, 0.037)),
        law=random.choice(("additive", "additive", "multiplicative")),
    )


class Trial:
    """One pipeline, run for a while.

    Args:
        random: Source of everything that is drawn.
        tally: Where to write what is seen.
        plot: Who misbehaves.
        make_engine: The engine, or a broken double of it.
        mischief: Share of decisions in which a part misbehaves.
    """

    def __init__(self, random: Random, tally: Tally, plot: Plot, make_engine: MakeEngine, mischief: float) -> None:
        self._random, self._tally, self._plot, self._mischief = random, tally, plot, mischief
        self.rules = draw_rules(random)
        rules, kinds = self.rules, random.random() < 0.5
        cast = parts(plot, rules.shape, random.randrange(2**30), rules.law, rules.amount, random.choice((0, 60)), kinds)
        limits = Limits(cap=rules.cap, factor=rules.factor, slew=rules.slew)
        self.engine = make_engine(**cast, limits=limits)
        self._last: Last | None = None
        self._lawful = True
        self._pending: tuple[Said, dict[str, object], int, list[Deed]] | None = None

    def run(self, decisions: int) -> None:
        """Take so many decisions, or stop at the first exception that the engine lets through."""
        for number in range(decisions):
            self._tally.decisions += 1
            if self._random.random() < self._mischief:
                self._plot.arm()
            state = State(number, self._random.random() < 0.4, self._random.uniform(-1, 1))
            try:
                self._judge_evaluation(state)
                self._interrupt()
                self._judge_decision(state)
            except KeyboardInterrupt:
                raise
            except BaseException as error:
                self._note([Breach("loop", f"the engine let {type(error).__name__} through")], self._plot.take())
                return

    def _note(self, breaches: Sequence[Breach], deeds: Sequence[Deed]) -> None:
        for breach in breaches:
            self._tally.note(breach, deeds, self.rules)

    def _interrupt(self) -> None:
        if self._random.random() < 0.01:
            self.engine.reset()
            self._last = None

    def _judge_decision(self, state: State) -> None:
        tutor, counts = self.engine.tutor, sum(self.engine.incident_counts.values())
        before = len(tutor.record)
        executed = self.engine.propagate(state)
        deeds, decision = self._plot.take(), self.engine.pending
        incidents = list(self.engine.incidents)[-1:] if sum(self.engine.incident_counts.values()) > counts else []
        if len(tutor.record) != before + 1:
            self._note([Breach("asked", f"the tutor was asked {len(tutor.record) - before} times")], deeds)
        words = tutor.record[-1]
        honest_distances = not any(deed.slot == "change" and deed.behaviour.verdict == "either" for deed in deeds)
        claim = Claim(
            executed,
            decision.selected.level,
            decision.resulting.level,
            decision.resulting.ampbit,
            bool(incidents),
            honest_distances if not incidents else self._lawful and self.rules.law == "additive",
        )
        self._note(judge(self.rules, self._last, words, claim), deeds)
        self._note(list(_answered(deeds, [incident.part for incident in incidents])), deeds)
        self._lawful = claim.lawful
        self._last = Last(words.kind, claim.resulting_level)
        self._pending = words, dict(executed.__dict__), len(incidents), deeds
        self._tally.amplified += decision.amplified

    def _judge_evaluation(self, state: State) -> None:
        heard_before = len(self.engine.student.heard)
        turn = self.engine.evaluate(state)
        deeds = self._plot.take()
        if turn is None or self._pending is None:
            return
        words, executed, before, earlier = self._pending
        incidents = turn.incidents[before:]
        heard = self.engine.student.heard[heard_before:]
        self._tally.clean += not turn.incidents
        self._note(list(_answered(deeds, [incident.part for incident in incidents])), deeds)
        self._note(list(_recorded(turn, words, executed)), [*earlier, *deeds])
        self._note(list(_judged(turn, state, deeds)), deeds)
        self._note(list(_taught(turn, heard, words, executed, deeds)), [*earlier, *deeds])


def _answered(deeds: Sequence[Deed], blamed: Sequence[str]) -> Iterator[Breach]:
    """What is refused is an incident of the part that did it; what is fine is none."""
    refused = [deed for deed in deeds if deed.behaviour.verdict == "refused"]
    if refused and not any(part in BLAMED[deed.slot] for part in blamed for deed in refused):
        yield Breach("incident", f"went unnoticed (blamed: {', '.join(blamed) or 'nobody'})")
    if blamed and not any(deed.behaviour.verdict in ("refused", "either") for deed in deeds):
        yield Breach("false alarm", f"{', '.join(blamed)} blamed for nothing")


def _recorded(turn: Any, words: Said, executed: dict[str, object]) -> Iterator[Breach]:
    """Records show what the tutor said and what was executed, whatever the parts did to their copies."""
    decision = turn.decision
    own = {"kind": words.kind, **words.values, **words.constants}
    for where, action in (
        ("moment", decision.moment.tutor_action),
        ("selected", decision.selected.action),
        ("resulting", decision.resulting.action),
    ):
        if _plain(action.__dict__) != own:
            yield Breach("record", f"the {where} shows {action.__dict__}, the tutor said {own}")
    if _plain(decision.executed.__dict__) != executed:
        yield Breach("record", f"the executed action shows {decision.executed.__dict__}, executed was {executed}")


def _plain(values: dict[str, Any]) -> dict[str, object]:
    """Return values that cannot lie."""
    plain = {float: lambda v: v, str: lambda v: v}
    return {key: plain.get(type(value), lambda v: f"a {type(v).__name__}")(value) for key, value in values.items()}


def _judged(turn: Any, state: State, deeds: Sequence[Deed]) -> Iterator[Breach]:
    hostile = [deed for deed in deeds if deed.slot in ("condition", "margins")]
    violated = state.hot or any(deed.behaviour.verdict == "refused" for deed in hostile)
    expected = ("flag",) if violated else ()
    if turn.outcome.violated != expected:
        yield Breach("violated", f"recorded {turn.outcome.violated}, expected {expected}")


def _taught(
    turn: Any, heard: Sequence[Heard], words: Said, executed: dict[str, object], deeds: Sequence[Deed]
) -> Iterator[Breach]:
    teaching = [deed for deed in deeds if deed.slot in ("evaluator", "learner", "encode")]
    if any(deed.behaviour.verdict == "refused" for deed in teaching):
        if turn.lesson is not None:
            yield Breach("lesson", "a refused lesson is recorded as taught")
        if heard and any(deed.slot == "evaluator" and deed.behaviour.verdict == "refused" for deed in teaching):
            yield Breach("lesson", "a refused lesson was taught")
        return
    if any(deed.slot == "evaluator" for deed in teaching):
        return
    selected, resulting = turn.decision.selected, turn.decision.resulting
    success = not turn.outcome.violated
    level = resulting.level if success else selected.level if resulting.level > selected.level else 0
    own = {"kind": words.kind, **words.values, **words.constants}
    moment = turn.decision.moment
    expected = [Heard(moment.number, moment.state, own, level, success, resulting.level, executed)]
    if list(heard) != expected:
        yield Breach("lesson", f"taught {heard}, expected {expected}")


def run(
    seed: int,
    decisions: int,
    *,
    chosen: Sequence[tuple[str, str]] = EVERYTHING,
    make_engine: MakeEngine = Engine,
    trial_length: int = 200,
    mischief: float = 0.55,
    progress: Callable[[int], None] = lambda done: None,
) -> Tally:
    """Run trials until so many decisions were taken."""
    random, tally = Random(seed), Tally()
    plot = Plot(random, chosen)
    while tally.decisions < decisions:
        before = tally.decisions
        Trial(random, tally, plot, make_engine, mischief).run(trial_length)
        progress(tally.decisions - before)
    tally.deeds = plot.done
    return tally
