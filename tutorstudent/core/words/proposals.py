"""What a student may say. Two types, never one with optional fields.

Levels and bits travel towards the robot, so they are really validated; numpy integers and booleans are taken, floats
and strings are not.
"""

from __future__ import annotations

import math
import operator
from typing import Annotated, Any, TypeVar

import numpy as np
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field


def exact_level(value: Any) -> int:
    """Return `value` as a plain int; anything that is not an integer raises TypeError.

    >>> exact_level(3), exact_level(True)
    (3, 1)
    """
    return value if type(value) is int else int.__add__(operator.index(value), 0)


def exact_number(value: Any) -> float:
    """Return `value` as a plain float; what is no number (a string, say) raises TypeError.

    >>> exact_number(np.float32(0.5)), exact_number(1)
    (0.5, 1.0)
    """
    return math.ldexp(value, 0)  # unlike float(), it reads no strings


def exact_bit(value: Any) -> bool:
    """Return a bit as a plain bool; only 0 and 1 (of any integer or boolean type) are bits.

    >>> exact_bit(1), exact_bit(False)
    (True, False)
    """
    if value is True or value is False:
        return value
    number = int(value) if isinstance(value, np.bool_) else exact_level(value)
    if number not in (0, 1):
        raise ValueError(f"a bit is 0 or 1, not {number}")
    return number == 1


def _level_for_pydantic(value: Any) -> Any:
    try:
        return exact_level(value)
    except TypeError:
        return value


def _bit_for_pydantic(value: Any) -> Any:
    try:
        return exact_bit(value)
    except TypeError:
        return value


Level = Annotated[int, BeforeValidator(_level_for_pydantic), Field(ge=0)]
Bit = Annotated[bool, BeforeValidator(_bit_for_pydantic)]


class LevelProposal(BaseModel):
    """An amplification level for whatever the tutor chose (Thesis 5.2.1).

    >>> LevelProposal(level=2, ampbit=True)
    LevelProposal(level=2, ampbit=True)
    """

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid")

    level: Level
    ampbit: Bit


class KindProposal(BaseModel):
    """An action kind with its level and ampbit (Thesis 3.3.2). The kind is None where a code names no kind.

    >>> KindProposal(kind="forward", level=2, ampbit=True).kind
    'forward'
    """

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid")

    kind: str | None
    level: Level
    ampbit: Bit


Proposal = KindProposal | LevelProposal
ProposalT = TypeVar("ProposalT", bound=Proposal)
