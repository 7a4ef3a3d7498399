"""``KEY=VALUE``: another value for one dotted key of a pipeline."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.words.errors import PipelineError


def split_setting(option: str, text: str) -> tuple[str, str]:
    """Return key and value of ``KEY=VALUE``, the value as written.

    Args:
        option: Where it was given, for messages.
        text: What was given.

    Raises:
        PipelineError: if it is not of that form.
    """
    key, equals, value = text.partition("=")
    if not equals or not all(word.strip() for word in key.split(".")):
        raise PipelineError(f"{option} {text}: write key=value, as in {option} world.scene=cave-box.")
    return key.strip(), value


def read_key_value(option: str, text: str) -> tuple[str, Any]:
    """Return the key and the value of ``KEY=VALUE``; the value is YAML.

    >>> read_key_value("--set", "student.hidden=10")
    ('student.hidden', 10)
    """
    key, value = split_setting(option, text)
    return key, parse_yaml(value, f"{option} {text}").data


def read_settings(option: str, texts: Sequence[str]) -> dict[str, Any]:
    """Return several as a mapping.

    >>> read_settings("--set", ["student.hidden=10", "conditions=[bumped]"])
    {'student.hidden': 10, 'conditions': ['bumped']}
    """
    return dict(read_key_value(option, text) for text in texts)


def format_setting(key: str, value: Any) -> str:
    """Return ``key=value`` for messages, shortened where it is long.

    >>> format_setting("student.hidden", 10), format_setting("limits", {"cap": None})
    ('student.hidden=10', 'limits={"cap": null}')
    """
    text = value if isinstance(value, str) else json.dumps(value, default=str)
    return f"{key}={text}" if len(text) <= 40 else f"{key}={text[:37]}..."


def set_value(data: dict[str, Any], dotted: str, value: Any, name: str) -> None:
    """Set the value of a dotted key in `data`; nested mappings are copied, not changed.

    Raises:
        PipelineError: if the key leads through something other than a mapping; `name` is what messages call the data.
    """
    *parents, last = dotted.split(".")
    for key in parents:
        below = data.get(key, {})
        if isinstance(below, str):
            below = {} if key == "on_tutor_failure" else {"use": below}
        if not isinstance(below, dict):
            raise PipelineError(f"{name}: {dotted}: '{key}' is {below!r}, not a mapping; set '{key}' itself.")
        data[key] = dict(below)
        data = data[key]
    data[last] = value
