"""The trigger ``crosses``."""

from typing import Annotated, Literal

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import Cell
from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.effects import Passage
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ENTITIES, GATES
from rcj_challenges.tracking.bound_rules import TriggerBinding
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import Missed, PositionTracker


class Crosses(Trigger):
    """Fires when an entity's centre crosses a gate."""

    trigger: Literal["crosses"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    gate: Annotated[Names, GATES] = described(
        ..., "a gate, each, a draw's name, or a list or group of gates (any of them)"
    )
    direction: Literal["forward", "backward", "either"] = described("either", "direction of the crossing")

    MOMENT = Passage
    EXAMPLE = """
gates:
  # Seen from one post to the other, forward is from the right to the left: here towards +y.
  first_gate: {from_m: [-0.1, 0.2], to_m: [0.1, 0.2]}
rules:
  through:
    triggers: [{trigger: crosses, entity: Y1, gate: first_gate, direction: forward}]
    actions: [{action: emit, event: THROUGH}]
expect:
  only_crossing_forward_counts:
    keyframes:
      - {at_s: 1, place: {Y1: [0, 0.1]}}
      - {at_s: 2, move: {Y1: [0, 0.3]}}
      - {at_s: 3, move: {Y1: [0, 0.1]}}
    lasts_s: 4
    events: [{event: THROUGH, at_s: 1.5, tolerance_s: 0.05}]
"""

    def bind(self, to: Binder) -> None:
        """Bind a rule to a tracker for each entity and gate; of a draw's name for each gate that it may decide on."""
        for entity in to.entities(self.entity):
            for name in to.members(self.gate):
                draw = name if name in to.drawn else None
                for gate in to.drawn.get(name, (name,)):
                    line = to.gate(gate)
                    if line.anchor == entity:
                        continue  # nothing crosses a gate that it carries
                    tracker = to.track(GateTracker, (entity, gate, draw), entity, line, gate, draw)
                    for direction in _DIRECTIONS[self.direction]:
                        tracker.by_direction[direction].append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        way = {"either": "", "forward": " forward", "backward": " backward"}[self.direction]
        return f"{phrases.any_of(self.entity)} crosses {phrases.any_of(self.gate)}{way}"


_DIRECTIONS = {"forward": (1,), "backward": (-1,), "either": (1, -1)}


class GateTracker(PositionTracker):
    """Follows an entity across a gate.

    Attributes:
        by_direction: the rules that it reports to, by direction: 1 forward and -1 backward.

    Args:
        name: of the gate.
        draw: what must have decided on it; None: it always counts.
    """

    def __init__(self, state: RefereeState, entity: int, gate: GateLine, name: str, draw: str | None) -> None:
        super().__init__(state, entity)
        self.by_direction: dict[int, list[TriggerBinding]] = {1: [], -1: []}
        self._gate = gate
        self._name, self._draw = name, draw

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell that the gate does not reach into."""
        return self._gate.cell(x_m, y_m)

    def advance(self, before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report each direction once a tick; of a gate that a draw decides on while it is the one."""
        if self._draw is not None and self._state.draws[self._draw] != self._name:
            return
        was, crossed = before, set()
        for now in substeps:
            crossed.add(self._gate.crossed(self.entity, was, now))
            was = now
        for way in (1, -1):
            if way in crossed:
                self._hits.report(self.by_direction[way])
                if not self.by_direction[way] and self.missed is None:
                    what = f"{self._name} {'forward' if way > 0 else 'backward'}"
                    self.missed = Missed(self._state.tick, "crossed", what, self.by_direction[-way])
