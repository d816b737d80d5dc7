"""The trigger ``no_progress``."""

from bisect import bisect_right
from collections.abc import Callable
from itertools import accumulate, pairwise
from math import inf, sqrt
from typing import Annotated, Literal

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.fields import DurationS, Names, described
from rcj_challenges.rules.phrasing import metres, seconds
from rcj_challenges.rules.refs import ENTITIES
from rcj_challenges.rules.values import Limit, compile_limit, limit_words
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import NEVER, DueTracker


class NoProgress(Trigger):
    """Fires when an entity's path within a sliding window is too short, but only once the window is full.

    A robot that a rule holds (action `hold`) is not judged meanwhile; its window begins when it is let go.
    """

    trigger: Literal["no_progress"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    distance_m: Limit = described(..., "expected path length in m, read when the window begins after a placement")
    within_s: DurationS = described(..., "length of the window in s; for a held robot, the window starts on release")

    MEASURED = "the length in m of its path"
    MUST_EXCEED = True
    LIMIT = "distance_m"
    REASON = "made no progress: {measured} m in {within_s:g} s, at least {limit} m"
    EXAMPLE = """
rules:
  stuck:
    triggers: [{trigger: no_progress, entity: ball, distance_m: 0.5, within_s: 10}]
    actions: [{action: emit, event: STUCK}]
expect:
  the_window_must_be_full_first:
    keyframes: [{at_s: 1}]
    lasts_s: 12
    events: [{event: STUCK, at_s: 10.05}]
"""

    def bind(self, to: Binder) -> None:
        limit_m = compile_limit(self.distance_m, to, most=inf, none=0.0)
        for entity in to.entities(self.entity):
            key = (entity, self.within_s, self.distance_m)
            to.track(PathTracker, key, entity, self, limit_m).bindings.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        distance = limit_words(phrases, self.distance_m, metres, "m")
        way = f"less than {distance} in all over the last {seconds(self.within_s)}"
        return f"{phrases.any_of(self.entity)} has moved {way}"


class PathTracker(DueTracker):
    """Measures the path of an entity over a sliding window of path pieces between judged positions.

    The path is added up from the history only when the window could fall short: if the last pieces already reach the
    length that is asked for, nothing can happen until they slide out. So the usual tick costs nothing.

    The first judged position after a placement begins the path (the placed pose is not a judged one); a window of
    469 pieces is therefore full at the 470th tick after it. Who is held by a rule could not move: it is not judged
    meanwhile, and its path begins when it is let go.
    """

    def __init__(self, state: RefereeState, entity: int, model: NoProgress, limit_m: Callable[[], float]) -> None:
        super().__init__(state, entity)
        self._entity = entity
        self._read_length_m = limit_m
        self._length = 0.0
        self._pieces = ticks_from_s(model.within_s)
        self._paths: list[float] = [0.0]  # path up to each judged position since the start
        self._first = 0  # tick of the first of them
        self._short = False
        state.pose_history.need(self._pieces + 1)

    def reset(self) -> None:
        self._paths, self._length = [0.0], self._read_length_m()
        self._first = self._state.tick + 1
        self._short = False
        self.due = self._first + self._pieces if self._state.present[self._entity] else NEVER

    def release(self, robots: frozenset[int]) -> None:
        """Forget the path of one that could not move."""
        if self._entity in robots:
            self.reset()

    def update(self) -> None:
        """Measure the window, report when it falls short, and find when it could next."""
        if self._entity in self._state.held.by_rules:
            self.due = NEVER  # until it is let go
            return
        self._add_up()
        paths, tick = self._paths, self._state.tick
        path = paths[-1] - paths[-1 - self._pieces]
        was_short, self._short = self._short, path < self._length
        if self._short:
            if not was_short:
                self._hits.report(self.bindings, path, self._length)
            self.due = tick + 1
            return
        # If it stood still from now on: the first window whose beginning lies too near to its end. A nanometre
        # earlier, so that rounding can only make it look too early.
        begins = bisect_right(paths, paths[-1] - self._length - 1e-9, len(paths) - 1 - self._pieces)
        self.due = max(tick + 1, self._first + begins + self._pieces)

    def _add_up(self) -> None:
        paths = self._paths
        last = self._first + len(paths) - 1
        poses = self._state.pose_history.of(self._entity, last, self._state.tick)
        pieces = [sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay)) for (ax, ay, _), (bx, by, _) in pairwise(poses)]
        paths += accumulate(pieces, initial=paths.pop())
        gone = len(paths) - 2 * self._pieces
        if gone > self._pieces:
            del paths[:gone]
            self._first += gone
