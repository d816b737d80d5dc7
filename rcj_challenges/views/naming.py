"""Names of teams that are shown side by side: two teams may have the same name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.result import RunResult
from rcj_challenges.scenario.models.scenario import Scenario

_LONGEST = 32
"""How many letters of a name are shown; names that differ only after these are also made distinct."""


def changes_sides(scenario: Scenario) -> bool:
    """Return whether a team plays from another seat in another half."""
    return scenario.match.swap_sides and scenario.match.halves > 1


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
