"""A chassis that the package does not have, in one file; run as a program it prints what the package makes of it."""

import json
import math
import sys
from collections.abc import Sequence
from pathlib import Path
from struct import Struct
from typing import Literal

from rcj_challenges.chassis.base import CHASSIS, GRAVITY_MPS2, YAW, Chassis, Drive, Grip, Mount, Physics, Wheel
from rcj_challenges.geometry.polygons import Point
from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.fields import described

_PAIR = Struct("2d")
THREE = tuple(math.radians(angle) for angle in (60, 180, 300))
FOUR = tuple(math.radians(angle) for angle in (60, 135, 225, 300))
_GAIN_PS, _ARRIVED_RAD = 10.0, 1e-6


class OmniChassis(Chassis):
    """A round body on wheels with rollers, which slip freely across."""

    drive: Literal["omni"]
    wheels_at_rad: tuple[float, ...] = described(..., "where the wheels are, counter-clockwise from +x", strict=False)

    MOTOR_JOINT = "motor"
    EXAMPLE = """
kits:
  v2:
    chassis: {drive: omni, wheels_at_rad: [1.0471975511965976, 3.141592653589793, 5.235987755982989]}
    devices:
      left wheel motor: {device: motor, wheel: 0}
      right wheel motor: {device: motor, wheel: 1}
      rear wheel motor: {device: motor, wheel: 2}
      left wheel sensor: {device: wheel_sensor, wheel: 0}
      right wheel sensor: {device: wheel_sensor, wheel: 1}
"""

    def body(self) -> tuple[Point, ...]:
        """Return a polygon with 16 corners."""
        corners = [math.pi * (2 * corner + 1) / 16 for corner in range(16)]
        return tuple((self.size_m / 2 * math.cos(at), self.size_m / 2 * math.sin(at)) for at in corners)

    def wheels(self) -> tuple[Wheel, ...]:
        """Return wheels that drive counter-clockwise around the body."""
        ring_m = 0.9 * self.size_m / 2
        return tuple(
            Wheel(number, ring_m * math.cos(at), ring_m * math.sin(at), at + math.pi / 2, 0.02, 0.008, 0.005)
            for number, at in enumerate(self.wheels_at_rad)
        )

    def grips(self, friction: float) -> tuple[Grip, ...]:
        """Return the grip along each wheel."""
        wheels = self.wheels()
        limit_n = friction * self.mass_kg * GRAVITY_MPS2 / len(wheels)
        slip = {"x": 0.0, "y": 0.0, "yaw": 0.9 * self.size_m / 2, self.MOTOR_JOINT: 0.0}
        return tuple(Grip(f"{wheel.name}_grip", limit_n, slip) for wheel in wheels)

    @classmethod
    def make_drive(cls, physics: Physics, mounts: Sequence[Mount]) -> Drive:
        """Return the drive of all robots with such wheels."""
        return OmniDrive(physics, mounts)

    def describe(self, _phrases: Phrases) -> str:
        """Return what it is."""
        return f"a round body on {len(self.wheels_at_rad)} omni wheels"


class OmniDrive:
    """One joint per robot turns at 1 rad/s; how fast a wheel turns is its grip's coefficient of that joint."""

    def __init__(self, physics: Physics, mounts: Sequence[Mount]) -> None:
        self._physics = physics
        self._mounts = {mount.robot: (mount, mount.chassis.wheels()) for mount in mounts}
        self._commands: dict[tuple[int, int], tuple[float, float]] = {}
        self._stopped: set[int] = set()

    def reset(self) -> None:
        """Brake all wheels."""
        self._commands.clear()
        self._stopped.clear()

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel."""
        self._commands[robot, wheel] = velocity_radps, position_rad

    def set_stopped(self, robot: int, *, stopped: bool) -> None:
        """Brake the wheels of a robot, or release them."""
        (self._stopped.add if stopped else self._stopped.discard)(robot)

    def before_substep(self, _substep: int) -> None:
        """Turn the wheels, and let the grips follow the yaw."""
        qpos, qvel, numbers = self._physics.qpos, self._physics.qvel, self._physics.coefficients
        for robot, (mount, wheels) in self._mounts.items():
            qvel[mount.at + YAW + 1] = 1.0
            for number, wheel in enumerate(wheels):
                first, at = mount.coefficient + 4 * number, mount.turned + number
                along_rad = qpos[mount.at + YAW] + wheel.yaw_rad
                _PAIR.pack_into(numbers, numbers.itemsize * first, math.cos(along_rad), math.sin(along_rad))
                radps = 0.0 if robot in self._stopped else self._turns(robot, number, self._physics.turned_rad[at])
                numbers[first + 3] = -wheel.radius_m * radps
                self._physics.turned_rad[at] += radps * 0.008

    def _turns(self, robot: int, wheel: int, angle_rad: float) -> float:
        velocity, target = self._commands.get((robot, wheel), (0.0, math.inf))
        if math.isinf(target):
            return velocity
        left_rad = target - angle_rad
        return 0.0 if abs(left_rad) < _ARRIVED_RAD else max(-abs(velocity), min(abs(velocity), _GAIN_PS * left_rad))


PROGRAM = """
from controller import Robot
robot = Robot()
motors = [robot.getDevice(name + " wheel motor") for name in ("left", "right", "rear")]
sensor = robot.getDevice("left wheel sensor"); sensor.enable(32)
for motor, speed in zip(motors, (-5, 0, 5)):
    motor.setPosition(float("inf")); motor.setVelocity(speed)
while robot.step(32) != -1:
    print(sensor.getValue().hex())
"""


def speeds(at_rad: Sequence[float]) -> dict[str, dict[str, list[float]]]:
    """Return speeds along and across the robot in m/s and about z in rad/s, as ordered and as they are."""
    from tests.world.physics_stage import Stage

    chassis = OmniChassis(drive="omni", wheels_at_rad=tuple(at_rad))
    stage = Stage(kits={"v2": {"chassis": chassis}})
    orders = {"ahead": (0.15, 0, 0), "sideways": (0, 0.15, 0), "spin": (0, 0, 3), "ahead and spin": (0.1, 0, 1)}
    found = {}
    for way, (vx, vy, spin) in orders.items():
        stage.put("B1", 0, 0)
        for number, wheel in enumerate(chassis.wheels()):
            along = math.cos(wheel.yaw_rad) * vx + math.sin(wheel.yaw_rad) * vy
            arm_m = math.hypot(wheel.x_m, wheel.y_m)
            stage.world.set_wheel(stage.index("B1"), number, (along + arm_m * spin) / wheel.radius_m, math.inf)
        stage.play(0.5)
        (x, y, turns), yaw = stage.velocity("B1"), stage.pose("B1")[2]
        c, s = math.cos(yaw), math.sin(yaw)
        found[way] = {"ordered": [vx, vy, spin], "is": [c * x + s * y, c * y - s * x, turns]}
    return found


def report(folder: Path) -> dict[str, object]:
    """Return what validation, physics, a match, replay, picture, video, sheet and reference make of the chassis."""
    from rcj_challenges.records.recorded_scenario import read_scenario
    from rcj_challenges.scenario.errors import ScenarioError
    from rcj_challenges.scenario.load import load_text
    from rcj_challenges.views.drawing.field import draw_scenario
    from rcj_challenges.views.palette import PALETTE, rgb
    from rcj_challenges.views.replay.page import write_replay
    from rcj_challenges.views.replay.things import visible_things
    from rcj_challenges.views.sheet import sheet_markdown
    from rcj_challenges.views.video.footage import Footage
    from rcj_challenges.views.video.scene import build_scene
    from rcj_challenges.world import contact
    from scripts.write_reference import Example, page
    from tests.match.playing import Place

    text = Example("chassis", ("omni",), OmniChassis.EXAMPLE).whole
    loaded = load_text(text)
    refused = []
    for right, wrong in (("wheel: 2", "wheel: 3"), ("wheels_at_rad: [1", "wheels_at_rad: [x, 1")):
        try:
            load_text(text.replace(right, wrong))
        except ScenarioError as error:
            refused += [one.where.path for one in error.diagnostics]
    place = Place(folder)
    run = place.play("match.half_s=2", blue=place.team_folder(PROGRAM), scenario=text)
    poses = [snapshot.substeps[-1][loaded.roster.index["B1"]] for snapshot in run.trajectory.halves[0].snapshots()]
    model = build_scene(Footage.open(run.folder), (64, 48), fine=False)
    dark = [part / 255 for part in rgb(PALETTE["dark"])]
    wheels = model.geom_rgba[model.geom_group == contact.GROUP_WHEELS]
    facts = visible_things(read_scenario(write_replay(run.folder).parent))
    return {
        "speeds": {len(at): speeds(at) for at in (THREE, FOUR)},
        "refused": refused,
        "turned": [float.fromhex(line) for line in run.log("B1").splitlines() if "0x" in line],
        "poses": [poses[0], poses[-1]],
        "dofs": model.nv,
        "recorded": type(read_scenario(run.folder).kits["v2"].chassis).__name__,
        "page": [len(one["wheels"]) for one in facts["entities"] if one["kind"] == "robot"],
        "drawn": draw_scenario(loaded.scenario, loaded.roster).count('fill="#212529"'),
        "filmed": int((abs(wheels[:, :3] - dark).max(axis=1) < 1e-6).sum()),
        "sheet": sheet_markdown(loaded.scenario, loaded.roster),
        "reference": page().partition("### omni\n")[2].partition("\n### ")[0],
    }


if __name__ == "__main__":
    CHASSIS.add(OmniChassis)
    print(json.dumps(report(Path(sys.argv[1]))))
