"""The wheels' motors."""

from __future__ import annotations

import math
from typing import Any

from ._hub import Hub, complain
from .device import Device


class Motor(Device):
    """A wheel's motor. Braked (it holds position 0) until ``setPosition(float('inf'))`` lets it turn freely."""

    ROTATIONAL, LINEAR = 0, 1

    def __init__(self, hub: Hub, spec: dict[str, Any]) -> None:
        super().__init__(hub, spec)
        self._max_velocity = float(self._facts.get("max_velocity", hub.spec["max_velocity_radps"]))
        self._velocity = self._max_velocity
        self._position = 0.0
        self._commanded = False
        self._acceleration = -1.0
        self._available_torque = self.getMaxTorque()
        self._warned_of_speed = False

    def setPosition(self, position: float) -> None:
        """Turn to an angle in rad and hold it; ``inf`` turns for ever, at the velocity set."""
        asked = float(position)
        if math.isnan(asked):
            complain(f"Error: {self.getName()!r}: setPosition(NaN) is refused.")
            return
        self._command(self._velocity, math.inf if math.isinf(asked) else asked)

    def setVelocity(self, velocity: float) -> None:
        """Set the velocity in rad/s; beyond the maximum it is clamped."""
        asked = float(velocity)
        if math.isnan(asked):
            complain(f"Error: {self.getName()!r}: setVelocity(NaN) is refused.")
            return
        if abs(asked) > self._max_velocity:
            if not self._warned_of_speed:
                self._warned_of_speed = True
                complain(
                    f"Warning: {self.getName()!r}: the velocity {asked:g} is beyond the maximum of "
                    f"{self._max_velocity:g} rad/s, which is taken instead."
                )
            asked = math.copysign(self._max_velocity, asked)
        if asked != self._velocity or not self._commanded:
            self._command(asked, self._position)

    def _command(self, velocity: float, position: float) -> None:
        self._commanded = True
        self._velocity, self._position = velocity, position
        self._hub.command(self._index, velocity, position)

    def getVelocity(self) -> float:
        """Return the velocity that is set, in rad/s."""
        return self._velocity

    def getMaxVelocity(self) -> float:
        """Return the largest velocity in rad/s."""
        return self._max_velocity

    def getTargetPosition(self) -> float:
        """Return the angle that is set, in rad."""
        return self._position

    def getMinPosition(self) -> float:
        """Return 0: no limit."""
        return 0.0

    def getMaxPosition(self) -> float:
        """Return 0: no limit."""
        return 0.0

    def setAcceleration(self, acceleration: float) -> None:
        """Remember an acceleration in rad/s². Grip limits these robots long before their motors do."""
        self._acceleration = float(acceleration)

    def getAcceleration(self) -> float:
        """Return the acceleration set in rad/s²; -1: none."""
        return self._acceleration

    def setAvailableTorque(self, torque: float) -> None:
        """Remember a torque in N·m. Grip limits these robots long before their motors do."""
        self._available_torque = min(float(torque), self.getMaxTorque())

    def getAvailableTorque(self) -> float:
        """Return the torque set in N·m."""
        return self._available_torque

    def getMaxTorque(self) -> float:
        """Return the largest torque in N·m (10 in the original's robots)."""
        return float(self._facts.get("max_torque", 10.0))

    def setTorque(self, torque: float) -> None:
        """Refused: these motors are driven by velocity."""
        complain(f"Error: {self.getName()!r}: setTorque is not offered by this robot; use setVelocity.")

    def enableTorqueFeedback(self, samplingPeriod: float) -> None:
        """Accepted without effect: there is no torque sensor, as in the original's robots."""

    def disableTorqueFeedback(self) -> None:
        """Accepted without effect."""

    def getTorqueFeedbackSamplingPeriod(self) -> int:
        """Return 0: there is no torque sensor."""
        return 0

    def getTorqueFeedback(self) -> float:
        """Return NaN: there is no torque sensor."""
        return math.nan

    def getMultiplier(self) -> float:
        """Return 1: the motor turns the wheel directly."""
        return 1.0

    def getType(self) -> int:
        """Return ``Motor.ROTATIONAL``."""
        return self.ROTATIONAL

    target_position = property(getTargetPosition, setPosition)
    velocity = property(getVelocity, setVelocity)
    target_velocity = property(getVelocity, setVelocity)
    max_velocity = property(getMaxVelocity)
    min_position = property(getMinPosition)
    max_position = property(getMaxPosition)
    acceleration = property(getAcceleration, setAcceleration)
    available_torque = property(getAvailableTorque, setAvailableTorque)
    max_torque = property(getMaxTorque)
    torque_feedback = property(getTorqueFeedback)
    multiplier = property(getMultiplier)
    type = property(getType)
