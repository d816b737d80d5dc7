"""Touches of balls: which robot had a ball last, and which touches were shots."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.timing import SUBSTEPS_PER_TICK, TICK_S
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.tracking.contacts import APART_S, substeps_apart

SHOT_WITHIN_S = 2.0
FREE_TICKS = 2
"""For so many ticks after a touch no robot may touch the ball, so that its speed can be measured. In the first tick a
ball that was hit still slides; in the second it rolls, and from then on loses 0.1 % of its speed in a metre (ADR 2)."""

_NEVER = 1 << 62

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class Contacts:
    """Contacts of robots with one ball, in order of time; sub-steps are counted over the half from 0."""

    substeps: Array
    robots: Array

    @property
    def ticks(self) -> Array:
        """The tick of each contact, from 1."""
        return self.substeps // SUBSTEPS_PER_TICK + 1


def contacts_of(half: HalfTrack, robots: int, ball: int) -> Contacts:
    """Return the contacts of a ball, by its entity index, with any of the first ``robots`` entities."""
    substeps = np.repeat(np.arange(half.touch_counts.size), half.touch_counts.ravel())
    pairs = half.touch_pairs
    chosen = (pairs[:, 1] == ball) & (pairs[:, 0] < robots)
    return Contacts(substeps[chosen], pairs[chosen, 0].astype(np.int64))


def owners(contacts: Contacts, seats: Sequence[str | None], ticks: int, placed_at: Sequence[int]) -> Array:
    """Return ``[T]``: the robot that was the last to have touched the ball when a tick was over, -1: none.

    If robots of two seats touch it in one sub-step, it keeps its owner. It loses it when it is put elsewhere.
    """
    touching = grouped(zip(contacts.substeps.tolist(), contacts.robots.tolist(), strict=True))
    changes: list[tuple[int, list[int]]] = [(tick, []) for tick in placed_at]  # before contacts of the next tick
    changes += [(substep // SUBSTEPS_PER_TICK, those) for substep, those in touching.items()]
    found, owner = np.full(ticks, -1), -1
    for tick, those in sorted(changes, key=itemgetter(0)):
        if owner not in those and len({seats[robot] for robot in those}) <= 1:
            owner = those[0] if those else -1
            found[tick:] = owner
    return found


def touch_ends(contacts: Contacts, robot: int) -> list[int]:
    """Return the ticks at which the touches of a robot ended."""
    substeps = contacts.substeps[contacts.robots == robot]
    is_last = np.diff(substeps, append=_NEVER) >= substeps_apart(APART_S)
    return sorted(set((substeps[is_last] // SUBSTEPS_PER_TICK + 1).tolist()))


@dataclass(frozen=True)
class Goals:
    """The goals, by end (1 or -1) with the widths between the posts.

    The lines are ``line_y_m`` off the centre; corner walls are left out of half the field's width.
    """

    line_y_m: float
    half_width_m: float
    widths_m: Mapping[int, float]


@dataclass(frozen=True)
class Shot:
    """A shot; its tick is that of the last contact: a ball that is carried in is touched until it is over the line."""

    tick: int
    robot: int
    on_goal: bool


def shots_of(
    contacts: Contacts, places: Array, placed_at: Sequence[int], ends: Mapping[int, frozenset[int]], goals: Goals
) -> list[Shot]:
    """Return the shots of a half with one ball.

    ``places`` are its judged positions, ``[T, 2]`` in m; ``placed_at`` are the ticks after which it was put elsewhere;
    ``ends`` are the ends that each robot attacks.
    """
    every_tick = contacts.ticks
    touched = np.zeros(len(places) + FREE_TICKS + 2, bool)
    touched[every_tick] = True
    put = np.zeros_like(touched)
    put[[tick for tick in placed_at if tick < len(put)]] = True
    shots = []
    for robot, attacked in ends.items():
        for tick in touch_ends(contacts, robot):
            after = slice(tick + 1, tick + FREE_TICKS + 1)
            if tick + FREE_TICKS > len(places) or touched[after].any() or put[tick : tick + FREE_TICKS + 1].any():
                continue
            if set(_last_touching(contacts, tick)) == {robot}:
                on_goal = _aim(places[tick + FREE_TICKS - 2], places[tick + FREE_TICKS - 1], attacked, goals)
                if on_goal is not None:
                    shots.append(Shot(tick, robot, on_goal))
    for goal in _went_in(contacts, places, placed_at, ends, goals):
        shots = [shot for shot in shots if (shot.tick, shot.robot) != (goal.tick, goal.robot)]
        shots.append(goal)
    return sorted(shots, key=lambda shot: (shot.tick, shot.robot))


def _last_touching(contacts: Contacts, tick: int) -> list[int]:
    end = int(np.searchsorted(contacts.ticks, tick, "right"))
    first = int(np.searchsorted(contacts.substeps, contacts.substeps[end - 1], "left"))
    found: list[int] = contacts.robots[first:end].tolist()
    return found


def _aim(before: Array, now: Array, attacked: frozenset[int], goals: Goals) -> bool | None:
    """Return whether a ball that rolls straight on is on goal; None if it reaches no attacked line in time."""
    x, y = now.tolist()
    vx, vy = ((now - before) / TICK_S).tolist()
    end = 1 if vy > 0 else -1
    if vy == 0 or end not in attacked:
        return None
    needed_s = (end * goals.line_y_m - y) / vy
    at_x = x + vx * max(0.0, needed_s)
    if not (needed_s <= SHOT_WITHIN_S and abs(at_x) < goals.half_width_m):
        return None
    return bool(abs(at_x) < goals.widths_m.get(end, 0.0) / 2)


def _went_in(
    contacts: Contacts, places: Array, placed_at: Sequence[int], ends: Mapping[int, frozenset[int]], goals: Goals
) -> list[Shot]:
    """Return the last touch before each time that the ball came into a goal which that robot attacks."""
    found = []
    x, y = places[:, 0], places[:, 1]
    for end, width_m in goals.widths_m.items():
        inside = (end * y > goals.line_y_m) & (np.abs(x) < width_m / 2)
        for row in np.flatnonzero(inside[1:] & ~inside[:-1]).tolist():
            tick = row + 2
            last = int(np.searchsorted(contacts.ticks, tick, "right")) - 1
            if last < 0:
                continue
            robot, touched_at = int(contacts.robots[last]), int(contacts.ticks[last])
            put = any(touched_at <= placed < tick for placed in placed_at)
            if end in ends.get(robot, ()) and not put:
                found.append(Shot(touched_at, robot, on_goal=True))
    return found
