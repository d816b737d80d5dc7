"""Which program drives which robot, and under what conditions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.controllers.team import Team
from rcj_challenges.core.traffic import RobotSpec
from rcj_challenges.scenario.models.limits import Limits


@dataclass(frozen=True)
class Assignment:
    """Which program drives which robot, and under what conditions.

    Attributes:
        spec: the robot as its program will see it.
        team: whose program it is.
        entry: its path inside the team's folder.
        limits: what it may use.
        half: 1-based.
        match_seed: its randomness derives from it.
        log_path: where its output goes; appended to.
        sandbox: ``auto``, ``strict`` or ``off``.
        debug: True gives it the terminal and takes away the limits.
        portable: True exchanges messages in the way that works everywhere; None decides by platform.
    """

    spec: RobotSpec
    team: Team
    entry: str
    limits: Limits
    half: int
    match_seed: int
    log_path: Path
    sandbox: str = "auto"
    debug: bool = False
    portable: bool | None = None
