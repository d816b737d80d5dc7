"""Shell completion: scenarios and teams by name. If nothing fits, the shell offers files."""

from __future__ import annotations


def complete_scenarios(incomplete: str) -> list[str]:
    """Return the names of shipped scenarios that begin like this."""
    from rcj_challenges.scenario.resources import shipped_scenarios

    return [name for name in shipped_scenarios() if name.startswith(incomplete)]


def complete_teams(incomplete: str) -> list[str]:
    """Return the names of sample teams that begin like this."""
    from rcj_challenges.scenario.resources import shipped_teams

    return [name for name in shipped_teams() if name.startswith(incomplete)]


def complete_seats(incomplete: str) -> list[str]:
    """Return ``ENTRANT=TEAM`` for the sample teams, once the entrant is typed."""
    seat, equals, name = incomplete.partition("=")
    return [f"{seat}={team}" for team in complete_teams(name)] if equals else []
