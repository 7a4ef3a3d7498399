"""Conformance checks for your own parts: they try out what every role promises.

In the tests of a plugin::

    import pytest
    from tutorstudent.checks import checks_of

    @pytest.mark.parametrize("check", checks_of(WallFollower(clearance_m=0.3)), ids=str)
    def test_conformance(check):
        check()

or, once it is installed, ``tutorstudent plugins check wall-follower``.
"""

from __future__ import annotations

from tutorstudent.checks.catalogue import Check, checks_of
from tutorstudent.checks.outcome import CheckFailed, CheckSkipped
from tutorstudent.checks.report import Report, Result, run_checks

__all__ = ["Check", "CheckFailed", "CheckSkipped", "Report", "Result", "checks_of", "run_checks"]
