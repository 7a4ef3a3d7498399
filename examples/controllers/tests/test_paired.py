"""Paired differences against closed forms."""

from __future__ import annotations

import pytest

from tutorstudent_controllers.paired import Difference, difference, verdict


def test_equal_differences_have_an_interval_of_one_point() -> None:
    assert Difference(-2.0, (-2.0, -2.0), -2.0) == difference([1.0, 2.0, 3.0], [3.0, 4.0, 5.0])


def test_two_pairs_have_no_interval() -> None:
    assert Difference(1.5, None, None) == difference([1.0, 2.0], [0.0, 0.0])


def test_the_interval_holds_the_mean_and_is_no_wider_than_the_pairs() -> None:
    found = difference([1.0, 5.0, 3.0, 4.0, 2.0], [0.0] * 5)
    assert found.interval is not None
    assert found.upper is not None
    assert 1.0 <= found.interval[0] < found.mean < found.upper < found.interval[1] <= 5.0


@pytest.mark.parametrize(
    ("low", "upper", "expected"),
    [(-3.0, 9.9, "not worse"), (-3.0, 10.1, "undecided"), (10.5, 30.0, "worse")],
)
def test_a_verdict_is_about_the_margin(low: float, upper: float, expected: str) -> None:
    assert expected == verdict(Difference(0.0, (low, upper + 1), upper), margin=10.0)
    assert "too few pairs" == verdict(Difference(0.0, None, None), margin=10.0)
