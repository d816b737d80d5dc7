"""Which program drives which robot, and under what conditions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.core.traffic import RobotSpec
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.submissions.team import Team


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


@dataclass(frozen=True)
class Assignment:
    """A program and its robot; ``entry`` is its path inside the team's folder, from `Team.entries`."""

    spec: RobotSpec
    team: Team
    entry: str
    plan: PoolPlan

    @property
    def is_debugged(self) -> bool:
        """Whether it has the terminal and no limits."""
        return self.spec.name in self.plan.debug
