"""The trigger ``displaced``."""

from collections.abc import Callable
from math import inf, remainder, tau
from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import NOWHERE, Cell, FarFrom
from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Name, Names, Point, described
from rcj_challenges.rules.phrasing import degrees, listed, metres
from rcj_challenges.rules.refs import ENTITIES
from rcj_challenges.rules.values import Angle, Limit, compile_limit, limit_words
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import PositionTracker


class Displaced(Trigger):
    """Fires when an entity has been moved or turned further than given limits from how it was placed."""

    trigger: Literal["displaced"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    from_: Literal["last_placement"] | Point = Field(
        "last_placement",
        alias="from",
        description="measured from where it was last placed (noise included), or from [x, y] in m",
    )
    distance_m: Limit | None = described(None, "distance in m beyond which it fires, read when it is placed")
    axis: Literal["either", "distance"] = described(
        "distance", "distance: the straight line; either: the larger of the shifts in x and in y"
    )

    angle_rad: Angle | None = described(
        None,
        "angle in rad between its yaw and that of its last placement beyond which it fires, read when it is placed; "
        "of both limits either suffices, and only a distance is measured",
    )

    REQUIRES = (("distance_m",), ("angle_rad",))
    MEASURED = "the distance in m by which it was displaced"
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

    def bind(self, to: Binder) -> None:
        limits = tuple(
            compile_limit(inf if limit is None else limit, to, most=inf, none=inf)
            for limit in (self.distance_m, self.angle_rad)
        )
        for entity in to.entities(self.entity):
            key = (entity, self.from_, self.axis, self.distance_m, self.angle_rad)
            to.track(DisplacedTracker, key, entity, self, *limits).bindings.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        ways = []
        if self.distance_m is not None:
            origin = "where it was put" if self.from_ == "last_placement" else phrases.point(self.from_)
            distance = limit_words(phrases, self.distance_m, metres, "m")
            ways.append(f"is more than {distance}{'' if self.axis == 'distance' else ' in x or in y'} from {origin}")
        if self.angle_rad is not None:
            angle = limit_words(phrases, self.angle_rad, degrees, "rad")
            ways.append(f"has turned by more than {angle} from how it was put")
        return f"{phrases.any_of(self.entity)} {listed(ways, 'or')}"

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        is_fixed = self.from_ != "last_placement" and self.axis == "distance"
        return ((self.from_, self.distance_m),) if is_fixed and isinstance(self.distance_m, int | float) else ()


class DisplacedTracker(PositionTracker):
    """Follows how far an entity is from an anchor, and how far it has turned."""

    def __init__(self, state: RefereeState, entity: int, model: Displaced, *limits: Callable[[], float]) -> None:
        super().__init__(state, entity)
        self._read_limit_m, self._read_limit_rad = limits
        self._limit_rad = inf
        self._turns = model.angle_rad is not None
        self._region = FarFrom(inf, square=model.axis == "either")
        self._fixed = None if isinstance(model.from_, str) else model.from_
        self._yaw_rad = 0.0
        self._beyond = False

    def reset(self) -> None:
        """Measure from how it was put, or from the fixed point; what is beyond now was beyond before."""
        self._region.limit_m, self._limit_rad = self._read_limit_m(), self._read_limit_rad()
        x, y, self._yaw_rad = self._state.placed_at[self.entity]
        self._region.anchor = (x, y) if self._fixed is None else self._fixed
        x, y, yaw = self._state.poses[self.entity]
        self._beyond = self._region.contains(x, y) or self._is_turned(yaw)

    def cell(self, x_m: float, y_m: float) -> Cell:
        return NOWHERE if self._turns else self._region.cell(x_m, y_m)

    def _is_turned(self, yaw_rad: float) -> bool:
        return self._turns and abs(remainder(yaw_rad - self._yaw_rad, tau)) > self._limit_rad

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report the furthest of this tick's sub-steps when one goes beyond."""
        went = False
        furthest = 0.0
        for poses in substeps:
            x, y, yaw = poses[self.entity]
            distance = self._region.distance_m(x, y)
            furthest = max(furthest, distance)
            beyond = distance > self._region.limit_m or self._is_turned(yaw)
            went = went or (beyond and not self._beyond)
            self._beyond = beyond
        if went and furthest > self._region.limit_m:
            self._hits.report(self.bindings, furthest, self._region.limit_m)
        elif went:
            self._hits.report(self.bindings)
