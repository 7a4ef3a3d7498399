"""A record of the calls that a world made to pybullet, to be made again without the world.

What the world itself costs is its time minus the time of the same bare calls in a same world::

    log = CallLog(load_pybullet())
    world = PioneerWorld(scene="cave-box")
    world.connect(Bullet(log))
    world.reset(7)
    log.clear()
    ...                    # decisions
    replay(log.calls, load_pybullet())
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple


class Call(NamedTuple):
    """One call of a function of pybullet."""

    function: str
    args: tuple[Any, ...]
    kwargs: dict[str, Any]


class CallLog:
    """Stands in for the pybullet module and notes every call.

    Args:
        api: The pybullet module.
    """

    def __init__(self, api: Any) -> None:
        self._api = api
        self.calls: list[Call] = []

    def clear(self) -> None:
        """Forget the calls so far."""
        self.calls.clear()

    def __getattr__(self, name: str) -> Any:
        value = getattr(self._api, name)
        return self._note(name, value) if callable(value) else value

    def _note(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: Any, **kwargs: Any) -> Any:
            self.calls.append(Call(name, tuple(map(_keep, args)), kwargs))
            return function(*args, **kwargs)

        return call


def bind_calls(calls: Iterable[Call], api: Any, client: int) -> list[Callable[[], Any]]:
    """Return the calls ready to be made on another client, so that a clock sees nothing but pybullet."""
    return [
        _bind_call(getattr(api, call.function), call.args, {**call.kwargs, "physicsClientId": client}) for call in calls
    ]


def _bind_call(function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]) -> Callable[[], Any]:
    return lambda: function(*args, **kwargs)


def _keep(value: Any) -> Any:
    """Return a copy of an array, whose owner writes into it again."""
    return value.copy() if hasattr(value, "copy") else value
