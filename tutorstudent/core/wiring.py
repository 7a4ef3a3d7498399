"""What has to fit before anything moves."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.actions import Action
from tutorstudent.core.errors import ContractError, listing
from tutorstudent.core.interfaces import ActionSelector, Student, Tutor


def check_wiring(tutor: Tutor[Any, Any], student: Student[Any, Any, Any], selector: ActionSelector[Any, Any]) -> None:
    """Refuse parts that do not fit together.

    Raises:
        ContractError: if nothing can be amplified, or the selector cannot read the student's proposals.
    """
    vocabulary = tutor.action.vocabulary
    if not any(vocabulary.groups.values()):
        raise ContractError(
            f"tutor '{tutor.name}': the action class {tutor.action.__name__} has nothing to amplify; "
            f"its components are {listing(vocabulary.components)}. Name at least one in its 'amplification'."
        )
    if student.proposal is not selector.proposal:
        raise ContractError(
            f"selector '{selector.name}' needs {selector.proposal.__name__} but student '{student.name}' makes "
            f"{student.proposal.__name__}. The selector 'same-kind' reads the codec 'kind-level-ampbit'; "
            "the selector 'modifier' reads 'level-ampbit'."
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
