"""Reading the values of a PGM image: P2, written in digits, and P5, written in bytes."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.uint8] | NDArray[np.uint16]

MAGIC = (b"P2", b"P5")
LONGEST_HEADER = 65_536
"""In bytes; a header is four words, with blanks and comments between them."""
MOST_PIXELS = 64_000_000
MOST_DIGITS = 30_000_000
"""Bytes of an image that is written in digits, which take longest to read."""
MOST_VALUE = 65_535

_COMMENT = re.compile(rb"#[^\n\r]*")
_BETWEEN = rb"(?:\s|#[^\n\r]*[\n\r])+"
_HEADER = re.compile(rb"P[25]" + 3 * (_BETWEEN + rb"([^\s#]+)") + rb"(?:#[^\n\r]*)?\s")


class Header(NamedTuple):
    """What a PGM says about itself."""

    width: int
    height: int
    most: int
    """The value of white."""
    end: int
    """Where the values begin."""


def read_pgm(data: bytes) -> tuple[Values, int]:
    """Return the values, shape (height, width), top row first, and the value of white.

    Raises:
        ValueError: It is no such image; the message says why.
    """
    header = _read_header(data)
    check_size(header.width, header.height)
    count = header.width * header.height
    values = _read_digits(data, header, count) if data.startswith(b"P2") else _read_bytes(data, header, count)
    if values.size < count:
        raise ValueError(f"the image is cut short: it has {values.size:,} of {count:,} values")
    if values.max() > header.most:
        raise ValueError(f"it has the value {values.max()}, but its header allows at most {header.most}")
    values = values.reshape(header.height, header.width)
    return (values.astype(np.uint16) if header.most > 255 else values.astype(np.uint8)), header.most


def check_size(width: int, height: int) -> None:
    """Raise ValueError if an image is too small or too large for a map."""
    if width < 1 or height < 1 or width * height > MOST_PIXELS:
        raise ValueError(f"{width} x {height} pixels is no size for a map; 1 to {MOST_PIXELS:,} pixels are allowed")


def _read_header(data: bytes) -> Header:
    found = _HEADER.match(data[:LONGEST_HEADER])
    if found is None:
        raise ValueError(f"the header of a PGM is not complete within its first {LONGEST_HEADER:,} bytes")
    words = found.groups()
    if not all(word.isdigit() and len(word) <= 9 for word in words):
        raise ValueError("the header of a PGM has three whole numbers: width, height and the value of white")
    width, height, most = (int(word) for word in words)
    if not 0 < most <= MOST_VALUE:
        raise ValueError(f"the value of white is {most}; 1 to {MOST_VALUE} are allowed")
    return Header(width, height, most, found.end())


def _read_bytes(data: bytes, header: Header, count: int) -> NDArray[np.integer]:
    kind, size = (">u2", 2) if header.most > 255 else ("u1", 1)
    count = min(count, (len(data) - header.end) // size)
    return np.frombuffer(data, kind, count, header.end)


def _read_digits(data: bytes, header: Header, count: int) -> NDArray[np.integer]:
    if len(data) > MOST_DIGITS:
        raise ValueError(f"as a P2 image it has {len(data):,} bytes, and {MOST_DIGITS:,} are allowed; save it as P5")
    text = data[header.end :]
    if b"#" in text:
        text = _COMMENT.sub(b" ", text)
    strange = re.search(rb"[^\d\s]\S*", text)
    if strange:
        word = strange.group()[:20].decode("ascii", "backslashreplace")
        raise ValueError(f"it has '{word}' among its values; 0 to {header.most} are allowed")
    if re.search(rb"[1-9]\d{9}", text):
        raise ValueError(f"it has a value of ten digits or more; 0 to {header.most} are allowed")
    return np.fromstring(text, np.int32, sep=" ")[:count] if text.strip() else np.zeros(0, np.int32)
