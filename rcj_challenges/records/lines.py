"""JSON as records write it: one form everywhere, lossless for texts, and only numbers that are valid JSON."""

from __future__ import annotations

import json
import math
from typing import Any


def json_line(value: Any) -> bytes:
    r"""Return a value as one line of UTF-8 JSON that ends in ``\n``; keys keep their order.

    Text that UTF-8 cannot hold (half of a surrogate pair) is written as an escape, so nothing is lost.

    Raises:
        ValueError: the value holds NaN or an infinity; see `number_or_none`.
    """
    text = json.dumps(value, ensure_ascii=False, allow_nan=False)
    try:
        return text.encode() + b"\n"
    except UnicodeEncodeError:
        return json.dumps(value, allow_nan=False).encode() + b"\n"


def parsed(text: str | bytes) -> Any:
    """Parse JSON.

    Raises:
        ValueError: it is not JSON, or nested more deeply than records write it.
    """
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError("nested too deeply") from None


def canonical(value: Any) -> bytes:
    """Return a value as the bytes that digests are made of: ASCII JSON without spaces, keys in their own order.

    The order is kept because it decides results: rules are judged in the order of the file.
    """
    return json.dumps(value, separators=(",", ":"), allow_nan=False).encode("ascii")


def number_or_none(value: float | None) -> float | None:
    """Return a number that JSON can hold, else None (an infinite distance measures nothing)."""
    return value if value is not None and math.isfinite(value) else None
