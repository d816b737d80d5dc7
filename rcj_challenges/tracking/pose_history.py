"""Judged poses of the past, for words that measure over a window of time."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2


class PoseHistory:
    """Judged poses of the last ticks, as far back as the longest window asks.

    Attributes:
        first: the tick of the oldest pose kept.
        poses: ``[tick - first][entity]``.
    """

    def __init__(self) -> None:
        self.first = 0
        self.poses: list[list[Pose2]] = []
        self._needed = 0

    def need(self, ticks: int) -> None:
        """Ask for at least this many ticks of the past."""
        self._needed = max(self._needed, ticks)

    @property
    def used(self) -> bool:
        """Whether any word needs the past."""
        return self._needed > 0

    def add(self, poses: list[Pose2]) -> None:
        """Add the judged poses of a tick."""
        kept = self.poses
        kept.append(poses)
        if len(kept) > 2 * self._needed + 2:
            gone = len(kept) - self._needed - 1
            del kept[:gone]
            self.first += gone

    def of(self, entity: int, from_tick: int, to_tick: int) -> list[Pose2]:
        """Return the entity's judged poses of the ticks from ``from_tick`` to ``to_tick``, both included."""
        return [poses[entity] for poses in self.poses[from_tick - self.first : to_tick + 1 - self.first]]
