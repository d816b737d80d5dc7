"""The device ``kicker``: a plunger that shoots off a ball at the robot's front."""

from functools import partial
from typing import Any, Literal

from rcj_challenges.devices.base import Device, Fitted, Motion, Movers, RobotSetup
from rcj_challenges.rules.fields import Positive, described


class KickerDevice(Device):
    """Shoots off a ball at the robot's front, and needs time to charge again."""

    # Their source: tried with prototypes; a robot that drives into a resting ball sends it off at 0.25 m/s.

    device: Literal["kicker"]
    speed_mps: Positive = described(
        0.8, "speed that a full charge gives the ball in m/s, relative to the robot; it rolls with 5/7 of it", le=1.5
    )
    recharge_s: Positive = described(2.0, "time in s from a kick to a full charge", ge=0.1, le=60)

    CLASS = "motor"
    ACCEPTS = frozenset({"motors"})
    EXAMPLE = """
robots:
  Y1: {devices: {kicker motor: {device: kicker, speed_mps: 1.2}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"max_velocity": self.speed_mps, "unit": "m/s"}

    def make_motion(self, fitted: Fitted, movers: Movers) -> Motion:
        return Motion(partial(movers.set_tool, fitted.robot, fitted.spec.name), 1, self.speed_mps)

    def describe(self) -> str:
        return f"kicker: at most {self.speed_mps:g} m/s, charged again after {self.recharge_s:g} s"
