"""What is wrong with a text that is not YAML, in a sentence that helps."""

from __future__ import annotations

from typing import NamedTuple

from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.reader import ReaderError


class Remedy(NamedTuple):
    """What a message of the parser means to somebody who wrote the file."""

    said: str
    """Stands in the parser's context or problem."""
    at_context: bool
    """Whether the mistake is where the parser began, not where it gave up."""
    sentence: str


REMEDIES = (
    Remedy("character '\\t'", False, "there is a tab here; indent with spaces."),
    Remedy("unexpected end of stream", True, "the quote that opens here is never closed."),
    Remedy("while parsing a flow sequence", True, "the '[' that opens here is not closed, or a comma is missing{end}."),
    Remedy("while parsing a flow mapping", True, "the '{{' that opens here is not closed, or a comma is missing{end}."),
    Remedy("could not find expected ':'", True, "a ':' with a space after it is missing here."),
    Remedy(
        "mapping values are not allowed",
        False,
        "a ':' is not expected here; check the indentation, look for a missing ':' in the line above, or quote the "
        "value.",
    ),
    Remedy("expected <block end>", False, "this is not indented like what it belongs to{begin}."),
    Remedy("undefined alias", False, "{problem}; quote a value that begins with '*'."),
    Remedy("cannot start any token", False, "{problem}; quote the value."),
    Remedy("unknown escape character", False, "{problem}; write the value in single quotes."),
    Remedy("maximum depth", False, "it is nested too deeply; write it flat."),
    Remedy("expected a single document", False, "another document begins here; a file holds one. Remove the '---'."),
)
GENERAL = Remedy("", False, "{problem}.")


def syntax_problem(name: str, text: str, error: YAMLError) -> str:
    """Return ``file:line:column: sentence`` for an error of the parser about a text."""
    if isinstance(error, ReaderError):
        return f"{name}:{position(text, error.position)}: not valid YAML: {_character(error)} Remove it."
    if not isinstance(error, MarkedYAMLError) or error.problem_mark is None:
        return f"{name}: not valid YAML: {_line(str(error))}."
    said = f"{error.context} {error.problem}"
    remedy = next((remedy for remedy in REMEDIES if remedy.said in said), GENERAL)
    end, begin = error.problem_mark, error.context_mark or error.problem_mark
    mark = begin if remedy.at_context else end
    sentence = remedy.sentence.format(
        problem=_line(str(error.problem)),
        end=f" before line {end.line + 1}" if end.line > begin.line else "",
        begin=f", which begins in line {begin.line + 1}" if begin.line < end.line else "",
    )
    return f"{name}:{mark.line + 1}:{mark.column + 1}: not valid YAML: {sentence}"


def position(text: str, index: int) -> str:
    r"""Return ``line:column``, counted from 1, of a character of a text.

    >>> position("a: 1\nb: 2", 8)
    '2:4'
    """
    before = text[:index]
    return f"{before.count(chr(10)) + 1}:{index - before.rfind(chr(10))}"


def _character(error: ReaderError) -> str:
    code = ord(error.character) if isinstance(error.character, str) else error.character
    return f"the character #x{code:04x} is not allowed."


def _line(text: str) -> str:
    return " ".join(text.split()).rstrip(".")
