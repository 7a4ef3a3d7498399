"""How far a command was amplified: what was executed beside what the tutor said."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.rendering import measure_deviation
from tutorstudent.core.words.records import Decision


def measure_ratio(decision: Decision[Any, Any]) -> float | None:
    """Return the executed command's distance from neutral as a multiple of the tutor's own.

    Of a kind with several groups of components it is the largest; None where the tutor's command is at neutral or its
    kind has nothing to amplify.
    """
    said = decision.moment.tutor_action
    own, executed = said.__dict__, decision.executed.__dict__
    sizes = [(group, measure_deviation(group, own)) for group in said.vocabulary.groups[said.kind]]
    return max((measure_deviation(group, executed) / size for group, size in sizes if size > 0), default=None)
