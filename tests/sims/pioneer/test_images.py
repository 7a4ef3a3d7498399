"""Images of maps: what is read, as what, and what is refused with which sentence."""

from __future__ import annotations

import io
import re
import sys
import zlib

import numpy as np
import pytest
from PIL import Image

from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer import images
from tutorstudent.sims.pioneer.images import read_pixels

GREYS = np.array([[0, 60, 128], [200, 254, 255]], dtype=np.uint8)


def save(image, name, **options):
    file = io.BytesIO()
    image.save(file, name, **options)
    return file.getvalue()


def lightness(tmp_path, data):
    """Return the pixels' lightness from 0 to 255."""
    (tmp_path / "image").write_bytes(data)
    pixels = read_pixels(tmp_path / "image")
    return (pixels.values.astype(float) * 255 / pixels.most).round(3).tolist()


def grey():
    return Image.fromarray(GREYS)


def palette():
    image = Image.fromarray(np.arange(6, dtype=np.uint8).reshape(2, 3))
    image.putpalette([value for value in GREYS.ravel().tolist() for _ in range(3)])
    return image


@pytest.mark.parametrize(
    "data",
    [
        save(grey(), "PPM"),
        save(grey(), "PNG"),
        save(grey(), "BMP"),
        save(grey(), "TIFF"),
        save(grey(), "GIF"),
        save(grey().convert("RGB"), "PNG"),
        save(grey().convert("RGB"), "BMP"),
        save(grey().convert("RGB"), "PPM"),
        save(grey().convert("LA"), "PNG"),
        save(grey().convert("RGBA"), "PNG"),
        save(palette(), "PNG"),
        save(palette(), "GIF"),
        save(Image.fromarray(GREYS.astype(np.uint16) * 257), "PNG"),
        b"P2 3 2 255 0 60 128 200 254 255",
        b"P2\n# drawn by hand\n3 2 # wide, high\n255\n0 60 # dark\n128#\n200 254\t255 # white\n7 7",
        b"P5 3 2 65535\n" + (GREYS.astype(">u2") * 257).tobytes(),
        b"P2 3 2 65535\n" + b" ".join(b"%d" % (257 * value) for value in GREYS.ravel().tolist()),
        b"P5\r\n3\t2\n#\n#\n 255\n" + GREYS.tobytes() + b"more",
        b"P5 000003 2 255#!\n" + GREYS.tobytes(),
    ],
)
def test_one_image_in_many_formats(tmp_path, data):
    assert lightness(tmp_path, data) == GREYS.tolist()


def test_a_jpg_is_read_as_nearly_the_same(tmp_path):
    big = grey().resize((96, 64), Image.Resampling.NEAREST)
    found = lightness(tmp_path, save(big, "JPEG", quality=95))
    assert np.abs(np.array(found)[::32, ::32] - GREYS).max() < 6
    assert np.abs(np.array(lightness(tmp_path, save(big.convert("CMYK"), "JPEG")))[16::32, 16::32] - GREYS).max() < 12


@pytest.mark.parametrize("name", ["PNG", "BMP", "PPM"])
def test_an_image_of_one_bit_is_black_and_white(tmp_path, name):
    image = Image.fromarray(np.array([[True, False, True]]))
    assert lightness(tmp_path, save(image, name)) == [[255, 0, 255]]


def test_colours_count_by_their_mean(tmp_path):
    image = Image.fromarray(np.array([[[30, 60, 91], [255, 0, 0]]], dtype=np.uint8))
    assert lightness(tmp_path, save(image, "PNG")) == [[60.333, 85.0]]


@pytest.mark.parametrize("mode", ["LA", "RGBA"])
def test_transparency_is_told_apart(tmp_path, mode):
    image = grey().convert(mode)
    image.putalpha(Image.fromarray(GREYS[::-1]))
    (tmp_path / "a.png").write_bytes(save(image, "PNG"))
    assert read_pixels(tmp_path / "a.png").alpha.tolist() == GREYS[::-1].tolist()


def test_a_transparent_colour_of_a_palette_is_transparent(tmp_path):
    (tmp_path / "a.png").write_bytes(save(palette(), "PNG", transparency=1))
    assert read_pixels(tmp_path / "a.png").alpha.tolist() == [[255, 0, 255], [255, 255, 255]]


def test_an_opaque_image_has_no_transparency(tmp_path):
    (tmp_path / "a.png").write_bytes(save(grey(), "PNG"))
    assert read_pixels(tmp_path / "a.png").alpha is None


GOOD = save(grey(), "PNG")
LONG = b" " * 20_000_000


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "it is no image that can be read"),
        (b"PSD is another format", "it is no image that can be read"),
        (b"P5 2 2", "the header of a PGM is not complete within its first 65,536 bytes"),
        (b"P5" + LONG + b"2 2 255\n0000", "the header of a PGM is not complete within its first 65,536 bytes"),
        (b"P2\n" + LONG.replace(b" ", b"#\n"), "the header of a PGM is not complete within its first 65,536 bytes"),
        (b"P5\n-2 -2\n255\n0000", "the header of a PGM has three whole numbers: width, height and the value of white"),
        (
            b"P5\n2 2\n" + b"9" * 5000 + b"\n",
            "the header of a PGM has three whole numbers: width, height and the value",
        ),
        (b"P5\n2 2\n0\n0000", "the value of white is 0; 1 to 65535 are allowed"),
        (b"P5\n2 2\n65536\n0000", "the value of white is 65536; 1 to 65535 are allowed"),
        (b"P5\n2 2\n255\n\x00", "the image is cut short: it has 1 of 4 values"),
        (b"P5\n2 2\n65535\n0000000", "the image is cut short: it has 3 of 4 values"),
        (b"P5\n2 2\n255\n", "the image is cut short: it has 0 of 4 values"),
        (b"P2\n2 2\n255\n0 0 0", "the image is cut short: it has 3 of 4 values"),
        (b"P2\n2 2\n255\n # nothing", "the image is cut short: it has 0 of 4 values"),
        (b"P2\n2 2\n10\n0 0 0 11", "it has the value 11, but its header allows at most 10"),
        (b"P5\n1 1\n10\n\x0b", "it has the value 11, but its header allows at most 10"),
        (b"P2\n2 2\n255\n0 0 0 1%022d" % 0, "it has a value of ten digits or more; 0 to 255 are allowed"),
        (b"P2\n2 2\n255\n0 0 -1 0", "it has '-1' among its values; 0 to 255 are allowed"),
        (b"P2\n1 1\n255\nblack", "it has 'black' among its values; 0 to 255 are allowed"),
        (b"P2\n1 1\n255\n\xff\xff", "it has '\\xff\\xff' among its values; 0 to 255 are allowed"),
        (
            b"P5\n100000 100000\n255\n",
            "100000 x 100000 pixels is no size for a map; 1 to 64,000,000 pixels are allowed",
        ),
        (b"P5\n0 3\n255\n", "0 x 3 pixels is no size for a map"),
        (GOOD[:20], "the image is cut short or damaged"),
        (GOOD[:-26], "the image is cut short or damaged"),
        (GOOD[:8] + GOOD[33:], "it is no image that can be read"),
        (GOOD.replace(zlib.compress(b""), b"")[:45] + b"\x00" * 40, "the image is cut short or damaged"),
        (b"P6 20000 20000 255\n", "it has more than 64,000,000 pixels"),
        (b"P6 8000 9000 255\n", "8000 x 9000 pixels is no size for a map"),
        (
            save(Image.fromarray(GREYS.astype(np.float32)), "TIFF"),
            "it has more than 16 bits for a pixel; save it with 8",
        ),
    ],
    ids=range(29),
)
def test_a_broken_image_is_refused_with_what_is_supported(tmp_path, data, why):
    path = tmp_path / "broken.png"
    path.write_bytes(data)
    with pytest.raises(PipelineError) as caught:
        read_pixels(path)
    assert str(caught.value).startswith(f"{path}: {why}")
    assert str(caught.value).endswith(". Maps are PGM, PNG, BMP, JPG, GIF, TIFF or PPM images.")


def test_a_file_that_is_too_large_is_not_read(tmp_path, monkeypatch):
    monkeypatch.setattr(images, "MOST_BYTES", 10)
    path = tmp_path / "large.pgm"
    path.write_bytes(b"P5 1 1 255\n0")
    with pytest.raises(PipelineError, match=re.escape(f"{path}: it has 12 bytes; 10 are allowed. Maps are ")):
        read_pixels(path)


def test_a_file_that_cannot_be_read(tmp_path):
    with pytest.raises(PipelineError, match="cannot be read: Is a directory"):
        read_pixels(tmp_path)


def test_only_other_formats_than_pgm_need_pillow(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "PIL", None)
    assert lightness(tmp_path, b"P2 1 1 255 7") == [[7]]
    with pytest.raises(PipelineError) as caught:
        lightness(tmp_path, GOOD)
    assert str(caught.value) == (
        f"{tmp_path / 'image'}: a map that is no PGM needs Pillow; install it with: pip install "
        "'tutorstudent[bullet]', or save the map as PGM."
    )
