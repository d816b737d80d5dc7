"""Held robots: all of them by a phase, single ones by rules, until a time or until a rule releases them."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf


class Held:
    """Which robots are held, by the phase or by rules, independently of each other.

    Attributes:
        by_rules: indices of the robots that rules hold; another object only when that changes.
        ends: the earliest tick at which a hold is over.
    """

    def __init__(self) -> None:
        self.by_phase = False
        self.by_rules: frozenset[int] = frozenset()
        self.ends: float = inf
        self._until: dict[int, float] = {}

    def holds(self, robot: int) -> bool:
        """Return whether a robot is held, by a phase or by a rule."""
        return self.by_phase or robot in self.by_rules

    def hold(self, robots: Iterable[int], until: float) -> None:
        """Hold robots until a tick, or for ever (``inf``); a robot that is held for longer stays so."""
        for robot in robots:
            self._until[robot] = max(until, self._until.get(robot, until))
        self._changed()

    def release(self, robots: Iterable[int]) -> frozenset[int]:
        """Let robots go that rules hold; returns those that were held."""
        freed = self.by_rules.intersection(robots)
        for robot in freed:
            del self._until[robot]
        self._changed()
        return freed

    def let_go_at(self, tick: int) -> frozenset[int]:
        """Let those go whose time is over at a tick, and return them."""
        return self.release([robot for robot, until in self._until.items() if tick >= until])

    def _changed(self) -> None:
        if self._until.keys() != self.by_rules:
            self.by_rules = frozenset(self._until)
        self.ends = min(self._until.values(), default=inf)
