"""Robots on omni wheels: how they drive, hold and turn, in a match and in pictures of it."""

import math
from functools import cache

import pytest

from rcj_challenges.chassis.omni import OmniChassis
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing.field import draw_scenario
from rcj_challenges.views.palette import PALETTE, rgb
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.scene import build_scene
from rcj_challenges.world import contact
from scripts.write_reference import Example
from tests.match.playing import Place
from tests.world.physics_stage import Stage, same_stage

GEOMETRIES = {
    "even four": (math.pi / 4, 3 * math.pi / 4, 5 * math.pi / 4, 7 * math.pi / 4),
    "usual four": OmniChassis.model_fields["wheels_at_rad"].default,
    "three": (math.pi / 3, math.pi, 5 * math.pi / 3),
}
ORDERS = {
    "ahead": (0.15, 0.0, 0.0),
    "sideways": (0.0, 0.15, 0.0),
    "diagonal": (0.1, 0.1, 0.0),
    "spin": (0.0, 0.0, 3.0),
    "ahead and spin": (0.1, 0.0, 1.0),
}
GIVEN = "schema_version: 2\nid: omni\ntitle: Omni\nextends: soccersim_v2\nmatch: {half_s: 2}\n"


@cache
def omni(*at_rad: float, shape: str = "round") -> OmniChassis:
    at_rad = at_rad or GEOMETRIES["usual four"]
    return OmniChassis(drive="omni", wheels_at_rad=at_rad, shape=shape, jaws_m=(0.006, 0.05))


def stage_of(chassis: OmniChassis, **changes) -> Stage:
    return same_stage(kits={"v2": {"chassis": chassis}}, **changes)


def order(stage: Stage, chassis: OmniChassis, name: str, vx: float, vy: float, spin: float) -> None:
    """Turn the wheels for a speed in the robot's frame."""
    for number, wheel in enumerate(chassis.wheels()):
        along = math.cos(wheel.yaw_rad) * vx + math.sin(wheel.yaw_rad) * vy + chassis.wheel_ring_m * spin
        stage.world.set_wheel(stage.index(name), number, along / wheel.radius_m, math.inf)


def motion(stage: Stage, name: str) -> tuple[float, float, float]:
    """Return the speed along and across a robot, and about z."""
    (x, y, spin), yaw = stage.velocity(name), stage.pose(name)[2]
    c, s = math.cos(yaw), math.sin(yaw)
    return c * x + s * y, c * y - s * x, spin


@pytest.mark.parametrize("way", ORDERS)
@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_robot_moves_as_its_wheels_are_commanded(geometry, way):
    chassis = omni(*GEOMETRIES[geometry])
    stage = stage_of(chassis)
    stage.put("B1", 0, 0, 0.4)
    order(stage, chassis, "B1", *ORDERS[way])
    stage.play(0.5)
    # What is left while it turns is the yaw of half a sub-step, with which the direction of a speed is seen.
    turned_mps = 0.004 * abs(ORDERS[way][2]) * 0.21 if way == "ahead and spin" else 0.0
    assert motion(stage, "B1") == pytest.approx(ORDERS[way], abs=1e-5 + turned_mps)


def test_it_has_95_percent_of_its_speed_within_a_tenth_of_a_second_and_no_more_grip_than_the_two_wheels():
    chassis = omni()
    stage = stage_of(chassis)
    stage.put("B1", 0, 0)
    order(stage, chassis, "B1", 0.2, 0.0, 0.0)
    stage.play(0.032)
    assert stage.speed("B1") / 0.032 < 0.4 * 9.81
    stage.play(0.064)
    assert stage.speed("B1") > 0.19


@pytest.mark.parametrize("shape", ["box", "round", "flat_front"])
def test_braked_robot_that_is_pushed_stays(shape):
    stage = stage_of(omni(shape=shape))
    stage.put("B1", 0, 0, 0.3)
    body = stage.world.tables.bodies[stage.index("B1")]
    stage.world.data.xfrc_applied[body, 0] = 0.5
    stage.play(12)
    stage.world.data.xfrc_applied[body, 0] = 0.0
    assert math.hypot(*stage.pose("B1")[:2]) < 0.001


@pytest.mark.parametrize("friction", [0.1, 0.5, 2.0])
def test_it_drives_on_any_floor(friction):
    chassis = omni()
    stage = stage_of(chassis, field={"friction": friction})
    stage.put("B1", 0, 0)
    order(stage, chassis, "B1", 0.15, 0.05, 1.0)
    stage.play(1.5)
    assert motion(stage, "B1") == pytest.approx((0.15, 0.05, 1.0), abs=0.002)


def test_wheels_that_contradict_each_other_slip_and_their_grip_cancels():
    stage = stage_of(omni(*GEOMETRIES["even four"]))
    stage.put("B1", 0, 0)
    for wheel, radps in enumerate((10, -10, 10, -10)):
        stage.world.set_wheel(stage.index("B1"), wheel, radps, math.inf)
    stage.play(2)
    assert stage.pose("B1") == pytest.approx((0, 0, 0), abs=1e-3)


def test_all_wheels_cost_one_degree_of_freedom():
    assert stage_of(omni()).world.model.nv == 6 * 4 + 6


def test_held_robot_stands_and_goes_on_as_it_was_commanded_meanwhile():
    chassis = omni()
    stage = stage_of(chassis)
    stage.put("B1", 0, 0)
    stage.hold("B1")
    order(stage, chassis, "B1", 0.0, 0.15, 0.0)
    stage.play(0.5)
    assert stage.pose("B1") == pytest.approx((0, 0, 0), abs=1e-6)
    stage.hold()
    stage.play(0.5)
    assert stage.pose("B1")[1] > 0.05


@pytest.mark.parametrize("shape", ["box", "round", "flat_front"])
def test_crowd_at_posts_and_corners_stays_on_the_field_and_does_not_sink_into_it(shape):
    chassis = omni(shape=shape)
    stage = stage_of(chassis)
    for number, name in enumerate(("B1", "B2", "B3", "Y1", "Y2", "Y3")):
        stage.put(name, -0.4 + 0.16 * number, 0.3)
    stage.put("ball", 0, 0.5)
    deepest_m = 0.0
    for _ in range(600):
        for number, name in enumerate(("B1", "B2", "B3", "Y1", "Y2", "Y3")):
            yaw, way = stage.pose(name)[2], stage.tick / 40 + number
            order(stage, chassis, name, 0.2 * math.cos(way - yaw), 0.2 * math.sin(way - yaw), math.sin(way) * 3)
        stage.play()
        deepest_m = max(deepest_m, -min(stage.world.data.contact.dist.tolist(), default=0.0))
        x_m, y_m, _ = (
            max(abs(at) for at in along) for along in zip(*map(stage.pose, stage.roster.entities[:6]), strict=True)
        )
        assert x_m < 0.65
        assert y_m < 0.85
    assert deepest_m < 0.005


def test_ball_between_jaws_that_is_pushed_at_a_wall_does_not_sink_in():
    chassis = omni()
    stage = stage_of(chassis)
    stage.put("ball", 0.65 - 0.021, 0)
    stage.put("B1", 0.5, 0)
    order(stage, chassis, "B1", 0.2, 0.0, 0.0)
    stage.play(3)
    assert stage.pose("ball")[0] == pytest.approx(0.65 - 0.021, abs=0.001)
    assert stage.pose("B1")[0] == pytest.approx(0.65 - 0.042 - chassis.front_m, abs=0.001)


@pytest.mark.parametrize(
    "at_rad", ["[0, 3.1416, 0]", "[1, 1, 1, 1]", "[0, 3.14, 6.28, 0.01]"], ids=["two places", "one place", "in line"]
)
def test_wheels_that_cannot_drive_it_are_refused(at_rad):
    with pytest.raises(ScenarioError) as caught:
        load_text(f"{GIVEN}kits: {{v2: {{chassis: {{drive: omni, wheels_at_rad: {at_rad}}}}}}}\n")
    found = [(one.code, one.where.path) for one in caught.value.diagnostics]
    assert ("wrong-value", "kits.v2.chassis.wheels_at_rad") in found


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_its_top_speed_is_that_of_the_best_direction(geometry):
    chassis = omni(*GEOMETRIES[geometry])
    speeds = []
    for degrees in range(360):
        way = math.radians(degrees)
        fastest = max(abs(math.cos(wheel.yaw_rad - way)) for wheel in chassis.wheels())
        speeds.append(chassis.max_wheel_radps * chassis.wheel_radius_m / fastest)
    assert chassis.top_speed_mps == pytest.approx(max(speeds), rel=1e-3)


PROGRAM = """
from controller import Robot
robot = Robot()
names = ("left wheel motor", "rear left motor", "rear right motor", "right wheel motor")
motors = [robot.getDevice(name) for name in names]
sensor = robot.getDevice("left wheel sensor"); sensor.enable(32)
for motor, speed in zip(motors, (-5, -5, 5, 5)):
    motor.setPosition(float("inf")); motor.setVelocity(speed)
motors[1].setPosition(-3); motors[1].setVelocity(10)
while robot.step(32) != -1:
    print(sensor.getValue().hex())
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Return a match that a team plays on omni wheels."""
    place = Place(tmp_path_factory.mktemp("omni"))
    text = Example("chassis", ("omni",), OmniChassis.EXAMPLE).whole
    return place.play("match.half_s=2", blue=place.team_folder(PROGRAM), scenario=text)


def test_program_drives_it_and_senses_how_far_a_wheel_has_turned(run):
    start, *_, end = (snapshot.substeps[-1][0] for snapshot in run.trajectory.halves[0].snapshots())
    turned = [float.fromhex(line) for line in run.log("B1").splitlines() if "0x" in line]
    assert turned[-1] == pytest.approx(-10, abs=0.4)
    assert math.dist(start[:2], end[:2]) > 0.1


def test_record_holds_it_and_pages_pictures_and_videos_draw_its_body_jaws_and_wheels(run):
    scenario = read_scenario(run.folder)
    assert scenario.kits["v2"].chassis == OmniChassis(drive="omni", shape="flat_front", jaws_m=(0.005, 0.05))
    facts = [one for one in visible_things(scenario)["entities"] if one["kind"] == "robot"]
    assert [(len(one["body"]), len(one["jaws"]), len(one["wheels"])) for one in facts] == [(14, 2, 4)] * 6
    footage = Footage.open(run.folder)
    assert draw_scenario(scenario, footage.roster).count('fill="#212529"') == 6 * 6
    model = build_scene(footage, (64, 48), fine=False)
    dark = abs(model.geom_rgba[:, :3] - [part / 255 for part in rgb(PALETTE["dark"])]).max(axis=1) < 1e-6
    assert int(dark[model.geom_group == contact.GROUP_WHEELS].sum()) == 6 * 4
    assert int(dark[model.geom_group == contact.GROUP_CHASSIS].sum()) == 6 * 2
