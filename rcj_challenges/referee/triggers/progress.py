"""The trigger no_progress: path length over a sliding window."""

from __future__ import annotations

from bisect import bisect_right
from functools import partial
from itertools import accumulate, pairwise
from math import sqrt

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.rules import Listener, StandingRule
from rcj_challenges.referee.watching import NEVER, DueWatch
from rcj_challenges.rules.triggers import NoProgress


def no_progress(model: NoProgress, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when the path of a full window falls short of a length."""
    for entity in workshop.entities(model.entity, rule.each):
        key = (entity, model.distance_m, model.within_s)
        watch = workshop.watch(PathWatch, key, rule, partial(PathWatch, entity, model, workshop))
        watch.listeners.append(workshop.listener(rule, position, model.trigger, entity))


class PathWatch(DueWatch):
    """Measures the path of an entity over a sliding window of path pieces between judged positions.

    The path is added up from the track only when the window could fall short: if the last pieces already reach the
    length that is asked for, nothing can happen until they slide out. So the usual tick costs nothing.

    The first judged position after a placement begins the path (the placed pose is not a judged one); a window of
    469 pieces is therefore full at the 470th tick after it. Who is held by a rule could not move: it is not judged
    meanwhile, and its path begins when it is let go.

    Attributes:
        listeners: ears.
    """

    def __init__(self, entity: int, model: NoProgress, workshop: Workshop) -> None:
        self.entities = (entity,)
        self.listeners: list[Listener] = []
        self._entity = entity
        self._length = model.distance_m
        self._pieces = ticks_from_s(model.within_s)
        self._state = workshop.state
        self._track = workshop.track
        self._hits = workshop.hits
        self._paths: list[float] = [0.0]  # path up to each judged position since the start
        self._first = 0  # tick of the first of them
        self._short = False
        workshop.track.need(self._pieces + 1)

    def restart(self) -> None:
        """Forget the path."""
        self._paths = [0.0]
        self._first = self._state.tick + 1
        self._short = False
        self.due = self._first + self._pieces if self._state.present[self._entity] else NEVER

    def let_go(self, robots: frozenset[int]) -> None:
        """Forget the path of one that could not move."""
        if self._entity in robots:
            self.restart()

    def look(self) -> None:
        """Measure the window, report when it falls short, and reckon when it could next."""
        if self._entity in self._state.held.by_rules:
            self.due = NEVER  # until it is let go
            return
        self._add_up()
        paths, tick = self._paths, self._state.tick
        path = paths[-1] - paths[-1 - self._pieces]
        was_short, self._short = self._short, path < self._length
        if self._short:
            if not was_short:
                self._hits.report(self.listeners, path, self._length)
            self.due = tick + 1
            return
        # If it stood still from now on: the first window whose beginning lies too near to its end. A nanometre
        # earlier, so that rounding can only make it look too early.
        begins = bisect_right(paths, paths[-1] - self._length - 1e-9, len(paths) - 1 - self._pieces)
        self.due = max(tick + 1, self._first + begins + self._pieces)

    def _add_up(self) -> None:
        paths = self._paths
        last = self._first + len(paths) - 1
        poses = self._track.of(self._entity, last, self._state.tick)
        pieces = [sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay)) for (ax, ay, _), (bx, by, _) in pairwise(poses)]
        paths += accumulate(pieces, initial=paths.pop())
        gone = len(paths) - 2 * self._pieces
        if gone > self._pieces:
            del paths[:gone]
            self._first += gone
