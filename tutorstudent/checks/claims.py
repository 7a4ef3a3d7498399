"""The states and actions that a part is made for, as its class's type arguments say."""

from __future__ import annotations

import inspect
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

from tutorstudent.core.files.registry import ROLES
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.records import Moment, StateT


def find_state_claim(cls: type[Component]) -> Any:
    """Return the class of states that a part is made for.

    A TypeVar means that any will do, None that it is not known.

    >>> from tutorstudent.core.roles.interfaces import Tutor
    >>> class Pid(Tutor[float, Any]): ...
    >>> find_state_claim(Pid)
    <class 'float'>
    """
    return _find_claims(cls).get(StateT)


def find_action_claim(cls: type[Component]) -> Any:
    """Return the class of actions that a part is made for, as `find_state_claim` does for states."""
    return _find_claims(cls).get(ActionT)


def _find_claims(cls: type[Component]) -> dict[Any, Any]:
    function = vars(cls).get("__wrapped__")
    if function is not None:
        return _find_claims_of_function(function.__func__)
    role: Any = ROLES[cls.role]
    parameters = getattr(role, "__parameters__", ())
    return dict(zip(parameters, _find_arguments(cls, role), strict=False))


def _find_arguments(cls: type[Any], role: type[Any]) -> tuple[Any, ...]:
    for base in cls.__dict__.get("__orig_bases__", cls.__bases__):
        origin = get_origin(base) or base
        if origin is role:
            return get_args(base)
        if isinstance(origin, type) and issubclass(origin, role):
            given = dict(zip(getattr(origin, "__parameters__", ()), get_args(base), strict=False))
            return tuple([_substitute(given, argument) for argument in _find_arguments(origin, role)])
    return ()


def _substitute(given: dict[Any, Any], argument: Any) -> Any:
    return given.get(argument, argument) if isinstance(argument, TypeVar) else argument


def _find_claims_of_function(function: Any) -> dict[Any, Any]:
    # A leaf that a decorator made: what its function says of the first thing that it is given.
    try:
        hints = get_type_hints(function)
    except (NameError, TypeError):
        return {}
    hint = hints.get(next(iter(inspect.signature(function).parameters), ""))
    if get_origin(hint) is Moment:
        return dict(zip((StateT, ActionT), get_args(hint), strict=True))
    return {} if hint is None else {StateT: hint}
