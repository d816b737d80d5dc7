"""Who may talk to whom: the radio channel of each robot."""

from __future__ import annotations

from rcj_challenges.scenario.models.scenario import Scenario

ANY_CHANNEL = -1
"""What a receiver or emitter is set to that means all channels of its team (Webots: -1)."""


def entrant_of(scenario: Scenario) -> dict[str, str]:
    """Return the entrant that drives each robot, by the robot's name. A robot named twice belongs to the first."""
    owners: dict[str, str] = {}
    for entrant, entry in scenario.entrants.items():
        for robot in entry.robots:
            owners.setdefault(robot, entrant)
    return owners


def team_channels(scenario: Scenario) -> dict[str, int]:
    """Return the team radio channel of each driven robot, by its name.

    A team is an entrant: all its robots share its ``radio_channel``, whatever their colour. In a match that is blue
    2 and yellow 3; in a challenge with one entrant that drives both colours they all hear each other, for they are
    one team. Two entrants never share a channel: a later one that names a channel already taken gets the next free
    one.
    """
    owners = entrant_of(scenario)
    by_entrant: dict[str, int] = {}
    for name, entrant in scenario.entrants.items():
        channel = entrant.radio_channel
        while channel in by_entrant.values():
            channel += 1
        by_entrant[name] = channel
    return {robot: by_entrant[entrant] for robot, entrant in owners.items()}
