"""Typed actions: what travels towards the robot (Thesis 3.3.1).

An action class states its vocabulary: its kinds (the thesis's action *types*), its bounded components, and for each
kind which components an amplifier may move, and in which direction. The class is the single source of that statement;
core renders amplified actions from it and nothing else.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, ClassVar, Literal, NamedTuple, TypeVar, get_args, get_origin

from pydantic import BaseModel, ConfigDict, Field
from pydantic.fields import FieldInfo

from tutorstudent.core.words.errors import ContractError, list_names, suggest

Direction = Literal["+", "-", "outward"]
AmplificationMap = Mapping[str, Mapping[str | tuple[str, ...], Direction]]


class ComponentSpec(NamedTuple):
    """What one component of an action may be. Unbounded sides are infinite."""

    name: str
    low: float
    high: float
    scale: float
    neutral: float
    unit: str
    number: bool
    """Whether it is declared as a float."""


class Group(NamedTuple):
    """Components that an amplifier moves together; one component in most actions, several in a vector."""

    names: tuple[str, ...]
    direction: Direction
    scale: float
    low: tuple[float, ...]
    high: tuple[float, ...]
    neutral: tuple[float, ...]


class Vocabulary(NamedTuple):
    """The kinds and components of an action class, and what may be amplified for each kind."""

    kinds: tuple[str, ...]
    fields: tuple[str, ...]
    """``kind`` and the components: all that an action holds."""
    components: Mapping[str, ComponentSpec]
    groups: Mapping[str, tuple[Group, ...]]
    read: Callable[[dict[str, Any]], tuple[Any, ...]]
    """Reads what an action holds in the order of `fields`."""


def component(
    low: float | None = None,
    high: float | None = None,
    *,
    default: float | None = None,
    scale: float | None = None,
    neutral: float = 0.0,
    unit: str = "",
    description: str | None = None,
) -> Any:
    """Declare a component of an action.

    Args:
        low: Smallest allowed value, or none.
        high: Largest allowed value, or none.
        default: Value when the tutor says nothing; without one the component is required.
        scale: Size that one whole unit of amplification adds; by default the larger bound's distance from zero.
            An unbounded component that is amplified has to state it.
        neutral: The value at which the component does nothing; ``outward`` amplification moves away from it.
        unit: Physical unit, for people.
        description: One sentence, for people.
    """
    extra = {"component": {"scale": scale, "neutral": neutral, "unit": unit}}
    options: dict[str, Any] = {"json_schema_extra": extra, "description": description}
    if low is not None:
        options["ge"] = low
    if high is not None:
        options["le"] = high
    return Field(**options) if default is None else Field(default, **options)


class Action(BaseModel):
    """A typed, bounded command. Frozen, strict and really validated: NaN, strings and out-of-range values are refused.

    Subclass it, give ``kind`` a ``Literal`` of the kinds (or leave it out where there is one), declare the components
    with `component`, and say in ``amplification`` what an amplifier may move:

    >>> class Turn(Action):
    ...     kind: Literal["left", "right"]
    ...     rotation: float = component(-1.0, 1.0)
    ...     amplification: ClassVar[AmplificationMap] = {"left": {"rotation": "+"}, "right": {"rotation": "-"}}
    >>> Turn(kind="left", rotation=0.4)
    Turn(kind='left', rotation=0.4)

    A key of the inner mapping is a component, or a tuple of components that are scaled together so that their direction
    is kept. A direction is ``+``, ``-`` or ``outward`` (away from neutral, nothing at neutral).
    """

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid", allow_inf_nan=False)

    kind: str = Field("command", pattern="^command$")

    amplification: ClassVar[AmplificationMap] = {}
    vocabulary: ClassVar[Vocabulary] = Vocabulary(
        ("command",), ("kind",), {}, {"command": ()}, lambda values: (values["kind"],)
    )

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        super().__pydantic_init_subclass__(**kwargs)
        cls.vocabulary = read_vocabulary(cls)


ActionT = TypeVar("ActionT", bound=Action)


def rebuild(action: ActionT, changes: dict[str, float] | None = None) -> ActionT:
    """Return a validated copy of an action, with other values for some components.

    Raises:
        ValidationError: pydantic's, if the action or a change is not sound.
    """
    values = action.__dict__
    if len(values) != len(action.vocabulary.fields):  # a subclass may cache properties there
        values = {name: values[name] for name in action.vocabulary.fields}
    return type(action)(**(values | changes if changes else values))


def read_vocabulary(cls: type[Action]) -> Vocabulary:
    """Return the kinds, components and groups that an action class declares; ContractError where they make no sense."""
    kinds = _read_kinds(cls)
    specs = {name: _read_spec(name, info) for name, info in cls.model_fields.items() if name != "kind"}
    unknown = [kind for kind in cls.amplification if kind not in kinds]
    if unknown:
        raise ContractError(
            f"action class {cls.__name__}: amplification names the kind '{unknown[0]}'{suggest(unknown[0], kinds)}; "
            f"its kinds are {list_names(kinds)}."
        )
    groups = {kind: _make_groups(cls, kind, specs) for kind in kinds}
    fields = ("kind", *specs)
    return Vocabulary(kinds, fields, MappingProxyType(specs), MappingProxyType(groups), _make_reader(fields))


def _make_reader(fields: tuple[str, ...]) -> Callable[[dict[str, Any]], tuple[Any, ...]]:
    if len(fields) > 1:
        return operator.itemgetter(*fields)
    return lambda values: (values[fields[0]],)


def _read_kinds(cls: type[Action]) -> tuple[str, ...]:
    annotation = cls.model_fields["kind"].annotation
    if annotation is str:
        return ("command",)
    if get_origin(annotation) is Literal:
        return tuple(str(kind) for kind in get_args(annotation))
    raise ContractError(
        f"action class {cls.__name__}: 'kind' is annotated {annotation!r}; use Literal[...] of the kinds, "
        "or leave it out where there is one."
    )


def _read_spec(name: str, info: FieldInfo) -> ComponentSpec:
    extra: Any = info.json_schema_extra
    declared: dict[str, Any] = extra.get("component", {}) if isinstance(extra, dict) else {}
    low = next((float(m.ge) for m in info.metadata if getattr(m, "ge", None) is not None), -math.inf)
    high = next((float(m.le) for m in info.metadata if getattr(m, "le", None) is not None), math.inf)
    scale = declared.get("scale")
    if scale is None:
        scale = max(abs(low), abs(high))
    return ComponentSpec(
        name,
        low,
        high,
        float(scale),
        float(declared.get("neutral", 0.0)),
        declared.get("unit", ""),
        info.annotation is float,
    )


def _make_groups(cls: type[Action], kind: str, specs: Mapping[str, ComponentSpec]) -> tuple[Group, ...]:
    where = f"action class {cls.__name__}, kind '{kind}'"
    keys = {(key,) if isinstance(key, str) else tuple(key): d for key, d in cls.amplification.get(kind, {}).items()}
    named = [name for names in keys for name in names]
    doubled = [name for name in named if named.count(name) > 1]
    if doubled:
        raise ContractError(f"{where}: the component '{doubled[0]}' is amplified twice; name it once.")
    return tuple(_make_group(where, names, direction, specs) for names, direction in keys.items())


def _make_group(where: str, names: tuple[str, ...], direction: Direction, specs: Mapping[str, ComponentSpec]) -> Group:
    if not names:
        raise ContractError(f"{where}: a vector without components; its components are {list_names(specs)}.")
    for name in names:
        _check_movable(where, name, specs)
    if direction not in get_args(Direction):
        raise ContractError(f"{where}: direction {direction!r} of '{names[0]}'; allowed are '+', '-' and 'outward'.")
    if len(names) > 1 and direction != "outward":
        raise ContractError(f"{where}: a vector {names} keeps its direction; use 'outward', not {direction!r}.")
    chosen = [specs[name] for name in names]
    return Group(
        names,
        direction,
        min(spec.scale for spec in chosen),
        tuple(spec.low for spec in chosen),
        tuple(spec.high for spec in chosen),
        tuple(spec.neutral for spec in chosen),
    )


def _check_movable(where: str, name: str, specs: Mapping[str, ComponentSpec]) -> None:
    if name not in specs:
        raise ContractError(
            f"{where}: amplification names the component '{name}'{suggest(name, specs)}; "
            f"its components are {list_names(specs)}."
        )
    spec = specs[name]
    if not math.isfinite(spec.scale) or spec.scale <= 0:
        raise ContractError(
            f"{where}: the component '{name}' has no finite scale; give it bounds or component(..., scale=...)."
        )
    if not spec.low <= spec.neutral <= spec.high:
        raise ContractError(
            f"{where}: the component '{name}' has the neutral {spec.neutral}; it lies in [{spec.low}, {spec.high}]."
        )
    if not spec.number:
        raise ContractError(f"{where}: the component '{name}' is no float; only numbers are amplified.")
