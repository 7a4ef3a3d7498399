"""Broken engines, each broken in one way: the judge has to name what is wrong with every one of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tests.core.oracle.shapes import SHAPES, Shape
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.records import GradedAction
from tutorstudent.core.words.turn import FOOT


def _shape(action: Action) -> Shape:
    return next(shape for shape in SHAPES if shape.action is type(action))


def _with(action: Any, **values: Any) -> Any:
    """Return an action with other values, as nobody should make one: without validation."""
    spoilt = type(action)(**action.__dict__)
    spoilt.__dict__.update(values)
    return spoilt


def _clipped(shape: Shape, name: str, value: float) -> float:
    low, high = shape.bounds[name]
    return min(max(value, low), high)


class Executing(Engine[Any, Any, Any]):
    """Executes something else than the engine decided."""

    spoil: Callable[[Any], Any]

    def propagate(self, state: Any) -> Any:
        action = super().propagate(state)
        return type(self).spoil(action) if _shape(action).arms[action.kind] else action


def executing(spoil: Callable[[Any], Any]) -> type[Executing]:
    """Return an engine that executes what `spoil` makes of the action."""
    return type("Spoilt", (Executing,), {"spoil": staticmethod(spoil)})


def _move(factor: float) -> Callable[[Any], Any]:
    """Return what moves the first arm by so many times its scale along its direction."""

    def spoil(action: Any) -> Any:
        shape = _shape(action)
        arm = shape.arms[action.kind][0]
        moves = {}
        for name, neutral in zip(arm.names, arm.neutral, strict=True):
            offset = getattr(action, name) - neutral
            sign = {"+": 1.0, "-": -1.0}.get(arm.direction, (offset > 0) - (offset < 0))
            moves[name] = _clipped(shape, name, getattr(action, name) + sign * factor * arm.scale)
        return _with(action, **moves)

    return spoil


def _turn(action: Any) -> Any:
    names = _shape(action).arms[action.kind][0].names
    if len(names) == 1:
        return action
    return _with(
        action, **dict(zip(names, (getattr(action, name) * 0.4 for name in names[1:] + names[:1]), strict=True))
    )


def _other_component(action: Any) -> Any:
    moved = {name for arm in _shape(action).arms[action.kind] for name in arm.names}
    others = [name for name in _shape(action).bounds if name not in moved]
    return _with(action, **{name: _clipped(_shape(action), name, getattr(action, name) + 0.1) for name in others})


def _other_kind(action: Any) -> Any:
    return _with(action, kind=next((k for k in _shape(action).kinds if k != action.kind), "another"))


def _first(value: float) -> Callable[[Any], Any]:
    return lambda action: _with(action, **{_shape(action).arms[action.kind][0].names[0]: value})


def _other_class(action: Any) -> Any:
    return type("Impostor", (type(action),), {})(**action.__dict__)


class Unlimited(Engine[Any, Any, Any]):
    """Forgets one of the limits."""

    forgets: dict[str, Any]

    def __init__(self, *, limits: Limits, **parts: Any) -> None:
        super().__init__(limits=Limits(**{**limits.model_dump(), **self.forgets}), **parts)


def forgetting(**limits: Any) -> type[Unlimited]:
    """Return an engine with other limits than its owner wrote."""
    return type("Forgetful", (Unlimited,), {"forgets": limits})


class Mute(Engine[Any, Any, Any]):
    """Keeps silent about incidents."""

    def __init__(self, **parts: Any) -> None:
        super().__init__(**parts)
        self._guard.record = lambda *args: None  # type: ignore[method-assign]


class Paranoid(Engine[Any, Any, Any]):
    """Blames the student for nothing."""

    def propagate(self, state: Any) -> Any:
        action = super().propagate(state)
        self._guard.record("student", ValueError("I do not trust it"))
        return action


class Stubborn(Engine[Any, Any, Any]):
    """Does not fall back to the tutor's own action."""

    def __init__(self, **parts: Any) -> None:
        super().__init__(**parts)
        self._cycle._grader.fall_back = self._go_on  # type: ignore[method-assign]

    def _go_on(self, turn: Any) -> None:
        turn._selected = turn._resulting = GradedAction(_with(turn._original), 1, True)
        turn._rung, turn._limited_by = FOOT, ""


class Nagging(Engine[Any, Any, Any]):
    """Asks the tutor twice."""

    def propagate(self, state: Any) -> Any:
        self.tutor.act(state)
        return super().propagate(state)


class Fragile(Engine[Any, Any, Any]):
    """Lets a part's exceptions through."""

    def __init__(self, **parts: Any) -> None:
        super().__init__(**parts, on_incident="raise")


class Modest(Engine[Any, Any, Any]):
    """Records one level less than it executes."""

    def propagate(self, state: Any) -> Any:
        action = super().propagate(state)
        decision = self._cycle.turn._decision
        if decision.resulting.level > 0:
            graded = decision.resulting._replace(level=decision.resulting.level - 1)
            self._cycle.turn._decision = decision._replace(resulting=graded)
        return action


class Forger(Engine[Any, Any, Any]):
    """Writes down something else than what was executed."""

    def propagate(self, state: Any) -> Any:
        action = super().propagate(state)
        turn, forged = self._cycle.turn, _with(action, **{next(iter(_shape(action).bounds)): 0.7071})
        turn._action, turn._decision = forged, turn._decision._replace(executed=forged)
        return action


class Raising(Engine[Any, Any, Any]):
    """Teaches one level more than the evaluator's table says."""

    def evaluate(self, resulting_state: Any) -> Any:
        turn = self._cycle.turn
        if turn is None:
            return super().evaluate(resulting_state)
        honest = turn._decision
        turn._decision = honest._replace(resulting=honest.resulting._replace(level=honest.resulting.level + 1))
        super().evaluate(resulting_state)
        turn._decision = turn._decision._replace(resulting=honest.resulting)
        return turn


class Cheerful(Engine[Any, Any, Any]):
    """Overlooks violations."""

    def evaluate(self, resulting_state: Any) -> Any:
        turn: Any = super().evaluate(resulting_state)
        if turn is not None:
            turn._outcome = turn.outcome._replace(violated=())
        return turn


class Late(Engine[Any, Any, Any]):
    """Teaches the resulting state instead of the previous one."""

    def evaluate(self, resulting_state: Any) -> Any:
        turn: Any = self._cycle.turn
        if turn is None:
            return super().evaluate(resulting_state)
        before = turn._decision.moment
        turn._decision = turn._decision._replace(moment=before._replace(state=resulting_state))
        super().evaluate(resulting_state)
        turn._decision = turn._decision._replace(moment=before)
        return turn


BROKEN: dict[str, tuple[type[Engine[Any, Any, Any]], str]] = {
    "executes one level more than it records": (executing(_move(0.1)), "shown"),
    "executes one level less than it records": (Modest, "shown"),
    "flips the direction": (executing(_move(-0.1)), "direction"),
    "turns a vector": (executing(_turn), "direction"),
    "goes to the end of the range": (executing(_move(100.0)), "cap"),
    "forgets the cap": (forgetting(cap=50.0), "cap"),
    "forgets the factor": (forgetting(factor=None), "factor"),
    "forgets the slew": (forgetting(slew=None), "slew"),
    "executes another kind": (executing(_other_kind), "kind"),
    "executes another class": (executing(_other_class), "class"),
    "touches another component": (executing(_other_component), "untouched"),
    "executes NaN": (executing(_first(float("nan"))), "finite"),
    "executes a number out of bounds": (executing(_first(1e3)), "bounds"),
    "executes a copy of the tutor's action": (executing(_with), "own object"),
    "keeps silent about incidents": (Mute, "incident"),
    "blames a part for nothing": (Paranoid, "false alarm"),
    "does not fall back": (Stubborn, "fallback"),
    "asks the tutor twice": (Nagging, "asked"),
    "lets exceptions through": (Fragile, "loop"),
    "writes down another action": (Forger, "record"),
    "teaches one level more": (Raising, "lesson"),
    "teaches the resulting state": (Late, "lesson"),
    "overlooks violations": (Cheerful, "violated"),
}
