"""Checks of a part before it is used: its description and its options."""

from __future__ import annotations

import json
from typing import Any

from pydantic import BaseModel

from tutorstudent.checks.outcome import CheckFailed, CheckSkipped, describe_error, expect
from tutorstudent.checks.usage import Usage
from tutorstudent.core.files.plainvalues import make_plain
from tutorstudent.core.roles.part_options import read_part_role
from tutorstudent.core.words.errors import PipelineError, TutorStudentError, list_names


def is_described(usage: Usage) -> None:
    """The class has a docstring of its own: its first line is what `plugins list` shows."""
    cls = usage.subject.cls
    expect(
        bool((cls.__doc__ or "").strip()),
        "the class has a docstring",
        "there is none",
        f'write one sentence under "class {cls.__name__}:"; `plugins list` shows it',
    )


def options_are_described(usage: Usage) -> None:
    """Every option has a description: it is the reference and the schema of an editor."""
    bare = sorted(_find_bare(usage.subject.cls.Options))
    expect(
        not bare,
        "every option has a description",
        f"none for {list_names(bare)}",
        "write ts.Field(..., description='what it means, with its unit')",
    )


def constructs_with_defaults(usage: Usage) -> None:
    """Without any option the part can be made; skipped where an option is required."""
    cls = usage.subject.cls
    required = [name for name, field in cls.Options.model_fields.items() if field.is_required()]
    if required:
        raise CheckSkipped(f"options without a default: {list_names(required)}")
    try:
        cls()
    except Exception as error:
        raise CheckFailed(
            f"{cls.__name__}() can be made without any option",
            describe_error(error),
            "give every option a default that is valid, or none; leave __init__ as it is and use setup()",
        ) from error


def refuses_unknown_options(usage: Usage) -> None:
    """An option that is misspelt is an error, not ignored."""
    cls, given = usage.subject.cls, _copy_given(usage)
    try:
        cls(**given, no_such_option=1)
    except TutorStudentError:
        return
    except Exception as error:
        raise CheckFailed(
            "an unknown option is a PipelineError that says which",
            describe_error(error),
            "derive Options from ts.Options and leave __init__ as it is",
        ) from error
    raise CheckFailed(
        "an unknown option is refused",
        f"{cls.__name__}(no_such_option=1) was made",
        "derive Options from ts.Options, which forbids unknown ones, and leave __init__ as it is",
    )


def can_be_written_down(usage: Usage) -> None:
    """A run's pipeline.yaml can name the part with every option, so that the run can be repeated."""
    try:
        json.dumps(make_plain(usage.subject.sample.describe(), "describe()"))
    except (PipelineError, TypeError, ValueError) as error:
        raise CheckFailed(
            "every option is a plain value, a path, an enum or a part",
            describe_error(error),
            "build objects from plain options in setup()",
        ) from error


def _find_bare(model: type[BaseModel], prefix: str = "") -> list[str]:
    found = []
    for name, field in model.model_fields.items():
        if not (field.description or "").strip():
            found.append(prefix + name)
        inner: Any = field.annotation
        if isinstance(inner, type) and issubclass(inner, BaseModel) and read_part_role(inner, field.metadata) is None:
            found += _find_bare(inner, f"{prefix}{name}.")
    return found


def _copy_given(usage: Usage) -> dict[str, Any]:
    # Options that were set, by a new part each: a part stands in one place only.
    options = usage.subject.make().options
    return {name: getattr(options, name) for name in options.model_fields_set}
