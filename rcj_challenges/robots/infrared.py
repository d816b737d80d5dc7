"""The balls' infra-red: one packet a tick to every robot near enough with nothing in between."""

from __future__ import annotations

import math

from rcj_challenges.core.grouping import grouped
from rcj_challenges.devices.ball_receiver import BallReceiver
from rcj_challenges.devices.base import Rays
from rcj_challenges.devices.poses import Vector
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.poses import Poses


class Infrared:
    """From all balls to all ball receivers.

    A ray runs from the ball's centre to the robot's. Balls never hide a ball; the robot's own cube and wheels are
    what the ray must meet first (so a robot's own wheel never hides it); anything else in front of them does.
    """

    def __init__(self, scenario: Scenario, roster: Roster, rays: Rays, receivers: list[BallReceiver]) -> None:
        self._all_receivers = receivers
        self._receivers: dict[int, list[BallReceiver]] = {}
        self._rays = rays
        self._first_ball = roster.robots
        names = roster.entities[roster.robots : roster.robots + roster.balls]
        self._emitting = [index for index, name in enumerate(names) if scenario.balls[name].emits]

    def retune(self) -> None:
        """Look up the receivers that listen. To be called when a ball receiver was enabled, disabled or tuned."""
        self._receivers = grouped((one.robot, one) for one in self._all_receivers if one.listens)

    def send(self, robot: int, tick: int, poses: Poses) -> None:
        """Send each ball's packet of this tick to one robot, in the order of balls."""
        receivers = self._receivers.get(robot)
        if receivers is None or poses.parked[robot]:
            return
        pose = poses.robots[robot]
        for ball in self._emitting:
            if poses.parked[self._first_ball + ball]:
                continue
            centre = poses.balls[ball]
            dx, dy, dz = centre[0] - pose.x, centre[1] - pose.y, centre[2] - pose.z
            square = dx * dx + dy * dy + dz * dz
            direction: Vector | None = None
            for receiver in receivers:
                if square > receiver.range_square_m2:
                    continue
                if direction is None:  # the same for all of a robot, and a ray only if one is near enough
                    if not self._rays.reaches(robot, centre, (-dx, -dy, -dz)):
                        break
                    distance = math.sqrt(square)
                    direction = pose.to_frame(dx / distance, dy / distance, dz / distance)
                receiver.receive(tick, ball, square, direction)
