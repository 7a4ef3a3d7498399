"""Imports Gymnasium only when it is needed."""

from __future__ import annotations

import importlib
from typing import Any

from tutorstudent.core.words.errors import PipelineError


def load_gymnasium() -> Any:
    """Return the gymnasium module; PipelineError with the remedy where it is not installed."""
    try:
        return importlib.import_module("gymnasium")
    except ImportError:
        raise PipelineError(
            "world 'gymnasium' needs gymnasium; install it with: pip install 'tutorstudent[gym]'"
        ) from None
