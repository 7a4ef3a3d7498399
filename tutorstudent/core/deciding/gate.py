"""The last gate: what leaves for the owner, read back in the owner's own type, against the controller's own command.

Every limit holds for the action that was rendered. What is written for the owner may lie anywhere between the
controller's own command and that action, both included: then bounds, direction, cap, factor and slew hold for it too.
"""

from __future__ import annotations

import math
from typing import Any

from tutorstudent.core.deciding.guard import Breach
from tutorstudent.core.words.commands import Command
from tutorstudent.core.words.errors import quote
from tutorstudent.core.words.forms import Numbers
from tutorstudent.core.words.snapshots import PLAIN


def check_written(own: Any, meant: Any, written: Any, command: Any) -> Command | None:
    """Return what the owner really gets, where that is something between the controller's own and what was meant.

    Args:
        own: The controller's command as an action.
        meant: The action that was rendered.
        written: What was written for it in the owner's type.
        command: The controller's own command.

    Returns:
        None where it is what was meant, in the precision of the owner's type. The controller's own, where that
        precision is too coarse for the difference.

    Raises:
        Breach: if the owner must not get it.
    """
    form, names = own.form, own.vocabulary.components
    asked, found = [meant.__dict__[name] for name in names], form.read(written)
    if found == asked and type(command) in PLAIN:  # the usual case: a number that nobody can have changed
        return None
    said = [own.__dict__[name] for name in names]
    is_meant = found == form.fit(asked, command)
    if not is_meant:
        _check_between(own, said, asked, found)
    if (elsewhere := form.compare_rest(command, written)) is not None:
        raise Breach("mutated", f"writing the amplified command changed {elsewhere}, which is not declared.")
    if is_meant:
        return own if found == said and asked != said else None
    found_action: Command = type(own).model_validate(dict(zip(names, found, strict=True)))
    return found_action


def _check_between(own: Command, said: Numbers, asked: Numbers, found: Numbers) -> None:
    for spec, mine, meant, number in zip(own.vocabulary.components.values(), said, asked, found, strict=True):
        if not math.isfinite(number):
            raise Breach("not-finite", f"the command that was written says {spec.name} = {number}.")
        if not min(mine, meant) <= number <= max(mine, meant):
            raise Breach(
                "out-of-bounds",
                f"the command that was written says {spec.name} = {quote(number)}; it lies between the controller's "
                f"own {quote(mine)} and {quote(meant)}.",
            )
