"""The lidar's point cloud: the same readings as points, with the axes of the robot's years."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rcj_challenges.programs.program_side.controller.lidar import Lidar
from rcj_challenges.robots.fitting import fit
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.roster import Roster


class Reading(Lidar):
    """A lidar of four cells, of which each reads another distance: ahead, to the right, behind, to the left."""

    def __init__(self, facts: dict[str, Any]) -> None:
        self._rcj_facts = {**facts, "first_bearing_rad": 0.0, "bearing_step_rad": -math.pi / 2}
        self._rcj_connection = type("Connection", (), {"time_s": lambda _: 0.064})()
        self._rcj_has_cloud = True

    def _rcj_numbers(self) -> tuple[float, ...]:
        return 1.0, 2.0, 3.0, 4.0


def facts(scenario: str) -> dict[str, Any]:
    loaded = load(scenario).scenario
    (lidar,) = [one.spec for one in fit(loaded, Roster.of(loaded)) if one.spec.kind == "lidar"]
    return lidar.facts


@pytest.mark.parametrize(
    ("scenario", "points"),
    [
        # y is up there: x left, z ahead, the axes in which the compass of that robot tells north.
        ("precision_lidar", [(0, 0, 1), (-2, 0, 0), (0, 0, -3), (4, 0, 0)]),
        ("scenarios/variants/precision_lidar_v2.yaml", [(1, 0, 0), (0, -2, 0), (-3, 0, 0), (0, 4, 0)]),
    ],
)
def test_points_have_the_axes_of_the_robots_own_years(scenario: str, points: list[tuple[float, ...]]) -> None:
    cloud = Reading(facts(scenario)).getPointCloud()
    assert [pytest.approx((one.x, one.y, one.z)) for one in cloud] == points
    assert [(one.layer_id, one.time) for one in cloud] == [(0, 0.064)] * 4
