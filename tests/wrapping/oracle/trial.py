"""Wraps controllers in all forms of command, and has every command that an owner receives judged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import tutorstudent as ts
from tests.core.oracle.behaviours import PROPAGATION
from tests.core.oracle.branches import count_turn
from tests.core.oracle.judge import Breach
from tests.core.oracle.plot import Deed, Plot
from tests.core.oracle.trial import take_trials
from tests.wrapping.oracle import judge as judging
from tests.wrapping.oracle.cast import (
    BEHAVIOURS,
    BLAMES,
    OFTEN,
    Controller,
    Hearing,
    draw,
    draw_rules,
    make_parts,
    make_state,
)
from tests.wrapping.oracle.imprint import imprint
from tests.wrapping.oracle.judge import Levels, Rules, Said
from tests.wrapping.oracle.kits import declare
from tests.wrapping.oracle.meddling import HAND
from tests.wrapping.oracle.views import View

MakeLoop = Callable[..., Any]
SEATS = (Controller, Controller, Hearing)
WRITES = ("number", "whole")


class Fault(Exception):
    """A controller that fails."""


class Tally:
    """What was seen over many trials."""

    def __init__(self) -> None:
        self.decisions = self.clean = self.amplified = 0
        self.deeds: Counter[tuple[str, str]] = Counter()
        self.hits: Counter[str] = Counter()
        """How often each branch of guard and gate was passed."""
        self.breaches: Counter[tuple[str, str]] = Counter()
        self.examples: dict[tuple[str, str], str] = {}

    def note(self, breach: Breach, deeds: Sequence[Deed], rules: Rules) -> None:
        """Remember a breach."""
        during = " + ".join(f"{deed.slot} {deed.name}" for deed in deeds) or "nothing hostile"
        key = breach.name, f"{during} ({rules.kit.name})"
        self.breaches[key] += 1
        self.examples.setdefault(key, f"{breach.text} ({rules._replace(kit=rules.kit.name)})")

    def report(self) -> str:
        """Return one line for each sort of breach."""
        return "\n".join(f"{n} x {key[0]} during {key[1]}: {self.examples[key]}" for key, n in self.breaches.items())


class Trial:
    """One wrapped controller, driven for a while."""

    def __init__(self, random: Random, tally: Tally, plot: Plot, make_loop: MakeLoop, mischief: float) -> None:
        self._random, self._tally, self._plot, self._mischief = random, tally, plot, mischief
        self.rules = rules = draw_rules(random)
        self.controller = random.choice(SEATS)(random, rules)
        parts = make_parts(plot, rules, random.choice((0, 60)), random.random() < 0.5)
        limits, seed = {"cap": rules.cap}, random.randrange(2**30)
        HAND.works = False
        action = declare(rules.kit, rules.bounds)
        self.loop = make_loop(
            self.controller, action=action, factor=rules.factor, slew=rules.slew, limits=limits, seed=seed, **parts
        )
        plot.take()  # the change is asked at assembly too, which is no decision
        self._levels, self._lawful, self._received, self._decided = Levels(), True, None, 0
        self._given: tuple[Any, Any] = None, imprint(None)
        """The last command that was written for the owner, and what it said."""
        self._counts: Counter[tuple[str, str]] = Counter()
        self._counted: Any = None

    def run(self, decisions: int) -> None:
        """Take so many decisions, or stop at the first exception that is not the controller's."""
        for number in range(decisions):
            self._tally.decisions += 1
            if number and self._random.random() < self._mischief:
                self._plot.arm()
            if not self._decide(make_state(self._random, number)):
                return
            self._intervene()

    def _decide(self, state: Any) -> bool:
        before, asked = imprint(state), len(self.controller.asked)
        self.controller.fails = Fault() if self._random.random() < 0.003 else None
        try:
            received = self._step(state)
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            deeds, _ = self._plot.take(), self._blamed()
            if error is not self.controller.fails:
                self._note([Breach("loop", f"step() raised {type(error).__name__}: {error}"[:300])], deeds)
                return False
            self._tally.hits["the controller failed"] += 1
            return True
        HAND.works = True
        self._count()
        deeds, blamed = self._plot.take(), self._blamed()
        self._note(self._judge_handling(state, before, asked), deeds)
        if self.controller.said is not None:
            self._judge(received, self.controller.said, deeds, blamed)
        return True

    def _step(self, state: Any) -> Any:
        HAND.plot, HAND.whole_view = self._plot, View(self.rules.kit, self.controller)
        try:
            return self.loop.step(state)
        finally:
            HAND.awake = False

    def _judge_handling(self, state: Any, before: Any, asked: int) -> list[Breach]:
        found, controller = [], self.controller
        if len(controller.asked) != asked + 1:
            found.append(Breach("asked", f"the controller was asked {len(controller.asked) - asked} times"))
        elif controller.asked[-1] is not state:
            found.append(Breach("state", "the controller was asked with another object"))
        if imprint(self._given[0]) != self._given[1]:
            found.append(Breach("given", "a command that the owner has received before was changed"))
        if imprint(state) != before:
            found.append(Breach("state", "the owner's state was changed"))
        if isinstance(controller, Hearing) and controller.heard:
            heard = controller.heard.pop()
            if self._received is not None and heard != self._received:
                found.append(Breach("heard", f"{heard} is not what was executed"))
        return found

    def _judge(self, received: Any, said: Said, deeds: list[Deed], blamed: list[str]) -> None:
        found, own = [], received is said.itself
        if imprint(said.itself) != said.whole:
            found.append(Breach("own changed", f"the controller's command says {imprint(said.itself)}"))
            self.controller.said = None
        written = any(deed.slot in WRITES for deed in deeds)
        got = judging.measure(self.rules, said, received, not written)
        if isinstance(got, list):
            self._note([*found, *got], deeds)
            return
        refused = "action" in blamed
        slew = self.rules.slew
        self._decided = judging.HIGHEST if slew is None else min(self._levels.high + slew, judging.HIGHEST)
        change = any(deed.slot == "change" and deed.behaviour.verdict == "either" for deed in deeds)
        parts = [part for part in blamed if part in ("student", "selector", "amplifier")]
        self._lawful = (self._lawful and self.rules.law == "additive" and not change) if parts else not change
        self._levels, breaches = judging.judge_levels(
            self.rules, got, self._levels, self._lawful or refused, refused or written
        )
        if written or self.rules.kit.grain:  # what was written may be less, or no level at all
            self._levels = self._levels._replace(low=0)
        found += [*judging.judge(self.rules, said, got), *breaches, *self._answered(deeds, blamed, own)]
        self._tally.hits["gate: passed as it was written"] += written and not own
        if not written:
            found += judging.judge_heading(self.rules, said, got)
        self._note(found, deeds)
        self._tally.clean += not blamed
        self._tally.amplified += got.travelled > 0
        self._received = imprint(received)
        self._given = (None, imprint(None)) if own else (received, self._received)

    def _count(self) -> None:
        """Count the decision that is over, and how it went on."""
        turn = self.loop.engine.last
        if turn is not None and turn is not self._counted:
            count_turn(self._tally.hits, turn)
            self._counted = turn

    def _answered(self, deeds: Sequence[Deed], blamed: Sequence[str], own: bool) -> list[Breach]:
        """What is refused is an incident of the part that did it, and the controller's own object leaves."""
        found = []
        hidden = "number" if any(deed.slot == "whole" for deed in deeds) else ""  # another command took its place
        harmless = {hidden, "number"}  # a number may misbehave where it is only looked at; what left was measured
        refused = [deed for deed in deeds if deed.behaviour.verdict == "refused" and deed.slot not in harmless]
        if refused and not any(part in BLAMES[deed.slot] for part in blamed for deed in refused):
            found.append(Breach("incident", f"went unnoticed (blamed: {', '.join(blamed) or 'nobody'})"))
        if blamed and not deeds and not (blamed == ["action"] and self.rules.kit.grain):
            found.append(Breach("false alarm", f"{', '.join(blamed)} blamed for nothing: {self._last_incident()}"))
        if "action" in blamed and not own:
            found.append(Breach("fallback", "an action was refused, and another than the controller's own left"))
        failed = any(deed.slot in PROPAGATION and deed.behaviour.verdict == "refused" for deed in deeds)
        if failed and self.rules.slew is None and not own:
            found.append(Breach("fallback", "a part failed, and another than the controller's own left"))
        return found

    def _last_incident(self) -> str:
        return str(list(self.loop.engine.incidents)[-1:])

    def _blamed(self) -> list[str]:
        """Return which parts were blamed since this was asked last."""
        now = Counter(self.loop.engine.incident_counts)
        fresh, self._counts = now - self._counts, now
        return [part for part, _ in fresh]

    def _note(self, breaches: Sequence[Breach], deeds: Sequence[Deed]) -> None:
        for breach in breaches:
            self._tally.note(breach, deeds, self.rules)

    def _intervene(self) -> None:
        """Now and then say what an owner may say between two decisions."""
        dice = self._random.random()
        if dice < 0.01:
            self.loop.engine.reset()
            self._levels, self._received = Levels(), None
            self._count()
        elif dice < 0.02:
            self.loop.void("an emergency stop")
        elif dice < 0.04 and self.loop.engine.pending is not None:
            self._correct(draw(self._random, self.rules.kit, self.rules.bounds))

    def _correct(self, command: Any) -> None:
        """Say that something else was executed: from then on anything up to what was decided can be meant.

        That is more than was received where the decided command was refused.
        """
        own = self._random.random() < 0.5 and self.controller.said
        self.loop.executed(own.itself if own else command)
        self._levels, self._received = Levels(0, max(self._levels.high, self._decided)), None


def run(
    seed: int | str,
    decisions: int,
    *,
    chosen: Sequence[tuple[str, str]] = OFTEN,
    make_loop: MakeLoop = ts.wrap,
    trial_length: int = 200,
    mischief: float = 0.55,
    progress: Callable[[int], None] = lambda done: None,
    tally: Tally | None = None,
) -> Tally:
    """Run trials until so many decisions were taken, and write into the tally what is seen."""
    random, tally = Random(seed), tally or Tally()
    plot = Plot(random, chosen, BEHAVIOURS)
    plot.done = tally.deeds

    def take() -> None:
        Trial(random, tally, plot, make_loop, mischief).run(trial_length)
        plot.take()

    take_trials(tally, decisions, take, progress)
    return tally
