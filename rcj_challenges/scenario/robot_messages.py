"""Messages from robots to the referee: whether a scenario uses them, and which robots can send them."""

from __future__ import annotations

from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.rules.base import Word
from rcj_challenges.scenario.kit_devices import devices_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.walk import walk


def referee_listens(scenario: Scenario) -> bool:
    """Return whether a rule or the broadcast reads messages of robots.

    If none does, the referee's channels are closed to programs, as in the original.
    """
    words = (word for word, _ in walk((scenario.rules, scenario.broadcast)) if isinstance(word, Word))
    return any(word.READS_MESSAGES for word in words)


def robots_with_emitter(scenario: Scenario) -> list[str]:
    """Return the robots that have a program and an emitter, in the order of the file."""
    driven = {name for entrant in scenario.entrants.values() for name in entrant.robots}
    return [
        name
        for name, robot in scenario.robots.items()
        if name in driven
        and not robot.idle
        and any(isinstance(device, TeamEmitterDevice) for device in devices_of(scenario, name).values())
    ]
