"""What can go wrong, as a tree.

    TutorStudentError
    |-- PluginError            a plugin is missing, doubled or broken
    |   |-- UnknownPlugin
    |   |-- DuplicatePlugin
    |   `-- BrokenPlugin
    |-- PipelineError          a pipeline, an option or a scene says something that cannot be built
    `-- ContractError          a part does not keep the contract of its role

Every message says what was found, where, what is allowed and what to do.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class TutorStudentError(Exception):
    """Base of every error that this package raises on purpose."""

    slot: str = ""
    """The slot of the part that was being set up, where that is what failed."""
    placed: bool = False
    """Whether the message begins with the place in a file."""


class PluginError(TutorStudentError):
    """A plugin is missing, doubled or broken."""


class UnknownPlugin(PluginError):
    """No plugin of that role has that name."""


class DuplicatePlugin(PluginError):
    """Two plugins of one role have the same name."""


class BrokenPlugin(PluginError):
    """A plugin could not be loaded; the reason is in the message."""


class PipelineError(TutorStudentError):
    """A pipeline, an option or a scene says something that cannot be built."""


class ContractError(TutorStudentError):
    """A part does not keep the contract of its role."""


def suggestion(word: str, known: Iterable[str]) -> str:
    """Return `` (did you mean 'x'?)``, or nothing when no known word is near.

    >>> suggestion("hiden", ["hidden", "momentum"])
    " (did you mean 'hidden'?)"
    >>> suggestion("qqq", ["hidden"])
    ''
    """
    near = difflib.get_close_matches(word, list(known), n=1)
    return f" (did you mean '{near[0]}'?)" if near else ""


def listing(words: Iterable[str]) -> str:
    """Return the words sorted and joined by commas, or ``none``.

    >>> listing(["b", "a"]), listing([])
    ('a, b', 'none')
    """
    return ", ".join(sorted(words)) or "none"
