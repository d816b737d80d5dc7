"""The device ``team_receiver``."""

from typing import Any, Literal

from rcj_challenges.devices.base import RobotSetup
from rcj_challenges.devices.receivers import ReceiverDevice
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import metres


class TeamReceiverDevice(ReceiverDevice):
    """Receives team radio on the team's channel."""

    device: Literal["team_receiver"]
    range_m: Positive = described(10.0, "range in m; the shorter of this and the emitter's range applies")

    EXAMPLE = """
robots:
  # Y1 only receives team-mates within half a metre.
  Y1: {devices: {team receiver: {device: team_receiver, range_m: 0.5}}}
"""

    def facts(self, setup: RobotSetup) -> dict[str, Any]:
        return {
            "channel": setup.own_channel,
            "range": self.range_m,
            "refused_channels": list(setup.foreign_channels),
        }

    def describe(self) -> str:
        return f"team radio, receives from up to {metres(self.range_m)}"
