"""How parts of each role are used."""

from __future__ import annotations

from tutorstudent.checks.roles.engine import (
    AmplifierUsage,
    EvaluatorUsage,
    SelectorUsage,
    StudentUsage,
    TutorUsage,
)
from tutorstudent.checks.roles.leaves import ChangeUsage, CodecUsage, ConditionUsage, EncoderUsage
from tutorstudent.checks.roles.outside import ObserverUsage, WorldUsage
from tutorstudent.checks.usage import Usage

USAGES: dict[str, type[Usage]] = {
    "tutor": TutorUsage,
    "student": StudentUsage,
    "selector": SelectorUsage,
    "amplifier": AmplifierUsage,
    "evaluator": EvaluatorUsage,
    "world": WorldUsage,
    "encoder": EncoderUsage,
    "codec": CodecUsage,
    "change": ChangeUsage,
    "condition": ConditionUsage,
    "observer": ObserverUsage,
}

__all__ = ["USAGES"]
