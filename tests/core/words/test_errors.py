"""What is said of an exception, however it behaves when it is asked."""

from __future__ import annotations

import pytest

from tutorstudent.core.words.errors import say_error


class Nameless(type):
    @property
    def __name__(cls) -> str:  # type: ignore[override]
        raise RuntimeError("no name")


class Untouchable(Exception, metaclass=Nameless):
    def __str__(self) -> str:
        raise SystemExit(9)


def test_an_exception_that_cannot_be_looked_at_has_a_sentence() -> None:
    assert "Untouchable: its message cannot be read." == say_error(Untouchable())


def test_ctrl_c_while_a_message_is_read_is_the_owners() -> None:
    class Slow(Exception):
        def __str__(self) -> str:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        say_error(Slow())
