"""Values that are not what they say."""

from __future__ import annotations

from typing import Any, NoReturn


class LyingInt(int):
    """An int that agrees with every comparison and adds up to nothing."""

    def _agree(self, other: object) -> bool:
        return True

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = _agree
    __hash__ = int.__hash__

    def __ne__(self, other: object) -> bool:
        return False

    def __index__(self) -> int:
        return 1

    def __int__(self) -> int:
        return 1

    def __bool__(self) -> bool:
        return True

    def __add__(self, other: Any) -> int:
        return 0


class LyingFloat(float):
    """A float that agrees with every comparison."""

    def _agree(self, other: object) -> bool:
        return True

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = _agree
    __hash__ = float.__hash__

    def __ne__(self, other: object) -> bool:
        return False


class LyingStr(str):
    """A string that equals every other."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        return True

    def __ne__(self, other: object) -> bool:
        return False

    __hash__ = str.__hash__


class Agreeable:
    """Something that is no action and equals every action."""

    def __eq__(self, other: object) -> bool:
        return True

    def __ne__(self, other: object) -> bool:
        return False

    __hash__ = object.__hash__


class Touchy:
    """Something that cannot be looked at."""

    def _raise(self, *args: object) -> NoReturn:
        raise ValueError("do not look at me")

    __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _raise
    __bool__ = __index__ = __int__ = __float__ = __str__ = __repr__ = __iter__ = __len__ = _raise
    __hash__ = object.__hash__


class Unsayable(Exception):
    """An exception whose message cannot be read."""

    def __str__(self) -> str:
        raise SystemExit("no message")

    __repr__ = __str__


class Fatal(BaseException):
    """Neither an Exception nor a KeyboardInterrupt."""
