"""The device ``supervisor_receiver``."""

from typing import Any, Literal

from rcj_challenges.devices.base import RobotSetup
from rcj_challenges.devices.receivers import ReceiverDevice
from rcj_challenges.rules.fields import described

RANGE_M = 10.0
"""Source: reference, 4.1."""


class SupervisorReceiverDevice(ReceiverDevice):
    """Receives the referee's packets: one per tick, or at the interval set in the kit."""

    device: Literal["supervisor_receiver"]
    channel: int = described(1, "channel number that getChannel returns")

    EXAMPLE = """
robots:
  Y1: {devices: {referee: {device: supervisor_receiver, channel: 1}}}
"""

    def facts(self, setup: RobotSetup) -> dict[str, Any]:
        facts = {"channel": self.channel, "range": RANGE_M, "refused_channels": list(setup.foreign_channels)}
        if setup.messages == "2021":  # what is sent after a tick is received in the next one
            facts["silent_ticks"] = setup.packet_every_ticks
        return facts

    def describe(self) -> str:
        return f"receiver of the referee's packets, channel {self.channel}"
