"""Ranks teams by the values of the scenario's ``result``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from rcj_challenges.core.amounts import round_score
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.referee.scope import NameScope
from rcj_challenges.referee.state import State
from rcj_challenges.rules.base import Number
from rcj_challenges.rules.ranked import Ranked
from rcj_challenges.scenario.halves import by_seat
from rcj_challenges.scenario.roster import ENTRANTS
from rcj_challenges.tracking.bound_rules import NO_FIRING

HalfValues = Mapping[str, Sequence[Number | None]]
"""By team, the values of a half by which it is ranked, in the order of the scenario's ``result``; None: it has none."""


def ranking(rank: Sequence[Ranked], teams: Sequence[str], halves: Sequence[HalfValues]) -> list[dict[str, Any]]:
    """Return ``{"place", "team", "values"}`` each, best first; later values break ties, equal teams share a place."""
    values = {team: over_halves(rank, team, halves) for team in teams}
    keys = {team: [one.number(value) for one, value in zip(rank, own, strict=True)] for team, own in values.items()}
    places = {team: 1 + sum(keys[other] < keys[team] for other in values) for team in values}  # integers
    best_first = sorted(values, key=keys.__getitem__)
    return [{"place": places[team], "team": team, "values": values[team]} for team in best_first]


def over_halves(rank: Sequence[Ranked], team: str, halves: Sequence[HalfValues]) -> list[Number | None]:
    """Return what counts for a team of the values of the halves."""
    return [one.of_halves([half[team][at] for half in halves]) for at, one in enumerate(rank)]


class RankedValues:
    """Reads the values by which entrants are ranked, of one half."""

    def __init__(self, rank: Sequence[Ranked], state: State) -> None:
        self._last = [one.over == "last" for one in rank]
        self._state = state
        seats = state.scenario.entrants
        self._readers = {seat: [one.compile(NameScope(state, seat, ENTRANTS)) for one in rank] for seat in seats}

    def read(self, before: HalfInfo) -> HalfValues:
        """Return the values by now; ``before``: the half with the scores and counters that it began with."""
        state, totals = self._state, self._read(before)
        points, counters = (state.scores, *state.began_with.values()), state.counters
        all_points, all_counters = [dict(one) for one in points], dict(counters)
        for one in points:
            one.update({seat: round_score(number - before.scores.get(seat, 0)) for seat, number in one.items()})
        for name, first in before.kept.get("counters", {}).items():
            is_of_entrants = state.scenario.counters[name].per == ENTRANTS
            counters[name] = _less(counters[name], by_seat(first, before.teams) if is_of_entrants else first)
        found = self._read(before)
        counters.update(all_counters)
        for one, all_there in zip(points, all_points, strict=True):
            one.update(all_there)
        for team, values in found.items():
            values[:] = [totals[team][at] if self._last[at] else value for at, value in enumerate(values)]
        return found

    def _read(self, half: HalfInfo) -> dict[str, list[Number | None]]:
        return {team: [read(NO_FIRING) for read in self._readers[seat]] for seat, team in half.teams.items()}


def _less(now: Any, before: Any) -> Any:
    """Return what has been added to a counter, or to that of each of several."""
    if isinstance(now, dict):
        return {one: _less(value, before[one]) for one, value in now.items()}
    return None if now is None else round_score(now - (before or 0))
