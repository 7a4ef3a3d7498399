"""Which actions a program answers with: a world's own action class, or one written out in the pipeline.

There are no import paths: a pipeline names what is installed, or writes it out.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import create_model

from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.roles.world import World
from tutorstudent.core.words.actions import Action, AmplificationMap, Direction, component, read_vocabulary
from tutorstudent.core.words.errors import PipelineError


class ComponentOptions(Options):
    """One number of an action."""

    low: float | None = Field(None, description="smallest allowed value, in its own unit; none: unbounded")
    high: float | None = Field(None, description="largest allowed value, in its own unit; none: unbounded")
    default: float | None = Field(None, description="value where the program says nothing; none: it has to say one")
    neutral: float = Field(0.0, description="value at which it does nothing; 'outward' moves away from it")
    scale: float | None = Field(None, gt=0, description="what one whole unit of amplification adds; none: from bounds")
    unit: str = Field("", max_length=40, description="physical unit, for people")


class ActionOptions(Options):
    """An action class, written out."""

    kinds: list[str] = Field(["command"], min_length=1, description="what the thesis calls action types")
    components: dict[str, ComponentOptions] = Field(min_length=1, description="the numbers of an action, by name")
    amplified: dict[str, dict[str, Direction]] | None = Field(
        None, description="for each kind, components and their direction; none: all together, outward, in every kind"
    )


def find_action_class(action: ActionOptions | None, action_of: World[Any, Any] | None) -> type[Action]:
    """Return the action class that the options state.

    Raises:
        PipelineError: if they state none or two, or the world has no action class of its own.
        ContractError: if what is written out makes no sense as an action.
    """
    if (action is None) == (action_of is None):
        raise PipelineError(
            f"tutor 'process': found {'neither' if action is None else 'both'} of 'action' and 'action_of'; say which "
            "actions the program commands: either 'action_of: pioneer' (those of a world), or "
            "'action: {components: {value: {low: -1, high: 1}}}'."
        )
    if action is not None:
        return _make_action_class(action)
    assert action_of is not None  # noqa: S101 - one of the two is there
    if not any(action_of.action.vocabulary.groups.values()):
        raise PipelineError(
            f"tutor 'process': action_of: world '{action_of.name}' has no actions of its own, it takes those that fit; "
            "write them out, as in 'action: {components: {value: {low: -1, high: 1}}}'."
        )
    return action_of.action


def _make_action_class(options: ActionOptions) -> type[Action]:
    fields: dict[str, Any] = {name: (float, _make_component(spec)) for name, spec in options.components.items()}
    for name in fields:
        if name == "kind" or name.startswith("_") or not name.isidentifier() or hasattr(Action, name):
            raise PipelineError(
                f"tutor 'process': action: '{name}' cannot name a component; use another word of letters and digits."
            )
    if options.kinds != ["command"]:
        fields["kind"] = (Literal[tuple(options.kinds)], ...)
    made: type[Action] = create_model("ProcessAction", __base__=Action, __module__=__name__, **fields)
    made.amplification = _make_amplification(options)
    made.vocabulary = read_vocabulary(made)
    return made


def _make_component(spec: ComponentOptions) -> Any:
    return component(spec.low, spec.high, default=spec.default, scale=spec.scale, neutral=spec.neutral, unit=spec.unit)


def _make_amplification(options: ActionOptions) -> AmplificationMap:
    if options.amplified is None:
        return {kind: {tuple(options.components): "outward"} for kind in options.kinds}
    return {kind: dict(directions.items()) for kind, directions in options.amplified.items()}
