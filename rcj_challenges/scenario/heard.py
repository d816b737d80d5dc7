"""Whether the referee of a scenario listens to what robots tell it by radio, and which of them can."""

from __future__ import annotations

from rcj_challenges.scenario.models.conditions import Told
from rcj_challenges.scenario.models.robots import TeamEmitterDevice
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import ToldValue
from rcj_challenges.scenario.models.triggers import Tells
from rcj_challenges.scenario.visiting import visit

_LISTENING = (Tells, Told, ToldValue)


def referee_listens(scenario: Scenario) -> bool:
    """Return whether a rule or the broadcast asks for what robots say.

    If none does, the referee's channels are closed to programs, as in the original.
    """
    return any(isinstance(model, _LISTENING) for model, _ in visit((scenario.rules, scenario.broadcast)))


def robots_that_speak(scenario: Scenario) -> list[str]:
    """Return the robots that have a program and an emitter, in the order of the file."""
    driven = {name for entrant in scenario.entrants.values() for name in entrant.robots}
    return [
        name
        for name, robot in scenario.robots.items()
        if name in driven and not robot.idle and _has_emitter(scenario, name)
    ]


def _has_emitter(scenario: Scenario, name: str) -> bool:
    robot = scenario.robots[name]
    of_kit = (device for key, device in scenario.kits[robot.kit].devices.items() if key not in robot.without)
    return any(isinstance(device, TeamEmitterDevice) for device in (*of_kit, *robot.devices.values()))
