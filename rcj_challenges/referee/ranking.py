"""Ranks teams by the criteria of the scenario's ``result``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from rcj_challenges.core.amounts import Score, add_up, clamp_to_max, round_score
from rcj_challenges.scenario.models.scenario import RankByCounter, RankByScore, RankByTime, Scenario
from rcj_challenges.scenario.roster import ENTRANTS


@dataclass(frozen=True)
class Tally:
    """The contribution of a finished half to the ranking.

    Attributes:
        counters: by name; kept per entity: by entity, per entrants: by seat.
        teams: by seat: a counter kept per robot counts for the team whose robot it was in this half.
        time_s: simulated time in s at which it ended.
        began: what counters marked ``keep: match`` had from the half before, per entrants by team: that is counted
            there.
    """

    counters: Mapping[str, Any]
    teams: Mapping[str, str]
    time_s: float
    began: Mapping[str, Any] = field(default_factory=dict)


def ranked_counters(scenario: Scenario) -> tuple[str, ...]:
    """Return the counters that the scenario's ``result`` ranks by, each once, in the order of the criteria."""
    names: list[str] = []
    for criterion in scenario.result.rank:
        if isinstance(criterion, RankByCounter):
            names.append(criterion.counter)
        elif isinstance(criterion, RankByTime):
            names += [part.counter for part in criterion.plus]
    return tuple(dict.fromkeys(names))


def counted_for(scenario: Scenario, team: str, counter: str, halves: Sequence[Tally]) -> Score:
    """Return a team's counters over halves: those of its own robots, or one that all share."""
    return round_score(add_up(_count(scenario, half, counter, team) for half in halves))


def ranking(scenario: Scenario, scores: Mapping[str, Score], halves: Sequence[Tally]) -> list[dict[str, Any]]:
    """Return ``{"place", "team", "values"}`` each, best first; teams that are equal by all criteria share a place.

    Criteria, in the order of the values, are those of the scenario's ``result.rank``; a later one breaks ties. Scores
    are by team; times and counters of all halves are added up.
    """
    criteria = scenario.result.rank
    values = {
        team: [_value(criterion, team, scores[team], scenario, halves) for criterion in criteria] for team in scores
    }
    keys = {
        team: [sign(criterion) * value for criterion, value in zip(criteria, own, strict=True)]
        for team, own in values.items()
    }
    best_first = sorted(values, key=keys.__getitem__)
    places = {team: 1 + sum(keys[other] < keys[team] for other in values) for team in values}  # integers
    return [{"place": places[team], "team": team, "values": values[team]} for team in best_first]


def _value(
    criterion: RankByScore | RankByTime | RankByCounter,
    team: str,
    score: Score,
    scenario: Scenario,
    halves: Sequence[Tally],
) -> Score:
    if isinstance(criterion, RankByScore):
        return score
    if isinstance(criterion, RankByCounter):
        return counted_for(scenario, team, criterion.counter, halves)
    time_s = add_up(half.time_s for half in halves)
    added = add_up(
        clamp_to_max(part.weight * counted_for(scenario, team, part.counter, halves)) for part in criterion.plus
    )
    return round(clamp_to_max(time_s + added), 6)


def _count(scenario: Scenario, half: Tally, name: str, team: str) -> Score:
    """Return the count of a team in a half: of a counter that is kept, what the half adds."""
    seats = [seat for seat, one in half.teams.items() if one == team]
    robots = [robot for seat in seats for robot in scenario.entrants[seat].robots]
    is_of_entrants = scenario.counters[name].per == ENTRANTS

    def of_owners(counted: Score | Mapping[str, Score], owners: Sequence[str]) -> Score:
        return add_up(counted.get(owner) or 0 for owner in owners) if isinstance(counted, Mapping) else counted or 0

    now, before = (seats, [team]) if is_of_entrants else (robots, robots)
    return of_owners(half.counters[name], now) - of_owners(half.began.get(name, 0), before)


def sign(criterion: RankByScore | RankByTime | RankByCounter) -> int:
    """Return 1 if the least value of a criterion is best, -1 if the greatest is."""
    order = (
        criterion.score
        if isinstance(criterion, RankByScore)
        else criterion.time
        if isinstance(criterion, RankByTime)
        else criterion.order
    )
    return 1 if order == "ascending" else -1
