"""What a check can end with, other than nothing."""

from __future__ import annotations

import unittest

RAISED = (Exception, SystemExit)
"""What a part may raise and a check tells of."""


class CheckFailed(AssertionError):
    """A part does not do what its role promises.

    Args:
        expected: What its role promises.
        seen: What it did.
        remedy: What to do about it.
    """

    def __init__(self, expected: str, seen: str, remedy: str) -> None:
        super().__init__(f"expected: {expected}\nseen:     {seen}\nto do:    {remedy}")
        self.expected, self.seen, self.remedy = expected, seen, remedy


class CheckSkipped(unittest.SkipTest):
    """A check does not apply; the message says why. Test runners count it as a skipped test."""


def expect(holds: bool, expected: str, seen: str, remedy: str) -> None:
    """Raise `CheckFailed` unless something holds."""
    if not holds:
        raise CheckFailed(expected, seen, remedy)


def describe_error(error: BaseException) -> str:
    """Return an exception as ``Type: message``, shortened.

    >>> describe_error(ValueError("too far"))
    'ValueError: too far'
    """
    text = f"{type(error).__name__}: {error}"
    return text if len(text) <= 300 else f"{text[:297]}..."
