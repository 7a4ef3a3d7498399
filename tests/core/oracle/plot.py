"""Who misbehaves, when, and what came of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from random import Random
from typing import Any, NamedTuple

from tests.core.oracle.acts import Behaviour
from tests.core.oracle.behaviours import EVALUATION, EVERYTHING, PROPAGATION

ACTS = PROPAGATION | EVALUATION


class Deed(NamedTuple):
    """A behaviour that was carried out."""

    slot: str
    name: str
    behaviour: Behaviour


class Plot:
    """Arms one behaviour of one part at a time, every one of them before any comes again.

    Args:
        random: Source of the order.
        chosen: The (slot, behaviour) pairs that may happen; all by default.
        acts: What each behaviour does, by slot and name.
    """

    def __init__(
        self,
        random: Random,
        chosen: Sequence[tuple[str, str]] = EVERYTHING,
        acts: Mapping[str, Mapping[str, Behaviour]] = ACTS,
    ) -> None:
        self._random, self._chosen, self._acts = random, tuple(chosen), acts
        self._bag: list[tuple[str, str]] = []
        self._armed: dict[str, str] = {}
        self._deeds: list[Deed] = []
        self.done: Counter[tuple[str, str]] = Counter()
        """How often each behaviour was carried out."""

    def arm(self) -> None:
        """Let the next behaviour happen at the first call that gives it an opportunity."""
        if not self._bag:
            self._bag = self._random.sample(self._chosen, len(self._chosen))
        slot, name = self._bag.pop()
        self._armed.setdefault(slot, name)

    def twist(self, slot: str, honest: Callable[[], Any], actions: Sequence[Any] = ()) -> Any:
        """Return what the part honestly returns, or what it does instead."""
        name = self._armed.pop(slot, None)
        if name is None:
            return honest()
        behaviour = self._acts[slot][name]
        self.done[slot, name] += 1
        self._deeds.append(Deed(slot, name, behaviour))
        return behaviour.act(honest(), actions)

    def take(self) -> list[Deed]:
        """Return what was done since this was asked last."""
        deeds, self._deeds = self._deeds, []
        return deeds
