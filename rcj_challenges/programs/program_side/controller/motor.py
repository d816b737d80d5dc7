"""Motors: of wheels, dribblers and kickers."""

from __future__ import annotations

import math

from ._connection import Connection, complain, number
from .device import LONGEST_MS, Device, ReadOnly

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A computed speed may be slightly above the intended one: 10.000000000000002 is not a mistake.
_MORE_THAN_ROUNDING = 1 + 1e-9


class Motor(Device):
    """A motor. It holds position 0 until ``setPosition(float('inf'))`` lets it turn without end, at the velocity set.

    A kicker is linear: ``setPosition(0.04)`` shoots with the velocity set, in m/s, and ``setPosition(0)`` rearms it.
    """

    ROTATIONAL, LINEAR = 0, 1

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_max_velocity = float(self._rcj_facts.get("max_velocity", connection.spec["max_velocity_radps"]))
        self._rcj_velocity = self._rcj_max_velocity
        self._rcj_unit = str(self._rcj_facts.get("unit", "rad/s"))
        self._rcj_position = 0.0
        self._rcj_commanded = False
        self._rcj_acceleration = -1.0
        self._rcj_turning = 0.0  # the velocity commanded for the last step
        self._rcj_noted_tick = -1
        self._rcj_torque_period_ms = 0
        self._rcj_max_torque = float(self._rcj_facts.get("max_torque", 10.0))
        self._rcj_available_torque = self._rcj_max_torque
        self._rcj_warned_of_speed = False

    def setPosition(self, position: float) -> None:
        """Turn to an angle in rad and hold it; ``inf`` lets the wheel turn without end, at the velocity set.

        Raises:
            TypeError: no number was given.

        Example:
            ``motor.setPosition(float("inf"))`` once at the start, before ``setVelocity``.
        """
        asked = float(number(position, f"{self._rcj_name!r}: setPosition takes a number of rad, such as float('inf')"))
        if math.isnan(asked):
            complain(f"Error: {self._rcj_name!r}: setPosition(NaN) is refused.", "correct this call")
            return
        self._rcj_command(self._rcj_velocity, math.inf if math.isinf(asked) else asked)

    def setVelocity(self, velocity: float) -> None:
        """Set the velocity in rad/s; beyond the maximum (10 rad/s of a wheel) it is clamped. Positive drives forward.

        Raises:
            TypeError: no number was given.

        Example:
            ``left.setVelocity(5.0)``; left faster than right turns the robot counter-clockwise.
        """
        try:
            asked = float(velocity)
        except (TypeError, ValueError):
            asked = math.nan
        # Called in every tick. NaN is what differs from itself; and float gives back a float itself, but reads texts.
        if asked != asked or (asked is not velocity and type(velocity) is str):  # type: ignore[comparison-overlap]  # noqa: PLR0124
            number(velocity, f"{self._rcj_name!r}: setVelocity takes a number of rad/s, such as 5.0")
            complain(f"Error: {self._rcj_name!r}: setVelocity(NaN) is refused.", "correct this call")
            return
        if abs(asked) > self._rcj_max_velocity:
            if not self._rcj_warned_of_speed and abs(asked) > self._rcj_max_velocity * _MORE_THAN_ROUNDING:
                self._rcj_warned_of_speed = True
                complain(
                    f"Warning: {self._rcj_name!r}: the velocity {asked:.10g} is beyond the maximum of "
                    f"{self._rcj_max_velocity:g} {self._rcj_unit}, which is taken instead.",
                    "ask for less",
                )
            asked = math.copysign(self._rcj_max_velocity, asked)
        if asked != self._rcj_velocity or not self._rcj_commanded:
            self._rcj_command(asked, self._rcj_position)

    def _rcj_command(self, velocity: float, position: float) -> None:
        if self._rcj_noted_tick != self._rcj_connection.tick:
            self._rcj_note_turning()
        self._rcj_commanded = True
        connection, index = self._rcj_connection, self._rcj_index
        if self._rcj_acceleration < 0.0 or position != math.inf:
            # In one assignment: between two, another thread could set the motor, and its setting would be lost.
            setting = index, velocity, position
            self._rcj_velocity, self._rcj_position, connection.motors[index] = velocity, position, setting
        else:
            self._rcj_velocity, self._rcj_position = velocity, position
            connection.ramp(index, self._rcj_approach)

    def _rcj_note_turning(self) -> None:
        """Before the first change of a step: keep the velocity commanded until now."""
        self._rcj_noted_tick = self._rcj_connection.tick
        if self._rcj_position != math.inf:
            self._rcj_turning = 0.0  # it holds its angle
        elif self._rcj_acceleration < 0.0:
            self._rcj_turning = self._rcj_velocity

    def _rcj_approach(self, ticks: int) -> bool:
        """Command a step of so many ticks the velocity that the acceleration allows.

        Returns:
            Whether the velocity that is set is still to be reached.
        """
        if self._rcj_acceleration < 0.0 or self._rcj_position != math.inf:
            return False
        most = self._rcj_acceleration * ticks * self._rcj_connection.tick_ms / 1000
        change = self._rcj_velocity - self._rcj_turning
        arrives = abs(change) <= most
        self._rcj_turning = self._rcj_velocity if arrives else self._rcj_turning + math.copysign(most, change)
        self._rcj_connection.command(self._rcj_index, self._rcj_turning, math.inf)
        return not arrives

    def getVelocity(self) -> float:
        """Return the velocity that is set, in rad/s, also while an acceleration lets the motor only approach it."""
        return self._rcj_velocity

    def getMaxVelocity(self) -> float:
        """Return the largest velocity in rad/s."""
        return self._rcj_max_velocity

    def getTargetPosition(self) -> float:
        """Return the angle that is set, in rad."""
        return self._rcj_position

    def getMinPosition(self) -> float:
        """Return 0: no limit."""
        return 0.0

    getMaxPosition = getMinPosition  # noqa: N815 - its name in Webots

    def setAcceleration(self, acceleration: float) -> None:
        """Limit the change of the velocity to so many rad/s²; -1: no limit. It does not apply to ``setPosition``.

        Example:
            ``motor.setAcceleration(20.0)`` reaches 10 rad/s after half a second.
        """
        asked = float(number(acceleration, f"{self._rcj_name!r}: setAcceleration takes a number of rad/s²"))
        if math.isnan(asked):
            complain(f"Error: {self._rcj_name!r}: setAcceleration(NaN) is refused.", "correct this call")
            return
        if self._rcj_noted_tick != self._rcj_connection.tick:
            self._rcj_note_turning()
        self._rcj_acceleration = asked if asked >= 0.0 else -1.0
        if self._rcj_position == math.inf and self._rcj_turning != self._rcj_velocity:
            self._rcj_command(self._rcj_velocity, self._rcj_position)

    def getAcceleration(self) -> float:
        """Return the acceleration set in rad/s²; -1: none."""
        return self._rcj_acceleration

    def setAvailableTorque(self, torque: float) -> None:
        """Remember a torque in N·m. It is not simulated: the motor always turns at the commanded velocity."""
        self._rcj_available_torque = min(float(torque), self._rcj_max_torque)

    def getAvailableTorque(self) -> float:
        """Return the torque set in N·m."""
        return self._rcj_available_torque

    def getMaxTorque(self) -> float:
        """Return the largest torque in N·m (10 in the original's robots)."""
        return self._rcj_max_torque

    def setTorque(self, torque: float) -> None:
        """Refused: these motors are driven by velocity."""
        complain(
            f"Error: {self._rcj_name!r}: setTorque is not offered by this robot; use setVelocity.", "correct this call"
        )

    def setControlPID(self, p: float, i: float, d: float) -> None:
        """Accepted without effect: on its way to an angle the motor turns at the velocity set."""

    def enableTorqueFeedback(self, samplingPeriod: float) -> None:
        """Remember a period in ms. The torque itself is not simulated."""
        self._rcj_torque_period_ms = max(1, int(min(samplingPeriod, LONGEST_MS))) if samplingPeriod > 0 else 0

    def disableTorqueFeedback(self) -> None:
        """Forget the period."""
        self._rcj_torque_period_ms = 0

    def getTorqueFeedbackSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._rcj_torque_period_ms

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
        return self._rcj_sibling("position_sensor", self._rcj_name.replace("motor", "sensor"))

    def getBrake(self) -> None:
        """Return None: there are no brakes."""

    def getMultiplier(self) -> float:
        """Return 1: the motor turns the wheel directly."""
        return 1.0

    def getType(self) -> int:
        """Return ``Motor.ROTATIONAL``, of a kicker ``Motor.LINEAR``."""
        return self.LINEAR if self._rcj_unit == "m/s" else self.ROTATIONAL

    target_position = property(getTargetPosition, setPosition)
    velocity = property(getVelocity, setVelocity)
    target_velocity = property(getVelocity, setVelocity)
    max_velocity = ReadOnly(getMaxVelocity)
    min_position = ReadOnly(getMinPosition)
    max_position = ReadOnly(getMaxPosition)
    acceleration = property(getAcceleration, setAcceleration)
    target_acceleration = property(getAcceleration, setAcceleration)
    torque = property(getTorqueFeedback, setTorque)
    force = property(getTorqueFeedback, setTorque)
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
