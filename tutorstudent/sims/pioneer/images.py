"""Reading the pixels of a map: PGM by ourselves, other formats with Pillow."""

from __future__ import annotations

import io
import struct
import warnings
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.pgm import MAGIC, MOST_PIXELS, Values, check_size, read_pgm

if TYPE_CHECKING:
    from PIL.Image import Image

FORMATS = ("PNG", "BMP", "JPEG", "GIF", "TIFF", "PPM")
"""As Pillow calls them; other formats have decoders that nobody uses for maps."""
SUPPORTED = "Maps are PGM, PNG, BMP, JPG, GIF, TIFF or PPM images."
MOST_BYTES = 300_000_000
DEEP = ("I;16", "I;16L", "I;16B", "I;16N")
"""Grey values of 16 bits, as Pillow calls them."""


class Pixels(NamedTuple):
    """The pixels of an image, top row first."""

    values: Values
    """The sum of a pixel's colours, shape (height, width); 0 is black."""
    most: int
    """The value of white."""
    alpha: NDArray[np.uint8] | None = None
    """255 where a pixel is opaque; None if there is no transparency."""


def read_pixels(path: Path) -> Pixels:
    """Return the pixels of an image; PipelineError if the file cannot be read."""
    try:
        size = path.stat().st_size
        if size > MOST_BYTES:
            raise ValueError(f"it has {size:,} bytes; {MOST_BYTES:,} are allowed")
        data = path.read_bytes()
        return Pixels(*read_pgm(data)) if data.startswith(MAGIC) else _read_with_pillow(data, path)
    except ValueError as error:
        raise PipelineError(f"{path}: {error}. {SUPPORTED}") from None
    except OSError as error:
        raise PipelineError(f"{path}: cannot be read: {error.strerror}.") from None


def _read_with_pillow(data: bytes, path: Path) -> Pixels:
    try:
        from PIL import Image, UnidentifiedImageError
    except ImportError:
        raise PipelineError(
            f"{path}: a map that is no PGM needs Pillow; install it with: pip install 'tutorstudent[bullet]', or save "
            "the map as PGM."
        ) from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of images that are large, or a little odd
            with Image.open(io.BytesIO(data), formats=FORMATS) as image:
                check_size(*image.size)
                return _take_pixels(image)
    except UnidentifiedImageError:
        raise ValueError("it is no image that can be read") from None
    except Image.DecompressionBombError:
        raise ValueError(f"it has more than {MOST_PIXELS:,} pixels") from None
    except (OSError, SyntaxError, EOFError, struct.error, zlib.error):
        raise ValueError("the image is cut short or damaged") from None


def _take_pixels(image: Image) -> Pixels:
    if image.mode in DEEP:
        return Pixels(np.asarray(image).astype(np.uint16), 65_535)
    if image.mode in ("I", "F"):
        raise ValueError("it has more than 16 bits for a pixel; save it with 8")
    if image.has_transparency_data:
        channels = np.asarray(image.convert("RGBA"))
        return Pixels(_add_colours(channels), 3 * 255, channels[:, :, 3].copy())
    if image.mode in ("1", "L"):
        return Pixels(np.asarray(image.convert("L")), 255)
    return Pixels(_add_colours(np.asarray(image.convert("RGB"))), 3 * 255)


def _add_colours(channels: NDArray[np.uint8]) -> NDArray[np.uint16]:
    total = channels[:, :, 0].astype(np.uint16)
    total += channels[:, :, 1]
    total += channels[:, :, 2]
    return total
