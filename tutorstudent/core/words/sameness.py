"""Whether two values are the same, bit for bit."""

from __future__ import annotations

import struct
from typing import Any

import numpy as np


def is_same(own: Any, other: Any) -> bool:
    """Return whether two values are the same, bit for bit."""
    if own is other:
        return True
    if type(own) is not type(other):
        return False
    if isinstance(own, float):
        return struct.pack("d", own) == struct.pack("d", other)
    if isinstance(own, np.ndarray):
        return bool(own.dtype == other.dtype and own.shape == other.shape and own.tobytes() == other.tobytes())
    return bool(own == other)
