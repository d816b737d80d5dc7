"""Places beside what moves, as far as they are known: at the start of a half, or beside what a rule has just put."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import product
from typing import NamedTuple

from rcj_challenges.scenario.beginnings import turns
from rcj_challenges.scenario.catalogue import EACH, OTHER
from rcj_challenges.scenario.models.actions import Place, Remove
from rcj_challenges.scenario.models.base import Names
from rcj_challenges.scenario.models.places import (
    At,
    AtPoint,
    AtSpot,
    Choice,
    Facing,
    Mirror,
    Placing,
    RelativeTo,
    Start,
)
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import DrawValue
from rcj_challenges.scenario.other import written_others
from rcj_challenges.scenario.remembered import fixed_spots
from rcj_challenges.scenario.roster import Roster, row_of
from rcj_challenges.scenario.starting import start_noise_m
from rcj_challenges.views.drawing.flips import AS_WRITTEN, Flip, flipped
from rcj_challenges.views.drawing.labels import Point
from rcj_challenges.views.drawing.shapes import home, home_yaw_rad, shifted

_DIGITS = 3  # of a place in m; a yaw written as 1.57 shifts it by less


class Beside(NamedTuple):
    """A place beside something that moves.

    Attributes:
        names: what is put there, as written.
        at: where it is.
        noise_m: half width of the noise around it, that of what it is beside included.
        aim: whether things are not put there, but roll there.
    """

    names: tuple[str, ...]
    at: Point
    noise_m: Point
    aim: bool


@dataclass(frozen=True)
class _Pose:
    at: Point
    noise_m: Point = (0.0, 0.0)
    yaw_rad: float | None = None  # None: nobody knows


_Board = dict[str, tuple[_Pose, ...]]
"""Every pose that an entity may have. What is not in it may be anywhere."""


def places_beside(scenario: Scenario, roster: Roster) -> Iterator[Beside]:
    """Yield the known places beside entities where rules put things, or where they roll things to."""
    start: _Board = {
        name: (_Pose(home(scenario, name), start_noise_m(scenario, name), home_yaw_rad(scenario, name)),)
        for name in roster.entities
    }
    starting = {turn.name: turn for turn in turns(scenario)}
    for name, rule in sorted(scenario.rules.items(), key=lambda named: named[1].priority):
        turn = starting.get(name)
        walks = [
            _Walk(scenario, roster, rule, flags, {} if turn is None else start) for flags in _settings(scenario, rule)
        ]
        for walk in walks:
            yield from walk.found
        if turn is not None:
            left_out = [] if turn.surely else [start]
            start = _merged([*left_out, *(walk.board for walk in walks)])


def layouts_of(scenario: Scenario, action: Place) -> list[str]:
    """Return the layouts that an action may put."""
    if isinstance(action.layout, DrawValue):
        return [str(value) for value in scenario.draws[action.layout.draw].values]
    return [] if action.layout is None else [action.layout]


def listed_names(names: Names, rule: Rule | None = None) -> tuple[str, ...]:
    """Return names as a row, with what a rule goes over for ``each``, and what it finds touched for ``other``."""
    listed = row_of(names)
    if rule is None:
        return listed
    bound = {EACH: (rule.for_each or "",), OTHER: written_others(rule)}
    return tuple(one for name in listed for one in bound.get(name, (name,)))


def _settings(scenario: Scenario, rule: Rule) -> list[frozenset[str]]:
    """Return which flags may be set that mirror what a rule puts: every choice of them."""
    placings: list[Place | Placing] = [action for action in rule.actions if isinstance(action, Place)]
    names = [name for action in placings if isinstance(action, Place) for name in layouts_of(scenario, action)]
    placings += [placing for name in names for placing in scenario.placements[name]]
    mirrors = [placing.mirror for placing in placings if placing.mirror is not None]
    flags = dict.fromkeys(mirror.when for mirror in mirrors if mirror.when is not None)
    choices = product(*((None, flag) for flag in flags))
    return [frozenset(flag for flag in choice if flag is not None) for choice in choices]


def _merged(boards: Iterable[_Board]) -> _Board:
    """Return every pose that an entity has on one of the boards; one that is missing on any of them may be anywhere."""
    first, *others = boards
    return {
        name: tuple(dict.fromkeys(pose for board in (first, *others) for pose in board[name]))
        for name in first
        if all(name in board for board in others)
    }


class _Walk:
    """Carries out what a rule puts, in order, as far as it can be known beforehand.

    Args:
        scenario: the scenario.
        roster: its roster.
        rule: the rule.
        flags: the flags that are set meanwhile.
        board: where things are before.
    """

    def __init__(self, scenario: Scenario, roster: Roster, rule: Rule, flags: frozenset[str], board: _Board) -> None:
        self.board = dict(board)
        self.found: list[Beside] = []
        self._scenario, self._roster, self._flags = scenario, roster, flags
        self._spots = {name: (spot.x_m, spot.y_m) for name, spot in fixed_spots(scenario).items()}
        self._rule = rule
        for action in rule.actions:
            if isinstance(action, Remove):
                for name in roster.expand(listed_names(action.entity, rule)):
                    self.board.pop(name, None)
            elif isinstance(action, Place):
                self._place(action)

    def _place(self, action: Place) -> None:
        if action.layout is None:
            self._put(action, AS_WRITTEN)
            return
        before, after = self.board, []
        for name in layouts_of(self._scenario, action):
            self.board = dict(before)
            for placing in self._scenario.placements[name]:
                self._put(placing, self._flip(action.mirror))
            after.append(self.board)
        self.board = _merged(after)

    def _put(self, placing: Place | Placing, whole: Flip) -> None:
        """Put what a placement names, and remember where, if that is beside something."""
        own = self._flip(placing.mirror)
        flip = (own[0] is not whole[0], own[1] is not whole[1])
        names = listed_names(placing.entity or (), self._rule)
        self._remember(names, placing.at, placing.noise_m, flip, aim=False)
        for name in self._roster.expand(names):
            yaw_rad = self._yaw_rad(name, placing.facing)
            poses = self._poses(name, placing.at, flip)
            if poses:
                self.board[name] = tuple(
                    replace(pose, noise_m=shifted(pose.noise_m, placing.noise_m), yaw_rad=yaw_rad) for pose in poses
                )
            else:
                self.board.pop(name, None)
        if placing.kick is not None:
            self._remember(names, placing.kick.towards, (0.0, 0.0), flip, aim=True)

    def _remember(self, names: tuple[str, ...], at: At | None, noise_m: Point, flip: Flip, *, aim: bool) -> None:
        if not isinstance(at, RelativeTo):
            return
        if at.relative_to in names and not any(at.offset_m):
            return  # it stays where it is
        for anchor in self._anchors(at.relative_to):
            if anchor not in self._roster.entities:
                continue  # beside a spot: known without the rule
            for pose in self._beside(anchor, at, flip):
                x, y = (round(value, _DIGITS) + 0.0 for value in pose.at)  # adding 0 makes no -0
                self.found.append(Beside(names, (x, y), shifted(pose.noise_m, noise_m), aim))

    def _poses(self, entity: str, at: At | None, flip: Flip) -> tuple[_Pose, ...]:
        """Return where an entity may be after it was put somewhere; empty if nobody knows."""
        match at:
            case "start" | Start():
                noise_m = start_noise_m(self._scenario, entity)
                return (_Pose(flipped(home(self._scenario, entity), flip), noise_m),)
            case AtPoint():
                return (_Pose(flipped(at.point, flip)),)
            case AtSpot():
                return self._on_any((at.spot,), flip)
            case Choice():
                return self._on_any(at.choice, flip)
            case RelativeTo():
                several = [self._beside(anchor, at, flip) for anchor in self._anchors(at.relative_to)]
                return tuple(pose for poses in several for pose in poses) if all(several) else ()
        return ()

    def _on_any(self, options: tuple[str | Point, ...], flip: Flip) -> tuple[_Pose, ...]:
        """Return the poses on one of several spots or points; empty if a rule sets one of the spots."""
        named = [name for option in options if isinstance(option, str) for name in self._anchors(option)]
        points = [option for option in options if not isinstance(option, str)]
        points += [self._spots[name] for name in named if name in self._spots]
        known = all(name in self._spots for name in named)
        return tuple(_Pose(flipped(point, flip)) for point in dict.fromkeys(points)) if known else ()

    def _anchors(self, name: str) -> tuple[str, ...]:
        """Return what a name may stand for: all values of a draw, the members of a group of spots, or one thing."""
        scenario = self._scenario
        is_draw = name in scenario.draws and name not in (*self._roster.entities, *scenario.spots)
        names = tuple(map(str, scenario.draws[name].values)) if is_draw else (name,)
        return tuple(dict.fromkeys(member for one in names for member in self._roster.expand(one)))

    def _beside(self, anchor: str, at: RelativeTo, flip: Flip) -> tuple[_Pose, ...]:
        if anchor in self._spots:
            return (_Pose(flipped(shifted(self._spots[anchor], at.offset_m), flip)),)
        poses = self.board.get(anchor, ())
        if not at.turns:
            return tuple(replace(pose, at=shifted(pose.at, flipped(at.offset_m, flip))) for pose in poses)
        known = [(pose, pose.yaw_rad) for pose in poses if pose.yaw_rad is not None]
        return tuple(replace(pose, at=shifted(pose.at, _turned(at.offset_m, yaw))) for pose, yaw in known)

    def _yaw_rad(self, entity: str, facing: Facing) -> float | None:
        if facing == "start":
            return home_yaw_rad(self._scenario, entity)
        if facing == "keep":
            yaws = {pose.yaw_rad for pose in self.board.get(entity, ())}
            return yaws.pop() if len(yaws) == 1 else None
        return facing if isinstance(facing, float) else None

    def _flip(self, mirror: Mirror | None) -> Flip:
        if mirror is None or (mirror.when is not None and mirror.when not in self._flags):
            return AS_WRITTEN
        return mirror.axis in ("x", "both"), mirror.axis in ("y", "both")


def _turned(offset_m: Point, yaw_rad: float) -> Point:
    x, y = offset_m
    return math.cos(yaw_rad) * x - math.sin(yaw_rad) * y, math.sin(yaw_rad) * x + math.cos(yaw_rad) * y
