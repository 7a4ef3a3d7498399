"""Digests of decision streams: what must not change when the code does.

A recording keeps one short digest for each column and block of decisions, so that a difference is named by column and
place. It also keeps a digest of the machine's own arithmetic: numpy's and pybullet's last bits differ between
processors, and then a difference says nothing about our code.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

BLOCK = 100
Digests = dict[str, list[str]]


def digest(array: NDArray[Any]) -> str:
    """Return a short digest of an array's values and type."""
    stored = np.ascontiguousarray(array)
    return hashlib.sha256(f"{stored.dtype.str}{stored.shape}".encode() + stored.tobytes()).hexdigest()[:8]


def digests(columns: Mapping[str, NDArray[Any]]) -> Digests:
    """Return the digests of all columns, one for each block of decisions."""
    return {
        name: [digest(column[first : first + BLOCK]) for first in range(0, max(len(column), 1), BLOCK)]
        for name, column in columns.items()
    }


def differences(stored: Digests, found: Digests) -> list[str]:
    """Return where the streams differ: column and first decision of the first differing block."""
    problems = []
    for name, blocks in stored.items():
        if name not in found:
            problems.append(f"{name} is no longer recorded")
        elif found[name] != blocks:
            first = next((i for i, (a, b) in enumerate(zip(blocks, found[name], strict=False)) if a != b), -1)
            problems.append(f"{name} differs from decision {first * BLOCK} on")
    return problems


def arithmetic() -> str:
    """Return a digest of what this machine's numpy makes of transcendental functions and products."""
    numbers = np.random.default_rng(1).normal(size=(64, 64))
    return digest(np.stack([np.exp(-numbers), np.sin(numbers), np.tanh(numbers), numbers @ numbers]))
