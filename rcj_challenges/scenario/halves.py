"""The halves of a match: their lengths, and the team in each seat.

A half is longer than its length where a phase stops the clock. A *seat* is an entrant of the scenario (``blue``): it
owns robots and a goal. A *team* is what a seat holds in the first half, and keeps that name for the whole match. With
``swap_sides`` two teams exchange seats after each half. The match, tests and readers of records all use this module,
so that they agree. A team may have kits of its own, which it takes along.
"""

from __future__ import annotations

from collections.abc import Mapping

from rcj_challenges.core.amounts import Score
from rcj_challenges.scenario.models.field import Match
from rcj_challenges.scenario.models.scenario import Scenario

MAX_LENGTHS = 10
"""A half whose clock a phase has stopped for good ends after this many times its length."""


def half_lengths_s(match: Match) -> tuple[float, ...]:
    """Return the length of each half that is played, in s.

    Where more halves are asked for than the file has lengths (on the command line), the last one goes for them too.
    """
    written = match.half_s if isinstance(match.half_s, tuple) else (match.half_s,)
    return tuple(written[min(number, len(written) - 1)] for number in range(match.halves))


def half_length_s(match: Match, half: int) -> float:
    """Return the length of a half in s, numbered from 1; beyond those that are played it is as long as the last."""
    lengths_s = half_lengths_s(match)
    return lengths_s[min(half, len(lengths_s)) - 1]


def longest_half_s(match: Match) -> float:
    """Return the length of the longest half that is played, in s."""
    return max(half_lengths_s(match))


def clock_may_stop(scenario: Scenario) -> bool:
    """Return whether a phase stops the clock, so that a half lasts longer than its length."""
    return any(phase.clock == "stops" for phase in scenario.phases.values())


def teams_by_seat(scenario: Scenario, half: int) -> dict[str, str]:
    """Return, by seat, the team (named by its seat of the first half) that plays there in a half (1-based)."""
    seats = list(scenario.entrants)
    teams = seats[::-1] if scenario.match.swap_sides and half % 2 == 0 else seats
    return dict(zip(seats, teams, strict=True))


def in_half(scenario: Scenario, half: int) -> Scenario:
    """Return the scenario of a half, in which each robot has the kit of the team that drives it there."""
    seats = teams_by_seat(scenario, half)
    kits = {
        robot: kit
        for seat, team in seats.items()
        for robot, kit in zip(scenario.entrants[seat].robots, scenario.entrants[team].kits, strict=False)
    }
    if not kits:
        return scenario
    robots = {
        name: robot.model_copy(update={"kit": kits.get(name, robot.kit)}) for name, robot in scenario.robots.items()
    }
    return scenario.model_copy(update={"robots": robots})


def by_seat(by_team: Mapping[str, Score], teams: Mapping[str, str]) -> dict[str, Score]:
    """Return scores by seat from scores by team."""
    return {seat: by_team[team] for seat, team in teams.items()}


def by_team(by_seat_now: Mapping[str, Score], teams: Mapping[str, str]) -> dict[str, Score]:
    """Return scores by team, in the order of the first half's seats, from scores by seat."""
    scores = {team: by_seat_now[seat] for seat, team in teams.items()}
    return {team: scores[team] for team in sorted(scores, key=list(teams).index)}
