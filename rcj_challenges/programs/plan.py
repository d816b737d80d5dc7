"""Under what conditions the programs of a half run."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.scenario.models.limits import Limits


@dataclass(frozen=True)
class PoolPlan:
    """The conditions of all programs of a half.

    Attributes:
        match_seed: their randomness derives from it.
        logs: folder of ``<robot>.log``; made if it is not there.
        sandbox: ``auto``, ``strict`` or ``off``.
        debug: robots whose program has the terminal, without limits.
        portable: True exchanges messages in the way that works everywhere; None decides by platform.
    """

    limits: Limits
    half: int
    match_seed: int
    logs: Path
    sandbox: str = "auto"
    debug: frozenset[str] = frozenset()
    portable: bool | None = None
