"""Runs pipelines of plotted parts and has every decision judged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

from tests.core.oracle.behaviours import EVERYTHING
from tests.core.oracle.branches import count_turn
from tests.core.oracle.cast import State, parts
from tests.core.oracle.hearing import answered, judged, recorded, taught
from tests.core.oracle.judge import Breach, Claim, Last, Rules, Said, judge
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
        self.hits: Counter[str] = Counter()
        """How often each branch of the guard was passed."""
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
    cap = random.choice((0.1, 0.3, 0.5, 0.8, 0.8, 2.0, 500.0))
    return Rules(
        shape=random.choice(SHAPES),
        cap=cap,
        factor=None if cap > 100 else random.choice((None, None, 1.0, 1.1, 1.3, 2.5)),  # where levels end at 1000
        slew=random.choice((None, None, 1, 2, 5)),
        amount=random.choice((0.1, 0.1, 0.05, 0.25, 0.037) if cap < 100 else (0.1, 1e-5)),
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
        self._told = ""
        """What was said of the pending decision."""

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
                self._intervene()
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

    def _intervene(self) -> None:
        """Now and then say what may be said of a decision before it is judged."""
        dice, decision = self._random.random(), self.engine.pending
        if dice < 0.01:
            self.engine.void("an emergency stop")
            self._told = "an emergency stop"
        elif dice < 0.02:
            self.engine.drop()
            self._pending = None
            count_turn(self._tally.hits, self.engine.last)
        elif dice < 0.04 and self._pending is not None:
            self._correct(decision)

    def _correct(self, decision: Any) -> None:
        """Say that the tutor's own action was executed, or one that has nothing to do with it."""
        words, _, before, deeds = self._pending
        shape = self.rules.shape
        other = shape.draw(self._random, words.kind) if self._random.random() < 0.5 else words.itself
        self.engine.executed(other)
        now = self.engine.pending
        if not 0 <= now.resulting.level <= decision.resulting.level:
            found = f"level {now.resulting.level} is recorded, asked was {decision.resulting.level}"
            self._note([Breach("executed", found)], self._plot.take())
        self._last = Last(words.kind, now.resulting.level)
        self._told = "executed"
        self._pending = words, dict(other.__dict__), before, deeds

    def _judge_decision(self, state: State) -> None:
        tutor, counts = self.engine.tutor, sum(self.engine.incident_counts.values())
        before = len(tutor.record)
        executed = self.engine.propagate(state)
        deeds, decision = self._plot.take(), self.engine.pending
        fresh = sum(self.engine.incident_counts.values()) - counts
        incidents = list(self.engine.incidents)[-fresh:] if fresh else []
        if len(tutor.record) != before + 1:
            self._note([Breach("asked", f"the tutor was asked {len(tutor.record) - before} times")], deeds)
        words = tutor.record[-1]
        honest_distances = not any(deed.slot == "change" and deed.behaviour.verdict == "either" for deed in deeds)
        refused = any(incident.part == "action" for incident in incidents)
        claim = Claim(
            executed,
            decision.selected.level,
            decision.resulting.level,
            decision.resulting.ampbit,
            bool(incidents),
            not refused and (honest_distances if not incidents else self._lawful and self.rules.law == "additive"),
        )
        self._note(judge(self.rules, self._last, words, claim), deeds)
        if refused and (claim.resulting_level or executed is not words.itself):
            self._note([Breach("fallback", f"a refused action is recorded at level {claim.resulting_level}")], deeds)
        blamed = [incident.part for incident in incidents if incident.part != self.rules.shape.refuses]
        self._note(list(answered(deeds, blamed)), deeds)
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
        told, self._told = self._told, ""
        count_turn(self._tally.hits, turn)
        words, executed, before, earlier = self._pending
        incidents = turn.incidents[before:]
        heard = self.engine.student.heard[heard_before:]
        self._tally.clean += not turn.incidents
        self._note(list(answered(deeds, [incident.part for incident in incidents])), deeds)
        self._note(list(recorded(turn, words, executed)), [*earlier, *deeds])
        self._note(list(judged(turn, state, deeds)), deeds)
        if not (told and turn.void):
            self._note(list(taught(turn, heard, words, executed, deeds)), [*earlier, *deeds])
        elif heard or turn.lesson is not None or turn.void == "dropped":
            self._note([Breach("void", f"taught {heard} although {turn.void}")], [*earlier, *deeds])


def run(
    seed: int | str,
    decisions: int,
    *,
    chosen: Sequence[tuple[str, str]] = EVERYTHING,
    make_engine: MakeEngine = Engine,
    trial_length: int = 200,
    mischief: float = 0.55,
    progress: Callable[[int], None] = lambda done: None,
    tally: Tally | None = None,
) -> Tally:
    """Run trials until so many decisions were taken, and write into the tally what is seen."""
    random, tally = Random(seed), tally or Tally()
    plot = Plot(random, chosen)
    plot.done = tally.deeds
    take_trials(tally, decisions, lambda: Trial(random, tally, plot, make_engine, mischief).run(trial_length), progress)
    return tally


def take_trials(tally: Any, decisions: int, take: Callable[[], None], progress: Callable[[int], None]) -> None:
    """Take one trial after the other until so many more decisions were taken."""
    decisions += tally.decisions
    while tally.decisions < decisions:
        before = tally.decisions
        take()
        progress(tally.decisions - before)
