"""Reading the grey values of a PGM or PNG file, as far as maps need it."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.words.errors import PipelineError

Grey = NDArray[np.uint8]

_PNG = b"\x89PNG\r\n\x1a\n"
_CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}
"""Bytes for a pixel by PNG colour type: grey, colour, each with and without transparency."""
SUPPORTED = "Maps are PGM (P2 or P5) or PNG (8 bit, grey or colour, not interlaced)."
MOST_PIXELS = 64_000_000


def read_grey(path: Path) -> Grey:
    """Return the grey values, shape (height, width), top row first; PipelineError if the file cannot be read."""
    try:
        data = path.read_bytes()
        return _read_png(data) if data.startswith(_PNG) else _read_pgm(data)
    except OSError as error:
        raise PipelineError(f"{path}: cannot be read: {error.strerror}.") from None
    except (struct.error, zlib.error):
        raise PipelineError(f"{path}: the image is cut short or damaged. {SUPPORTED}") from None
    except ValueError as error:
        raise PipelineError(f"{path}: {error}. {SUPPORTED}") from None


def _read_pgm(data: bytes) -> Grey:
    header, start = _read_pgm_header(data)
    if not all(word.isdigit() for word in header[1:]):
        raise ValueError("the header of a PGM has three whole numbers")
    width, height, most = (int(word) for word in header[1:])
    _check_size(width, height)
    if not 0 < most < 256:
        raise ValueError(f"grey values up to {most} are not supported")
    if header[0] == b"P5":
        values = np.frombuffer(data[start : start + width * height], np.uint8)
    else:
        values = np.array(data[start:].split()[: width * height], dtype=np.int64)
    if values.size != width * height or (values.size and values.max() > most):
        raise ValueError("the image is cut short or its values are too large")
    return (values.reshape(height, width).astype(np.float64) * 255.0 / most).astype(np.uint8)


def _read_pgm_header(data: bytes) -> tuple[list[bytes], int]:
    """Return magic number, width, height and largest value, and where the values begin."""
    words: list[bytes] = []
    at = 0
    while len(words) < 4:
        if at >= len(data):
            raise ValueError("not a PGM or PNG image")
        end = data.find(b"\n", at) if data[at : at + 1] == b"#" else at
        if end > at:
            at = end
        elif data[at : at + 1].isspace():
            at += 1
        else:
            words.append(data[at:].split(maxsplit=1)[0])
            at += len(words[-1])
        if words and words[0] not in (b"P2", b"P5"):
            raise ValueError("not a PGM or PNG image")
    return words, at + 1


def _read_png(data: bytes) -> Grey:
    chunks = list(_read_chunks(data))
    header = next((body for kind, body in chunks if kind == b"IHDR"), b"")
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", header)
    _check_size(width, height)
    if depth != 8 or colour not in _CHANNELS or interlaced:
        raise ValueError(f"a PNG of bit depth {depth}, colour type {colour}, interlace {interlaced} is not supported")
    channels = _CHANNELS[colour]
    limit = height * (width * channels + 1)
    raw = zlib.decompressobj().decompress(b"".join(body for kind, body in chunks if kind == b"IDAT"), limit)
    if len(raw) < limit:
        raise ValueError("the image is cut short or damaged")
    rows = np.frombuffer(raw, np.uint8).reshape(height, width * channels + 1)
    pixels = _unfilter(rows, channels).reshape(height, width, channels)
    shades = pixels[:, :, :1] if channels < 3 else pixels[:, :, :3]
    grey: Grey = shades.mean(axis=2).astype(np.uint8)
    return grey


def _read_chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    at = len(_PNG)
    while at + 8 <= len(data):
        size = struct.unpack(">I", data[at : at + 4])[0]
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        at += size + 12


def _unfilter(rows: Grey, channels: int) -> Grey:
    out = np.zeros((rows.shape[0], rows.shape[1] - 1), np.uint8)
    above = np.zeros(rows.shape[1] - 1, np.int64)
    for i, row in enumerate(rows):
        above = _unfilter_row(int(row[0]), row[1:].astype(np.int64), above, channels)
        out[i] = above
    return out


def _unfilter_row(method: int, row: NDArray[np.int64], above: NDArray[np.int64], step: int) -> NDArray[np.int64]:
    """Undo one of PNG's five row filters."""
    if method == 0:
        return row
    if method == 2:
        return (row + above) % 256
    if method > 4:
        raise ValueError(f"PNG row filter {method} does not exist")
    out, up = row.tolist(), above.tolist()
    for i in range(len(out)):
        left = out[i - step] if i >= step else 0
        corner = up[i - step] if i >= step else 0
        guess = left if method == 1 else (left + up[i]) // 2 if method == 3 else _paeth(left, up[i], corner)
        out[i] = (out[i] + guess) % 256
    return np.array(out)


def _paeth(left: int, up: int, corner: int) -> int:
    guess = left + up - corner
    return min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]


def _check_size(width: int, height: int) -> None:
    if width < 1 or height < 1 or width * height > MOST_PIXELS:
        raise ValueError(f"{width} x {height} pixels is no size for a map")
