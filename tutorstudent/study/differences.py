"""Says in words how two plans differ."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

SHOWN = 5


def differences(there: Any, asked: Any) -> str:
    """Return where two nested values differ, the first few; lists of things with a name are compared by name.

    Args:
        there: What stands in the folder.
        asked: What is asked for now.

    >>> differences({"seeds": [0, 1], "decisions": 60}, {"seeds": [0, 1], "decisions": 30})
    'decisions: 60 there, 30 now'
    """
    found = list(_walk(there, asked, ""))
    more = f"; and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    return "; ".join(found[:SHOWN]) + more


def _walk(there: Any, asked: Any, at: str) -> Iterator[str]:
    there, asked = _by_name(there), _by_name(asked)
    if not (isinstance(there, dict) and isinstance(asked, dict)):
        if there != asked:
            yield f"{at}: {_short(there)} there, {_short(asked)} now"
        return
    for key in there | asked:
        place = f"{at}.{key}" if at else str(key)
        if key not in asked:
            yield f"{place}: only there"
        elif key not in there:
            yield f"{place}: only now"
        else:
            yield from _walk(there[key], asked[key], place)


def _by_name(value: Any) -> Any:
    if isinstance(value, list) and value and all(isinstance(item, dict) and "name" in item for item in value):
        return {item["name"]: item for item in value}
    return value


def _short(value: Any) -> str:
    text = json.dumps(value, default=str)
    return text if len(text) <= 60 else f"{text[:57]}..."
