"""Seats and teams: the team in each seat in each half.

A *seat* is an entrant of the scenario (``blue``): it owns robots and a goal. A *team* is what a seat holds in the
first half, and keeps that name for the whole match. With ``swap_sides`` two teams exchange seats after each half.
The match, tests and readers of records all use this module, so that they agree.
"""

from __future__ import annotations

from collections.abc import Mapping

from rcj_challenges.core.amounts import Score
from rcj_challenges.scenario.models.scenario import Scenario


def teams_by_seat(scenario: Scenario, half: int) -> dict[str, str]:
    """Return, by seat, the team (named by its seat of the first half) that plays there in a half (1-based)."""
    seats = list(scenario.entrants)
    teams = seats[::-1] if scenario.match.swap_sides and half % 2 == 0 else seats
    return dict(zip(seats, teams, strict=True))


def by_seat(by_team: Mapping[str, Score], teams: Mapping[str, str]) -> dict[str, Score]:
    """Return scores by seat from scores by team."""
    return {seat: by_team[team] for seat, team in teams.items()}


def by_team(by_seat_now: Mapping[str, Score], teams: Mapping[str, str]) -> dict[str, Score]:
    """Return scores by team, in the order of the first half's seats, from scores by seat."""
    scores = {team: by_seat_now[seat] for seat, team in teams.items()}
    return {team: scores[team] for team in sorted(scores, key=list(teams).index)}
