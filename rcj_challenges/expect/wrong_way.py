"""Notes on gates that were crossed the wrong way in a test: a likely reason for a missing event."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import NamedTuple

from rcj_challenges.core.play import Pose2
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.geometry.regions import crossing
from rcj_challenges.rules.effects import Crossing
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.tracking.gates import seen_from

_WAYS = {1: "forward", -1: "backward"}
_WRONG = {"forward": -1, "backward": 1}


class _Passage(NamedTuple):
    """A crossing that counts for nothing: of an entity, through a gate, 1 forward or -1 backward."""

    entity: int
    gate: str
    way: int
    without_effect: str


class WrongWays:
    """Notes which gates were crossed the way that a sequence, or a rule with a direction, does not count."""

    def __init__(self, scenario: Scenario, roster: Roster) -> None:
        self._roster = roster
        self._gates = scenario.gates
        sequences = (
            passage for name, sequence in scenario.sequences.items() for passage in self._of_sequence(name, sequence)
        )
        rules = (passage for name, rule in scenario.rules.items() for passage in self._of_rule(name, rule))
        self.passages = tuple(dict.fromkeys((*sequences, *rules)))
        self._first: dict[_Passage, int] = {}

    def _of_sequence(self, name: str, sequence: Sequence) -> Iterable[_Passage]:
        steps = (one for places in sequence.places() for one in places)
        gates = [gate for gate in self._roster.expand(tuple(steps)) if gate in self._gates]
        for entity in self._entities(self._roster.expand(sequence.followed)):
            for gate in gates:
                yield _Passage(entity, gate, -1, f"no step of {name}, which counts only gates crossed forward")

    def _of_rule(self, name: str, rule: Rule) -> Iterable[_Passage]:
        for one in rule.moments(Crossing):
            if one.direction == "either":
                continue
            unheard = f"not counted by the rule {name}, which has direction: {one.direction}"
            for each in (None,) if rule.for_each is None else self._roster.keepers(rule.for_each):
                for entity in self._entities(self._roster.named(one.entity, rule.for_each, each)):
                    # A gate that is drawn is not looked at: it may be another one at that time.
                    for gate in self._roster.named(one.gate, rule.for_each, each):
                        if gate in self._gates:
                            yield _Passage(entity, gate, _WRONG[one.direction], unheard)

    def _entities(self, names: tuple[str, ...]) -> tuple[int, ...]:
        return tuple(self._roster.index[name] for name in names)

    def look(self, tick: int, before: list[Pose2], substeps: list[list[Pose2]], parked: Collection[int]) -> None:
        """Note the crossings of a tick in its sub-steps, ``[sub-step][entity]``, from the poses by entity before them.

        Entities that are parked, off the field, cross nothing, nor are gates crossed that are anchored to them.
        """
        for passage in self.passages:
            if passage in self._first or passage.entity in parked:
                continue
            was = before
            for now in substeps:
                if now is not was and self._way(passage, was, now, parked) == passage.way:
                    self._first[passage] = tick
                    break
                was = now

    def _way(self, passage: _Passage, was: list[Pose2], now: list[Pose2], parked: Collection[int]) -> int:
        gate, entity = self._gates[passage.gate], passage.entity
        start, end = was[entity][:2], now[entity][:2]
        if gate.anchor is not None:
            anchor = self._roster.index[gate.anchor]
            if anchor in parked:
                return 0
            start, end = seen_from(was[anchor], was[entity]), seen_from(now[anchor], now[entity])
        return crossing(start, end, gate.from_m, gate.to_m)

    def notes(self) -> Iterable[str]:
        """Return the crossings the wrong way, each with its first time in s."""
        for passage, tick in sorted(self._first.items(), key=lambda entry: entry[1]):
            name = self._roster.entities[passage.entity]
            when = f"{s_from_ticks(tick):g} s"
            yield f"note: {name} crossed {passage.gate} {_WAYS[passage.way]} at {when}: {passage.without_effect}"
