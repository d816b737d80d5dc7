"""Who is ranked where, by the criteria of the scenario's ``result``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rcj_challenges.scenario.models.scenario import RankByCounter, RankByScore, RankByTime, Scenario

Score = int | float
Counters = Mapping[str, Any]


def ranking(
    scenario: Scenario, scores: Mapping[str, Score], counters: Counters, teams: Mapping[str, str], time_s: float
) -> list[dict[str, Any]]:
    """Return the teams, best first; teams that no criterion tells apart share a place.

    Args:
        scenario: its ``result.rank`` holds the criteria; a later one breaks ties.
        scores: by team.
        counters: of the last half, by name; kept per entity: by entity.
        teams: of the last half, by seat: a counter kept per robot counts for the team whose robot it is.
        time_s: simulated time in s at which the last half ended.

    Returns:
        ``{"place", "team", "values"}`` each; values in the order of the criteria.
    """
    criteria = scenario.result.rank
    robots = {team: tuple(scenario.entrants[seat].robots) for seat, team in teams.items()}
    values = {
        team: [_value(criterion, scores[team], counters, robots[team], time_s) for criterion in criteria]
        for team in scores
    }
    keys = {
        team: [_sign(criterion) * value for criterion, value in zip(criteria, own, strict=True)]
        for team, own in values.items()
    }
    best_first = sorted(values, key=keys.__getitem__)
    return [
        {"place": 1 + sum(keys[other] < keys[team] for other in values), "team": team, "values": values[team]}
        for team in best_first
    ]


def _value(
    criterion: RankByScore | RankByTime | RankByCounter,
    score: Score,
    counters: Counters,
    robots: tuple[str, ...],
    time_s: float,
) -> Score:
    if isinstance(criterion, RankByScore):
        return score
    if isinstance(criterion, RankByCounter):
        return _count(counters, criterion.counter, robots)
    return round(time_s + sum(part.weight * _count(counters, part.counter, robots) for part in criterion.plus), 6)


def _count(counters: Counters, name: str, robots: tuple[str, ...]) -> Score:
    counted: Score | Mapping[str, Score] = counters[name]
    return sum(counted.get(robot, 0) for robot in robots) if isinstance(counted, Mapping) else counted


def _sign(criterion: RankByScore | RankByTime | RankByCounter) -> int:
    order = (
        criterion.score
        if isinstance(criterion, RankByScore)
        else criterion.time
        if isinstance(criterion, RankByTime)
        else criterion.order
    )
    return 1 if order == "ascending" else -1
