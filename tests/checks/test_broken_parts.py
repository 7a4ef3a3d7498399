"""Each of these parts breaks one promise; the check of that promise fails, says what was seen, and no other does."""

from __future__ import annotations

import random
import sys
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import pytest

import tutorstudent as ts
from tests.checks.good import (
    Bits,
    Counter,
    Degrees,
    Heat,
    House,
    Judge,
    Linear,
    Memory,
    Raiser,
    Room,
    Stove,
    Taker,
    TooHot,
    room,
)
from tutorstudent.checks import checks_of, run_checks
from tutorstudent.core.roles.part import Component

GLOBAL = np.random.RandomState(1)
UNSOUND = "answers_are_sound"


class Broken(NamedTuple):
    cls: type[Component]
    check: str
    seen: str
    """Stands in what was seen."""


BROKEN: list[Broken] = []


def breaks(check: str, seen: str) -> Any:
    def remember(cls: type[Component]) -> type[Component]:
        BROKEN.append(Broken(cls, check, seen))
        return cls

    return remember


def copied(good: type[Any], name: str = "") -> Any:
    """Return a class with all that a good one has and a docstring of its own."""
    return type(name or good.__name__, (good,), {"__doc__": "Like the good one."})


@breaks("is_described", "there is none")
class Undescribed(Stove):
    pass


@breaks("options_are_described", "none for clearance_m")
class Mute(copied(Stove)):
    """Has an option that nobody explains."""

    class Options(Stove.Options):
        clearance_m: float = 0.5


@breaks("constructs_with_defaults", "option 'power': input should be less than or equal to 1")
class BadDefault(copied(Stove)):
    """Has a default that is not allowed."""

    class Options(Stove.Options):
        power: float = ts.Field(5.0, le=1, description="out of its own bounds")

    def __init__(self, **options: Any) -> None:
        super().__init__(**({"power": 0.5, **options} if sys._getframe(1).f_code.co_name == "<lambda>" else options))


@breaks("refuses_unknown_options", "(no_such_option=1) was made")
class Swallower(copied(Stove)):
    """Takes any option."""

    class Options(ts.Options, extra="ignore"):
        goal_celsius: float = ts.Field(20.0, description="the temperature to reach, degrees Celsius")


@breaks("refuses_unknown_options", "TypeError")
class Picky(copied(Stove)):
    """Has an __init__ of its own."""

    def __init__(self, goal_celsius: float = 20.0) -> None:
        super().__init__(goal_celsius=goal_celsius)


@breaks("can_be_written_down", "an option holds a object")
class Opaque(copied(Stove)):
    """Has an object for an option."""

    class Options(Stove.Options):
        driver: Any = ts.Field(default_factory=object, description="cannot be written into a file")


@breaks("waives_with_reasons", "no_such_check")
class Waiver(copied(Stove)):
    """Waives what there is not."""

    waived_checks = {"no_such_check": "it is tired"}


@breaks("works", "setup() raised RuntimeError: not today., when it was bound (setup)")
class NoSetup(copied(Stove)):
    """Cannot be bound."""

    def setup(self) -> None:
        raise RuntimeError("not today")


@breaks("works", "KeyError: 'sonar', when it was asked question 1")
class NoAct(copied(Stove)):
    """Looks for what is not there."""

    def act(self, state: Room) -> Heat:
        raise KeyError("sonar")


@breaks("works", "SystemExit: 3")
class Quitter(copied(Degrees)):
    """Ends the program."""

    def encode(self, moment: Any) -> Any:
        sys.exit(3)


@breaks("works", "when it was closed")
class Unclosable(copied(House)):
    """Cannot be closed after use."""

    def close(self) -> None:
        if getattr(self, "celsius", 15.0) != 15.0:
            raise OSError("busy")


@breaks(UNSOUND, "str: 'heat'")
class Worded(copied(Stove)):
    """Says a word instead of an action."""

    def act(self, state: Room) -> Any:
        return "heat"


@breaks(UNSOUND, "less than or equal to 1")
class Overheated(copied(Stove)):
    """Goes round the bounds."""

    def act(self, state: Room) -> Any:
        return Heat.model_construct(kind="heat", power=7.0)


@breaks(UNSOUND, "None")
class Situationless(copied(Stove)):
    """Is in no situation at all."""

    situation = None


@breaks(UNSOUND, "'fly'")
class Flier(ts.Student[Room, Heat, ts.KindProposal]):
    """Proposes a kind that there is not."""

    name = "flier"
    proposal = ts.KindProposal

    def propose(self, moment: Any) -> Any:
        return ts.KindProposal(kind="fly", level=0, ampbit=True)

    def teach(self, lesson: Any) -> None:
        pass


@breaks(UNSOUND, "LevelProposal")
class Undeclared(copied(Memory)):
    """Declares another proposal than it makes."""

    proposal = ts.KindProposal


@breaks(UNSOUND, "level=-1")
class Negative(copied(Memory)):
    """Goes below zero."""

    def propose(self, moment: Any) -> Any:
        return ts.LevelProposal.model_construct(level=-1, ampbit=True)


@breaks(UNSOUND, "parts move levels and bits only")
class Usurper(copied(Taker)):
    """Selects an action of its own."""

    def select(self, tutor_action: Any, proposal: Any) -> Any:
        return ts.GradedAction(Heat(kind="heat", power=1.0), proposal.level, True)


@breaks(UNSOUND, "level -2")
class Sinking(copied(Raiser)):
    """Lowers below zero."""

    def amplify(self, selected: Any, decision_number: int) -> Any:
        return selected._replace(level=-2)


@breaks(UNSOUND, "nan")
class Amountless(copied(Raiser)):
    """Has no amount."""

    amount = float("nan")


@breaks(UNSOUND, "True")
class Verdict(copied(Judge)):
    """Answers yes or no."""

    def evaluate(self, decision: Any, outcome: Any) -> Any:
        return True


@breaks(UNSOUND, "of the shape (2,)")
class Narrow(copied(Degrees)):
    """Has fewer numbers than it says."""

    def encode(self, moment: Any) -> Any:
        return np.zeros(2)


@breaks(UNSOUND, "list of the shape None")
class Listed(copied(Degrees)):
    """Returns a list."""

    def encode(self, moment: Any) -> Any:
        return [0.0, 0.0, 0.0]


@breaks(UNSOUND, "[2. 2. 2.]")
class Loud(copied(Bits)):
    """Encodes beyond 1."""

    def encode(self, target: Any) -> Any:
        return np.full(3, 2.0)

    def decode(self, outputs: Any) -> Any:
        return super().decode(outputs)

    waived_checks = {"says_back_what_it_was_told": "another test"}


@breaks(UNSOUND, "= -1.0")
class Backwards(copied(Linear)):
    """Moves the wrong way."""

    def fraction(self, amplification: float, magnitude: float) -> float:
        return -1.0


@breaks(UNSOUND, "violated() returns True or False ''")
class Chatty(copied(TooHot)):
    """Answers with words."""

    def violated(self, state: Any) -> Any:
        return "too hot" if state.celsius > 30 else ""


@breaks(UNSOUND, "the event 'boom'")
class Surprising(copied(House)):
    """Has an event that it never announced."""

    def step(self, action: Any) -> Any:
        return super().step(action)._replace(events={"boom": 1.0})


@breaks(UNSOUND, "'many'")
class Vague(copied(Counter)):
    """Counts in words."""

    def summary(self) -> Any:
        return {"count": "many"}


@breaks(UNSOUND, "the number 'steps'")
class Unannounced(copied(Counter)):
    """Measures what it never declared."""

    def observe(self, turn: Any, step: Any) -> Any:
        super().observe(turn, step)
        return {"steps": 1.0}


@breaks("changes_nothing_it_is_handed", "it changed what it was handed in question 1")
class Scribbler(copied(Degrees)):
    """Writes into the state."""

    def encode(self, moment: Any) -> Any:
        bits = super().encode(moment)
        moment.state.walls[:] += 1.0
        return bits


@breaks("survives_broken_readings", "ValidationError")
class Trusting(copied(Stove)):
    """Computes its command from whatever it reads."""

    def act(self, state: Room) -> Heat:
        return Heat(kind="heat", power=float(np.clip((20 - state.celsius) / 100, 0, 1)))


@breaks("survives_broken_readings", "it works as before")
class Poisoned(copied(Stove)):
    """Keeps a mean, NaN for ever."""

    def reset(self) -> None:
        super().reset()
        self.mean = 0.0

    def act(self, state: Room) -> Heat:
        if not np.isfinite(self.mean):
            raise ValueError("it works as before? no")
        self.mean = 0.9 * self.mean + 0.1 * state.celsius
        return Heat(kind="off") if not np.isfinite(self.mean) else super().act(state)


@breaks("goes_on_after_an_exception", "RuntimeError: still at it")
class Locked(copied(Stove)):
    """Remembers that it is at work, and forgets to forget."""

    busy = False

    def act(self, state: Room) -> Heat:
        if self.busy:
            raise RuntimeError("still at it")
        self.busy = True
        action = super().act(state)
        self.busy = False
        return action


@breaks("resets_twice", "KeyError")
class OneTrial(copied(Stove)):
    """Throws away what was never there."""

    def reset(self) -> None:
        self.asked = 0
        vars(self).setdefault("trials", []).append(1)
        if len(self.trials) > 1:
            raise KeyError("episode")


@breaks("closes_twice", "AttributeError")
class OneEnd(copied(Stove)):
    """Closes what it closed."""

    def setup(self) -> None:
        super().setup()
        self.file: Any = "open"

    def close(self) -> None:
        self.file.upper()
        self.file = None


@breaks("prints_nothing", "'heating")
class Talker(copied(Stove)):
    """Talks while it works."""

    def act(self, state: Room) -> Heat:
        print("heating")
        return super().act(state)


@breaks("same_seed_same_answers", "they differ from answer 3 on")
class Whimsical(copied(Stove)):
    """Draws from what all instances share."""

    def act(self, state: Room) -> Heat:
        return Heat(kind="heat", power=float(GLOBAL.random()) if state.celsius == 19.0 else 0.1)


@breaks("has_its_own_random_numbers", "the generator here.dice is the same in two slots")
class Dicer(copied(Stove)):
    """Has dice of its own."""

    def setup(self) -> None:
        super().setup()
        self.dice = np.random.default_rng(0)

    def act(self, state: Room) -> Heat:
        return Heat(kind="heat", power=float(self.dice.random()))


@breaks("has_its_own_random_numbers", "the same in two slots")
class Reseeded(copied(Memory)):
    """Replaces the generator that it was given."""

    def setup(self) -> None:
        super().setup()
        self.rng = np.random.default_rng(1)


@breaks("leaves_global_random_numbers_alone", "a global generator changed")
class Seeder(copied(Stove)):
    """Seeds everybody's generator."""

    def reset(self) -> None:
        super().reset()
        random.seed(7)


@breaks("learned_state_is_plain", "objects at mind")
class Pickler(copied(Memory)):
    """Hands out an object."""

    def state_dict(self) -> Mapping[str, Any]:
        return {"levels": self.levels.copy(), "mind": object()}

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        super().load_state_dict({key: value for key, value in state.items() if key != "mind"})


@breaks("learned_state_is_a_copy", "changed when the part was used again")
class Live(copied(Memory)):
    """Hands out its own array, and goes on writing into it."""

    def state_dict(self) -> Mapping[str, Any]:
        return {"levels": self.levels}

    def teach(self, lesson: Any) -> None:
        super().teach(lesson)
        self.levels[99] += 1


@breaks("remembers_through_a_file", "answers differ")
class Forgetful(copied(Memory)):
    """Takes back nothing."""

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        super().load_state_dict(state)
        self.levels[:] = 0


@breaks("remembers_through_a_file", "ValueError: no list")
class Particular(copied(Memory)):
    """Takes back lists, which a file does not give."""

    def state_dict(self) -> Mapping[str, Any]:
        return {"levels": self.levels.tolist()}

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        super().load_state_dict(state)
        if not isinstance(state["levels"], list):
            raise ValueError("no list")


@breaks("refuses_foreign_learned_state", "was taken")
class Gullible(copied(Memory)):
    """Takes anything."""

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        self.levels = np.array(state.get("levels", self.levels))


@breaks("refuses_foreign_learned_state", "KeyError")
class Terse(copied(Memory)):
    """Takes nothing else, and does not say so."""

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        self.levels = np.array(state["levels"])


@breaks("keeps_what_it_learned_over_trials", "state_dict() changed")
class ShortLived(copied(Memory)):
    """Forgets with every trial."""

    def reset(self) -> None:
        super().reset()
        self.levels = np.zeros(100, dtype=np.int64)

    waived_checks = {"remembers_through_a_file": "nothing is left to compare"}


@breaks("hands_out_what_it_learned", "state_dict() is empty")
class Secretive(copied(Memory)):
    """Learns, and hands out nothing."""

    def state_dict(self) -> Mapping[str, Any]:
        return {}

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        raise ts.ContractError("without argung")


@breaks("margins_agree_with_the_condition", "violated: True, least margin 5.0")
class Reversed(copied(TooHot)):
    """Counts margins the other way."""

    def margins(self, state: Any) -> list[float]:
        return [abs(30 - state.celsius)]


@breaks("says_back_what_it_was_told", "says [0, True] [0, False]")
class Bitless(copied(Bits)):
    """Forgets the ampbit."""

    def encode(self, target: Any) -> Any:
        return super().encode(target._replace(ampbit=False))


@breaks("grows_with_the_amplification", "fraction(0.8, 0.0) = ")
class Swinging(copied(Linear)):
    """Goes up and down."""

    def fraction(self, amplification: float, magnitude: float) -> float:
        return float(abs(np.sin(2 * amplification)))


@breaks("same_seed_same_trial", "they differ")
class Ageing(copied(House)):
    """Never cools down between trials."""

    warmth = 0.0

    def reset(self, seed: int) -> Room:
        super().reset(seed)
        self.warmth += 1.0
        self.celsius += self.warmth
        return self.sense()


@breaks("states_stay_as_they_were", "state 0 changed later")
class Reusing(copied(House)):
    """Measures into the same buffer."""

    def reset(self, seed: int) -> Room:
        self.buffer = np.zeros(3)
        return super().reset(seed)

    def sense(self) -> Room:
        self.buffer.setflags(write=True)
        self.buffer[:] = self.celsius
        self.buffer.setflags(write=False)
        return Room(self.celsius, self.buffer)

    waived_checks = {"same_seed_same_answers": "the answers change afterwards", "same_seed_same_trial": "so they do"}


@breaks("states_stay_as_they_were", "13 writable arrays")
class Writable(copied(House)):
    """Hands out arrays that anybody can change."""

    def sense(self) -> Room:
        return room(self.celsius)


@breaks("draws_itself_with_finite_numbers", "[nan]")
class Scrawl(copied(House)):
    """Draws what has no place."""

    def sketch(self) -> ts.Sketch:
        return ts.Sketch(poses=[(0.0, float("nan"), 0.0, "red")])


@pytest.mark.parametrize("broken", BROKEN, ids=lambda item: f"{item.cls.__name__}-{item.check}")
def test_the_check_of_the_broken_promise_fails_and_no_other(broken: Broken) -> None:
    part = broken.cls if broken.check != "constructs_with_defaults" else (lambda: broken.cls())
    report = run_checks(checks_of(part))
    assert [broken.check] == [result.check for result in report.of("failed")]
    (failure,) = report.of("failed")
    assert broken.seen in f"{failure.expected} {failure.seen}"
    assert failure.remedy


def test_every_check_that_can_fail_has_a_part_that_fails_it() -> None:
    every = {check.name for cls in (Stove, Memory, House, Bits, Linear, TooHot) for check in checks_of(cls())}
    elsewhere = {"same_answers_in_another_process", "says_how_long_it_takes"}
    assert every - elsewhere == {broken.check for broken in BROKEN}
