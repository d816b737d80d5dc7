"""Chance in a tournament: seeds of fixtures, draws and lots, all derived from the tournament's seed."""

from __future__ import annotations

import hashlib
import random
from collections.abc import Sequence


def derived_seed(seed: int | str, use: str) -> int:
    """Return the 32-bit seed for one use, such as a fixture's id: the first bytes of SHA-256 over both."""
    return int.from_bytes(_digest(seed, use)[:4], "big")


def lot(seed: int | str, use: str, name: str) -> bytes:
    """Return a lot; the smallest wins. It does not depend on the other teams."""
    return _digest(seed, f"{use}/{name}")


def shuffled(seed: int | str, use: str, names: Sequence[str]) -> list[str]:
    """Return names in the order of a draw."""
    order = list(names)
    random.Random(_digest(seed, use)).shuffle(order)  # noqa: S311 - a reproducible draw, not a secret
    return order


def seed_hash(seed: int | str) -> str:
    """Return the hash that commits an organizer to a seed: published before, compared after."""
    return hashlib.sha256(str(seed).encode()).hexdigest()


def _digest(seed: int | str, use: str) -> bytes:
    return hashlib.sha256(f"{seed}/{use}".encode()).digest()
