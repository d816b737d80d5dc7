"""Contacts from sub-step to sub-step: new ones, and which robot touched a thing last."""

from __future__ import annotations

Pair = tuple[int, int]
Touches = tuple[tuple[Pair, ...], ...]


class Contacts:
    """Memory of contacts. It follows only what rules ask for.

    Attributes:
        fresh: pairs that came into contact in this tick, the smaller index first, in order.
        used: whether any rule asks for contacts.
    """

    def __init__(self, robots: int) -> None:
        self.fresh: list[Pair] = []
        self.used = False
        self._robots = robots
        self._touching: frozenset[Pair] = frozenset()
        self._last: dict[int, int | None] = {}

    @property
    def touching(self) -> frozenset[Pair]:
        """The pairs that touch at the end of this tick."""
        return self._touching

    def follow_last(self, entity: int) -> None:
        """Remember from now on which robot touched the entity last."""
        self.used = True
        self._last.setdefault(entity, None)

    def last(self, entity: int) -> int | None:
        """Return the index of the robot that touched the entity last since it was put where it is, or None."""
        return self._last[entity]

    def advance(self, touches: Touches) -> None:
        """Go through the sub-steps of a tick."""
        self.fresh.clear()
        for pairs in touches:
            if not pairs and not self._touching:
                continue
            now = frozenset(pairs)
            new = [pair for pair in dict.fromkeys(pairs) if pair not in self._touching]
            self.fresh += new
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
        for entity in entities:
            if entity in self._last:
                self._last[entity] = None
