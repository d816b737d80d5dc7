"""The balls' infra-red: one packet a tick to every robot near enough with nothing in between."""

from __future__ import annotations

import math
from typing import Any, cast

import mujoco
import numpy as np

from rcj_challenges.devices.channels import ANY_CHANNEL
from rcj_challenges.devices.fitting import Fitted
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import Poses, Vector
from rcj_challenges.devices.receivers import Receiver
from rcj_challenges.devices.sight import as_geomgroup
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.facts.traffic import Packet
from rcj_challenges.scenario.models.robots import BallReceiverDevice
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world import contact
from rcj_challenges.world.tables import one_by_one

PAYLOADS = {"v2.1": b"\x01", "v2.2": b"x", "2021": b"\x01"}
"""What the ball sends, by the kit's messages: ``struct '?'``, or a letter. Source: reference, 4.1. (The robots of 2021
had no infra-red; one fitted to them gets bytes.)"""


class InfraredEar:
    """A ball receiver with what it needs: the balls' channel, its noise, its payload."""

    def __init__(self, receiver: Receiver, fitted: Fitted, messages: str, balls: int, half: HalfInfo) -> None:
        """Join a receiver and its settings.

        Args:
            receiver: what delivers to the program.
            fitted: the ball receiver on its robot.
            messages: of the robot's kit.
            balls: how many there are; the noise has two draws a tick for each.
            half: for the noise.
        """
        device = cast("BallReceiverDevice", fitted.device)
        noisy = device.strength_noise > 0 or device.direction_noise_rad > 0
        self.receiver = receiver
        self.robot = receiver.robot
        self.payload = PAYLOADS[messages]
        self.ball_channel = device.channel
        self.range_square_m2 = device.range_m**2
        self.strength_noise = device.strength_noise
        self.direction_noise_rad = device.direction_noise_rad
        self.noise = Noise(half, [(fitted.robot_name, fitted.spec.name)], 2 * max(1, balls)) if noisy else None

    @property
    def listens(self) -> bool:
        """Whether it is enabled, and tuned to the balls."""
        return self.receiver.period_ticks > 0 and self.receiver.channel in (self.ball_channel, ANY_CHANNEL)

    def hear(self, tick: int, ball: int, square_m2: float, direction: Vector) -> None:
        """Take a ball's packet of a tick: from so far, squared, and from there, in the robot's frame."""
        strength = 1 / square_m2
        if self.noise is not None:
            strength, direction = self._disturbed(self.noise.numbers(tick), ball, strength, direction)
        self.receiver.hear(Packet(self.receiver.device, self.payload, strength, direction))

    def _disturbed(
        self, errors: list[float], ball: int, strength: float, direction: Vector
    ) -> tuple[float, Vector]:  # fmt: skip
        """Return strength and direction with a tick's errors."""
        error, turn = errors[2 * ball : 2 * ball + 2]
        cos, sin = math.cos(turn * self.direction_noise_rad), math.sin(turn * self.direction_noise_rad)
        x, y, z = direction
        return max(0.0, strength * (1 + self.strength_noise * error)), (cos * x - sin * y, sin * x + cos * y, z)


class Infrared:
    """From all balls to all ears.

    A ray runs from the ball's centre to the robot's. Balls never hide a ball; the robot's own cube and wheels are
    what the ray must meet first (so a robot's own wheel never hides it); anything else in front of them does.
    """

    def __init__(self, scenario: Scenario, roster: Roster, ground: Ground, ears: list[InfraredEar]) -> None:
        """Look up which geom belongs to which robot, once."""
        self._all_ears = ears
        self._ears: dict[int, list[InfraredEar]] = {}
        self._model = ground.model
        self._data = ground.data
        self._first_ball = roster.robots
        names = roster.entities[roster.robots : roster.robots + roster.balls]
        self._emitting = [index for index, name in enumerate(names) if scenario.balls[name].emits]
        robots = roster.entities[: roster.robots]
        robot_of_body = {int(ground.model.body(name).id): index for index, name in enumerate(robots)}
        roots = ground.model.body_rootid[ground.model.geom_bodyid].tolist()
        self._robot_of_geom = [robot_of_body.get(root, -1) for root in roots]
        self._groups = as_geomgroup((contact.GROUP_FIXTURES, contact.GROUP_CUBES, contact.GROUP_WHEELS))
        self._from, self._along = np.zeros(3), np.zeros(3)
        geom: Any = np.zeros(1, np.int32)
        # Written and read number by number, which numpy takes longer for.
        self._from_where, self._along_what = one_by_one(self._from), one_by_one(self._along)
        self._geom, self._met = geom, memoryview(geom)

    def retune(self) -> None:
        """Find out anew who listens. To be called when a ball receiver was enabled, disabled or tuned."""
        self._ears = {}
        for ear in self._all_ears:
            if ear.listens:
                self._ears.setdefault(ear.robot, []).append(ear)

    def send(self, robot: int, tick: int, poses: Poses) -> None:
        """Send each ball's packet of this tick to one robot, in the order of balls."""
        ears = self._ears.get(robot)
        if ears is None or poses.parked[robot]:
            return
        pose = poses.robots[robot]
        for ball in self._emitting:
            if poses.parked[self._first_ball + ball]:
                continue
            centre = poses.balls[ball]
            dx, dy, dz = centre[0] - pose.x, centre[1] - pose.y, centre[2] - pose.z
            square = dx * dx + dy * dy + dz * dz
            direction: Vector | None = None
            for ear in ears:
                if square > ear.range_square_m2:
                    continue
                if direction is None:  # the same for all its ears, and a ray only if one is near enough
                    if not self._reaches(robot, centre, -dx, -dy, -dz):
                        break
                    distance = math.sqrt(square)
                    direction = pose.to_frame(dx / distance, dy / distance, dz / distance)
                ear.hear(tick, ball, square, direction)

    def _reaches(self, robot: int, centre: Vector, along_x: float, along_y: float, along_z: float) -> bool:
        """Whether a ray from a ball's centre first meets that robot, or nothing."""
        source, along = self._from_where, self._along_what
        source[0], source[1], source[2] = centre
        along[0], along[1], along[2] = along_x, along_y, along_z
        mujoco.mj_ray(self._model, self._data, self._from, self._along, self._groups, 1, -1, self._geom)
        met = self._met[0]
        return met < 0 or self._robot_of_geom[met] == robot
