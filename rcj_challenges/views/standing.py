"""The standings of a match that is ranked by more than the score, during play and at the end."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rcj_challenges.core.amounts import measure, measured_words, number_words
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.referee.ranking import Tally, counted_for, ranked_counters
from rcj_challenges.rules.effects import Scores
from rcj_challenges.scenario.halves import by_team
from rcj_challenges.scenario.models.scenario import RankByScore, Scenario
from rcj_challenges.scenario.roster import ENTRANTS

Value = int | float


def shows_score(scenario: Scenario) -> bool:
    """Return whether a scoreboard has points to show: rules give some, or the ranking compares them."""
    ranked = any(isinstance(criterion, RankByScore) for criterion in scenario.result.rank)
    return ranked or bool(scenario.effects(Scores))


def counted_names(scenario: Scenario) -> list[dict[str, str]]:
    """Return the counters that the ranking compares, as a scoreboard has them: ``{"name": "best", "unit": "s"}``."""
    return [dict(zip(("name", "unit"), measure(name), strict=True)) for name in ranked_counters(scenario)]


class RankingCounters:
    """Follows the counters that decide the ranking, for each team and over all halves."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._names = ranked_counters(scenario)
        self._over: list[Tally] = []
        self._seats: Mapping[str, str] = {}
        self._began: dict[str, Any] = {}
        self._latest: Mapping[str, Any] | None = None

    def begin(self, half: HalfInfo) -> None:
        """Begin a half."""
        counters = self._scenario.counters
        if self._latest is not None:
            self._over.append(self._tally(self._latest))
            self._began = {
                name: by_team(self._latest[name], self._seats) if counters[name].per == ENTRANTS else self._latest[name]
                for name in self._names
                if counters[name].keep == "match"
            }
        self._seats, self._latest = half.teams, None

    def by_team(self, counters: Mapping[str, Any]) -> dict[str, list[Value]] | None:
        """Return the current values by team, in the order of `counted_names`; None if a counter is missing."""
        if any(name not in counters for name in self._names):
            return None
        self._latest = counters
        halves = [*self._over, self._tally(counters)]
        teams = dict.fromkeys(self._seats.values())
        return {team: [counted_for(self._scenario, team, name, halves) for name in self._names] for team in teams}

    def _tally(self, counters: Mapping[str, Any]) -> Tally:
        """Return the counters of this half, without its time."""
        return Tally(counters, self._seats, time_s=0.0, began=self._began)


def counted_line(scenario: Scenario, values: list[Value]) -> str:
    """Return ``best 10.48 s, poles touched 2``: what counts for a team in the ranking beside its score."""
    names = ranked_counters(scenario)
    return ", ".join(measured_words(name, number_words(value)) for name, value in zip(names, values, strict=True))
