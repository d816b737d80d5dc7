"""Triggers about ways: crosses, sequence_completed, sequence_broken."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from rcj_challenges.facts.play import Pose2
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.regions import Cell
from rcj_challenges.referee.rules import Listener, StandingRule
from rcj_challenges.referee.sequences import GateLine, SequenceWatch, sequence_watches
from rcj_challenges.referee.watching import PositionWatch
from rcj_challenges.rules.triggers import Crosses, SequenceBroken, SequenceCompleted

_WAYS = {"forward": (1,), "backward": (-1,), "either": (1, -1)}


def crosses(model: Crosses, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a centre crosses a gate."""
    for entity in workshop.entities(model.entity, rule.each):
        for name in workshop.members(model.gate, rule.each):
            among = workshop.roster.drawn.get(name)
            for gate in (name,) if among is None else among:
                if workshop.scenario.gates[gate].anchor == workshop.roster.entities[entity]:
                    continue  # nothing crosses a gate that it carries
                line = GateLine(workshop.scenario.gates[gate], workshop)
                is_meant = None if among is None else _is_drawn(name, gate, workshop)
                key, make = (
                    (entity, gate, name if among else None),
                    partial(GateWatch, entity, line, workshop, is_meant),
                )
                watch = workshop.watch(GateWatch, key, rule, make)
                for way in _WAYS[model.direction]:
                    watch.listeners[way].append(workshop.listener(rule, position, model.trigger, entity))


def _is_drawn(draw: str, gate: str, workshop: Workshop) -> Callable[[], bool]:
    draws = workshop.state.draws
    return lambda: draws[draw] == gate


class GateWatch(PositionWatch):
    """Follows an entity across a gate.

    Attributes:
        listeners: ears by direction, 1 forward and -1 backward.
    """

    def __init__(
        self, entity: int, gate: GateLine, workshop: Workshop, is_meant: Callable[[], bool] | None = None
    ) -> None:
        self.entity = entity
        self.entities = (entity,)
        self.listeners: dict[int, list[Listener]] = {1: [], -1: []}
        self._gate = gate
        self._is_meant = is_meant
        self._hits = workshop.hits

    def restart(self) -> None:
        """Nothing is remembered: a way begins where the entity is."""

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell that the gate does not reach into."""
        return self._gate.cell(x_m, y_m)

    def advance(self, before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report each direction once a tick; of a gate that a draw decides on while it is the one."""
        if self._is_meant is not None and not self._is_meant():
            return
        was, crossed = before, set()
        for now in substeps:
            crossed.add(self._gate.crossed(self.entity, was, now))
            was = now
        for way in (1, -1):
            if way in crossed:
                self._hits.report(self.listeners[way])


def sequence_completed(model: SequenceCompleted, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when the last step of a sequence is made; measured is the time since its first, in s."""
    for watch in _heard(model, rule, workshop):
        watch.completed.append(workshop.listener(rule, position, model.trigger, watch.entity))


def sequence_broken(model: SequenceBroken, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a wrong step is made."""
    for watch in _heard(model, rule, workshop):
        watch.broken.append(workshop.listener(rule, position, model.trigger, watch.entity))


def _heard(
    model: SequenceCompleted | SequenceBroken, rule: StandingRule, workshop: Workshop
) -> tuple[SequenceWatch, ...]:
    """Return the watches that a trigger hears: those of the ones it names, else of all who have one."""
    watches = sequence_watches(workshop, model.sequence)
    if model.entity is None:
        return tuple(watches.values())
    return tuple(watches[member] for member in workshop.members(model.entity, rule.each))
