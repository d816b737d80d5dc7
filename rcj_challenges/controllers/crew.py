"""All programs of one half."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from rcj_challenges.controllers import scratch
from rcj_challenges.controllers.assignment import Assignment
from rcj_challenges.controllers.isolation import active_layers
from rcj_challenges.controllers.private_folders import PrivateFolders, remove_left_overs_once, temporary_folder_error
from rcj_challenges.controllers.program import CLEAN_UP_S, Program
from rcj_challenges.controllers.sharing import Sharing
from rcj_challenges.controllers.team import Team
from rcj_challenges.controllers.timed_channel import WaitBudget
from rcj_challenges.core.traffic import Observation, RobotSpec
from rcj_challenges.scenario.models.limits import Limits

_MAX_HELD_UP = 4
"""A half may wait this many times as long as all its programs may be charged together, because others may have the
processors."""


@dataclass(frozen=True)
class CrewPlan:
    """What all programs of a half have in common.

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


class Crew:
    """The programs of one half; a context manager, after which none of them exists any more.

    Attributes:
        programs: by the robot's name, in the order in which they were added.
    """

    def __init__(self, plan: CrewPlan) -> None:
        """Prepare a half without programs.

        Raises:
            IsolationError: the plan requires layers that are missing here.
        """
        self._plan = plan
        active_layers(plan.sandbox)  # refuses what cannot be had
        self.programs: dict[str, Program] = {}
        self._folders: PrivateFolders | None = None

    def add(self, spec: RobotSpec, team: Team, entry: str) -> Program:
        """Add a robot's program; `launch` starts it.

        Args:
            spec: the robot as its program will see it.
            team: whose program it is.
            entry: its path inside the team's folder, from `Team.entry_for`.
        """
        plan = self._plan
        program = Program(
            Assignment(
                spec=spec,
                team=team,
                entry=entry,
                limits=plan.limits,
                half=plan.half,
                match_seed=plan.match_seed,
                log_path=plan.logs / f"{spec.name}.log",
                sandbox=plan.sandbox,
                debug=spec.name in plan.debug,
                portable=plan.portable,
            )
        )
        self.programs[spec.name] = program
        return program

    def launch(self) -> None:
        """Start all programs; they run to their first ``step`` side by side.

        Meanwhile the leftovers of killed matches are removed.

        Raises:
            OSError: a log cannot be written.
            HostError: no folder can be made for the programs, or this computer cannot start one more.
        """
        try:
            self._folders = PrivateFolders()
            place = self._folders.place
            share_bytes = scratch.share_bytes(place, len(self.programs))
            sharing = Sharing(place, share_bytes, tuple(self.programs.values()), WaitBudget(self._max_wait_s()))
        except OSError as error:
            raise temporary_folder_error(error) from error
        for program in sharing.programs:
            program.launch(sharing)
        remove_left_overs_once()

    def _max_wait_s(self) -> float:
        """Return for how long this half may wait for programs, in s of wall time."""
        plan = self._plan
        charged_s = plan.limits.start_s + len(self.programs) * plan.limits.half_s
        return math.inf if plan.debug else _MAX_HELD_UP * charged_s

    def finish(self, last: Mapping[str, Observation]) -> None:
        """Tell programs that the match is over, give them about 1 s together to clean up, then end all.

        Args:
            last: by the robot's name, the observation with which its ``step`` returns -1.
        """
        for name, observation in last.items():
            self.programs[name].finish(observation)
        until = time.perf_counter() + CLEAN_UP_S
        for name in last:
            self.programs[name].wait_until(until)
        self.close()

    def close(self) -> None:
        """End all programs and remove their folders. Can be called again."""
        for program in self.programs.values():
            with suppress(OSError):
                program.kill()
        for program in self.programs.values():
            program.close()
        if self._folders is not None:
            self._folders.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
