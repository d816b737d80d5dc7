"""A trigger that the package does not have."""

from math import hypot
from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Names, Positive, described
from rcj_challenges.rules.phrasing import metres
from rcj_challenges.rules.refs import ENTITIES
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import TickTracker


class Strays(Trigger):
    """Fires when an entity's centre is further from the centre of the field than a distance."""

    trigger: Literal["strays"]
    entity: Annotated[Names, ENTITIES] = described(..., "whose")
    distance_m: Positive = described(..., "the distance in m")

    MEASURED = "the distance in m to the centre"
    LIMIT = "distance_m"
    EXAMPLE = """
rules:
  strayed:
    triggers: [{trigger: strays, entity: ball, distance_m: 0.5}]
    says: "{entity} is {measured} m away"
    actions: [{action: emit, event: STRAYED}]
expect:
  it_is_called_back:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0]}}
      - {at_s: 2, move: {ball: [0, 0.6]}}
    lasts_s: 3
    events: [{event: STRAYED, at_s: 1.84, tolerance_s: 0.05}]
"""

    def bind(self, to: Binder) -> None:
        """Bind a rule to the tracker of each entity."""
        for entity in to.entities(self.entity):
            key = (entity, self.distance_m)
            to.track(StrayTracker, key, *key).bindings.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        """Return the part of a sentence that follows ``When``."""
        return f"{phrases.any_of(self.entity)} strays by more than {metres(self.distance_m)}"


class StrayTracker(TickTracker):
    """Reports the tick in which an entity is too far away."""

    def __init__(self, state: RefereeState, entity: int, limit_m: float) -> None:
        super().__init__(state, entity)
        self._limit = limit_m
        self._far = False

    def reset(self) -> None:
        """Take the present distance for the one before."""
        self._far = self._distance_m() > self._limit

    def update(self) -> None:
        """Report when it goes beyond the limit."""
        was, self._far = self._far, self._distance_m() > self._limit
        if self._far and not was:
            self._hits.report(self.bindings, self._distance_m(), self._limit)

    def _distance_m(self) -> float:
        x, y, _ = self._state.poses[self.entities[0]]
        return hypot(x, y)
