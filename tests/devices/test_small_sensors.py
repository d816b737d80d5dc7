"""Gyro, accelerometer, inertial unit, light barrier, floor sensor, bumper and LED."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tests.devices.device_bench import Bench, half
from tests.match.playing import Place

CALM: dict[str, dict[str, Any]] = {
    "gyro": {"device": "gyro"},
    "accelerometer": {"device": "accelerometer"},
    "unit": {"device": "inertial_unit"},
    "ball sensor": {"device": "ball_sensor"},
    "floor": {"device": "floor_sensor", "ahead_m": 0.03},
    "bumper": {"device": "touch_sensor"},
    "left bumper": {"device": "touch_sensor", "bearing_rad": math.pi / 2, "angle_rad": 1.0},
}
FRONT_M, BALL_M = 0.0375, 0.021


def bench_with(devices: dict[str, dict[str, Any]] | None = None, seed: int = 7, number: int = 1) -> Bench:
    devices = CALM if devices is None else devices
    bench = Bench(change={"robots": {"Y1": {"devices": devices}}}, info=half(number, seed))
    bench.enable("Y1", *devices)
    bench.place("Y1", 0, 0, 0)
    return bench


def test_gyro_reads_how_fast_the_robot_turns() -> None:
    bench = bench_with()
    bench.drive("Y1", 10, -10)
    bench.play(30)
    assert bench.read("Y1", "gyro") == pytest.approx([0, 0, 4.44], rel=0.03)


@pytest.mark.parametrize("yaw", [0.0, 2.5])
def test_accelerometer_reads_the_start_ahead_and_gravity(yaw: float) -> None:
    bench = bench_with()
    bench.place("Y1", 0, 0, yaw)
    bench.play(5)
    assert bench.read("Y1", "accelerometer") == pytest.approx([0, 0, 9.81], abs=1e-3)
    bench.drive("Y1", 10, 10)
    bench.play(1)
    assert bench.read("Y1", "accelerometer") == pytest.approx([9.81 / 3, 0, 9.81], abs=0.2)
    bench.play(20)
    assert bench.read("Y1", "accelerometer") == pytest.approx([0, 0, 9.81], abs=0.01)


@pytest.mark.parametrize("yaw", [0.0, 1.0, -3.0])
def test_inertial_unit_reads_the_yaw(yaw: float) -> None:
    bench = bench_with()
    bench.place("Y1", 0, 0, yaw)
    bench.sense()
    assert bench.read("Y1", "unit") == pytest.approx([0, 0, yaw], abs=1e-6)


@pytest.mark.parametrize(("device", "drift"), [("gyro", 0.1), ("inertial_unit", 0.1)])
def test_drift_is_drawn_for_each_half_and_lasts_all_through_it(device: str, drift: float) -> None:
    readings = []
    for seed, number in ((7, 1), (7, 2), (8, 1), (7, 1)):
        bench = bench_with({"it": {"device": device, "drift_radps": drift}}, seed, number)
        found = []
        for _ in range(2):
            bench.sense(ticks=100)
            found.append(bench.read("Y1", "it")[2])
        readings.append(found)
        assert found[1] == pytest.approx(found[0] * (2 if device == "inertial_unit" else 1))
    assert readings[0] == readings[3]
    assert len({found[0] for found in readings}) == 3


@pytest.mark.parametrize(("device", "field", "axis"), [
    ("gyro", "noise_radps", 2), ("accelerometer", "noise_mps2", 1), ("inertial_unit", "noise_rad", 2),
    ("floor_sensor", "noise", 0),
])  # fmt: skip
def test_noise_has_its_standard_deviation_and_a_stream_of_its_own(device: str, field: str, axis: int) -> None:
    def readings(**others: Any) -> list[float]:
        bench = bench_with({"it": {"device": device, field: 0.05}, **others})
        found = []
        for _ in range(400):
            bench.sense()
            found.append(bench.read("Y1", "it")[axis])
        return found

    alone = readings()
    mean = math.fsum(alone) / len(alone)
    deviation = math.sqrt(math.fsum((one - mean) ** 2 for one in alone) / len(alone))
    assert deviation / (mean if device == "floor_sensor" else 1) == pytest.approx(0.05, rel=0.15)
    assert alone == readings(**CALM)


@pytest.mark.parametrize(("gap_m", "aside_m", "reading"), [
    (0.0, 0.0, 0.0), (0.012, 0.0, 12.0), (0.019, 0.01, 19.0), (0.03, 0.0, 20.0), (0.005, 0.03, 20.0),
])  # fmt: skip
@pytest.mark.parametrize("yaw", [0.0, -2.0])
def test_light_barrier_reads_the_gap_to_a_ball_ahead(gap_m: float, aside_m: float, reading: float, yaw: float) -> None:
    bench = bench_with()
    bench.place("Y1", 0.1, 0.1, yaw)
    c, s, ahead_m = math.cos(yaw), math.sin(yaw), FRONT_M + BALL_M + gap_m
    bench.place("ball", 0.1 + c * ahead_m - s * aside_m, 0.1 + s * ahead_m + c * aside_m)
    bench.sense()
    assert bench.read("Y1", "ball sensor") == pytest.approx([reading], abs=0.2)


def test_floor_sensor_reads_lines_brighter_than_the_floor() -> None:
    bench = bench_with()
    for y_m, is_line in ((0.0, True), (-0.03, True), (-0.2, False)):
        bench.place("Y1", 0.2, y_m, math.pi / 2 if y_m else 0.0)
        bench.sense()
        (bright,) = bench.read("Y1", "floor")
        assert (bright == pytest.approx(1000)) is is_line
        assert is_line or 100 < bright < 700


def test_bumper_reads_1_while_the_robot_touches_something_but_a_ball() -> None:
    bench = bench_with()
    bench.place("Y1", 0.4, 0, 0)
    bench.place("ball", 0.47, 0)
    bench.drive("Y1", 10, 10)
    found = []
    for _ in range(60):
        bench.play(1)
        found.append(bench.read("Y1", "bumper")[0])
    assert set(found[:20]) == {0.0}
    bench.park("ball")
    bench.place("Y1", 0.55, 0, 0)
    bench.play(20)
    assert bench.read("Y1", "bumper") == [1.0]
    assert bench.read("Y1", "left bumper") == [0.0]


def test_bumper_covers_its_angle() -> None:
    bench = bench_with()
    bench.place("Y1", 0, 0, 0)
    bench.place("B1", 0, 0.12, -math.pi / 2)
    bench.drive("B1", 10, 10)
    touched = []
    for _ in range(40):
        bench.play(1)
        touched.append((bench.read("Y1", "bumper")[0], bench.read("Y1", "left bumper")[0]))
    assert (1.0, 1.0) in touched
    assert (1.0, 0.0) not in touched


PROGRAM = """
from controller import *
robot = Robot()
names = "gyro", "accelerometer", "unit", "ball sensor", "floor", "bumper"
gyro, accelerometer, unit, ball, floor, bumper = [robot.getDevice(name) for name in names]
for sensor in (gyro, accelerometer, unit, ball, floor, bumper):
    sensor.enable(32)
led = LED("lamp")
led.set(2)
led.set(3)
print([isinstance(*pair) for pair in ((gyro, Gyro), (accelerometer, Accelerometer), (unit, InertialUnit),
    (ball, DistanceSensor), (floor, LightSensor), (bumper, TouchSensor), (led, LED))])
while robot.step(32) != -1:
    print(gyro.getValues(), accelerometer.getValues(), unit.getRollPitchYaw(), unit.getQuaternion(), ball.getValue(),
        floor.getValue(), bumper.getValue(), led.get())
print(ball.getType() == DistanceSensor.INFRA_RED, bumper.getType() == TouchSensor.BUMPER, unit.getNoise(),
    gyro.getLookupTable(), [device.getNodeType() == kind for device, kind in ((led, Node.LED), (unit, Node.INERTIAL_UNIT),
    (floor, Node.LIGHT_SENSOR), (bumper, Node.TOUCH_SENSOR))])
"""


def test_programs_use_them_by_the_calls_of_webots(tmp_path: Any) -> None:
    place = Place(tmp_path)
    devices = ", ".join(
        f"{name}: {{{', '.join(f'{key}: {value}' for key, value in device.items())}}}" for name, device in CALM.items()
    )
    override = f"robots.B1.devices={{{devices}, lamp: {{device: led, colours: [red, lime]}}}}"
    run = place.play("match.half_s=1", override, blue=place.team_folder(PROGRAM), record_sensors=True)
    first, warning, *lines = [line for line in run.log("B1").splitlines() if line and not line.startswith("---")]
    said = run.log("B1")
    assert "[True, True, True, True, True, True, True]" in said
    assert "'lamp': there is no colour 3; 0 to 2 are possible" in said
    assert "True True 0.0 [] [True, True, True, True]" in said
    assert any(line.endswith(" 2") and "9.81" in line for line in lines), (first, warning)
