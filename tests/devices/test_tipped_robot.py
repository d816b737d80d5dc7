"""A robot that has tipped over. The world's own robots cannot (ADR 2), so this one is built by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import mujoco
import pytest

from rcj_challenges.core.traffic import Request
from rcj_challenges.robots.fitting import fit, fixed_rays
from rcj_challenges.robots.manager import DeviceManager
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world import contact
from rcj_challenges.world.rays import add_fixed_rays
from tests.devices.device_bench import BLANK, half, scenario_of

CHANGE: dict[str, Any] = {
    "robots": {
        **dict.fromkeys(("B1", "B2", "B3", "Y2", "Y3")),
        "Y1": {"devices": {"lidar": {"device": "lidar", "rotating": False}}},
    },
    "entrants": {"blue": None, "yellow": {"robots": {"Y2": None, "Y3": None}}},
    "kits": {"v2": {"devices": {"distancesensor front": {"noise": 0}, "distancesensor right": {"noise": 0}}}},
}


@dataclass
class FreeGround:
    """A floor, a wall at x = 0.5, and a robot that can be turned in any direction."""

    model: Any = None
    data: Any = None
    parked: list[bool] = field(default_factory=lambda: [False, False])

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """No wheels turn here."""

    def turn(self, height: float, quaternion: tuple[float, float, float, float]) -> None:
        self.data.joint("Y1").qpos[:] = (0, 0, height, *quaternion)
        mujoco.mj_kinematics(self.model, self.data)


def about(axis: tuple[int, int, int], angle: float) -> tuple[float, float, float, float]:
    sin = math.sin(angle / 2)
    return (math.cos(angle / 2), axis[0] * sin, axis[1] * sin, axis[2] * sin)


@dataclass
class Tipping:
    """Turns the robot, and reads what it senses."""

    ground: FreeGround
    devices: DeviceManager
    tick: int = 0

    def read(self, device: str) -> list[float]:
        spec = next(one for one in self.devices.specs[0].devices if one.name == device)
        return self.devices.observe(0, self.tick).values[spec.slot : spec.slot + spec.width]

    def sense(self, height: float, quaternion: tuple[float, float, float, float]) -> list[Any]:
        self.ground.turn(height, quaternion)
        self.tick += 1
        self.devices.sense(self.tick, BLANK)
        return [packet for packet in self.devices._queues[0].take() if packet.strength != 1.0]


@pytest.fixture
def tipping() -> Tipping:
    scenario = scenario_of(change=CHANGE)
    roster = Roster.of(scenario)
    spec = mujoco.MjSpec()
    box, plane = mujoco.mjtGeom.mjGEOM_BOX, mujoco.mjtGeom.mjGEOM_PLANE
    spec.worldbody.add_geom(type=plane, size=[2, 2, 0.1], group=contact.GROUP_FLOOR)
    spec.worldbody.add_geom(type=box, size=[0.1, 1, 0.3], pos=[0.6, 0, 0.3], group=contact.GROUP_FIXTURES)
    robot = spec.worldbody.add_body(name="Y1")
    robot.add_freejoint(name="Y1")
    robot.add_geom(type=box, size=[0.0375] * 3, mass=0.2, group=contact.GROUP_CHASSIS)
    for side, y in (("left", 0.045), ("right", -0.045)):
        wheel = robot.add_body(name=f"Y1/{side}_wheel", pos=[0, y, -0.0176])
        wheel.add_joint(name=f"Y1/{side}_wheel", axis=[0, 1, 0])
        wheel.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.02, 0, 0], mass=0.005, group=contact.GROUP_WHEELS)
    ball = spec.worldbody.add_body(name="ball", pos=[0.2, 0, 0.0209])
    ball.add_freejoint(name="ball")
    ball.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.021, 0, 0], mass=0.05, group=contact.GROUP_BALLS)
    add_fixed_rays(spec, fixed_rays(fit(scenario, roster)))
    model = spec.compile()
    ground = FreeGround(model, mujoco.MjData(model))
    devices = DeviceManager(scenario, roster, ground, half())
    sampled = [one.index for one in devices.specs[0].devices if one.kind not in ("motor", "emitter")]
    ground.turn(0.0375, (1, 0, 0, 0))
    devices.begin(BLANK)
    devices.apply(0, Request(1, sampling=tuple((index, 1) for index in sampled)))
    return Tipping(ground, devices)


def test_a_robot_that_rocks_keeps_a_level_frame(tipping: Tipping) -> None:
    (packet,) = tipping.sense(0.0378, about((0, 1, 0), 0.05))
    assert packet.direction == pytest.approx((0.9966, 0, -0.0827), abs=1e-4)
    assert tipping.read("compass") == pytest.approx([0, 1, 0])
    assert tipping.read("gps")[2] == 0.0375


def test_a_robot_on_its_side_has_the_frame_of_its_body(tipping: Tipping) -> None:
    # Rolled by 90° about its x axis: its left looks up, its top to the world's -y.
    (packet,) = tipping.sense(0.05, about((1, 0, 0), math.pi / 2))
    length = math.hypot(0.2, 0.05 - 0.0209)
    assert packet.direction == pytest.approx((0.2 / length, -(0.05 - 0.0209) / length, 0), abs=1e-9)


@pytest.mark.parametrize("way", [1, -1])
def test_the_third_part_of_the_compass_shows_that_it_lies_on_its_side(tipping: Tipping, way: int) -> None:
    tipping.sense(0.05, about((1, 0, 0), way * math.pi / 2))
    assert abs(tipping.read("compass")[2]) >= 0.5
    assert tipping.read("compass") == pytest.approx([0, 0, -way], abs=1e-9)


def test_from_30_degrees_on_it_counts_as_tipped_over(tipping: Tipping) -> None:
    tipping.sense(0.04, about((1, 0, 0), math.radians(29)))
    assert tipping.read("compass")[2] == 0
    tipping.sense(0.04, about((1, 0, 0), math.radians(31)))
    assert abs(tipping.read("compass")[2]) == pytest.approx(math.sin(math.radians(31)))


def test_lying_its_height_is_the_true_one(tipping: Tipping) -> None:
    tipping.sense(0.061, about((1, 0, 0), math.pi / 2))
    assert tipping.read("gps") == pytest.approx([0, 0, 0.061])


def test_a_robot_that_was_lifted_has_its_true_height(tipping: Tipping) -> None:
    tipping.sense(0.1, (1, 0, 0, 0))
    assert tipping.read("gps")[2] == pytest.approx(0.1)


def test_sonars_turn_with_the_body_and_see_the_floor(tipping: Tipping) -> None:
    # On its nose (pitched by 90°) its front looks down: the ray starts 0.0385 below the centre.
    tipping.sense(0.3, about((0, 1, 0), math.pi / 2))
    assert tipping.read("distancesensor front") == pytest.approx([1000 * (0.3 - 0.0385)])


def test_the_lidars_plane_turns_with_the_body(tipping: Tipping) -> None:
    tipping.sense(0.3, about((1, 0, 0), math.pi / 2))
    cells = tipping.read("lidar")
    # Its front still looks at the wall; left and right look up and down, and rays of a lidar do not see the floor.
    assert cells[0] == pytest.approx(0.5, abs=1e-6)
    assert cells[90] == cells[270] == math.inf


def test_the_lidar_of_a_robot_that_leans_stands_above_its_body_and_not_above_the_floor(tipping: Tipping) -> None:
    lean = math.pi / 4
    tipping.sense(0.5, about((0, 1, 0), lean))
    above_centre = 0.0425 - 0.0375
    assert tipping.read("lidar")[0] == pytest.approx((0.5 - above_centre * math.sin(lean)) / math.cos(lean), abs=1e-6)


def test_a_robot_on_its_nose_keeps_its_last_yaw(tipping: Tipping) -> None:
    tipping.sense(0.0375, about((0, 0, 1), 1.0))
    tipping.sense(0.0375, about((0, 1, 0), math.pi / 2))
    assert tipping.devices._poses.robots[0].yaw == pytest.approx(1.0)
