"""What is checked, and what it is tried with.

Where states come from, the first that applies:

1. ``checks_of(part, states=[...])``;
2. ``checks_of(part, world=...)`` or ``plugins check NAME --world pioneer``: states that the world gives;
3. ``examples()`` of the part: a method that returns states;
4. ``examples()`` of the state class that the part is made for (``Tutor[PioneerState, DriveAction]``): a class method;
5. the same of its nested parts;
6. where the part is made for any state, a stand-in: the number 0.

Actions come from the action class: the one that is given, the tutor's or world's own, the one that the part or a nested
part is made for, or a stand-in with every direction.
"""

from __future__ import annotations

import contextlib
import copy
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from itertools import cycle, islice
from typing import Any, TypeVar

from tutorstudent.checks.claims import find_action_claim, find_state_claim
from tutorstudent.checks.motion import Motion, make_examples
from tutorstudent.checks.outcome import CheckSkipped
from tutorstudent.core.files.registry import ROLES
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import World
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.records import StateT

SEED = 7
FEWEST = 12
"""States are repeated until there are so many."""


class Subject:
    """A part under check: makes fresh, unbound instances of it, and knows what to try them with.

    Args:
        part: An instance that stands in no pipeline, which is only copied; or a callable that makes one, such as its
            class.
        states: States to try it with.
        world: An unbound world to take states from.
        action: The tutor's action class, where the part does not say.
    """

    def __init__(
        self,
        part: Component | Callable[[], Component],
        states: Sequence[Any] | None = None,
        world: World[Any, Any] | None = None,
        action: type[Action] | None = None,
    ) -> None:
        self.sample = _require_unbound(part if isinstance(part, Component) else part())
        self.make: Callable[[], Any] = partial(copy.deepcopy, part) if isinstance(part, Component) else part
        self.cls = type(self.sample)
        self.world = world
        self.given_states = states
        self.given_action = action
        self._made: list[Component] = []

    def make_bound(self, slot: str = "", seed: int = SEED) -> Any:
        """Return a fresh instance that was bound at a slot; its role's, if none is named."""
        part = self.make()
        self._made.append(part)
        part.bind(Binding(seed, slot or self.cls.role, self.action))
        return part

    def close_all(self) -> None:
        """Close every instance that was bound, so that no check leaves anything open."""
        while self._made:
            with contextlib.suppress(Exception, SystemExit):
                self._made.pop().close()

    @property
    def waived(self) -> Mapping[str, str]:
        """Checks that do not apply to the part, each with the reason: what its class calls ``waived_checks``."""
        return getattr(self.cls, "waived_checks", {})

    @cached_property
    def action(self) -> type[Action]:
        """The tutor's action class."""
        owners = [owner for owner in (self.world, *walk_family(self.sample)) if owner is not None]
        own = [getattr(owner, "action", None) for owner in owners]
        claims = [self.given_action, *own, *(find_action_claim(type(owner)) for owner in owners)]
        known = (claim for claim in claims if isinstance(claim, type) and issubclass(claim, Action))
        return next((claim for claim in known if claim is not Action), Motion)

    @cached_property
    def actions(self) -> list[Any]:
        """Sound actions of the class."""
        return make_examples(self.action)

    @cached_property
    def states(self) -> list[Any]:
        """States to try the part with, at least `FEWEST`.

        Raises:
            CheckSkipped: if nobody supplies any.
        """
        found = list(self._find_states())
        return list(islice(cycle(found), max(FEWEST, len(found))))

    def _find_states(self) -> Sequence[Any]:
        if self.given_states:
            return self.given_states
        if self.world is not None:
            return _visit(self.world, self.action)
        members = list(walk_family(self.sample))
        for member in members:
            if type(member).examples is not Component.examples:
                return _find_examples(member, self.action)
            claim = find_state_claim(type(member))
            if hasattr(claim, "examples"):
                return list(claim.examples())
        if all(isinstance(find_state_claim(type(member)), TypeVar) for member in members if _reads_states(member)):
            return [0.0]
        raise CheckSkipped(
            f"it is not known what states {self.cls.__name__} is made for: give its class or its state class "
            "examples(), or checks_of(part, states=[...]), or `plugins check NAME --world WORLD`"
        )


def walk_family(part: Component) -> Iterator[Component]:
    """Yield a part and all that is nested in it."""
    yield part
    for _, nested in part.parts():
        yield from walk_family(nested)


def _find_examples(member: Component, action: type[Action]) -> list[Any]:
    fresh: Any = copy.deepcopy(member)
    fresh.bind(Binding(SEED, member.role, action))
    return list(fresh.examples())


def _reads_states(member: Component) -> bool:
    return StateT in getattr(ROLES[member.role], "__parameters__", ())


def _visit(world: World[Any, Any], action: type[Action]) -> list[Any]:
    visited = copy.deepcopy(world)
    visited.bind(Binding(SEED, "world", action))
    try:
        states = [visited.reset(SEED)]
        for example in islice(cycle(make_examples(action)), 2 * FEWEST):
            step = visited.step(example)
            states.append(visited.reset(SEED + len(states)) if step.done or step.truncated else step.state)
        return states
    finally:
        visited.close()


def _require_unbound(part: Component) -> Component:
    if part.slot:
        raise ContractError(
            f"{part.role} '{part.name}' stands at '{part.slot}' of a pipeline; give the checks one that is in none."
        )
    return part
