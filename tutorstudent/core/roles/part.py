"""The base of everything that a pipeline names: options, life cycle, random stream, learned state."""

from __future__ import annotations

import abc
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from typing import Any, ClassVar

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, ValidationInfo, field_validator

from tutorstudent.core.roles.binding import Binding, make_stream
from tutorstudent.core.roles.option_problems import find_option_problems, refuse_truth
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import (
    ContractError,
    PipelineError,
    TutorStudentError,
    list_names,
    say_error,
    suggest,
)
from tutorstudent.core.words.turn import Turn

Learned = Mapping[str, Any]
"""What was learned: arrays, numbers, strings, and mappings of these."""


class Options(BaseModel):
    """The options of a part. Unknown ones are refused; give each field a description and a unit."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, validate_default=True)

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        super().__pydantic_init_subclass__(**kwargs)
        for name, field in cls.model_fields.items():
            if isinstance(field.default, Component):
                raise ContractError(
                    f"{cls.__qualname__}.{name}: the default is one part, shared by all; "
                    f"use Field(default_factory={type(field.default).__name__})."
                )

    @field_validator("*", mode="before")
    @classmethod
    def _refuse_truth(cls, value: Any, info: ValidationInfo) -> Any:
        refuse_truth(cls.model_fields[str(info.field_name)].annotation, value)
        return value


# A plugin is a part, and a component is a number of an action; only this class and the hook `tutorstudent_components`,
# which plugins depend on, keep the old word. See docs/decisions/0007-a-plugin-is-a-part.md.
class Component(abc.ABC):
    """Something with a name and options that a pipeline can use.

    What to do when:

    * ``__init__(**options)``: nothing; the base stores the validated options in ``self.options``
    * ``setup()``: once, when ``self.rng``, ``self.slot`` and ``self.action_class`` are known: allocate, open
    * ``reset()``: between trials: forget the trial, keep what was learned
    * ``judged(turn)``: hear what became of a decision (parts of an engine; optional)
    * ``state_dict()`` / ``load_state_dict()``: hand out and take back what was learned; never pickle
    * ``close()``: once, at the end
    """

    role: ClassVar[str] = ""
    name: ClassVar[str] = ""

    Options: ClassVar[type[BaseModel]] = Options

    rng: np.random.Generator
    slot: str = ""
    action_class: type[Action]

    def __init__(self, **options: Any) -> None:
        try:
            self.options: Any = self.Options(**options)
        except ValidationError as error:
            raise PipelineError(explain_option_error(type(self), error)) from None

    def bind(self, binding: Binding) -> None:
        """Tell the part its slot. Called once by whoever builds the pipeline; nested parts come first."""
        if not hasattr(self, "options"):
            raise ContractError(
                f"{self.role} '{self.name}': its own __init__ does not call super().__init__(**options); call that "
                "first, or leave __init__ out and prepare in setup()."
            )
        if self.slot:
            raise ContractError(
                f"{self.role} '{self.name}' is already at '{self.slot}' of a pipeline; make one for each slot."
            )
        self.slot = binding.slot
        self.action_class = binding.action
        self.rng = make_stream(binding.seed, binding.slot)
        for key, part in self.parts():
            part.bind(binding._replace(slot=f"{binding.slot}.{key}"))
        try:
            self.setup()
        except TutorStudentError as error:
            error.slot = binding.slot
            raise
        except (Exception, SystemExit) as error:
            said = f"{self.role} '{self.name}': setup() raised {say_error(error)}"
            raise PipelineError(said, binding.slot) from error

    def parts(self) -> Iterator[tuple[str, Component]]:
        """Yield the nested parts, each with the option that holds it."""
        for key in type(self.options).model_fields:
            value = getattr(self.options, key)
            if isinstance(value, Component):
                yield key, value
            elif isinstance(value, list | tuple):
                yield from ((f"{key}.{i}", item) for i, item in enumerate(value) if isinstance(item, Component))

    def setup(self) -> None:  # noqa: B027 - an optional hook, deliberately concrete
        """Prepare for work. Random generator, slot and action class are known."""

    def close(self) -> None:
        """Release what `setup` opened."""
        with ExitStack() as stack:  # whatever one of them raises, all are closed
            for _, part in reversed(list(self.parts())):
                stack.callback(part.close)

    def state_dict(self) -> Learned:
        """Return what was learned: arrays and plain values, by name."""
        return {key: state for key, part in self.parts() if (state := part.state_dict())}

    def load_state_dict(self, state: Learned) -> None:
        """Take back what `state_dict` returned."""
        nested = dict(self.parts())
        for key, value in state.items():
            if key not in nested:
                raise ContractError(
                    f"{self.role} '{self.name}' learned nothing named '{key}'{suggest(key, nested)}; "
                    f"it takes {list_names(nested)}."
                )
            nested[key].load_state_dict(value)

    def examples(self) -> Sequence[Any]:
        """Return states for the conformance checks to try the part with; called on a bound copy.

        Not needed where the part's state class has a class method `examples`.
        """
        return ()

    def describe(self) -> dict[str, Any]:
        """Return the part as a pipeline would name it: ``use`` and every option, defaults included."""
        return {"use": self.name} | {
            key: _describe_value(getattr(self.options, key)) for key in type(self.options).model_fields
        }

    def __repr__(self) -> str:
        given = ", ".join(f"{key}={getattr(self.options, key)!r}" for key in sorted(self.options.model_fields_set))
        return f"{type(self).__name__}({given})"


class EnginePart(Component):
    """A part of the engine: it is reset between trials."""

    def reset(self) -> None:
        """Forget the trial, keep what was learned."""
        with ExitStack() as stack:  # whatever one of them raises, all are reset
            for _, part in reversed(list(self.parts())):
                if isinstance(part, EnginePart):
                    stack.callback(part.reset)

    def judged(self, turn: Turn[Any, Any]) -> None:
        """Hear what became of a decision: after it was judged and taught, or when it was dropped.

        A part that does not override it is never called. The turn is for reading.
        """


def find_listeners(parts: Iterable[tuple[str, Component]]) -> Iterator[tuple[str, EnginePart]]:
    """Yield every part that listens to `EnginePart.judged`, nested ones too, with its slot."""
    for slot, part in parts:
        if isinstance(part, EnginePart) and type(part).judged is not EnginePart.judged:
            yield slot, part
        yield from find_listeners((f"{slot}.{key}", nested) for key, nested in part.parts())


def _describe_value(value: Any) -> Any:
    if isinstance(value, Component):
        return value.describe()
    if isinstance(value, BaseModel):
        return {key: _describe_value(getattr(value, key)) for key in type(value).model_fields}
    if isinstance(value, list | tuple):
        return [_describe_value(item) for item in value]
    if isinstance(value, Mapping):
        return {key: _describe_value(item) for key, item in value.items()}
    return value


def explain_option_error(cls: type[Component], error: ValidationError) -> str:
    """Say in one sentence what is wrong with a part's options."""
    return "; ".join(f"{cls.role} '{cls.name}': {problem}" for _, problem in find_option_problems(cls.Options, error))


__all__ = ["Component", "EnginePart", "Field", "Learned", "Options", "explain_option_error"]
