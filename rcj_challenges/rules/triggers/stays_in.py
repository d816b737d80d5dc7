"""The trigger ``stays_in``."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.core.play import Pose2
from rcj_challenges.core.timing import TICK_S, s_from_ticks, whole_ticks_within_s
from rcj_challenges.geometry.regions import Cell, Region
from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ENTITIES, ZONES
from rcj_challenges.rules.values import Lasts, Waits, compile_limit, duration_words
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import NEVER, DueTracker, PositionTracker


class StaysIn(Trigger):
    """Fires when an entity has been in a zone for longer than a time limit."""

    trigger: Literal["stays_in"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: in any of them"
    )
    limit_s: Lasts = described(..., "time in s, read when the stay begins; it fires as soon as the stay is longer")
    grace_s: Waits = described(0.0, "absences of up to this time, in s, count as inside")

    MEASURED = "the time in s of the stay"
    MUST_EXCEED = True
    LIMIT = "limit_s"
    REASON = "stayed for {measured} s, at most {limit} s"
    EXAMPLE = """
rules:
  waits_too_long:
    for_each: robots
    triggers: [{trigger: stays_in, entity: each, zone: penalty_areas, limit_s: 5, grace_s: 1}]
    actions: [{action: emit, event: TOO_LONG, payload: {robot_name: {word: robot_name}}}]
expect:
  an_absence_of_half_a_second_counts_as_inside:
    keyframes:
      - {at_s: 1, place: {Y1: [0, 0.65]}}
      - {at_s: 4, place: {Y1: [0, 0.5]}}
      - {at_s: 4.5, place: {Y1: [0, 0.65]}}
    lasts_s: 8
    events: [{event: TOO_LONG, at_s: 6.05, payload: {robot_name: Y1}}]
"""

    def bind(self, to: Binder) -> None:
        zones, region = to.members(self.zone), to.region(self.zone)
        limits = compile_limit(self.limit_s, to, TICK_S), compile_limit(self.grace_s, to, none=0.0)
        for entity in to.entities(self.entity):
            key = (entity, zones, self.limit_s, self.grace_s)
            tracker = to.track(StayTracker, key, entity, region, *limits)
            to.reset_with_draws(tracker, zones)
            tracker.bindings.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        grace = f" (leaving for up to {duration_words(phrases, self.grace_s)} does not count)" if self.grace_s else ""
        longer = f"for more than {duration_words(phrases, self.limit_s)}{grace}"
        stay = f"has been in {phrases.any_of(self.zone)} {longer}"
        return f"{phrases.any_of(self.entity)} {stay}"


class StayTracker(PositionTracker, DueTracker):
    """Measures how long an entity stays in a region; an absence of up to the grace counts as inside."""

    def __init__(
        self, state: RefereeState, entity: int, region: Region,
        limit_s: Callable[[], float], grace_s: Callable[[], float],
    ) -> None:  # fmt: skip
        super().__init__(state, entity)
        self._region = region
        self.entities = (entity, *region.anchors)
        self._limits = limit_s, grace_s
        self._limit_s, self._longer, self._grace = 0.0, 0, 0
        self._came: int | None = None
        self._left: int | None = None
        self._reported = False

    def reset(self) -> None:
        """Begin a stay now if inside."""
        self._left = None
        x, y, _ = self._state.poses[self.entity]
        inside = self._state.present[self.entity] and self._region.contains(x, y)
        self._begin(self._state.tick if inside else None)

    def _begin(self, tick: int | None) -> None:
        limit_s, grace_s = self._limits
        self._limit_s, self._grace = limit_s(), whole_ticks_within_s(grace_s())
        self._longer = whole_ticks_within_s(self._limit_s) + 1  # the first tick at which it is longer than the limit
        self._came, self._reported = tick, False
        self.due = NEVER if tick is None else tick + self._longer

    def cell(self, x_m: float, y_m: float) -> Cell:
        return self._region.cell(x_m, y_m)

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Begin, go on with, or leave a stay, as the judged poses say; without grace any sub-step outside ends it."""
        tick = self._state.tick
        inside: list[bool] = []
        for poses in substeps:
            self._state.seen = poses
            x, y, _ = poses[self.entity]
            inside += (self._region.contains(x, y),)
        self._state.seen = None
        if not inside[-1]:
            if self._came is not None and self._left is None:
                self._left, self.due = tick, NEVER
            return
        absent = 0 if self._left is None else tick - self._left
        self._left = None
        if self._came is None or absent > self._grace or (self._grace == 0 and not all(inside)):
            self._begin(tick)
        elif not self._reported:
            self.due = self._came + self._longer

    def update(self) -> None:
        """Report a stay that is longer than the limit, once."""
        if self._came is None:
            self.due = NEVER
            return
        self._reported, self.due = True, NEVER
        self._hits.report(self.bindings, s_from_ticks(self._state.tick - self._came), self._limit_s)
