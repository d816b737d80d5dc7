"""Ranks teams by the values of the scenario's ``result``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

from rcj_challenges.core.amounts import round_score
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.referee.scope import NameScope
from rcj_challenges.referee.state import State
from rcj_challenges.rules.base import Firing, Number, Reader
from rcj_challenges.rules.ranked import Ranked
from rcj_challenges.scenario.halves import by_seat
from rcj_challenges.scenario.roster import ENTRANTS
from rcj_challenges.tracking.bound_rules import BoundRule
from rcj_challenges.tracking.contacts import Contacts

HalfValues = Mapping[str, Sequence[Number | None]]
"""By team, the values of a half by which it is ranked, in the order of the scenario's ``result``; None: it has none."""


def ranking(rank: Sequence[Ranked], teams: Sequence[str], halves: Sequence[HalfValues]) -> list[dict[str, Any]]:
    """Return ``{"place", "team", "values"}`` each, best first; later values break ties, equal teams share a place."""
    values = {
        team: [one.of_halves([half[team][at] for half in halves]) for at, one in enumerate(rank)] for team in teams
    }
    keys = {team: [one.number(value) for one, value in zip(rank, own, strict=True)] for team, own in values.items()}
    places = {team: 1 + sum(keys[other] < keys[team] for other in values) for team in values}  # integers
    best_first = sorted(values, key=keys.__getitem__)
    return [{"place": places[team], "team": team, "values": values[team]} for team in best_first]


class RankedValues:
    """Reads the values by which entrants are ranked, of one half."""

    def __init__(self, rank: Sequence[Ranked], state: State, contacts: Contacts) -> None:
        self._state = state
        self._added = _Added(state)
        self._readers = {
            seat: [
                (_reader(one, seat, state if one.over == "last" else cast("State", self._added), contacts))
                for one in rank
            ]
            for seat in state.scenario.entrants
        }

    def read(self, before: HalfInfo) -> HalfValues:
        """Return the values by now; ``before``: the half with the scores and counters that it began with."""
        self._added.update(before)
        return {
            team: [read(Firing(_rule_of(seat), None, "")) for read in self._readers[seat]]
            for seat, team in before.teams.items()
        }


def _reader(ranked: Ranked, seat: str, state: State, contacts: Contacts) -> Reader:
    scope = NameScope(state, contacts, seat)
    scope.for_each = ENTRANTS
    return ranked.compile(scope)


def _rule_of(seat: str) -> BoundRule:
    return BoundRule("", seat, None, None, None, None, "", entrant=seat)


class _Added:
    """The referee's state, in which scores, and counters that are kept for the match, are what a half has added."""

    def __init__(self, state: State) -> None:
        self._state = state
        self.scores = dict(state.scores)
        self.began_with: dict[str, dict[str, Number]] = {
            "half": dict.fromkeys(state.scores, 0),
            "phase": dict(state.scores),
        }
        self.counters = dict(state.counters)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._state, name)

    counter = State.counter

    def update(self, before: HalfInfo) -> None:
        """Work out what has been added to what was before."""
        state, kept = self._state, before.kept.get("counters", {})
        for seat in self.scores:
            earlier = before.scores.get(seat, 0)
            self.scores[seat] = round_score(state.scores[seat] - earlier)
            self.began_with["phase"][seat] = state.began_with["phase"][seat] - earlier
        for name, counter in state.scenario.counters.items():
            first = kept.get(name) if counter.keep == "match" else None
            first = by_seat(first, before.teams) if counter.per == ENTRANTS and first is not None else first
            self.counters[name] = _less(state.counters[name], first)


def _less(now: Any, before: Any) -> Any:
    if isinstance(now, dict):
        return {one: _less(value, before and before.get(one)) for one, value in now.items()}
    return None if now is None else round_score(now - (before or 0))
