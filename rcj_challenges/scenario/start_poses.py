"""Where everything stands at the start of a half, for the referee, the world, scripts and what is saved of a run."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2
from rcj_challenges.scenario.models.field import Box, Wall
from rcj_challenges.scenario.models.scenario import Scenario


def start_pose(scenario: Scenario, name: str) -> Pose2:
    """Return the start of a robot, ball or obstacle, without noise: x and y in m, yaw in rad.

    A wall has no place of its own: its ends say where it stands.
    """
    if name in scenario.robots:
        start = scenario.robots[name].start
        return start.x_m, start.y_m, start.yaw_rad
    if name in scenario.balls:
        return (*scenario.balls[name].start_m, 0.0)
    obstacle = scenario.obstacles[name]
    if isinstance(obstacle, Wall):
        return 0.0, 0.0, 0.0
    return (*obstacle.centre_m, obstacle.yaw_rad if isinstance(obstacle, Box) else 0.0)


def start_noise_m(scenario: Scenario, name: str) -> tuple[float, float]:
    """Return the half widths, on x and y in m, of the noise around the place where something starts."""
    return scenario.robots[name].start.noise_m if name in scenario.robots else (0.0, 0.0)
