"""What has to fit before anything moves."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from tutorstudent.core.deciding.checking import copy_checked
from tutorstudent.core.roles.interfaces import ActionSelector, Student, Tutor
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, list_names, quote

HELD = (bool, int, float, str, bytes, type(None), None, Decimal, Fraction)
"""Types whose values nobody can change."""


def check_vocabulary(tutor: Tutor[Any, Any]) -> None:
    """Refuse a tutor whose actions have nothing to amplify.

    Raises:
        ContractError: if they have not.
    """
    if getattr(tutor, "action", None) is None:
        raise ContractError(
            f"tutor '{tutor.name}': it has no 'action'; name the class of actions that it returns, as in "
            "action = ts.scalar(-1, 1).",
            slot="tutor",
        )
    vocabulary = tutor.action.vocabulary
    if not any(vocabulary.groups.values()):
        raise ContractError(
            f"tutor '{tutor.name}': the action class {tutor.action.__name__} has nothing to amplify; "
            f"its components are {list_names(vocabulary.components)}. Name at least one in its 'amplification'.",
            slot="tutor",
        )


def check_held(action: type[Action]) -> None:
    """Refuse an action class with a component that parts could change from outside.

    Raises:
        ContractError: if there is one.
    """
    for name, field in action.model_fields.items():
        if not can_be_held(field.annotation):
            raise ContractError(
                f"action class {action.__name__}: the component '{name}' is a {quote(field.annotation)}, which can be "
                "changed after it was checked. Use numbers, texts, enums, literals, or tuples of these.",
                slot="tutor",
            )


def can_be_held(annotation: Any) -> bool:
    """Return whether nobody can change a value of this type.

    >>> can_be_held(float | None), can_be_held(tuple[int, ...]), can_be_held(list[int])
    (True, True, False)
    """
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Literal:
        return True
    if origin is Annotated:
        return can_be_held(inner[0])
    if origin in (Union, UnionType, tuple):
        return all(item is ... or can_be_held(item) for item in inner)
    return annotation in HELD or (isinstance(annotation, type) and issubclass(annotation, Enum))


def check_wiring(student: Student[Any, Any, Any], selector: ActionSelector[Any, Any]) -> None:
    """Refuse a selector that cannot read the student's proposals.

    Raises:
        ContractError: if it cannot.
    """
    if student.proposal is not selector.proposal:
        raise ContractError(
            f"selector '{selector.name}' needs {selector.proposal.__name__} but student '{student.name}' makes "
            f"{student.proposal.__name__}. The selector 'same-kind' reads the codec 'kind-level-ampbit'; "
            "the selector 'modifier' reads 'level-ampbit'.",
            slot="selector",
        )


def check_failure_action(tutor: Tutor[Any, Any], action: Action | None) -> None:
    """Refuse an emergency action that is not of the tutor's class.

    Raises:
        ContractError: if it is not.
    """
    if action is not None and type(action) is not tutor.action:
        raise ContractError(
            f"on_tutor_failure: found {type(action).__name__}; expected the tutor's {tutor.action.__name__}."
        )
    if action is not None:
        copy_checked(action, "on_tutor_failure")


def check_conditions(conditions: Sequence[Condition[Any]]) -> None:
    """Refuse two conditions of one name.

    Raises:
        ContractError: if there are.
    """
    doubled = [name for name, count in Counter(condition.label for condition in conditions).items() if count > 1]
    if doubled:
        raise ContractError(
            f"condition '{doubled[0]}' stands there twice; each condition has a name of its own.",
            slot=f"conditions.{doubled[0]}",
        )
