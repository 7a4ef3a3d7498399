"""What conditions, evaluator and learner may do wrong while a decision is judged."""

from __future__ import annotations

import numpy as np

from tests.core.oracle.acts import HUGE, NAN, Act, Behaviour, returns
from tests.core.oracle.lies import LyingFloat, LyingInt
from tutorstudent.sims.pioneer.types import DriveAction


def _lesson(**fields: object) -> Act:
    return lambda honest, actions: honest._replace(**fields)


def _target(**fields: object) -> Act:
    return lambda honest, actions: honest._replace(target=honest.target._replace(**fields))


LESSONS: dict[str, Behaviour] = {
    "teaches nothing": Behaviour("either", returns(None)),
    "teaches a plain tuple": Behaviour("refused", lambda h, a: tuple(h)),
    "teaches a level that is NaN": Behaviour("refused", _target(level=NAN)),
    "teaches a negative level": Behaviour("refused", _target(level=-1)),
    "teaches a bit that is 2": Behaviour("refused", _target(ampbit=2)),
    "teaches a numpy level": Behaviour("either", _target(level=np.int64(1))),
    "teaches no target": Behaviour("refused", _lesson(target=None)),
    "teaches a foreign action": Behaviour("refused", _target(action=DriveAction(kind="left", rotation=0.77))),
    "teaches about no moment": Behaviour("refused", _lesson(moment=None)),
    "teaches about another moment": Behaviour(
        "refused", lambda h, a: h._replace(moment=h.moment._replace(number=-7, state="elsewhere"))
    ),
    "teaches a wrong executed level": Behaviour("refused", _lesson(executed_level=HUGE)),
    "teaches a wrong executed action": Behaviour("refused", _lesson(executed="nothing")),
    "teaches a wrong outcome": Behaviour("refused", _lesson(outcome=None)),
}
JUDGES: dict[str, Behaviour] = {
    "answers 2": Behaviour("refused", returns(2)),
    "answers NaN": Behaviour("refused", returns(NAN)),
    "answers with a numpy bool": Behaviour("fine", lambda h, a: np.bool_(h)),
    "answers with an int": Behaviour("fine", lambda h, a: int(h)),
    "answers with a lying int": Behaviour("refused", returns(LyingInt(5))),
}
MEASURES: dict[str, Behaviour] = {
    "measures NaN": Behaviour("refused", returns((1.0, NAN))),
    "measures a lying NaN": Behaviour("refused", returns([LyingFloat("nan")])),
    "measures a number alone": Behaviour("refused", returns(1.0)),
    "measures words": Behaviour("refused", returns(["far"])),
    "measures with numpy": Behaviour("fine", lambda h, a: np.array(h)),
    "does not measure": Behaviour("fine", returns(None)),
}
LEARNS: dict[str, Behaviour] = {"returns something": Behaviour("fine", returns(3))}
