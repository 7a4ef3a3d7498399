"""What can go wrong, as a tree.

    TutorStudentError
    |-- PluginError            a plugin is missing, doubled or broken
    |   |-- UnknownPlugin
    |   |-- DuplicatePlugin
    |   `-- BrokenPlugin
    |-- PipelineError          a pipeline, an option or a scene cannot be built as it is written
    `-- ContractError          a part breaks the contract of its role
        `-- UnreadableState    a part is wired to a state that it cannot read

Every message says what was found, where, what is allowed and what to do.
"""

from __future__ import annotations

import difflib
import reprlib
from collections.abc import Iterable


class TutorStudentError(Exception):
    """Base of every error that this package raises on purpose.

    Args:
        message: What was found, where, what is allowed and what to do.
        slot: The slot of the part to blame, as in ``student.encoder``, if there is one.
    """

    def __init__(self, message: str = "", slot: str = "") -> None:
        super().__init__(message)
        self.slot = slot
        self.placed = False
        """Whether the message begins with a position in a file."""


class PluginError(TutorStudentError):
    """A plugin is missing, doubled or broken."""


class UnknownPlugin(PluginError):
    """No plugin of that role has that name."""


class DuplicatePlugin(PluginError):
    """Two plugins of one role have the same name."""


class BrokenPlugin(PluginError):
    """A plugin could not be loaded; the reason is in the message."""


class PipelineError(TutorStudentError):
    """A pipeline, an option or a scene cannot be built as it is written."""


class ContractError(TutorStudentError):
    """A part breaks the contract of its role."""


class UnreadableState(ContractError):
    """A part is wired to a state that it cannot read.

    In an engine's first decision it goes through to the owner, who can mend the wiring; later it is an incident like
    any other.
    """


class TutorStudentWarning(UserWarning):
    """A learner has no effect; the message says why and what to do."""


def suggest(word: str, known: Iterable[str]) -> str:
    """Return `` (did you mean 'x'?)``, or nothing when no known word is near.

    >>> suggest("hiden", ["hidden", "momentum"])
    " (did you mean 'hidden'?)"
    >>> suggest("qqq", ["hidden"])
    ''
    """
    by_letters = {name.lower(): name for name in known}
    near = [by_letters[name] for name in difflib.get_close_matches(word.lower(), list(by_letters), n=1)]
    return f" (did you mean '{near[0]}'?)" if near else ""


def list_names(words: Iterable[str]) -> str:
    """Return the words sorted and joined by commas, or ``none``.

    >>> list_names(["b", "a"]), list_names([])
    ('a, b', 'none')
    """
    return ", ".join(sorted(words)) or "none"


def quote(value: object) -> str:
    """Return a value for a message: as YAML writes it, on one line, shortened.

    >>> quote(None), quote(True), quote("x"), quote([1, [2, 3]])
    ('nothing', 'true', "'x'", '[1, [2, 3]]')
    """
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return str(value).lower()
    brief = reprlib.Repr()
    brief.maxstring = brief.maxother = brief.maxlong = 60
    text = brief.repr(value)
    return text if len(text) <= 100 else f"{text[:97]}..."


_read_name = type.__dict__["__name__"].__get__
"""Reads the name of a class, whatever its metaclass says."""


def say_error(error: BaseException) -> str:
    r"""Return what an exception is and says, as one line that ends a sentence; however it behaves when it is asked.

    >>> say_error(ValueError("no\nroom.")), say_error(KeyError())
    ('ValueError: no room.', 'KeyError.')
    """
    name = _read_name(type(error))
    try:
        said = " ".join(str(error).split()).rstrip(".")
    except KeyboardInterrupt:
        raise
    except BaseException:
        said = "its message cannot be read"
    return f"{name}: {said}." if said else f"{name}."


def with_article(word: str) -> str:
    """Return a word with its article.

    >>> with_article("tutor"), with_article("encoder")
    ('a tutor', 'an encoder')
    """
    return f"{'an' if word[:1] in tuple('aeiou') else 'a'} {word}"
