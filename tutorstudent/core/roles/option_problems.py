"""What is wrong with the options of a part, in sentences."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel, ValidationError

from tutorstudent.core.words.errors import list_names, quote, suggest

KEY = "[key]"
"""What pydantic puts behind a key that is wrong itself."""


def find_option_problems(model: type[BaseModel], error: ValidationError) -> list[tuple[tuple[int | str, ...], str]]:
    """Return (location, sentence) for every mistake in a pydantic error, unknown options first.

    A missing option is usually a misspelt one.
    """
    found: list[Any] = list(error.errors(include_url=False))
    fitting = [item for item in found if not (item["loc"] and _is_label(item["loc"][-1]))]
    items = sorted(fitting or found, key=lambda item: item["type"] != "extra_forbidden")
    for item in items:
        item["loc"] = tuple(key for key in item["loc"] if key != KEY and not _is_label(key))
    return [(item["loc"], _describe_problem(model, item)) for item in items]


def _is_label(key: int | str) -> bool:
    # Where an option takes several forms, pydantic puts the form between the keys, as in ``list[float]``.
    return isinstance(key, str) and "[" in key and key != KEY


def refuse_truth(annotation: Any, value: Any) -> None:
    """Refuse true and false where a number is expected; Python would read them as 1 and 0.

    Raises:
        ValueError: if there is one.
    """
    wanted = set(_find_leaves(annotation))
    if wanted & {int, float} and bool not in wanted and Any not in wanted and _holds_truth(value):
        raise ValueError("input should be a number, not true or false")


def _find_leaves(annotation: Any) -> Iterator[Any]:
    inner = get_args(annotation)
    if get_origin(annotation) is Literal:
        yield from map(type, inner)
    elif inner:
        yield from (leaf for arg in inner for leaf in _find_leaves(arg))
    elif annotation is Any or isinstance(annotation, type):
        yield annotation


def _holds_truth(value: Any) -> bool:
    items = value.values() if isinstance(value, Mapping) else value if isinstance(value, list | tuple) else ()
    return isinstance(value, bool) or any(map(_holds_truth, items))


def _describe_problem(model: type[BaseModel], item: Any) -> str:
    *above, last = item["loc"] or ("",)
    path = ".".join(str(key) for key in item["loc"])
    match item["type"]:
        case "extra_forbidden":
            return _describe_unknown(model, item["loc"], path)
        case "missing" if isinstance(last, int):
            return f"option '{'.'.join(map(str, above))}': it has too few values, found {quote(item['input'])}."
        case "missing":
            return f"option '{path}' is required."
        case "is_instance_of":
            kind = item["ctx"]["class"]
            return f"option '{path}' must be a part ({kind}), not {item['input']!r}; in Python give an instance."
        case "value_error":
            said = str(item["ctx"]["error"]).rstrip(".")
            return f"option '{path}': {said}, found {quote(item['input'])}." if path else f"{said}."
    return f"option '{path}': {_describe_expected(item)}, found {quote(item['input'])}{_suggest_choice(item)}."


def _describe_unknown(model: type[BaseModel], location: tuple[int | str, ...], path: str) -> str:
    holder = _find_holder(model, [key for key in location if isinstance(key, str)])
    known = holder.model_fields if holder else {}
    allowed = f" Options: {list_names(known)}." if holder else ""
    return f"unknown option '{path}'{suggest(str(location[-1]), known)}.{allowed}"


def _describe_expected(item: Any) -> str:
    said = str(item["msg"]).partition(", unable to parse")[0]
    return f"{said[0].lower()}{said[1:]}"


def _suggest_choice(item: Any) -> str:
    expected = item.get("ctx", {}).get("expected", "")
    return suggest(item["input"], re.findall(r"'([^']+)'", expected)) if isinstance(item["input"], str) else ""


def _find_holder(model: type[BaseModel], path: list[str]) -> type[BaseModel] | None:
    # The model in which the last key stands; None where the way there leads through something else.
    if len(path) == 1:
        return model
    inner = model.model_fields[path[0]].annotation if path[0] in model.model_fields else None
    nested = [item for item in (inner, *get_args(inner)) if isinstance(item, type) and issubclass(item, BaseModel)]
    return _find_holder(nested[0], path[1:]) if len(nested) == 1 else None
