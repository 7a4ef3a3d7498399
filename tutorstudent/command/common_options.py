"""Options of every command, before its name or behind it: --verbose and --trace."""

from __future__ import annotations

import functools
import inspect
import os
from collections.abc import Callable
from typing import Annotated, Any

import typer

from tutorstudent.core.files.loading import TRACE

VERBOSE = "TUTORSTUDENT_VERBOSE"
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="show tracebacks: of a mistake, of broken plugins")]
Trace = Annotated[bool, typer.Option("--trace", help="tell every call of a plugin's hook on standard error")]


def heed(verbose: bool, trace: bool) -> None:
    """Store the options in the environment, so that worker processes heed them too."""
    for name, wanted in ((VERBOSE, verbose), (TRACE, trace)):
        if wanted:
            os.environ[name] = "1"


def is_verbose() -> bool:
    """Return whether tracebacks are to be shown."""
    return bool(os.environ.get(VERBOSE))


def add_common_options(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that takes these options beside its own."""

    @functools.wraps(command)
    def heed_and_run(*words: Any, verbose: bool, trace: bool, **options: Any) -> None:
        heed(verbose, trace)
        command(*words, **options)

    own = inspect.signature(command, eval_str=True)
    ours = [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=False, annotation=annotation)
        for name, annotation in (("verbose", Verbose), ("trace", Trace))
    ]
    # Typer reads the options of a command from its signature.
    vars(heed_and_run)["__signature__"] = own.replace(parameters=[*own.parameters.values(), *ours])
    return heed_and_run
