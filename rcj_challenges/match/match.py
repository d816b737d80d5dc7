"""A whole match: halves one after the other, each with a fresh world and fresh processes."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rcj_challenges.controllers.crew import Crew
from rcj_challenges.controllers.team import Team
from rcj_challenges.devices.rack import DeviceRack
from rcj_challenges.facts.play import Event, Fault, HalfInfo, Snapshot, Verdict
from rcj_challenges.facts.timing import TICK_S, ticks_from_s
from rcj_challenges.match.half import HalfOutcome, HalfPlay, HalfStage
from rcj_challenges.match.seats import by_seat, by_team, teams_by_seat
from rcj_challenges.match.watching import Progress, Silent, Watcher
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.world.world import World


@dataclass(frozen=True)
class MatchPlan:
    """All that decides a match, and where its record goes.

    Attributes:
        loaded: the scenario.
        teams: by seat of the first half.
        team_names: as shown and logged, by seat of the first half.
        seed: of everything that chance decides.
        match_id: as printed in MATCH_START.
        out: the folder in which the record's folder is made.
        sandbox: ``auto``, ``strict`` or ``off``.
        real_time: True delays the loop to the pace of the clock; it changes nothing else.
        show_output: robots whose output is shown while they play.
        debug: robots whose program has the terminal, without limits.
    """

    loaded: Loaded
    teams: Mapping[str, Team]
    team_names: Mapping[str, str]
    seed: int = 1
    match_id: int = 0
    out: Path = Path("runs")
    sandbox: str = "auto"
    real_time: bool = False
    show_output: frozenset[str] = frozenset()
    debug: frozenset[str] = field(default_factory=frozenset)
