"""Extrapolates what programs print and write in a short match to a whole half."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rcj_challenges.controllers import scratch
from rcj_challenges.controllers.team import Team
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.scenario.models.limits import Limits

EVERY_TICKS = 32
"""How often amounts are noted: walking through a folder is slow."""


@dataclass
class Growth:
    """A growing amount, sampled now and then.

    Attributes:
        noted: ticks and bytes, in order.
    """

    noted: list[tuple[int, int]] = field(default_factory=list)

    def note(self, tick: int, total_bytes: int) -> None:
        """Record the current amount."""
        self.noted.append((tick, total_bytes))

    @property
    def total_bytes(self) -> int:
        """The last amount."""
        return self.noted[-1][1] if self.noted else 0

    @property
    def total_s(self) -> float:
        """After how many s it was noted the last time."""
        return s_from_ticks(self.noted[-1][0]) if self.noted else 0.0

    def at_bytes(self, tick: int) -> float:
        """Extrapolate the amount to a later tick, from the growth since the middle of the samples.

        What a program writes once when it starts does not count again.
        """
        last_tick, last_bytes = self.noted[-1] if self.noted else (0, 0)
        return last_bytes + self._bytes_per_tick() * max(0, tick - last_tick)

    def reaches_s(self, limit_bytes: float) -> float:
        """Return after how many s it would exceed a limit that it reaches."""
        last_tick, last_bytes = self.noted[-1]
        rate = self._bytes_per_tick()
        return s_from_ticks(last_tick + (round((limit_bytes - last_bytes) / rate) if rate else 0))

    def _bytes_per_tick(self) -> float:
        if len(self.noted) < 2:  # two points make a line
            return 0.0
        last_tick, last_bytes = self.noted[-1]
        tick, then_bytes = next((noted for noted in self.noted[:-1] if 2 * noted[0] >= last_tick), self.noted[-2])
        return max(0, last_bytes - then_bytes) / (last_tick - tick)


class FollowedTeam(Team):
    """A team that records where the private folders of its programs are."""

    def __init__(self, team: Team) -> None:
        """Be the same team, with the same files in memory."""
        self.__dict__.update(team.__dict__)
        self._folders: list[Path] = []

    def unpack(self, folder: Path) -> None:
        """Write a copy of the team's files, and record where."""
        super().unpack(folder)
        self._folders.append(folder.parent)

    def written_bytes(self, robot: str, limits: Limits) -> int:
        """Return how much a robot's program has in its folder beside the team's files, counted as a match does.

        Args:
            robot: its name; a program that is gone has nothing.
            limits: counting ends where they are exceeded.
        """
        folders = [folder for folder in self._folders if folder.name.startswith(f"rcj-{robot}-")]
        own_bytes = self.size_bytes()
        limit_bytes = limits.scratch_mb * 1_000_000 + own_bytes
        if not folders:
            return 0
        # The match handles unreadable files: it ends such a program.
        return max(0, int(min(scratch.bytes_below(folders[-1], limit_bytes), limit_bytes)) - own_bytes)


class Amounts:
    """What the programs of some robots have printed and written.

    Attributes:
        printed: by robot.
        written: by robot, into its own folder.
    """

    def __init__(self, robots: Sequence[str], team: FollowedTeam, limits: Limits) -> None:
        self.printed = {robot: Growth() for robot in robots}
        self.written = {robot: Growth() for robot in robots}
        self._so_far = dict.fromkeys(robots, 0)
        self._team, self._limits = team, limits

    def said(self, robot: str, text: str) -> None:
        """Record what a program printed."""
        if robot in self._so_far:
            self._so_far[robot] += len(text.encode("utf-8", "replace"))

    def ticked(self, tick: int) -> None:
        """Record all amounts, if it is time."""
        if tick % EVERY_TICKS != 1:  # just after a match has passed on what was printed, which it does every 16 ticks
            return
        for robot, so_far_bytes in self._so_far.items():
            self.printed[robot].note(tick, so_far_bytes)
            self.written[robot].note(tick, self._team.written_bytes(robot, self._limits))
