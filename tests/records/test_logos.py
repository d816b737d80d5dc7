"""A team's logo is shown only if it is a PNG of a sensible size, and only what showing it needs."""

import struct
import zlib
from pathlib import PurePosixPath

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.records.logos import MAX_LOGO_BYTES, MAX_LOGO_SIDE, LogoError, checked_png, logo_of
from tests.hostile.archives.pictures import PNG, chunk


def png(
    width: int = 4, height: int = 3, *, colour: int = 6, depth: int = 8, interlace: int = 0,
    pixels: bytes | None = None, before: bytes = b"", after: bytes = b"",
) -> bytes:  # fmt: skip
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    lines = b"".join(b"\0" + b"\x40" * ((width * channels * depth + 7) // 8) for _ in range(height))
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, interlace)
    palette = chunk(b"PLTE", bytes(6)) if colour == 3 else b""
    data = chunk(b"IDAT", zlib.compress(lines if pixels is None else pixels))
    return PNG + chunk(b"IHDR", header) + before + palette + data + chunk(b"IEND") + after


@pytest.mark.parametrize(("colour", "depth"), [(0, 1), (0, 16), (2, 8), (3, 4), (4, 8), (6, 16)])
def test_a_logo_of_any_kind_of_png_is_kept_as_it_is(colour: int, depth: int) -> None:
    logo = png(colour=colour, depth=depth)
    assert checked_png(logo) == logo


def test_an_interlaced_logo_is_kept() -> None:
    # 8 x 8 pixels of one byte in seven passes: 1x1, 1x1, 2x1, 2x2, 4x2, 4x4, 8x4 and a byte for each line.
    passes = ((1, 1), (1, 1), (2, 1), (2, 2), (4, 2), (4, 4), (8, 4))
    pixels = b"".join(bytes(1 + width) for width, height in passes for _ in range(height))
    logo = png(8, 8, colour=0, interlace=1, pixels=pixels)
    assert checked_png(logo) == logo


def test_text_animation_and_what_stands_behind_the_end_are_left_out() -> None:
    extra = chunk(b"tEXt", b"Comment\0<script>alert(1)</script>") + chunk(b"acTL", bytes(8))
    assert checked_png(png(before=extra, after=b"<script>")) == png()


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"\xff\xd8\xff\xe0JFIF", "a JPEG"),
        (b"GIF89a", "a GIF"),
        (b"BMxxxx", "a BMP"),
        (b"<svg onload='alert(1)'>", "no PNG"),
        (b"", "no PNG"),
        (png(MAX_LOGO_SIDE + 1, 1), "1025 x 1 pixels"),
        (png(0, 1), "0 x 1 pixels"),
        (png()[:-1], "damaged"),
        (png()[:40], "damaged"),
        (png(pixels=b"\0" * 10), "other pixels"),
        (png(pixels=b"\0" * 10_000_000), "other pixels"),
        (png(before=chunk(b"IDAT", b"x")), "unpacked"),
        (png(colour=6, depth=1), "what no PNG has"),
        (PNG + chunk(b"IEND"), "out of order"),
        (PNG + chunk(b"IDAT") + png()[8:], "out of order"),
        (PNG + bytes(MAX_LOGO_BYTES), "MB, more than 1"),
    ],
)
def test_what_is_no_logo_is_refused_with_the_reason(data: bytes, says: str) -> None:
    with pytest.raises(LogoError, match=says):
        checked_png(data)


@given(place=st.integers(0, 200), byte=st.integers(0, 255), cut=st.integers(0, 200))
def test_a_damaged_logo_is_refused_or_shown_never_a_crash(place: int, byte: int, cut: int) -> None:
    data = bytearray(png())
    data[place % len(data)] = byte
    damaged = bytes(data[: max(0, len(data) - cut % 3 * cut)])
    try:
        assert checked_png(damaged) == png()
    except LogoError as error:
        assert str(error).startswith("it ")  # noqa: PT017 - either is right


def test_the_logo_nearest_to_the_top_of_a_submission_is_the_teams() -> None:
    files = {
        PurePosixPath("robot1/logo.png"): b"inner",
        PurePosixPath("Logo.PNG"): b"outer",
        PurePosixPath("a.py"): b"",
    }
    assert logo_of(files) == b"outer"
    assert logo_of({PurePosixPath("a.py"): b""}) is None
    assert logo_of({PurePosixPath("logo.png"): bytes(MAX_LOGO_BYTES + 1)}) is None
