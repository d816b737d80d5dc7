"""Names of teams that are shown side by side: two teams may have the same name; and scores as lines of text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from rcj_challenges.core.amounts import number_words
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.result import RunResult
from rcj_challenges.scenario.models.scenario import Scenario

_LONGEST = 32
"""How many characters of a name are shown; names that differ only after these are also made distinct."""


def changes_sides(scenario: Scenario) -> bool:
    """Return whether a team plays from another seat in another half."""
    return scenario.match.swap_sides and scenario.match.halves > 1


def seat_colours(scenario: Scenario) -> dict[str, str]:
    """Return by seat the colour of its first robot as the scenario has it; seats without robots are left out."""
    first = {seat: next(iter(entrant.robots)) for seat, entrant in scenario.entrants.items() if entrant.robots}
    return {seat: scenario.robots[robot].colour for seat, robot in first.items()}


def titles(scenario: Scenario, result: RunResult) -> dict[str, str]:
    """Return distinct names of the teams, by their seats of the first half."""
    names = {team: entrant.name or team for team, entrant in result.entrants.items()}
    return distinct_names(names, sides_change=changes_sides(scenario))


def distinct_names(names: Mapping[str, str], *, sides_change: bool = False) -> dict[str, str]:
    """Return the names by team; those that look the same with their seats: ``Hanse (blue)``, ``Hanse (blue first)``."""
    several = Counter(sanitize(name)[:_LONGEST] for name in names.values())
    first = " first" if sides_change else ""
    return {
        team: f"{name} ({team}{first})" if several[sanitize(name)[:_LONGEST]] > 1 else name
        for team, name in names.items()
    }


def score_line(names: Mapping[str, str], scores: Mapping[str, int | float]) -> str:
    """Return ``Hanse 2 : 1 Alster`` for two seats, ``Hanse 21`` for one, in the order of the first half.

    ``names`` are as of `shown_names`.
    """
    if len(scores) == 2:
        (first, first_score), (second, second_score) = scores.items()
        return f"{names[first]} {number_words(first_score)} : {number_words(second_score)} {names[second]}"
    return ", ".join(f"{names[seat]} {number_words(score)}" for seat, score in scores.items())


def score_so_far(half: HalfInfo, scores: Mapping[str, int | float]) -> str:
    """Return the `score_line` within a half, teams in the order of the first half as in the result and on pages."""
    seat_of = {team: seat for seat, team in half.teams.items()}
    names = shown_names(team_names(half), sides_change=any(team != seat for seat, team in half.teams.items()))
    return score_line(names, {team: scores[seat_of[team]] for team in half.teams})


def team_names(half: HalfInfo) -> dict[str, str]:
    """Return the teams' names by their seats of the first half."""
    seat_of = {team: seat for seat, team in half.teams.items()}
    return {team: half.team_names[seat_of[team]] for team in half.teams}


def shown_names(names: Mapping[str, str], *, sides_change: bool = False) -> dict[str, str]:
    """Return the names by seat as a line may show them."""
    return distinct_names({seat: sanitize(name, 32) for seat, name in names.items()}, sides_change=sides_change)
