"""Named random streams: one per use, derived from the match seed, so that adding one never shifts another.

Nothing in this project draws from a global generator. A stream is named by its use (``placement/…``,
``sensor/Y1/distancesensor left``, ``rule/…``) and by the half, and is the same on every machine.
"""

from __future__ import annotations

import hashlib
import random


def stream_seed(match_seed: int, name: str) -> int:
    """Return the 64-bit seed of the stream ``name`` of a match (SHA-256 over seed and name)."""
    digest = hashlib.sha256(f"{match_seed}/{name}".encode()).digest()
    return int.from_bytes(digest[:8], "little")


def random_stream(match_seed: int, name: str) -> random.Random:
    """Return a new generator for the use ``name``; two calls return two generators with equal draws."""
    return random.Random(stream_seed(match_seed, name))  # noqa: S311 - a reproducible draw, not a secret
