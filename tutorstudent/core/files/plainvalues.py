"""Descriptions of parts as plain values that a file can hold."""

from __future__ import annotations

from typing import Any

import numpy as np
from pydantic_core import to_jsonable_python

from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.errors import PipelineError


def make_plain(value: Any, where: str) -> Any:
    """Return a description as values for YAML and JSON: paths and enums as text, tuples as lists.

    Raises:
        PipelineError: if it holds something else; `where` says in the message what it describes.
    """
    try:
        return to_jsonable_python(value, fallback=_convert_leftover)
    except (TypeError, ValueError) as error:
        raise PipelineError(f"{where}: cannot be written into a file: {error}") from None


def _convert_leftover(value: Any) -> Any:
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    if isinstance(value, Component):
        return value.describe()
    raise TypeError(f"an option holds a {type(value).__name__}; options are plain values, paths, enums or parts.")
