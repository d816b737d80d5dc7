"""Contacts from sub-step to sub-step: new ones, and which robot touched a thing last."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from rcj_challenges.core.timing import SUBSTEP_S

Pair = tuple[int, int]
Touches = tuple[tuple[Pair, ...], ...]


NEVER_TOUCHED = 1 << 62
APART_S = 0.2
"""A contact that is interrupted for less is one contact: a robot that slides along a wall hops off and on."""


def substeps_apart(apart_s: float) -> int:
    """Return after how many sub-steps since the last one of a contact another contact is a new one."""
    return math.ceil(round(apart_s / SUBSTEP_S, 6))


class Contacts:
    """Memory of contacts. It follows only what rules ask for.

    Attributes:
        fresh: pairs that came into contact in this tick, the smaller index first, in order, each with the number of
            sub-steps that it was apart; `NEVER_TOUCHED` if it had not touched before.
        used: whether any rule asks for contacts.
    """

    def __init__(self, robots: int) -> None:
        self.fresh: list[tuple[Pair, int]] = []
        self.used = False
        self._robots = robots
        self._touching: frozenset[Pair] = frozenset()
        self._now = 0
        self._parted: dict[Pair, int] = {}
        self._last: dict[int, int | None] = {}

    def is_one_contact(self, pair: Pair, apart: int) -> bool:
        """Return whether a pair touches, or has been apart for fewer than so many sub-steps."""
        return pair in self._touching or self._now - self._parted.get(pair, -NEVER_TOUCHED) < apart

    def follow_last(self, entity: int) -> Callable[[], int | None]:
        """Return a function that reads which robot touched the entity last since it was put where it is; None: none."""
        self.used = True
        self._last.setdefault(entity, None)
        return partial(self._last.__getitem__, entity)

    def advance(self, touches: Touches) -> None:
        """Go through the sub-steps of a tick."""
        self.fresh.clear()
        for pairs in touches:
            self._now += 1
            if not pairs and not self._touching:
                continue
            now = frozenset(pairs)
            new = [pair for pair in dict.fromkeys(pairs) if pair not in self._touching]
            for pair in new:
                self.fresh.append((pair, self._now - self._parted.pop(pair, -NEVER_TOUCHED)))
            for pair in self._touching - now:
                self._parted[pair] = self._now - 1
            for entity in self._last:
                self._remember(entity, now, new)
            self._touching = now

    def _remember(self, entity: int, now: frozenset[Pair], new: list[Pair]) -> None:
        """A new contact counts before one that goes on; of several at once the first robot's."""
        came = self._robots_at(entity, new)
        if came:
            self._last[entity] = min(came)
            return
        staying = self._robots_at(entity, now)
        if staying and self._last[entity] not in staying:
            self._last[entity] = min(staying)

    def _robots_at(self, entity: int, pairs: frozenset[Pair] | list[Pair]) -> set[int]:
        others = {a if b == entity else b for a, b in pairs if entity in {a, b}}
        return {other for other in others if other < self._robots}

    def forget(self, entities: set[int]) -> None:
        """Forget the contacts of entities that were put elsewhere or taken off."""
        self._touching = frozenset(pair for pair in self._touching if entities.isdisjoint(pair))
        self._parted = {pair: last for pair, last in self._parted.items() if entities.isdisjoint(pair)}
        for entity in entities:
            if entity in self._last:
                self._last[entity] = None
