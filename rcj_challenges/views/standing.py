"""The standings of a match that is ranked by more than the score, during play and at the end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from rcj_challenges.core.amounts import measure, measured_words, number_words
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.referee.ranking import HalfValues, RankedValues, over_halves
from rcj_challenges.referee.state import State
from rcj_challenges.rules.effects import Scores
from rcj_challenges.rules.ranked import counters_in
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

Value = int | float | None


def shows_score(scenario: Scenario) -> bool:
    """Return whether a scoreboard has points to show: rules give some, or the ranking compares them."""
    return any(one.is_score for one in scenario.result.rank) or bool(scenario.effects(Scores))


def counted_names(scenario: Scenario) -> list[dict[str, str]]:
    """Return the counters that the ranking reads, as a scoreboard has them: ``{"name": "best", "unit": "s"}``."""
    return [dict(zip(("name", "unit"), measure(name), strict=True)) for name in counters_in(scenario.result.rank)]


class RankingCounters:
    """Follows the counters that decide the ranking, for each team and over all halves."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario, self._roster = scenario, Roster.of(scenario)
        counted = counters_in(scenario.result.rank)
        self._names, self._counted = tuple(counted), tuple(counted.values())
        self._over: list[HalfValues] = []
        self._state: State | None = None
        self._latest: HalfValues | None = None

    def begin(self, half: HalfInfo) -> None:
        """Begin a half."""
        if self._latest is not None:
            self._over.append(self._latest)
        kept = {} if self._state is None else self._state.kept()
        self._latest, self._state = None, State(self._scenario, self._roster, replace(half, kept=kept))
        self._values = RankedValues(self._counted, self._state)

    def by_team(self, counters: Mapping[str, Any]) -> dict[str, list[Value]] | None:
        """Return the current values by team, in the order of `counted_names`; None if a counter is missing."""
        if any(name not in counters for name in self._names) or self._state is None:
            return None
        self._state.counters.update(counters)
        self._latest = self._values.read(self._state.half)
        halves = [*self._over, self._latest]
        return {team: over_halves(self._counted, team, halves) for team in self._latest}


def counted_line(scenario: Scenario, values: list[Value]) -> str:
    """Return ``best 10.48 s, poles touched 2``: what counts for a team in the ranking beside its score."""
    named = zip(counters_in(scenario.result.rank), values, strict=True)
    return ", ".join(measured_words(name, number_words(value)) for name, value in named)
