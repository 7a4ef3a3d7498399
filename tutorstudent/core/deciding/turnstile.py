"""One call into an engine at a time."""

from __future__ import annotations

from tutorstudent.core.words.errors import ContractError


class Turnstile:
    """Lets one call into an engine at a time; a part that calls the engine it works in is refused."""

    __slots__ = ("_is_taken",)

    def __init__(self) -> None:
        self._is_taken = False

    def __enter__(self) -> None:
        if self._is_taken:
            raise ContractError(
                "the engine is in the middle of a decision; a part must not call the engine that it works in, and two "
                "threads must not share one."
            )
        self._is_taken = True

    def __exit__(self, *error: object) -> None:
        self._is_taken = False
