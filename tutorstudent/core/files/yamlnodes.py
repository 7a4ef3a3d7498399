"""From the nodes of a YAML file to plain values with their places. No tags, no objects, no duplicate keys."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode
from ruamel.yaml.reader import ReaderError

from tutorstudent.core.words.errors import PipelineError

Key = int | str
Location = tuple[Key, ...]
DEEPEST = 50
MOST = 100_000
"""Values of one file, those that aliases repeat included."""
LONGEST_NUMBER = 1000
"""Digits of a whole number; reading more takes time that grows with their square."""
STANDARD = "tag:yaml.org,2002:"
_LEADING_ZERO = re.compile(r"[-+]?0[0-9_]+")


class Place(NamedTuple):
    """A line and a column, counted from 1."""

    line: int
    column: int
    file: str = ""
    """Only if it is another file than the document's own: one that it extends."""


class NodeReader:
    """Reads the nodes of one document."""

    def __init__(self, name: str) -> None:
        self.places: dict[Location, Place] = {}
        self._name = name
        self._count = 0

    def read_value(self, node: Node, at: Location = ()) -> Any:
        """Return the value of a node, and note the places of everything in it.

        Raises:
            PipelineError: if it is not plain; the message says where and what to do.
        """
        self._check_bounds(node, at)
        tag = str(node.tag).replace(STANDARD, "!!")
        if isinstance(node, MappingNode) and tag == "!!map":
            return self._read_mapping(node, at)
        if isinstance(node, SequenceNode) and tag == "!!seq":
            return [self._read_at(item, item, (*at, i)) for i, item in enumerate(node.value)]
        if isinstance(node, ScalarNode) and tag in _SCALARS:
            return self._read_scalar(node, tag, at)
        raise self._make_error(node, at, f"the tag '{tag}' is not allowed; write plain YAML without tags.")

    def _check_bounds(self, node: Node, at: Location) -> None:
        self._count += 1
        if len(at) > DEEPEST:
            raise self._make_error(node, at[:3], "it is nested too deeply, or contains itself; make it flatter.")
        if self._count > MOST:
            problem = f"there are more than {MOST:,} values, counting repeated ones; shorten it."
            raise self._make_error_at(self.places.get(at[:1], Place(1, 1)), at[:1], problem)

    def _read_at(self, marked: Node, node: Node, at: Location) -> Any:
        self.places[at] = _find_place(marked)
        return self.read_value(node, at)

    def _read_mapping(self, node: MappingNode, at: Location) -> dict[str, Any]:
        values: dict[str, Any] = {}
        own: set[str] = set()
        for merged in reversed(list(self._find_merged(node, at))):
            self._check_bounds(merged, at)
            values |= self._read_mapping(merged, at)
        for key_node, value_node in node.value:
            if not _is_merge(key_node):
                key = self._read_key(key_node, at)
                if key in own:
                    line = self.places[*at, key].line
                    raise self._make_error(key_node, (*at, key), f"this key is in line {line} too; keep one of them.")
                own.add(key)
                values[key] = self._read_at(key_node, value_node, (*at, key))
        return values

    def _find_merged(self, node: MappingNode, at: Location) -> Iterator[MappingNode]:
        """Yield the mappings that ``<<`` names, the strongest first."""
        for _, value in filter(lambda pair: _is_merge(pair[0]), node.value):
            for item in value.value if isinstance(value, SequenceNode) else [value]:
                if not isinstance(item, MappingNode):
                    raise self._make_error(item, at, "'<<' merges mappings; name one by its alias, as in <<: *name.")
                yield item

    def _read_key(self, node: Node, at: Location) -> str:
        if isinstance(node, ScalarNode) and str(node.tag) == f"{STANDARD}str":
            return str(node.value)
        found = node.value if isinstance(node, ScalarNode) else "in brackets"
        raise self._make_error(node, at, f"the key {found} is not a word; quote it.")

    def _read_scalar(self, node: ScalarNode, tag: str, at: Location) -> Any:
        try:
            return _SCALARS[tag](node.value)
        except (KeyError, ValueError) as error:
            reason = f": {error}" if isinstance(error, _Ambiguous) else " that can be read"
            raise self._make_error(node, at, f"'{_shorten(node.value)}' is no {tag.strip('!')}{reason}.") from None

    def _make_error(self, node: Node, at: Location, problem: str) -> PipelineError:
        return self._make_error_at(_find_place(node), at, problem)

    def _make_error_at(self, place: Place, at: Location, problem: str) -> PipelineError:
        dotted = ".".join(str(key) for key in at)
        where = f"{self._name}:{place.line}:{place.column}"
        return PipelineError(f"{where}: {dotted}: {problem}" if dotted else f"{where}: {problem}")


class _Ambiguous(ValueError):
    """A number that other YAML readers read differently."""


def _find_place(node: Node) -> Place:
    return Place(node.start_mark.line + 1, node.start_mark.column + 1)


def _is_merge(key: Node) -> bool:
    return str(key.tag) == f"{STANDARD}merge"


def _shorten(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:37]}..."


def _read_int(text: str) -> int:
    if len(text) > LONGEST_NUMBER:
        raise _Ambiguous(f"with {len(text):,} digits; {LONGEST_NUMBER} are allowed")
    if _LEADING_ZERO.fullmatch(text):
        plain = text.lstrip("+-0") or "0"
        raise _Ambiguous(f"with a leading zero some read it as octal; write {plain}, or 0o{plain} if that is meant")
    return int(text, 0)


def _read_float(text: str) -> float:
    return float(text.lower().replace(".inf", "inf").replace(".nan", "nan"))


_SCALARS: Mapping[str, Callable[[str], Any]] = {
    "!!null": lambda _: None,
    "!!bool": lambda text: {"true": True, "false": False}[text.lower()],
    "!!int": _read_int,
    "!!float": _read_float,
    "!!str": str,
    "!!timestamp": str,
    "!!value": str,
    "!!merge": str,
}
"""How the scalars of a tag are read. Dates stay words."""


class Remedy(NamedTuple):
    """What a message of the parser means for the author of the file."""

    said: str
    """Part of the parser's context or problem."""
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
        "a ':' is not expected here; is this line indented further than the line above? Check the indentation, look "
        "for a missing ':' in the line above, or quote the value.",
    ),
    Remedy("expected <block end>", False, "this is not indented like what it belongs to{begin}."),
    Remedy("undefined alias", False, "{problem}; quote a value that begins with '*'."),
    Remedy("cannot start any token", False, "{problem}; quote the value."),
    Remedy("unknown escape character", False, "{problem}; write the value in single quotes."),
    Remedy("maximum depth", False, "it is nested too deeply; make it flatter."),
    Remedy("expected a single document", False, "another document begins here; a file holds one. Remove the '---'."),
)
GENERAL = Remedy("", False, "{problem}.")


def explain_syntax(name: str, text: str, error: YAMLError) -> str:
    """Return ``file:line:column: sentence`` for an error of the parser about a text."""
    if isinstance(error, ReaderError):
        return f"{name}:{count_position(text, error.position)}: not valid YAML: {_describe_character(error)} Remove it."
    if not isinstance(error, MarkedYAMLError) or error.problem_mark is None:
        return f"{name}: not valid YAML: {_join_lines(str(error))}."
    said = f"{error.context} {error.problem}"
    remedy = next((remedy for remedy in REMEDIES if remedy.said in said), GENERAL)
    end, begin = error.problem_mark, error.context_mark or error.problem_mark
    mark = begin if remedy.at_context else end
    sentence = remedy.sentence.format(
        problem=_join_lines(str(error.problem)),
        end=f" before line {end.line + 1}" if end.line > begin.line else "",
        begin=f", which begins in line {begin.line + 1}" if begin.line < end.line else "",
    )
    return f"{name}:{mark.line + 1}:{mark.column + 1}: not valid YAML: {sentence}"


def count_position(text: str, index: int) -> str:
    r"""Return ``line:column``, counted from 1, of a character of a text.

    >>> count_position("a: 1\nb: 2", 8)
    '2:4'
    """
    before = text[:index]
    return f"{before.count(chr(10)) + 1}:{index - before.rfind(chr(10))}"


def _describe_character(error: ReaderError) -> str:
    code = ord(error.character) if isinstance(error.character, str) else error.character
    return f"the character #x{code:04x} is not allowed."


def _join_lines(text: str) -> str:
    return " ".join(text.split()).rstrip(".")
