"""What a student may say. Two types, never one with optional fields.

Levels and bits decide what the robot does, so they are validated: numpy integers and booleans are taken, floats
and strings are not.
"""

from __future__ import annotations

import math
import operator
from typing import Annotated, Any, TypeVar

import numpy as np
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field


def require_level(value: Any) -> int:
    """Return `value` as a plain int; anything that is not an integer raises TypeError.

    >>> require_level(3), require_level(True)
    (3, 1)
    """
    return value if type(value) is int else int.__add__(operator.index(value), 0)


def require_number(value: Any) -> float:
    """Return `value` as a plain float; what is no number (a string, say) raises TypeError.

    >>> require_number(np.float32(0.5)), require_number(1)
    (0.5, 1.0)
    """
    return math.ldexp(value, 0)  # unlike float(), it reads no strings


def require_bit(value: Any) -> bool:
    """Return a bit as a plain bool; only 0 and 1 (of any integer or boolean type) are bits.

    >>> require_bit(1), require_bit(False)
    (True, False)
    """
    if value is True or value is False:
        return value
    number = int(value) if isinstance(value, np.bool_) else require_level(value)
    if number not in (0, 1):
        raise ValueError(f"a bit is 0 or 1, not {number}")
    return number == 1


def _validate_level(value: Any) -> Any:
    try:
        return require_level(value)
    except TypeError:
        return value


def _validate_bit(value: Any) -> Any:
    try:
        return require_bit(value)
    except TypeError:
        return value


Level = Annotated[int, BeforeValidator(_validate_level), Field(ge=0)]
Bit = Annotated[bool, BeforeValidator(_validate_bit)]


class LevelProposal(BaseModel):
    """An amplification level for whatever the tutor chose (Thesis 5.2.1).

    >>> LevelProposal(level=2, ampbit=True)
    LevelProposal(level=2, ampbit=True)
    """

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid")

    level: Level
    ampbit: Bit


class KindProposal(BaseModel):
    """An action kind with its level and ampbit (Thesis 3.3.2). The kind is None where the student's output names none.

    >>> KindProposal(kind="forward", level=2, ampbit=True).kind
    'forward'
    """

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid")

    kind: str | None
    level: Level
    ampbit: Bit


Proposal = KindProposal | LevelProposal
ProposalT = TypeVar("ProposalT", bound=Proposal)
