"""Every part with everything that it may do, and who is blamed for it."""

from __future__ import annotations

from tests.core.oracle.acts import JUNK, MUTATES, RAISES, Behaviour
from tests.core.oracle.deciding import CHANGES, ENCODES, GRADES, NAMES_KINDS, PROPOSES
from tests.core.oracle.judging import JUDGES, LEARNS, LESSONS, MEASURES

Acts = dict[str, Behaviour]


def _without(*names: str, acts: Acts) -> Acts:
    return {key: value for key, value in acts.items() if key not in names}


PROPAGATION: dict[str, Acts] = {
    "encoder": {**RAISES, **MUTATES, **ENCODES},
    "decode": {**RAISES, **JUNK},
    "student": {**RAISES, **JUNK, **MUTATES, **PROPOSES},
    "kinds": NAMES_KINDS,
    "selector": {**RAISES, **JUNK, **MUTATES, **GRADES},
    "amplifier": {**RAISES, **JUNK, **MUTATES, **GRADES},
    "change": {**RAISES, **JUNK, **CHANGES},
}
EVALUATION: dict[str, Acts] = {
    "condition": {**RAISES, **JUNK, **JUDGES},
    "margins": {**RAISES, **_without("returns a string", "returns None", acts=JUNK), **MEASURES},
    "evaluator": {**RAISES, **_without("returns None", acts=JUNK), **MUTATES, **LESSONS},
    "learner": {**RAISES, **MUTATES, **LEARNS},
    "encode": {**RAISES, **MUTATES},
}
BLAMED: dict[str, tuple[str, ...]] = {
    "encoder": ("student",),
    "decode": ("student",),
    "student": ("student", "selector"),  # a forged proposal is found where it is read
    "kinds": ("student", "selector"),
    "selector": ("selector",),
    "amplifier": ("amplifier",),
    "change": ("amplifier",),
    "condition": ("conditions.flag",),
    "margins": ("conditions.flag",),
    "evaluator": ("evaluator",),
    "learner": ("student",),
    "encode": ("student",),
}
EVERYTHING = [(slot, name) for table in (PROPAGATION, EVALUATION) for slot, acts in table.items() for name in acts]
