"""What a terminal cannot show is said with what it can."""

from __future__ import annotations

import io

import pytest

from rcj_challenges.core.letters import READABLE


@pytest.mark.parametrize(
    ("text", "encoding", "said"),
    [
        ("→ turn by 90° … ≥ 2", "ascii", "-> turn by 90 degrees ... >= 2"),
        ("→ turn by 90°", "cp1252", "-> turn by 90°"),
        ("ボール ö → x", "cp1252", "??? ö -> x"),
        ("→ ö", "utf-8", "→ ö"),
    ],
)
def test_signs_that_an_encoding_lacks_are_written_in_plain_letters(text: str, encoding: str, said: str) -> None:
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding=encoding, errors=READABLE)
    stream.write(text)
    stream.flush()
    assert raw.getvalue().decode(encoding) == said


def test_reading_is_not_its_business() -> None:
    with pytest.raises(UnicodeDecodeError):
        b"\xff".decode("ascii", READABLE)
