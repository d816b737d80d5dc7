"""Resolves the names of a rule, a layout or the broadcast to indices, regions, places and positions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import product
from math import sqrt
from random import Random
from typing import Any, TypeVar, cast

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import distance_to_segment_m
from rcj_challenges.geometry.regions import AnyOf, Drawn, Outlined, Outside, Region
from rcj_challenges.referee.state import State
from rcj_challenges.referee.zones import point_sampler, region_of
from rcj_challenges.rules.fields import Name, Names, Point, Scalar
from rcj_challenges.scenario.models.field import Wall
from rcj_challenges.scenario.models.places import CircleZone
from rcj_challenges.scenario.roster import EACH, ENTRANTS, OTHER, OTHERS, as_tuple
from rcj_challenges.scenario.rule_effects import roles_in, with_names
from rcj_challenges.scenario.shapes import centre_of, start_noise_m, start_pose
from rcj_challenges.tracking.gates import AnchoredCircle, GateLine
from rcj_challenges.tracking.places import Anchor, Poses, Target, point_of

_T = TypeVar("_T")
_W = TypeVar("_W")
_F = TypeVar("_F", bound=Callable[..., Any])


class NameScope:
    """Implements `Scope`: what names stand for in a rule or a layout.

    Args:
        state: the referee's memory.
        each: the name that ``each`` stands for; None: it is not known there.
        for_each: the group for whose members it is; None: for none.

    Attributes:
        named: the roles that the words named that it was asked to compile.
    """

    def __init__(self, state: State, each: str | None = None, for_each: str | None = None) -> None:
        self.state = state
        self.each, self.for_each = each, for_each
        self.other: str | None = None
        self.scenario = state.scenario
        self.roster = state.roster
        self.named: set[str] = set()
        self.roles: Mapping[str, tuple[str, ...]] = state.roster.roles

    def by_role(self, word: _W, compiled: Callable[[_W], _F], otherwise: Any) -> _F:
        named = roles_in(word, self.roles)
        self.named.update(named)
        if not named:
            return compiled(word)
        draws = self.state.draws
        found = {holders: compiled(one) for holders, one in self.for_holders(word, named)}

        def choose(*args: Any) -> Any:
            chosen = found.get(tuple(draws[role] for role in named))
            return otherwise if chosen is None else chosen(*args)

        return cast("_F", choose)

    def for_holders(self, word: _W, roles: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], _W]]:
        """Yield a word once for all that may have the roles that it names: these, and the word with their names."""
        for holders in product(*(self.roles[role] for role in roles)):
            yield holders, with_names(word, dict(zip(roles, holders, strict=True)))

    def members(self, names: Names) -> tuple[str, ...]:
        key = (names, self.each, self.for_each)
        known = self.state.members.get(key)
        if known is None:
            known = self.state.members[key] = self.roster.named(names, self.for_each, self.each)
        return known

    def entrants(self, names: Names) -> tuple[str, ...]:
        found: list[str | None] = []
        for name in as_tuple(names):
            if name in self.roster.teams:
                found.append(name)
            elif self.for_each == ENTRANTS and (members := self.roster.of_rule(name, ENTRANTS, self.each)):
                found += members
            else:
                robots = self.members((self.other or name) if name == OTHER else name)
                own = self.state.entrant_of.get(self.each or "") if self.roster.is_others(name) else None
                found += [one for one in map(self.state.entrant_of.get, robots) if one != own]
        return tuple(dict.fromkeys(one for one in found if one is not None))

    def group_of_owners(
        self, section: str, name: str, names: Names
    ) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        per = getattr(self.scenario, section)[name].per
        if per == ENTRANTS:
            entrants = self.entrants(names)
            return entrants, lambda: entrants
        if self.for_each != ENTRANTS:
            return self.group(names)
        (members, members_now), owners = self.group(names), self.roster.keepers(per)
        has_one = owners.__contains__
        return tuple(filter(has_one, members)), lambda: tuple(filter(has_one, members_now()))

    def group(self, names: Names) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        members, each = self.members(names), self.each
        if each is None or not (isinstance(names, str) and self.roster.is_others(names)):
            return members, lambda: members
        is_entrant = self.for_each == ENTRANTS

        def on_field() -> tuple[str, ...]:
            is_there = is_entrant or self.is_present(each)
            return tuple(name for name in members if self.is_present(name)) if is_there else ()

        return members, on_field

    def entities(self, names: Names) -> tuple[int, ...]:
        return tuple(self.roster.index[name] for name in self.members(names))

    def owners(self, section: str, name: str, names: Names | None) -> tuple[str, ...] | None:
        per = getattr(self.scenario, section)[name].per
        if per is None or (names is None and not self.roster.keeps(self.for_each, per)):
            return None
        names = EACH if names is None else names
        return self.entrants(names) if per == ENTRANTS else self.members(names)

    def drawn_value(self, value: Scalar) -> Scalar:
        if self.each is None or value not in (EACH, OTHERS):
            return value
        meant = self.roster.of_rule(str(value), self.for_each, self.each)
        return meant[0] if len(meant) == 1 else value

    def region(self, names: Names) -> Region:
        drawn, members = self.roster.drawn, self.members(names)
        regions = tuple(Drawn(self._decided(one, self.zone)) if one in drawn else self.zone(one) for one in members)
        return regions[0] if len(regions) == 1 else AnyOf(regions)

    def _decided(self, draw: str, resolve: Callable[[str], _T]) -> Callable[[], _T]:
        """Return a function that finds among what a draw may decide, each resolved once, what it has decided."""
        draws, found = self.state.draws, {one: resolve(one) for one in self.roster.drawn[draw]}
        return lambda: found[str(draws[draw])]

    def zone(self, name: str) -> Outlined:
        """Return the region of one zone."""
        zone = self.scenario.zones[name]
        if not isinstance(zone, CircleZone) or zone.anchor is None:
            return region_of(zone)
        state, anchor, among = self.state, zone.anchor, self.roster.may_be(zone.anchor)
        indices = {one: self.roster.index[one] for one in among if one not in state.spots}

        def locate() -> Pose2 | None:
            name = anchor if anchor in among else state.draws[anchor]
            if name in state.spots:
                return (*state.spots[name], 0.0)
            index = indices.get(name)
            return (state.seen or state.poses)[index] if index is not None and state.present[index] else None

        circle = AnchoredCircle(zone.middle_m, zone.radius_m, locate, tuple(indices.values()))
        return Outside(circle) if zone.inverted else circle

    def gate(self, name: str) -> GateLine:
        gate = self.scenario.gates[name]
        anchor = None if gate.anchor is None else self.entities(gate.anchor)[0]
        return GateLine(gate.from_m, gate.to_m, anchor, self.state)

    def start_of(self, entity: int) -> tuple[Pose2, Point]:
        name = self.roster.entities[entity]
        return start_pose(self.scenario, name), start_noise_m(self.scenario, name)

    def anchor(self, what: Name | Point) -> Callable[[], Anchor]:
        return self._find(what, lambda entity: lambda: entity)

    def places(self, what: Names | Point) -> Callable[[Poses, int | None], list[Point]]:
        if isinstance(what, tuple) and not isinstance(what[0], str):
            return lambda _poses, _entity: [what]
        anchors, present = [self.anchor(one) for one in self.members(what)], self.state.present
        if len(anchors) == 1:
            return lambda poses, _entity: [point_of(anchors[0](), poses)]

        def find(poses: Poses, entity: int | None) -> list[Point]:
            found = (anchor() for anchor in anchors)
            counting = (one for one in found if not isinstance(one, int) or (present[one] and one != entity))
            return [point_of(one, poses) for one in counting]

        return find

    def random_point(self, zones: Names) -> Callable[[Random], Point]:
        return point_sampler({name: self.scenario.zones[name] for name in self.members(zones)})

    def is_present(self, name: str) -> bool:
        """Return whether something is on the field now; what is no entity always is."""
        index = self.roster.index.get(name, len(self.state.present))
        return index >= len(self.state.present) or self.state.present[index]

    def locate(self, what: Name | Point) -> Callable[[], Any]:
        state = self.state
        return self._find(what, lambda entity: lambda: state.poses[entity] if state.present[entity] else None)

    def _find(self, what: Name | Point, of_entity: Callable[[int], Callable[[], Any]]) -> Callable[[], Any]:
        """Return a function that finds where something is; of an entity, given by its index, what that returns."""
        if isinstance(what, tuple):
            return lambda: what
        name, state, roster = self.members(what)[0], self.state, self.roster
        if name in roster.drawn:
            decided = self._decided(name, lambda one: self._find(one, of_entity))
            return lambda: decided()()  # noqa: PLW0108 - which one is known when it is called
        if (zone := self.scenario.zones.get(name)) is not None:
            centre = centre_of(zone)
            return lambda: centre
        if name in state.spots:
            return lambda: state.spots[name]
        index = roster.index[name]
        if index < len(roster.entities):
            return of_entity(index)
        middle = start_pose(self.scenario, name)
        return lambda: middle

    def targets(self, named: Names | Point) -> tuple[Target, ...]:
        if isinstance(named, tuple) and not isinstance(named[0], str):
            return (_at(lambda: named),)
        found: list[Target] = []
        for name in self.members(named):
            among = self.roster.drawn.get(name)
            found += [_target(name, self)] if among is None else [_if_drawn(name, one, self) for one in among]
        return tuple(found)


def _if_drawn(draw: str, name: str, scope: NameScope) -> Target:
    """Return one of those among which a draw decides: it is nowhere while another one is drawn."""
    draws, target = scope.state.draws, _target(name, scope)
    place = target.place
    return Target(
        lambda x_m, y_m: target.away_m(x_m, y_m) if draws[draw] == name else None,
        None if place is None else (lambda: place() if draws[draw] == name else None),
        target.entity,
    )


def _target(name: str, scope: NameScope) -> Target:
    """Return a thing or a spot by its centre, a wall by its middle line, a zone or a gate by its nearest point."""
    scenario, index = scope.scenario, scope.roster.index.get(name, len(scope.roster.entities))
    if name in scenario.zones:
        zone = scope.zone(name)
        return Target(zone.away_m, None, zone.anchors[0] if len(zone.anchors) == 1 else None)
    if name in scenario.gates:
        gate = scope.gate(name)
        return Target(gate.distance_m, None, gate.anchor)
    if isinstance(wall := scenario.obstacles.get(name), Wall):
        ends = (*wall.from_m, *wall.to_m)
        return Target(lambda x_m, y_m: distance_to_segment_m(x_m, y_m, *ends), None)
    return _at(scope.locate(name), index if index < len(scope.roster.entities) else None)


def _at(place: Callable[[], tuple[float, ...] | None], entity: int | None = None) -> Target:
    def away_m(x_m: float, y_m: float) -> float | None:
        at = place()
        return None if at is None else sqrt((x_m - at[0]) ** 2 + (y_m - at[1]) ** 2)

    return Target(away_m, place, entity)
