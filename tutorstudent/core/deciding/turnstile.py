"""One call into an engine at a time."""

from __future__ import annotations

from tutorstudent.core.deciding.guard import Guard
from tutorstudent.core.words.errors import ContractError


class Turnstile:
    """Lets one call into an engine at a time; a part that calls the engine it works in is refused.

    What the recursion limit is when a call comes in is the owner's; parts must leave it so.
    """

    __slots__ = ("_guard", "_is_taken")

    def __init__(self, guard: Guard) -> None:
        self._guard, self._is_taken = guard, False

    def __enter__(self) -> None:
        if self._is_taken:
            raise ContractError(
                "the engine is in the middle of a decision; a part must not call the engine that it works in, and two "
                "threads must not share one."
            )
        self._is_taken = True
        self._guard.begin_call()

    def __exit__(self, *error: object) -> None:
        self._is_taken = False
