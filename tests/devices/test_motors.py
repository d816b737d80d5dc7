"""Motors: signs and sides of both kits, clamping, position control, the end of a program."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from rcj_challenges.world.world import World
from tests.devices.device_bench import Bench


class Wheels:
    """Stands in for the world's wheels and remembers their commands."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.commanded: dict[tuple[int, int], tuple[float, float]] = {}
        monkeypatch.setattr(World, "set_wheel", lambda _world, *command: self.set_wheel(*command))

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        self.commanded[robot, wheel] = (velocity_radps, position_rad)


@pytest.fixture
def wheels(monkeypatch: pytest.MonkeyPatch) -> Callable[..., tuple[Bench, Wheels]]:
    def make(*args: Any) -> tuple[Bench, Wheels]:
        found = Wheels(monkeypatch)
        return Bench(*args), found

    return make


def moved(bench: Bench, robot: str, ticks: int = 60) -> tuple[float, float, float]:
    entity = bench.roster.index[robot]
    before = bench.world.judged().substeps[-1][entity]
    bench.play(ticks)
    after = bench.world.judged().substeps[-1][entity]
    return (after[0] - before[0], after[1] - before[1], math.remainder(after[2] - before[2], math.tau))


def test_positive_velocity_drives_v2_forward() -> None:
    bench = Bench()
    bench.place("Y1", -0.4, 0, 0)
    bench.drive("Y1", 10, 10)
    dx, dy, turn = moved(bench, "Y1")
    assert dx == pytest.approx(0.2 * 60 * 0.032, rel=0.05)
    assert (dy, turn) == pytest.approx((0, 0), abs=1e-3)


def test_left_faster_than_right_turns_v2_to_its_left() -> None:
    bench = Bench()
    bench.place("Y1", 0, 0, 0)
    bench.drive("Y1", 2, -2)
    assert moved(bench, "Y1", 20)[2] > 0.3


def test_the_worked_example_of_2021_negative_velocity_drives_forward() -> None:
    bench = Bench("soccersim_2021")
    bench.place("Y1", -0.3, 0.2, 0.5)
    bench.drive("Y1", -10, -10)
    bench.play(10)
    dx, dy, _ = moved(bench, "Y1", 20)
    assert (dx / 0.64, dy / 0.64) == pytest.approx((0.176, 0.096), rel=0.03)


def test_the_motors_names_are_the_wrong_way_round_in_v2_and_right_in_2021(
    wheels: Callable[..., tuple[Bench, Wheels]],
) -> None:
    bench, commanded = wheels()
    bench.drive("B1", 3, 4)
    assert commanded.commanded == {(0, 1): (3, math.inf), (0, 0): (4, math.inf)}
    bench, commanded = wheels("soccersim_2021")
    bench.drive("B1", 3, 4)
    assert commanded.commanded == {(0, 0): (-3, math.inf), (0, 1): (-4, math.inf)}


@pytest.mark.parametrize(("asked", "done"), [(15, 10), (-15, -10), (math.inf, 10), (-math.inf, -10), (9.99, 9.99)])
def test_too_fast_a_command_is_clamped(wheels: Callable[..., tuple[Bench, Wheels]], asked: float, done: float) -> None:
    bench, commanded = wheels()
    bench.drive("B1", asked, 0)
    assert commanded.commanded[0, 1] == (done, math.inf)


@pytest.mark.parametrize(("velocity", "position"), [(math.nan, math.inf), (1.0, math.nan)])
def test_a_command_that_is_no_number_is_ignored(
    wheels: Callable[..., tuple[Bench, Wheels]], velocity: float, position: float
) -> None:
    bench, commanded = wheels()
    bench.drive("B1", 5, 5)
    bench.drive("B1", velocity, velocity, position)
    assert commanded.commanded[0, 1] == (5, math.inf)


def test_a_position_target_has_the_sign_of_its_motor(wheels: Callable[..., tuple[Bench, Wheels]]) -> None:
    bench, commanded = wheels("soccersim_2021")
    bench.drive("B1", 5, 5, 1.5)
    assert commanded.commanded[0, 0] == (-5, -1.5)
    bench.drive("B1", 5, 5, -math.inf)
    assert commanded.commanded[0, 0] == (-5, math.inf)


def test_a_wheel_goes_to_its_position_and_its_sensor_agrees() -> None:
    bench = Bench("soccersim_2021")
    bench.place("Y1", 0, 0, 0)
    bench.enable("Y1", "left wheel sensor")
    bench.drive("Y1", 10, 10, 2.0)
    bench.play(60)
    assert bench.read("Y1", "left wheel sensor") == pytest.approx([2.0], abs=0.01)


def test_a_robot_without_commands_is_braked() -> None:
    bench = Bench()
    bench.place("Y1", 0, 0, 0)
    assert moved(bench, "Y1", 30) == pytest.approx((0, 0, 0), abs=1e-4)


def test_a_dead_programs_wheels_stop(wheels: Callable[..., tuple[Bench, Wheels]]) -> None:
    bench, commanded = wheels()
    bench.drive("B1", 5, 5)
    bench.devices.silence(0)
    assert commanded.commanded == {(0, 0): (0, math.inf), (0, 1): (0, math.inf)}
    bench.drive("B1", 5, 5)
    assert commanded.commanded == {(0, 0): (0, math.inf), (0, 1): (0, math.inf)}


def test_a_robot_taken_off_the_field_drives_on_as_commanded_when_it_is_back() -> None:
    bench = Bench()
    bench.place("Y1", 0, 0, 0)
    bench.drive("Y1", 10, 10)
    bench.play(5)
    bench.park("Y1")
    parked = moved(bench, "Y1", 10)
    assert parked == pytest.approx((0, 0, 0), abs=1e-6)
    bench.drive("Y1", 5, 5)
    assert moved(bench, "Y1", 10) == pytest.approx((0, 0, 0), abs=1e-6)
    bench.place("Y1", 0, 0, 0)
    bench.play(10)
    assert moved(bench, "Y1", 10)[0] == pytest.approx(0.1 * 0.32, rel=0.05)
