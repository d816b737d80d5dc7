"""Which program drives which robot, under what conditions, and what the programs of a half share."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rcj_challenges.core.traffic import RobotSpec
from rcj_challenges.programs.timed_channel import WaitBudget
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.submissions.team import Team

if TYPE_CHECKING:
    from rcj_challenges.programs.program import Program


@dataclass(frozen=True)
class PoolPlan:
    """The conditions of all programs of a half.

    Attributes:
        limits: what each may use.
        half: 1-based.
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
    """A program and its robot.

    Attributes:
        spec: the robot as its program will see it.
        team: whose program it is.
        entry: its path inside the team's folder, from `Team.entry_for`.
        plan: its conditions.
    """

    spec: RobotSpec
    team: Team
    entry: str
    plan: PoolPlan

    @property
    def is_debugged(self) -> bool:
        """Whether it has the terminal and no limits."""
        return self.spec.name in self.plan.debug


@dataclass(frozen=True)
class Sharing:
    """How the programs of a half share the temporary folder, and the time of the match.

    Attributes:
        place: in the temporary folder, where each has its private folder.
        share_bytes: when it is full, programs that have written more than this have filled it.
        programs: all of them.
        wait_budget: of the match for all of them together.
    """

    place: Path
    share_bytes: float
    programs: tuple[Program, ...]
    wait_budget: WaitBudget
