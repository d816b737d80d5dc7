"""Triggers about places: enters, leaves, stays_in, displaced."""

from __future__ import annotations

from functools import partial

from rcj_challenges.facts.play import Pose2
from rcj_challenges.facts.timing import s_from_ticks, whole_ticks_within_s
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.regions import Cell, FarFrom, Region
from rcj_challenges.referee.rules import Listener, StandingRule
from rcj_challenges.referee.watching import NEVER, DueWatch, PositionWatch
from rcj_challenges.rules.triggers import Displaced, Enters, Leaves, StaysIn


def enters(model: Enters, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a centre comes into a zone it was not in."""
    for entity in workshop.entities(model.entity, rule.each):
        watch = _zone_watch(entity, workshop.members(model.zone, rule.each), rule, workshop)
        watch.entering.append(workshop.listener(rule, position, model.trigger, entity))


def leaves(model: Leaves, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a centre leaves a zone it was in."""
    for entity in workshop.entities(model.entity, rule.each):
        watch = _zone_watch(entity, workshop.members(model.zone, rule.each), rule, workshop)
        watch.leaving.append(workshop.listener(rule, position, model.trigger, entity))


def _zone_watch(entity: int, zones: tuple[str, ...], rule: StandingRule, workshop: Workshop) -> ZoneWatch:
    region = workshop.region(zones, None)
    watch = workshop.watch(ZoneWatch, (entity, zones), rule, partial(ZoneWatch, entity, region, workshop))
    workshop.follow_draws(watch, zones)
    return watch


class ZoneWatch(PositionWatch):
    """Follows an entity into and out of a region.

    Attributes:
        entering, leaving: ears.
    """

    def __init__(self, entity: int, region: Region, workshop: Workshop) -> None:
        self.entity = entity
        self.entities = (entity,)
        self.entering: list[Listener] = []
        self.leaving: list[Listener] = []
        self._region = region
        self._inside = False
        self._state = workshop.state
        self._hits = workshop.hits

    def restart(self) -> None:
        """Take the present side for the one it was on before."""
        x, y, _ = self._state.poses[self.entity]
        self._inside = self._region.contains(x, y)

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the region's cell."""
        return self._region.cell(x_m, y_m)

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report each kind of change once a tick, also one that is undone in a later sub-step."""
        entered = left = False
        for poses in substeps:
            x, y, _ = poses[self.entity]
            inside = self._region.contains(x, y)
            if inside != self._inside:
                self._inside = inside
                entered, left = entered or inside, left or not inside
        if entered:
            self._hits.report(self.entering)
        if left:
            self._hits.report(self.leaving)


def displaced(model: Displaced, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when an entity is further from where it was put than a distance."""
    for entity in workshop.entities(model.entity, rule.each):
        key = (entity, model.from_, model.distance_m, model.axis)
        watch = workshop.watch(DisplacedWatch, key, rule, partial(DisplacedWatch, entity, model, workshop))
        watch.listeners.append(workshop.listener(rule, position, model.trigger, entity))


class DisplacedWatch(PositionWatch):
    """Follows how far an entity is from an anchor.

    Attributes:
        listeners: ears.
    """

    def __init__(self, entity: int, model: Displaced, workshop: Workshop) -> None:
        self.entity = entity
        self.entities = (entity,)
        self.listeners: list[Listener] = []
        self._limit = model.distance_m
        self._region = FarFrom(model.distance_m, square=model.axis == "either")
        self._fixed = None if isinstance(model.from_, str) else model.from_
        self._beyond = False
        self._state = workshop.state
        self._hits = workshop.hits

    def restart(self) -> None:
        """Measure from where it was put, or from the fixed point; what is beyond now was beyond before."""
        self._region.anchor = self._state.put_at[self.entity] if self._fixed is None else self._fixed
        x, y, _ = self._state.poses[self.entity]
        self._beyond = self._region.contains(x, y)

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell on this side of the limit."""
        return self._region.cell(x_m, y_m)

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report the furthest of this tick's sub-steps when one goes beyond."""
        went = False
        furthest = 0.0
        for poses in substeps:
            x, y, _ = poses[self.entity]
            distance = self._region.distance_m(x, y)
            furthest = max(furthest, distance)
            beyond = distance > self._limit
            went = went or (beyond and not self._beyond)
            self._beyond = beyond
        if went:
            self._hits.report(self.listeners, furthest, self._limit)


def stays_in(model: StaysIn, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires while inside, once the stay is longer than a limit."""
    for entity in workshop.entities(model.entity, rule.each):
        zones = workshop.members(model.zone, rule.each)
        key = (entity, zones, model.limit_s, model.grace_s)
        region = workshop.region(zones, None)
        watch = workshop.watch(StayWatch, key, rule, partial(StayWatch, entity, region, model, workshop))
        workshop.follow_draws(watch, zones)
        watch.listeners.append(workshop.listener(rule, position, model.trigger, entity))


class StayWatch(PositionWatch, DueWatch):
    """Measures how long an entity stays in a region; an absence of up to the grace counts as inside.

    Attributes:
        listeners: ears.
    """

    def __init__(self, entity: int, region: Region, model: StaysIn, workshop: Workshop) -> None:
        self.entity = entity
        self.entities = (entity,)
        self.listeners: list[Listener] = []
        self._region = region
        self._limit_s = model.limit_s
        self._longer = whole_ticks_within_s(model.limit_s) + 1  # the first tick at which it is longer than the limit
        self._grace = whole_ticks_within_s(model.grace_s)
        self._came: int | None = None
        self._left: int | None = None
        self._told = False
        self._state = workshop.state
        self._hits = workshop.hits

    def restart(self) -> None:
        """Begin a stay now if inside."""
        self._left = None
        x, y, _ = self._state.poses[self.entity]
        inside = self._state.present[self.entity] and self._region.contains(x, y)
        self._begin(self._state.tick if inside else None)

    def _begin(self, tick: int | None) -> None:
        self._came, self._told = tick, False
        self.due = NEVER if tick is None else tick + self._longer

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the region's cell."""
        return self._region.cell(x_m, y_m)

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Begin, go on with, or leave a stay, as the judged poses say; without grace any sub-step outside ends it."""
        tick = self._state.tick
        contains, entity = self._region.contains, self.entity
        inside = [contains(x, y) for x, y, _ in (poses[entity] for poses in substeps)]
        if not inside[-1]:
            if self._came is not None and self._left is None:
                self._left, self.due = tick, NEVER
            return
        absent = 0 if self._left is None else tick - self._left
        self._left = None
        if self._came is None or absent > self._grace or (self._grace == 0 and not all(inside)):
            self._begin(tick)
        elif not self._told:
            self.due = self._came + self._longer

    def look(self) -> None:
        """Report a stay that is longer than the limit, once."""
        if self._came is None:
            self.due = NEVER
            return
        self._told, self.due = True, NEVER
        self._hits.report(self.listeners, s_from_ticks(self._state.tick - self._came), self._limit_s)
