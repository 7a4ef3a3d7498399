"""What a faulty writer can do with the controller's own command."""

from __future__ import annotations

from collections.abc import MutableMapping
from typing import Any

from tests.wrapping.oracle.kits import Kit


class View:
    """The controller's own command, as it stands while another is written."""

    def __init__(self, kit: Kit, controller: Any) -> None:
        self._kit, self._controller = kit, controller

    @property
    def own(self) -> Any:
        """The controller's own command itself."""
        return self._controller.said.itself

    def change_own(self, made: Any) -> Any:
        """Write into the controller's own command, and return it."""
        own = self.own
        if hasattr(own, "numbers"):
            own.numbers = [number * 1.05 for number in own.numbers]
        elif self._kit.skipped and hasattr(own, "__dict__") and isinstance(own, object):
            self._set(own, self._kit.skipped[0])
        return own

    def _set(self, own: Any, path: tuple[Any, ...]) -> None:
        *way, last = path
        for step in way:
            own = own[step] if isinstance(own, MutableMapping) else getattr(own, step)
        if isinstance(own, MutableMapping):
            dict.__setitem__(own, last, own[last] * 1.05)  # type: ignore[arg-type]
        else:
            setattr(own, last, getattr(own, last) * 1.05)

    def forget(self, made: Any) -> Any:
        """Change something that is not declared."""
        for name in ("mode", "frame", "label", "tags", "words"):
            if isinstance(made, dict) and name in made:
                dict.__setitem__(made, name, "forgotten")
                return made
            if hasattr(made, "__dict__") and name in vars(made):
                vars(made)[name] = "forgotten"
                return made
        return made

    def retype(self, made: Any) -> Any:
        """Return the same in another type."""
        if isinstance(made, dict):
            return dict(made)
        other = type("Other", (type(made),), {})
        if hasattr(made, "__dict__") and not isinstance(made, tuple):
            copied = other.__new__(other)
            vars(copied).update(vars(made))
            return copied
        return made
