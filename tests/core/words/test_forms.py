"""Numbers in the owner's precision."""

from __future__ import annotations

import numpy as np
import pytest

from tutorstudent.core.words.forms import fit_number


@pytest.mark.parametrize("kind", [np.float16, np.float32, np.float64])
@pytest.mark.parametrize(("own", "number"), [(0.25, 0.5), (-0.25, -0.5), (0.5, 0.5)])
def test_a_number_that_the_type_holds_stays_as_it_is(kind: type[np.floating], own: float, number: float) -> None:
    assert number == fit_number(kind(own), number)


@pytest.mark.parametrize(("own", "number"), [(0.25, 0.3), (-0.25, -0.3), (0.3, 0.25)])
def test_any_other_is_rounded_towards_the_owners(own: float, number: float) -> None:
    found = fit_number(np.float32(own), number)
    assert min(own, number) <= found <= max(own, number)
    assert pytest.approx(number, rel=1e-6) == found
