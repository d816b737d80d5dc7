"""GPS, compass and wheel sensors: reference, 4.1 and 4.2."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.device_bench import Bench

S3_ROBOT = {
    "robots": {"Y3": {"devices": {
        "gps": {"device": "gps", "frame": "legacy"},
        "compass": {"device": "compass", "frame": "legacy"},
    }}},
}  # fmt: skip


@pytest.fixture(scope="module")
def bench() -> Bench:
    bench = Bench()
    bench.enable("Y1", "gps", "compass", "left wheel sensor", "right wheel sensor")
    return bench


@given(st.floats(-0.6, 0.6), st.floats(-0.7, 0.7), st.floats(-math.pi, math.pi))
def test_gps_and_compass_together_give_the_pose(x: float, y: float, yaw: float) -> None:
    bench = _shared()
    bench.place("Y1", x, y, yaw)
    bench.sense()
    assert bench.read("Y1", "gps")[:2] == pytest.approx([x, y], abs=1e-9)
    north = bench.read("Y1", "compass")
    assert math.remainder(math.atan2(north[0], north[1]) - yaw, math.tau) == pytest.approx(0, abs=1e-9)
    assert math.hypot(*north) == pytest.approx(1)


_SHARED: list[Bench] = []


def _shared() -> Bench:
    if not _SHARED:
        _SHARED.append(Bench())
        _SHARED[0].enable("Y1", "gps", "compass")
    return _SHARED[0]


def test_the_worked_example_of_2021_reads_its_gps_and_compass() -> None:
    bench = Bench("soccersim_2021", S3_ROBOT)
    bench.enable("Y3", "gps", "compass")
    bench.place("Y3", -0.3, 0.2, 0.5)
    bench.sense()
    assert bench.read("Y3", "gps") == pytest.approx([0.2, 0.0375, -0.3], abs=1e-9)
    assert bench.read("Y3", "compass") == pytest.approx([0.878, 0, 0.479], abs=0.0005)


def test_wheel_sensors_read_the_angles_that_the_wheels_turned() -> None:
    bench = Bench()
    bench.place("Y1", 0, 0, 0)
    bench.enable("Y1", "left wheel sensor", "right wheel sensor")
    bench.drive("Y1", 5, 2)
    bench.play(10)
    assert bench.read("Y1", "left wheel sensor") == pytest.approx([5 * 0.32], rel=0.02)
    assert bench.read("Y1", "right wheel sensor") == pytest.approx([2 * 0.32], rel=0.02)


def test_wheel_sensors_of_2021_have_the_sign_of_their_motors() -> None:
    bench = Bench("soccersim_2021")
    bench.place("Y1", 0, 0, 0)
    bench.enable("Y1", "left wheel sensor", "right wheel sensor")
    bench.drive("Y1", -4, 4)
    bench.play(10)
    assert bench.read("Y1", "left wheel sensor") == pytest.approx([-4 * 0.32], rel=0.02)
    assert bench.read("Y1", "right wheel sensor") == pytest.approx([4 * 0.32], rel=0.02)


def test_gps_noise_has_the_spread_of_the_scenario() -> None:
    bench = Bench(change={"kits": {"v2": {"devices": {"gps": {"noise_m": 0.01}}}}})
    bench.place("Y1", 0.1, 0.2)
    bench.enable("Y1", "gps")
    errors = []
    for _ in range(500):
        bench.sense()
        x, y, z = bench.read("Y1", "gps")
        errors.append((x - 0.1, y - 0.2, z - 0.0375))
    for axis in zip(*errors, strict=True):
        assert sum(axis) / 500 == pytest.approx(0, abs=0.002)
        assert math.sqrt(sum(e * e for e in axis) / 500) == pytest.approx(0.01, rel=0.15)


def test_compass_noise_turns_the_heading_and_keeps_its_length() -> None:
    bench = Bench(change={"kits": {"v2": {"devices": {"compass": {"noise_rad": 0.1}}}}})
    bench.place("Y1", 0, 0, 1)
    bench.enable("Y1", "compass")
    errors = []
    for _ in range(500):
        bench.sense()
        north = bench.read("Y1", "compass")
        assert math.hypot(*north) == pytest.approx(1)
        errors.append(math.atan2(north[0], north[1]) - 1)
    assert math.sqrt(sum(e * e for e in errors) / 500) == pytest.approx(0.1, rel=0.15)
