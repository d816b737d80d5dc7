"""All programs of one half."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from contextlib import suppress
from typing import Self

from rcj_challenges.core.temporary_folder import temporary_folder_error
from rcj_challenges.core.traffic import Observation, RobotSpec
from rcj_challenges.programs import scratch
from rcj_challenges.programs.isolation import active_layers
from rcj_challenges.programs.plan import PoolPlan
from rcj_challenges.programs.private_folders import PrivateFolders, remove_left_overs_once
from rcj_challenges.programs.program import CLEAN_UP_S, Program, Sharing
from rcj_challenges.programs.timed_channel import WaitBudget
from rcj_challenges.submissions.team import Team

__all__ = ["PoolPlan", "ProgramPool"]

_MAX_HELD_UP = 4
"""A half may wait this many times as long as all its programs may be charged together, because others may have the
processors."""


class ProgramPool:
    """The programs of one half, by the robot's name; a context manager, after which none of them exists any more."""

    def __init__(self, plan: PoolPlan) -> None:
        """Prepare a half without programs.

        Raises:
            RcjError: the plan requires layers that are missing here.
        """
        self._plan = plan
        active_layers(plan.sandbox)  # refuses what cannot be had
        self.programs: dict[str, Program] = {}
        self._folders: PrivateFolders | None = None

    def add(self, spec: RobotSpec, team: Team, entry: str) -> Program:
        """Add a robot's program, the file ``entry`` of the team (`Team.entries`); `launch` starts it."""
        program = self.programs[spec.name] = Program(spec, team, entry, self._plan)
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
        except OSError as error:
            raise temporary_folder_error(error) from error
        limits = self._plan.limits
        max_wait_s = _MAX_HELD_UP * (limits.start_s + len(self.programs) * limits.half_s)
        budget = WaitBudget(math.inf if self._plan.debug else max_wait_s)
        sharing = Sharing(place, share_bytes, tuple(self.programs.values()), budget)
        for program in sharing.programs:
            program.launch(sharing)
        remove_left_overs_once()

    def finish(self, last: Mapping[str, Observation]) -> None:
        """Let the last ``step`` of programs return, give them about 1 s together to clean up, then end all.

        ``last`` has, by robot, the observation with which ``step`` returns -1.
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
