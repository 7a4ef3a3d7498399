"""Importing Gymnasium's Box2D environments."""

from __future__ import annotations

import importlib
import warnings
from typing import Any

from tutorstudent_controllers.missing import explain_missing


def load_box2d(module: str, who: str) -> Any:
    """Return a module of `gymnasium.envs.box2d`.

    Box2D's types warn when they are made, and where warnings are errors the interpreter dies of it; so they may not.

    Raises:
        PipelineError: Something that it needs is not installed.
    """
    with warnings.catch_warnings(), explain_missing(who, "gymnasium[box2d]"):
        warnings.filterwarnings("ignore", "builtin type", DeprecationWarning)
        return importlib.import_module(f"gymnasium.envs.box2d.{module}")
