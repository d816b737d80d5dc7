"""The trigger ``displaced``."""

from collections.abc import Callable
from math import inf
from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import Cell, FarFrom
from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Name, Names, Point, described
from rcj_challenges.rules.phrasing import metres
from rcj_challenges.rules.refs import ENTITIES
from rcj_challenges.rules.values import Limit, compile_limit, limit_key, limit_words
from rcj_challenges.tracking.bound_rules import HitBuffer
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import PositionTracker


class Displaced(Trigger):
    """Fires when an entity has been moved further than a given distance from where it was placed."""

    trigger: Literal["displaced"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    from_: Literal["last_placement"] | Point = Field(
        "last_placement",
        alias="from",
        description="measured from where it was last placed (noise included), or from [x, y] in m",
    )
    distance_m: Limit = described(..., "distance in m beyond which it fires, read when it is placed")
    axis: Literal["either", "distance"] = described(
        "distance", "distance: the straight line; either: the larger of the shifts in x and in y"
    )

    MEASURED = "the distance in m by which it was displaced"
    ASKS_WHERE = True
    LIMIT = "distance_m"
    REASON = "was displaced by {measured} m, at most {limit} m"
    EXAMPLE = """
rules:
  pushed:
    for_each: blue
    triggers: [{trigger: displaced, entity: each, from: last_placement, distance_m: 0.05}]
    actions: [{action: emit, event: PUSHED, payload: {robot_name: {word: robot_name}}}]
  begin:
    triggers: [{trigger: half_started}]
    actions: [{action: place, entity: B1, at: {point: [0.3, 0.3]}}]
expect:
  more_than_5_cm_is_a_push:
    keyframes:
      - {at_s: 1, place: {B1: [0.34, 0.3]}}
      - {at_s: 2, place: {B1: [0.36, 0.3]}}
    lasts_s: 3
    events: [{event: PUSHED, at_s: 2, payload: {robot_name: B1}}]
"""
    SENTENCE = "it is more than 5 cm from where it was put"

    def bind(self, to: Binder) -> None:
        limit_m = compile_limit(self.distance_m, to, most=inf, none=inf)
        for entity in to.entities(self.entity):
            key = (entity, self.from_, self.axis, *limit_key(to, self.distance_m))
            to.track(DisplacedTracker, key, entity, self, limit_m).bindings.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        origin = "where it was put" if self.from_ == "last_placement" else phrases.point(self.from_)
        distance = limit_words(phrases, self.distance_m, metres, "m")
        how = "" if self.axis == "distance" else " in x or in y"
        return f"{phrases.any_of(self.entity)} is more than {distance}{how} from {origin}"

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        is_fixed = self.from_ != "last_placement" and self.axis == "distance"
        return ((self.from_, self.distance_m),) if is_fixed and isinstance(self.distance_m, int | float) else ()


class DisplacedTracker(PositionTracker):
    """Follows how far an entity is from an anchor."""

    def __init__(
        self, state: RefereeState, hits: HitBuffer, entity: int, model: Displaced, limit_m: Callable[[], float]
    ) -> None:
        super().__init__(state, hits, entity)
        self._read_limit_m = limit_m
        self._region = FarFrom(inf, square=model.axis == "either")
        self._fixed = None if isinstance(model.from_, str) else model.from_
        self._beyond = False

    def reset(self) -> None:
        """Measure from where it was put, or from the fixed point; what is beyond now was beyond before."""
        self._region.limit_m = self._read_limit_m()
        self._region.anchor = self._state.placed_at[self.entity] if self._fixed is None else self._fixed
        x, y, _ = self._state.poses[self.entity]
        self._beyond = self._region.contains(x, y)

    def cell(self, x_m: float, y_m: float) -> Cell:
        return self._region.cell(x_m, y_m)

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report the furthest of this tick's sub-steps when one goes beyond."""
        went = False
        furthest = 0.0
        for poses in substeps:
            x, y, _ = poses[self.entity]
            distance = self._region.distance_m(x, y)
            furthest = max(furthest, distance)
            beyond = distance > self._region.limit_m
            went = went or (beyond and not self._beyond)
            self._beyond = beyond
        if went:
            self._hits.report(self.bindings, furthest, self._region.limit_m)
