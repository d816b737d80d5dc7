"""The device ``dribbler``: a roller that gives a ball at the robot's front back spin."""

from functools import partial
from typing import Any, Literal

from rcj_challenges.devices.base import Device, Fitted, Motion, Movers, RobotSetup
from rcj_challenges.rules.fields import Positive, described

ROLLER_M = 0.01
"""Radius of the roller."""


class DribblerDevice(Device):
    """A roller at the robot's front that gives a ball back spin: it follows when the robot turns or drives back."""

    # Their source: tried with prototypes; with more than 0.25 N a robot drags the ball wherever it drives.

    device: Literal["dribbler"]
    force_n: Positive = described(0.12, "force of the roller's rim on the ball in N", le=0.25)
    max_radps: Positive = described(50.0, "highest speed of the roller, which has a radius of 1 cm, in rad/s", le=100)

    CLASS = "motor"
    ACCEPTS = frozenset({"motors"})
    EXAMPLE = """
robots:
  Y1: {devices: {dribbler motor: {device: dribbler, force_n: 0.2}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"max_velocity": self.max_radps}

    def make_motion(self, fitted: Fitted, movers: Movers) -> Motion:
        return Motion(partial(movers.set_tool, fitted.robot, fitted.spec.name), 1, self.max_radps)

    def describe(self) -> str:
        return (
            f"dribbler: a roller of 1 cm radius that turns at up to {self.max_radps:g} rad/s; its rim pulls with up to "
            f"{self.force_n:g} N"
        )
