"""A stop that comes from outside is the owner's: it passes, whatever part is at work, and the engine stays sound."""

from __future__ import annotations

import functools
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

import pytest

from tests.core.oracle.scripted import Says, engine, forward, level
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.words.errors import ContractError
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.changes import Additive
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.streamlined.modifier import Modifier

pytestmark = pytest.mark.skipif(not hasattr(signal, "raise_signal"), reason="this system has no signals")


def leave(signum: int, frame: object, *, code: int = 0) -> None:
    raise SystemExit(code)


class Handler:
    """A callable object, and one with a method."""

    def __call__(self, signum: int, frame: object) -> None:
        raise TimeoutError("too late")

    def stop(self, number: int, _frame: object) -> None:
        raise SystemExit(4)


HANDLERS: dict[str, tuple[Callable[..., Any], type[BaseException]]] = {
    "the usual lambda": (lambda *_: sys.exit(0), SystemExit),
    "a function": (leave, SystemExit),
    "a partial": (functools.partial(leave, code=3), SystemExit),
    "an object": (Handler(), TimeoutError),
    "a method": (Handler().stop, SystemExit),
    "Python's own, for Ctrl-C": (signal.default_int_handler, KeyboardInterrupt),
}


@pytest.fixture(params=HANDLERS)
def stop(request: pytest.FixtureRequest) -> Iterator[type[BaseException]]:
    handler, error = HANDLERS[request.param]
    before = signal.signal(signal.SIGUSR1, handler)
    yield error
    signal.signal(signal.SIGUSR1, before)


def interrupted(base: type[Any], method: str) -> type[Any]:
    """Return a part in whose method the signal comes, in decision 2 only."""

    def call(self: Any, *arguments: Any) -> Any:
        SEEN[method] = SEEN.get(method, 0) + 1
        if SEEN[method] == 3:
            signal.raise_signal(signal.SIGUSR1)
        return getattr(base, method)(self, *arguments)

    return type(base.__name__, (base,), {method: call})


SEEN: dict[str, int] = {}
STUDENT = type(level(0))


def stopped_in(method: str) -> Engine[Any, Any, Any]:
    SEEN.clear()
    says = {"propose": level(3).options.propose}
    parts: dict[str, Any] = {
        "propose": {"student": interrupted(STUDENT, "propose")(**says)},
        "teach": {"student": interrupted(STUDENT, "teach")(**says)},
        "select": {"selector": interrupted(Modifier, "select")()},
        "amplify": {"amplifier": interrupted(Never, "amplify")()},
        "fraction": {"amplifier": Never(change=interrupted(Additive, "fraction")())},
        "judged": {"amplifier": interrupted(Never, "judged")()},
        "evaluate": {"evaluator": interrupted(Conditions, "evaluate")()},
        "violated": {"conditions": [interrupted(Says, "violated")(violated=lambda state: False)]},
    }[method]
    return engine(forward(0.1), parts.pop("student", level(3)), limits=Limits(slew=1), **parts)


METHODS = ("propose", "teach", "select", "amplify", "fraction", "judged", "evaluate", "violated")


@pytest.mark.parametrize("method", METHODS)
def test_a_stop_from_outside_passes_whatever_part_is_at_work(method: str, stop: type[BaseException]) -> None:
    wrapped = stopped_in(method)
    levels, stops = [], 0
    for state in range(8):
        try:
            wrapped.step(state)
        except stop:
            stops += 1
            assert wrapped.pending is None
        else:
            levels.append(wrapped.pending.resulting.level)
    assert 1 == stops
    assert {} == wrapped.incident_counts
    assert [1, 2, 3, 3, 3, 3, 3] == sorted(levels)
    assert all(abs(after - before) <= 1 for before, after in pairwise(levels))


def test_the_same_exceptions_are_a_parts_incidents_where_the_part_raises_them() -> None:
    for error in (SystemExit(0), TimeoutError("slow"), GeneratorExit()):

        def propose(moment: Any, error: BaseException = error) -> Any:
            raise error

        wrapped = engine(forward(0.1), STUDENT(propose=propose))
        wrapped.step(0)
        assert {("student", "raised"): 1} == wrapped.incident_counts


def test_an_exception_that_a_part_prepared_with_a_frame_in_hand_is_still_the_parts() -> None:
    def look(depth: str, frame: object) -> None:
        raise ValueError("mine")

    with pytest.raises(ValueError, match="mine") as raised:
        look("here", sys._getframe(0))
    assert not is_owners(raised.value)


@pytest.mark.parametrize("call", ["step", "propagate", "evaluate", "reset", "drop"])
def test_a_part_that_calls_its_own_engine_is_refused(call: str) -> None:
    held: list[Engine[Any, Any, Any]] = []

    def propose(moment: Any) -> Any:
        getattr(held[0], call)(*([0] if call in ("step", "propagate", "evaluate") else []))
        return level(3).options.propose(moment)

    wrapped = engine(forward(0.1), STUDENT(propose=propose), limits=Limits(slew=1))
    held.append(wrapped)
    for state in range(4):
        action = wrapped.step(state)
        assert 0.1 == action.translation
    assert {("student", "raised"): 4} == wrapped.incident_counts
    assert "a part must not call the engine that it works in" in wrapped.incidents[0].message


def test_two_threads_in_one_engine_are_told() -> None:
    inside, go = threading.Event(), threading.Event()

    def propose(moment: Any) -> Any:
        inside.set()
        go.wait(10)
        return level(1).options.propose(moment)

    wrapped = engine(forward(0.1), STUDENT(propose=propose))
    other = threading.Thread(target=wrapped.step, args=(0,))
    other.start()
    inside.wait(10)
    with pytest.raises(ContractError, match="two threads must not share one"):
        wrapped.step(1)
    go.set()
    other.join()
    assert {} == wrapped.incident_counts


class Nameless(type):
    """A class of exceptions that cannot be looked at."""

    @property
    def __name__(cls) -> str:  # type: ignore[override]
        raise RuntimeError("no name")


class Untouchable(Exception, metaclass=Nameless):
    @property
    def __class__(self) -> Any:
        raise RuntimeError("no class")

    @property
    def kind(self) -> str:
        raise RuntimeError("no kind")

    def __str__(self) -> str:
        raise SystemExit(9)


def test_an_exception_that_cannot_be_looked_at_is_an_incident() -> None:
    def propose(moment: Any) -> Any:
        raise Untouchable

    wrapped = engine(forward(0.1), STUDENT(propose=propose))
    assert 0.1 == wrapped.step(0).translation
    assert {("student", "raised"): 1} == wrapped.incident_counts
    assert "an exception that cannot even be named" == wrapped.incidents[0].message


def lower_the_recursion_limit(more: int) -> None:
    depth, frame = 0, sys._getframe(1)
    while frame is not None:
        depth, frame = depth + 1, frame.f_back
    sys.setrecursionlimit(depth + more)


@pytest.mark.parametrize("method", ["propose", "teach", "judged"])
@pytest.mark.parametrize("more", range(2, 12))
def test_a_part_that_lowers_the_recursion_limit_is_an_incident_and_the_limit_comes_back(method: str, more: int) -> None:
    def call(self: Any, *arguments: Any) -> Any:
        answer = getattr(STUDENT, method)(self, *arguments)
        lower_the_recursion_limit(more)
        return answer

    spoiler = type("Spoiler", (STUDENT,), {method: call})
    wrapped = engine(forward(0.1), spoiler(propose=level(2).options.propose), conditions=[Says(violated=bool)])
    before = sys.getrecursionlimit()
    for state in range(3):
        wrapped.step(state)
        assert before == sys.getrecursionlimit()
    assert {"student"} == {part for part, _ in wrapped.incident_counts}
    assert (3 if method == "propose" else 2) == sum(wrapped.incident_counts.values())
