"""The wheels' motors."""

from __future__ import annotations

import math
from typing import Any

from ._hub import Hub, complain
from .device import Device, ReadOnly


class Motor(Device):
    """A wheel's motor. Braked (it holds position 0) until ``setPosition(float('inf'))`` lets it turn freely."""

    ROTATIONAL, LINEAR = 0, 1

    def __init__(self, hub: Hub, spec: dict[str, Any], siblings: dict[str, Device]) -> None:
        super().__init__(hub, spec, siblings)
        self._max_velocity = float(self._facts.get("max_velocity", hub.spec["max_velocity_radps"]))
        self._velocity = self._max_velocity
        self._position = 0.0
        self._commanded = False
        self._acceleration = -1.0
        self._turning = 0.0  # the velocity commanded for the last step
        self._noted_tick = -1
        self._torque_period_ms = 0
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
        if self._noted_tick != self._hub.tick:
            self._note_turning()
        self._commanded = True
        self._velocity, self._position = velocity, position
        if self._acceleration < 0.0 or position != math.inf:
            self._hub.command(self._index, velocity, position)
        else:
            self._hub.ramp(self._index, self._approach)

    def _note_turning(self) -> None:
        """Before the first change of a step: keep how fast the motor was told to turn until now."""
        self._noted_tick = self._hub.tick
        if self._position != math.inf:
            self._turning = 0.0  # it holds its angle
        elif self._acceleration < 0.0:
            self._turning = self._velocity

    def _approach(self, ticks: int) -> bool:
        """Command a step of so many ticks the velocity that the acceleration allows.

        Returns:
            Whether the velocity that is set is still to be reached.
        """
        if self._acceleration < 0.0 or self._position != math.inf:
            return False
        most = self._acceleration * ticks * self._hub.tick_ms / 1000
        change = self._velocity - self._turning
        arrives = abs(change) <= most
        self._turning = self._velocity if arrives else self._turning + math.copysign(most, change)
        self._hub.command(self._index, self._turning, math.inf)
        return not arrives

    def getVelocity(self) -> float:
        """Return the velocity that is set, in rad/s, also while an acceleration lets the motor only approach it."""
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
        """Let the velocity change, up and down, by at most so many rad/s in a second; -1: at once, as at first.

        A motor that goes to an angle does so without regard to it.
        """
        asked = float(acceleration)
        if math.isnan(asked):
            complain(f"Error: {self.getName()!r}: setAcceleration(NaN) is refused.")
            return
        if self._noted_tick != self._hub.tick:
            self._note_turning()
        self._acceleration = asked if asked >= 0.0 else -1.0
        if self._position == math.inf and self._turning != self._velocity:
            self._command(self._velocity, self._position)

    def getAcceleration(self) -> float:
        """Return the acceleration set in rad/s²; -1: none."""
        return self._acceleration

    def setAvailableTorque(self, torque: float) -> None:
        """Remember a torque in N·m. It is not simulated: the motor turns as fast as it is told to."""
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

    def setControlPID(self, p: float, i: float, d: float) -> None:
        """Accepted without effect: on its way to an angle the motor turns at the velocity set."""

    def enableTorqueFeedback(self, samplingPeriod: float) -> None:
        """Remember a period in ms. The torque itself is not simulated."""
        self._torque_period_ms = int(samplingPeriod) if samplingPeriod > 0 else 0

    def disableTorqueFeedback(self) -> None:
        """Forget the period."""
        self._torque_period_ms = 0

    def getTorqueFeedbackSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._torque_period_ms

    def getTorqueFeedback(self) -> float:
        """Return 0.0 always: the torque is not simulated."""
        return 0.0

    # Webots has all of this under the names of linear motors too.
    setAvailableForce = setAvailableTorque  # noqa: N815 - these are methods
    getAvailableForce = getAvailableTorque  # noqa: N815
    getMaxForce = getMaxTorque  # noqa: N815
    setForce = setTorque  # noqa: N815
    enableForceFeedback = enableTorqueFeedback  # noqa: N815
    disableForceFeedback = disableTorqueFeedback  # noqa: N815
    getForceFeedbackSamplingPeriod = getTorqueFeedbackSamplingPeriod  # noqa: N815
    getForceFeedback = getTorqueFeedback  # noqa: N815

    def getPositionSensor(self) -> Any:
        """Return the sensor of the same wheel, by its name; None if the robot has none."""
        return self._sibling("position_sensor", self.getName().replace("motor", "sensor"))

    def getBrake(self) -> None:
        """Return None: there are no brakes."""

    def getMultiplier(self) -> float:
        """Return 1: the motor turns the wheel directly."""
        return 1.0

    def getType(self) -> int:
        """Return ``Motor.ROTATIONAL``."""
        return self.ROTATIONAL

    target_position = property(getTargetPosition, setPosition)
    velocity = property(getVelocity, setVelocity)
    target_velocity = property(getVelocity, setVelocity)
    max_velocity = ReadOnly(getMaxVelocity)
    min_position = ReadOnly(getMinPosition)
    max_position = ReadOnly(getMaxPosition)
    acceleration = property(getAcceleration, setAcceleration)
    available_torque = property(getAvailableTorque, setAvailableTorque)
    max_torque = ReadOnly(getMaxTorque)
    torque_feedback = ReadOnly(getTorqueFeedback)
    torque_feedback_sampling_period = ReadOnly(getTorqueFeedbackSamplingPeriod)
    available_force = property(getAvailableForce, setAvailableForce)
    max_force = ReadOnly(getMaxForce)
    force_feedback = ReadOnly(getForceFeedback)
    force_feedback_sampling_period = ReadOnly(getForceFeedbackSamplingPeriod)
    position_sensor = ReadOnly(getPositionSensor)
    brake = ReadOnly(getBrake)
    multiplier = ReadOnly(getMultiplier)
    type = ReadOnly(getType)
