"""What is sound wherever it is said: actions, graded actions, proposals, numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from pydantic import ValidationError

from tutorstudent.checks.outcome import CheckFailed, expect
from tutorstudent.core.deciding.checking import check_graded
from tutorstudent.core.deciding.guard import Breach
from tutorstudent.core.words.actions import Action, rebuild
from tutorstudent.core.words.errors import list_names
from tutorstudent.core.words.proposals import KindProposal, require_number


def expect_action(action: Any, cls: type[Action], what: str) -> None:
    """Check that an action is of the class and within its bounds."""
    expect(
        type(action) is cls,
        f"{what} returns a {cls.__name__}",
        f"{type(action).__name__}: {action!r}",
        f"return {cls.__name__}(...), or declare the class that it returns as 'action'",
    )
    try:
        rebuild(action)
    except (ValidationError, KeyError) as error:
        raise CheckFailed(
            f"the {cls.__name__} that {what} returns is within its bounds",
            f"{action!r}: {str(error).splitlines()[-2].strip() if isinstance(error, ValidationError) else error}",
            "make actions with their constructor, never with model_construct() or by changing one",
        ) from None


def expect_graded(graded: Any, shown: Action, what: str) -> None:
    """Check that a graded action is about the action that was shown, with a level and a bit."""
    try:
        check_graded(graded, shown)
    except (Breach, TypeError, ValueError) as error:
        raise CheckFailed(
            f"{what} returns a GradedAction of the action that it was given, with a level of 0 or more and a bit",
            f"{graded!r}: {error}",
            "return GradedAction(action, level, ampbit) with the action as it came",
        ) from None


def expect_proposal(proposal: Any, declared: Any, cls: type[Action], what: str) -> None:
    """Check that a proposal is of the declared type, validated, and names a kind of the action class or none."""
    expect(
        type(proposal) is declared,
        f"{what} returns a {declared.__name__}, as 'proposal' declares",
        f"{type(proposal).__name__}: {proposal!r}",
        "return the declared type, or declare the one that it returns",
    )
    try:
        declared(**proposal.__dict__)
    except ValidationError as error:
        raise CheckFailed(
            f"the {declared.__name__} is valid",
            f"{proposal!r}: {error.errors(include_url=False)[0]['msg']}",
            "make proposals with their constructor; a level is an integer of 0 or more, an ampbit is a bit",
        ) from None
    if isinstance(proposal, KindProposal):
        kinds = cls.vocabulary.kinds
        expect(
            proposal.kind is None or proposal.kind in kinds,
            f"the kind is one of {list_names(kinds)}, or None",
            f"{proposal.kind!r}",
            "take kinds from self.action_class.vocabulary.kinds; say None where the numbers name no kind",
        )


def expect_vector(vector: Any, width: int, what: str) -> None:
    """Check that a vector has the declared width and holds finite floats."""
    shape = getattr(vector, "shape", None)
    expect(
        isinstance(vector, np.ndarray) and vector.dtype == np.float64 and shape == (width,),
        f"{what} returns a float64 array of the shape ({width},), its width",
        f"{type(vector).__name__} of the shape {shape}, dtype {getattr(vector, 'dtype', None)}",
        "return np.array([...], dtype=np.float64) with as many numbers as 'width' says",
    )
    expect(
        bool(np.isfinite(vector).all()),
        f"{what} returns finite numbers",
        f"{vector}",
        "replace readings that are no numbers before they are used; one NaN in a network's weights stays there",
    )


def expect_number(value: Any, what: str) -> float:
    """Check that something is a finite number, and return it."""
    try:
        number = require_number(value)
    except TypeError:
        number = math.nan
    expect(math.isfinite(number), f"{what} is a finite number", f"{value!r}", "return a float")
    return number


def expect_numbers(values: Any, what: str) -> None:
    """Check that something is a sequence of finite numbers."""
    listed = isinstance(values, Sequence | np.ndarray) and not isinstance(values, str)
    expect(listed, f"{what} are a sequence of numbers", f"{values!r}", "return a list of floats")
    for value in values:
        expect_number(value, f"each of {what}")
