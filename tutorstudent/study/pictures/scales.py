"""Scales for numbers of which a few are very large, such as the collisions of a robot that was stuck once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

LINEAR_UP_TO = 10
"""Long scales are linear up to here and logarithmic beyond."""
LONG_LABEL = f"logarithmic beyond {LINEAR_UP_TO}"
_LONG_FROM = 40.0


def is_long_tailed(numbers: Sequence[float]) -> bool:
    """Return whether a linear scale would hide most of the numbers.

    >>> is_long_tailed([0, 2, 3, 500]), is_long_tailed([200, 300, 500]), is_long_tailed([0, 1, 30])
    (True, False, False)
    """
    highest = max(numbers, default=0.0)
    return bool(highest > _LONG_FROM and highest > 8 * np.median(numbers))


def make_long_ticks(highest: float, steps: Sequence[int]) -> list[int]:
    """Return where a long scale is marked: 0, and these steps of every power of ten.

    >>> make_long_ticks(300, (1, 5))
    [0, 1, 5, 10, 50, 100]
    """
    ticks = [0, *(step * 10**power for power in range(9) for step in steps)]
    return [tick for tick in ticks if tick <= highest]


def find_long_share(values: NDArray[np.float64], limit: float) -> NDArray[np.float64]:
    """Return how far along a long scale from 0 to `limit` values stand: the linear part is as long as a power of ten.

    >>> find_long_share(np.array([0.0, 5.0, 10.0, 100.0, 1000.0]), 1000.0).tolist()
    [0.0, 0.16666666666666666, 0.3333333333333333, 0.6666666666666666, 1.0]
    """
    ends = np.append(values, limit) / LINEAR_UP_TO
    tens = np.where(ends <= 1, ends, 1 + np.log10(np.maximum(ends, 1)))
    return np.asarray(tens[:-1] / tens[-1], dtype=np.float64)
