"""The device ``led``: a light that a program switches, for people who watch."""

from typing import Any, Literal

from rcj_challenges.devices.base import Device, RobotSetup
from rcj_challenges.rules.fields import Colour, described
from rcj_challenges.rules.phrasing import listed


class LedDevice(Device):
    """A light that a program switches; replays with recorded sensors show which of its colours is lit."""

    device: Literal["led"]
    colours: tuple[Colour, ...] = described(
        ("red",), "its colours, of which set(1) lights the first", min_length=1, max_length=8
    )

    CLASS = "led"
    ACCEPTS = frozenset({"motors"})
    FREE = frozenset({"colours"})
    EXAMPLE = """
robots:
  Y1: {devices: {led: {device: led, colours: [red, lime]}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"max_velocity": float(len(self.colours)), "unit": "", "colours": list(self.colours)}

    def describe(self) -> str:
        return f"light that can be {listed(list(self.colours), 'or')}"
