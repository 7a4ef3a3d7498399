"""What an owner's command types may do wrong while an amplified command is written."""

from __future__ import annotations

from typing import Any

from tests.core.oracle.acts import HUGE, INF, NAN, RAISES, Behaviour, returns
from tests.core.oracle.lies import Fatal, LyingFloat, Touchy
from tests.core.oracle.plot import Plot

NUMBERS: dict[str, Behaviour] = {
    **RAISES,
    "becomes NaN": Behaviour("refused", returns(NAN)),
    "becomes infinite": Behaviour("refused", returns(INF)),
    "becomes huge": Behaviour("refused", returns(float(HUGE) ** 3)),
    "becomes a word": Behaviour("refused", returns("9999")),
    "becomes nothing": Behaviour("refused", returns(None)),
    "becomes what cannot be looked at": Behaviour("refused", returns(Touchy())),
    "becomes a lying NaN": Behaviour("refused", returns(LyingFloat("nan"))),
    "becomes a lying huge number": Behaviour("refused", returns(LyingFloat(1e30))),
    "becomes true": Behaviour("either", returns(True)),
    "becomes complex": Behaviour("refused", returns(1j)),
    "doubles": Behaviour("either", lambda h, a: h * 2),
    "halves": Behaviour("either", lambda h, a: h / 2),
    "turns round": Behaviour("either", lambda h, a: -h),
    "is a little more": Behaviour("either", lambda h, a: h * 1.0000001),
    "is a little less": Behaviour("either", lambda h, a: h * 0.9999999),
    "is cut to tenths": Behaviour("either", lambda h, a: int(h * 10) / 10),
    "is rounded": Behaviour("either", lambda h, a: round(float(h), 1)),
}
"""One of the numbers that are written."""


WHOLES: dict[str, Behaviour] = {
    **RAISES,
    "is a word": Behaviour("refused", returns("word")),
    "is nothing": Behaviour("refused", returns(None)),
    "is what cannot be looked at": Behaviour("refused", returns(Touchy())),
    "is the controller's own": Behaviour("either", lambda h, a: a[0].own),
    "is the controller's own, changed": Behaviour("either", lambda h, a: a[0].change_own(h)),
    "is right, with the controller's own changed": Behaviour("either", lambda h, a: [a[0].change_own(h), h][1]),
    "spoils something else of the controller's own": Behaviour("either", lambda h, a: a[0].forget(a[0].own) and h),
    "raises after the controller's own was changed": Behaviour("refused", lambda h, a: _fail(a[0].change_own(h))),
    "forgets what is not declared": Behaviour("either", lambda h, a: a[0].forget(h)),
    "is of another type": Behaviour("either", lambda h, a: a[0].retype(h)),
}
"""The whole command that is written; what stands at `actions[0]` knows the controller's own."""

OWN_CHANGED = [name for name in WHOLES if "controller's own" in name]


def _fail(_: Any) -> Any:
    raise Fatal("too late")


ACTS = {"number": NUMBERS, "whole": WHOLES}
SPOILS: dict[str, Behaviour] = {
    "empties the state": Behaviour("either", lambda h, a: _empty(a[0])),
    "writes into the state": Behaviour("either", lambda h, a: _write(a[0])),
    "writes into an array of the state": Behaviour("either", lambda h, a: a[0]["scan"].__setitem__(0, 77.0)),
    "sorts a list of the state": Behaviour("either", lambda h, a: a[0]["trace"].append(7) or a[0]["trace"].clear()),
    "changes an object in the state": Behaviour("either", lambda h, a: setattr(a[0]["robot"], "hot", "spoilt")),
}
"""What a part may do to the state that it is shown."""


def _empty(state: Any) -> None:
    state.clear()


def _write(state: Any) -> None:
    state["number"] = -1
    state["robot"] = None


class Hand:
    """What the owner's types ask before they write; it is awake only while the engine writes.

    It `works` once a command was written without it: types that cannot be written at all are refused at once.
    """

    def __init__(self) -> None:
        self.plot: Plot | None = None
        self.works = self.awake = False
        self.whole_view: Any = None

    def number(self, value: Any) -> Any:
        """Return a number as it is written."""
        return self.plot.twist("number", lambda: value) if self.awake and self.plot else value

    def whole(self, made: Any) -> Any:
        """Return a command as it is written."""
        if self.awake and self.plot:
            return self.plot.twist("whole", lambda: made, [self.whole_view])
        return made


HAND = Hand()
