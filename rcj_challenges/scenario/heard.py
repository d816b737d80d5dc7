"""Whether the referee of a scenario listens to what robots tell it by radio, and which of them can."""

from __future__ import annotations

from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.facts.messages import READS, is_said
from rcj_challenges.rules.conditions.told import Told
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.rules.message import Message
from rcj_challenges.rules.triggers.tells import Tells
from rcj_challenges.rules.values.draw import DrawValue
from rcj_challenges.rules.values.told import ToldValue
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.scenario.walk import walk

_LISTENING = (Tells, Told, ToldValue)


def referee_listens(scenario: Scenario) -> bool:
    """Return whether a rule or the broadcast asks for what robots say.

    If none does, the referee's channels are closed to programs, as in the original.
    """
    return any(isinstance(model, _LISTENING) for model, _ in walk((scenario.rules, scenario.broadcast)))


def robots_that_speak(scenario: Scenario) -> list[str]:
    """Return the robots that have a program and an emitter, in the order of the file."""
    driven = {name for entrant in scenario.entrants.values() for name in entrant.robots}
    return [
        name
        for name, robot in scenario.robots.items()
        if name in driven
        and not robot.idle
        and any(isinstance(device, TeamEmitterDevice) for device in devices_of(scenario, name).values())
    ]


def wanted(message: Message, scenario: Scenario) -> tuple[Scalar, ...] | None:
    """Return what a message must say, one of these; None: anything."""
    if isinstance(message.text, DrawValue):
        return scenario.draws[message.text.draw].values
    return message.text if isinstance(message.text, tuple) or message.text is None else (message.text,)


def fits(said: Scalar, message: Message, scenario: Scenario) -> bool:
    """Return whether a robot that says this says what is asked for."""
    text, asked = as_said(said), wanted(message, scenario)
    return READS[message.is_a](text) is not None and (asked is None or any(is_said(text, one) for one in asked))


def as_said(said: Scalar) -> str:
    """Return how a robot says a value."""
    return str(said).lower() if isinstance(said, bool) else str(said)
