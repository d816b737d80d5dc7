"""Sequences: steps to be made in order over zones or gates."""

from __future__ import annotations

from math import cos, sin

from rcj_challenges.facts.play import Pose2
from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.regions import (
    EVERYWHERE,
    NOWHERE,
    Cell,
    Region,
    box_around,
    common_cell,
    crossing,
)
from rcj_challenges.referee.rules import Listener
from rcj_challenges.referee.watching import PositionWatch, Watch
from rcj_challenges.scenario.followed import followed, phases_of
from rcj_challenges.scenario.models.places import Gate
from rcj_challenges.scenario.models.state import AnyStep, Sequence
from rcj_challenges.scenario.polygons import distance_to_segment_m

_NOT_BEGUN = -1


class GateLine:
    """A gate on the field: fixed, or moving and turning with an entity.

    Args:
        gate: the gate of the scenario.
        workshop: names and state.
    """

    def __init__(self, gate: Gate, workshop: Workshop) -> None:
        self.anchor = None if gate.anchor is None else workshop.entity(gate.anchor, None)
        self._from, self._to = gate.from_m, gate.to_m
        self._state = workshop.state

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell that the gate does not reach into; a moving gate leaves none."""
        if self.anchor is not None:
            return NOWHERE
        return box_around(x_m, y_m, distance_to_segment_m(x_m, y_m, *self._from, *self._to))

    def distance_m(self, x_m: float, y_m: float) -> float | None:
        """Return how far a point is from it now, in m; None while what it moves with is off the field."""
        if self.anchor is None:
            return distance_to_segment_m(x_m, y_m, *self._from, *self._to)
        if not self._state.present[self.anchor]:
            return None
        seen = seen_from(self._state.poses[self.anchor], (x_m, y_m, 0.0))
        return distance_to_segment_m(*seen, *self._from, *self._to)

    def crossed(self, entity: int, was: list[Pose2], now: list[Pose2]) -> int:
        """Return 1 if the entity crossed it forward in this sub-step, -1 backward, 0 if it did not."""
        if self.anchor is None:
            return crossing(was[entity][:2], now[entity][:2], self._from, self._to)
        if not self._state.present[self.anchor]:
            return 0
        start = seen_from(was[self.anchor], was[entity])
        end = seen_from(now[self.anchor], now[entity])
        return crossing(start, end, self._from, self._to)


def seen_from(anchor: Pose2, pose: Pose2) -> tuple[float, float]:
    """Return where a pose is in the frame of an anchor that moves and turns: x and y in m."""
    dx, dy = pose[0] - anchor[0], pose[1] - anchor[1]
    c, s = cos(anchor[2]), sin(anchor[2])
    return (c * dx + s * dy, c * dy - s * dx)


class SequenceWatch(PositionWatch):
    """Follows an entity along the steps of a sequence.

    Attributes:
        reached: name of the zone or gate reached last; None before the first step.
        completed, broken: ears.
    """

    def __init__(self, sequence: Sequence, whose: str, workshop: Workshop) -> None:
        self.entity = workshop.entity(whose, None)
        self.entities = (self.entity,)
        self.reached: str | None = None
        self.completed: list[Listener] = []
        self.broken: list[Listener] = []
        self._workshop = workshop
        self._state = workshop.state
        self._cyclic = sequence.cyclic
        self._breaks = sequence.wrong_step == "break"
        self._goes_on = sequence.when_placed == "goes_on"
        self._steps = [
            workshop.members(step.any_of if isinstance(step, AnyStep) else step, None) for step in sequence.steps
        ]
        names = tuple(dict.fromkeys(name for step in self._steps for name in step))
        self._zones: dict[str, Region] = {
            name: workshop.zone(name) for name in names if name in workshop.scenario.zones
        }
        gates = workshop.scenario.gates
        self._gates = {name: GateLine(gates[name], workshop) for name in names if name not in self._zones}
        self._inside: set[str] = set()
        self._at = _NOT_BEGUN
        self._begun = 0

    def restart(self) -> None:
        """Stand at the first step if the entity is in it, else before it."""
        self._at, self.reached = _NOT_BEGUN, None
        self._look_around()
        if self._state.present[self.entity]:
            self._stand_at_first()

    def moved(self) -> None:
        """Begin anew, or keep the steps made, if there are any: then the place where the entity was put is no step."""
        if self._goes_on and self._at != _NOT_BEGUN:
            self._look_around()
        else:
            self.restart()

    def _look_around(self) -> None:
        """Take note of the zones in which the entity is; off the field it is in none."""
        x, y, _ = self._state.poses[self.entity]
        self._inside = self._zones_at(x, y) if self._state.present[self.entity] else set()

    def _zones_at(self, x_m: float, y_m: float) -> set[str]:
        return {name for name, region in self._zones.items() if region.contains(x_m, y_m)}

    def _stand_at_first(self) -> None:
        inside = [name for name in self._steps[0] if name in self._inside]
        self._at, self.reached = (0, inside[0]) if inside else (_NOT_BEGUN, None)
        self._begun = self._state.tick

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell in which no step is made."""
        cell = EVERYWHERE
        for region in self._zones.values():
            cell = common_cell(cell, region.cell(x_m, y_m))
        for gate in self._gates.values():
            cell = common_cell(cell, gate.cell(x_m, y_m))
        return cell

    def advance(self, before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Make the steps of this tick, in the order in which they happen."""
        was = before
        for now in substeps:
            x, y, _ = now[self.entity]
            inside = self._zones_at(x, y)
            made = [name for name in self._zones if name in inside and name not in self._inside]
            made += [name for name, gate in self._gates.items() if gate.crossed(self.entity, was, now) > 0]
            self._inside = inside
            was = now
            if made:
                self._make(made)

    def _make(self, made: list[str]) -> None:
        """Make steps with the places reached in one sub-step; what is then left over was a wrong step."""
        left = dict.fromkeys(made)
        while left:
            expected = self._expected()
            step = next((name for name in left if name in expected), None)
            if step is None:
                break
            del left[step]
            self._step_to(step)
        current = self._steps[self._at] if self._at != _NOT_BEGUN else ()
        if self._breaks and self._at != _NOT_BEGUN and any(name not in current for name in left):
            self._report(self.broken)
            self._stand_at_first()

    def _expected(self) -> tuple[str, ...]:
        following = self._at + 1
        if following < len(self._steps):
            return self._steps[following]
        return self._steps[0]

    def _step_to(self, name: str) -> None:
        last = len(self._steps) - 1
        if self._at == _NOT_BEGUN:
            self._begun = self._state.tick
        self.reached = name
        if self._at < last:
            self._at += 1
            if self._at == last and not self._cyclic:
                self._report(self.completed)
                self._at = _NOT_BEGUN
            return
        self._report(self.completed)
        self._at, self._begun = 0, self._state.tick

    def _report(self, listeners: list[Listener]) -> None:
        self._workshop.hits.report(listeners, measured=s_from_ticks(self._state.tick - self._begun))


def sequence_watches(workshop: Workshop, name: str) -> dict[str | None, SequenceWatch]:
    """Return the watches of a sequence by whose it is; None for one that is not kept per entity.

    They are the same for all rules, and live wherever one of these does.
    """
    sequence, known = workshop.scenario.sequences[name], workshop.sequences
    followed_ones = workshop.members(followed(sequence), None)
    if any((name, one) not in known for one in followed_ones):
        phases = phases_of(workshop.scenario, name)
        for one in followed_ones:
            known[name, one] = watch = SequenceWatch(sequence, one, workshop)
            watch.phases = phases
            workshop.lookout.add(watch)
    return {None if sequence.per is None else one: _watch(known[name, one], name) for one in followed_ones}


def _watch(found: Watch, name: str) -> SequenceWatch:
    if not isinstance(found, SequenceWatch):
        message = f"not a sequence: {name!r}"
        raise TypeError(message)
    return found
