"""What came out of all checks of a part."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

from tutorstudent.checks.catalogue import Check
from tutorstudent.checks.outcome import RAISED, CheckFailed, CheckSkipped, describe_error

Status = Literal["passed", "skipped", "failed"]


class Result(NamedTuple):
    """What came out of one check."""

    check: str
    about: str
    """What the check is about, one sentence."""
    status: Status
    note: str = ""
    """Why it was skipped, or what it reports."""
    expected: str = ""
    seen: str = ""
    remedy: str = ""


class Report(NamedTuple):
    """What came out of all checks of a part."""

    part: str
    results: Sequence[Result]
    seconds: float

    def of(self, status: Status) -> list[Result]:
        """Return the results with a status."""
        return [result for result in self.results if result.status == status]

    @property
    def headline(self) -> str:
        """Counts of all, in one line."""
        passed, skipped, failed = (len(self.of(status)) for status in ("passed", "skipped", "failed"))
        return f"{self.part}: {passed} passed, {skipped} skipped, {failed} failed in {self.seconds:.1f} s"

    def lines(self) -> list[str]:
        """Return the whole report as text: failures with what to do, reasons of what was skipped, what was measured."""
        failures = [
            line
            for result in self.of("failed")
            for line in (
                f"FAILED  {result.check}: {result.about}",
                f"        expected: {result.expected}",
                f"        seen:     {result.seen}",
                f"        to do:    {result.remedy}",
            )
        ]
        reasons = dict.fromkeys(result.note for result in self.of("skipped"))
        skips = [f"skipped {', '.join(self._format_skipped(reason))}: {reason}" for reason in reasons]
        notes = [f"passed  {result.check}: {result.note}" for result in self.of("passed") if result.note]
        return [*failures, *skips, *notes, self.headline]

    def _format_skipped(self, reason: str) -> list[str]:
        return [result.check for result in self.of("skipped") if result.note == reason]

    def as_json(self) -> dict[str, Any]:
        """Return the report as plain values."""
        counts = {status: len(self.of(status)) for status in ("passed", "skipped", "failed")}
        results = [{key: value for key, value in result._asdict().items() if value} for result in self.results]
        return {"part": self.part, **counts, "seconds": round(self.seconds, 3), "results": results}


def run_checks(checks: Sequence[Check]) -> Report:
    """Make all checks of one part."""
    start = time.perf_counter()
    results = [_make_result(check) for check in checks]
    cls = checks[0].usage.subject.cls
    return Report(f"{cls.role} '{cls.name}'", results, time.perf_counter() - start)


def _make_result(check: Check) -> Result:
    about = " ".join((check.function.__doc__ or "").split())
    try:
        return Result(check.name, about, "passed", check() or "")
    except CheckSkipped as skip:
        return Result(check.name, about, "skipped", str(skip))
    except CheckFailed as failure:
        return Result(check.name, about, "failed", "", failure.expected, failure.seen, failure.remedy)
    except RAISED as error:
        return Result(
            check.name,
            about,
            "failed",
            "",
            "the part can be used by the check",
            describe_error(error),
            "see the traceback with checks_of() in a test",
        )
