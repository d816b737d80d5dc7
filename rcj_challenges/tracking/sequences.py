"""Sequences: steps to be made over zones or gates."""

from __future__ import annotations

from typing import NamedTuple

from rcj_challenges.core.play import Pose2
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.geometry.regions import EVERYWHERE, Cell, Region, common_cell
from rcj_challenges.tracking.bound_rules import TriggerBinding
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import Missed, PositionTracker

_NOT_BEGUN = -1


class SequencePath(NamedTuple):
    """The steps of a sequence.

    Attributes:
        steps: for each step the zones and gates that satisfy it.
        is_cyclic: whether it goes on with its first step when it is complete.
        breaks: whether a wrong step ends it.
        survives_placement: whether the steps made are kept when a rule puts its entity somewhere.
        is_in_any_order: whether the steps may be made in any order.
    """

    steps: tuple[tuple[str, ...], ...]
    is_cyclic: bool
    breaks: bool
    survives_placement: bool
    is_in_any_order: bool = False


class SequenceTracker(PositionTracker):
    """Follows an entity along the steps of a sequence.

    Attributes:
        reached: name of the zone or gate reached last; None before the first step.
    """

    def __init__(
        self, state: RefereeState, entity: int, path: SequencePath,
        zones: dict[str, Region], gates: dict[str, GateLine],
    ) -> None:  # fmt: skip
        super().__init__(state, entity)
        self.reached: str | None = None
        self.completed: list[TriggerBinding] = []
        self.broken: list[TriggerBinding] = []
        self._path = path
        self._steps = list(path.steps)  # in any order: as they are made
        self._zones = zones
        self.entities = (entity, *(anchor for region in zones.values() for anchor in region.anchors))
        self._gates = gates
        self._inside: set[str] = set()
        self._at = _NOT_BEGUN
        self._begun = 0

    def reset(self) -> None:
        """Stand at the first step if the entity is in it, else before it."""
        self._at, self.reached = _NOT_BEGUN, None
        self._look_around()
        if self._state.present[self.entity]:
            self._stand_at_first()

    def moved(self) -> None:
        """Reset, or keep the steps made, if there are any: then the place where the entity was put does not count."""
        if self._path.survives_placement and self._at != _NOT_BEGUN:
            self._look_around()
        else:
            self.reset()

    def _look_around(self) -> None:
        """Take note of the zones in which the entity is; off the field it is in none."""
        x, y, _ = self._state.poses[self.entity]
        self._inside = self._zones_at(x, y) if self._state.present[self.entity] else set()

    def _zones_at(self, x_m: float, y_m: float) -> set[str]:
        return {name for name, region in self._zones.items() if region.contains(x_m, y_m)}

    def _stand_at_first(self) -> None:
        self._at, self.reached, self._begun = _NOT_BEGUN, None, self._state.tick
        inside = next((name for name in self._expected() if name in self._inside), None)
        if inside is not None:
            self._step_to(inside)

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
            self._state.seen = now
            x, y, _ = now[self.entity]
            inside = self._zones_at(x, y)
            self._state.seen = None
            made = [name for name in self._zones if name in inside and name not in self._inside]
            crossed = {name: gate.crossed(self.entity, was, now) for name, gate in self._gates.items()}
            made += [name for name, way in crossed.items() if way > 0]
            for gate in (name for name, way in crossed.items() if way < 0):
                self.missed = self.missed or Missed(self._state.tick, "crossed", f"{gate} backward")
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
        if self._path.breaks and self._at != _NOT_BEGUN and any(name not in current for name in left):
            self._report(self.broken)
            self._stand_at_first()

    def _expected(self) -> tuple[str, ...]:
        left = self._steps[self._at + 1 :]
        if self._path.is_in_any_order and left:
            return tuple(name for step in left for name in step)
        return left[0] if left else self._steps[0]

    def _step_to(self, name: str) -> None:
        last = len(self._steps) - 1
        if self._at == _NOT_BEGUN:
            self._begun = self._state.tick
        self.reached = name
        if self._at < last:
            self._at += 1
            if self._path.is_in_any_order:
                made = next(place for place in range(self._at, last + 1) if name in self._steps[place])
                self._steps.insert(self._at, self._steps.pop(made))
            if self._at == last and not self._path.is_cyclic:
                self._report(self.completed)
                self._at = _NOT_BEGUN
            return
        self._report(self.completed)
        self._at, self._begun = 0, self._state.tick

    def _report(self, bindings: list[TriggerBinding]) -> None:
        self._hits.report(bindings, measured=s_from_ticks(self._state.tick - self._begun))
