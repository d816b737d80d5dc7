"""Distance sensors: one horizontal ray each, incidence rule and noise as in reference, 4.1."""

from __future__ import annotations

import math
from typing import Any

import mujoco
import pytest

from tests.devices.device_bench import Bench, half, merged

SIDES = ("front", "left", "right", "back")
EXACT = {"kits": {"v2": {"devices": {f"distancesensor {side}": {"noise": 0} for side in SIDES}}}}


def exact(change: dict[str, Any] | None = None) -> Bench:
    bench = Bench(change=merged(EXACT, change or {}))
    bench.enable("Y1", *(f"distancesensor {side}" for side in SIDES))
    return bench


def readings(bench: Bench, robot: str = "Y1") -> dict[str, float]:
    bench.sense()
    return {side: bench.read(robot, f"distancesensor {side}")[0] for side in SIDES}


def test_each_sonar_measures_from_one_millimetre_outside_the_cubes_face_to_the_wall() -> None:
    bench = exact()
    bench.place("Y1", 0.25, 0.4, 0)  # inner faces: x = ±0.65, y = ±0.75
    assert readings(bench) == pytest.approx(
        {
            "front": 1000 * (0.65 - 0.25 - 0.0385),
            "left": 1000 * (0.75 - 0.4 - 0.0385),
            "back": 1000 * (0.25 + 0.65 - 0.0385),
            "right": 1000,  # 1.15 - 0.0385 is beyond the range
        },
        abs=1e-6,
    )


def test_the_sonars_names_are_true_sides() -> None:
    bench = exact()
    bench.place("Y1", 0.4, 0, math.pi / 2)  # it looks along +y, so its right is the wall at x = 0.65
    near = readings(bench)
    assert near["right"] == pytest.approx(1000 * (0.25 - 0.0385))
    assert near["front"] == pytest.approx(1000 * (0.75 - 0.0385))


def test_a_robots_cube_is_seen_at_its_face() -> None:
    bench = exact()
    bench.place("Y1", -0.3, 0, 0)
    bench.place("B1", 0.1, 0, 0)
    assert readings(bench)["front"] == pytest.approx(1000 * (0.4 - 0.0375 - 0.0385), abs=1e-6)


def test_the_ray_passes_over_the_ball_and_over_wheels() -> None:
    bench = exact()
    bench.place("Y1", -0.3, 0, 0)
    bench.place("ball", -0.2, 0)
    assert readings(bench)["front"] == pytest.approx(1000 * (0.95 - 0.0385), abs=1e-6)
    # Beside B1's cube (half 0.0375) its wheels stand out to 0.05: a ray at 0.045 meets nothing but the wall.
    bench.place("B1", 0.1, -0.045, 0)
    assert readings(bench)["front"] == pytest.approx(1000 * (0.95 - 0.0385), abs=1e-6)


def test_a_big_ball_that_reaches_up_to_the_ray_is_seen() -> None:
    bench = exact({"balls": {"ball": {"radius_m": 0.06}}})
    bench.place("Y1", -0.4, 0, 0)
    bench.place("ball", 0, 0)
    # The ray is 0.0025 under the centre of the sphere.
    half_chord = math.sqrt(0.06**2 - 0.0025**2)
    assert readings(bench)["front"] == pytest.approx(1000 * (0.4 - half_chord - 0.0385), abs=1)


def test_goal_walls_are_seen() -> None:
    bench = exact()
    bench.place("Y1", 0, 0.7, math.pi / 2)
    near = readings(bench)
    assert near["front"] == pytest.approx(1000 * (0.85 - 0.7 - 0.0385), abs=1e-6)


def test_walls_lower_than_the_ray_are_not_seen() -> None:
    bench = exact({"field": {"wall_height_m": 0.05}})
    bench.place("Y1", 0.5, 0.3, 0)
    assert readings(bench)["front"] == 1000


@pytest.mark.parametrize(
    ("degrees", "heard"), [(0, True), (22, True), (-22, True), (23, False), (-23, False), (45, False)]
)
def test_an_echo_from_22_5_degrees_on_is_lost(degrees: float, heard: bool) -> None:
    bench = exact()
    angle = math.radians(degrees)
    bench.place("Y1", 0.3, 0, angle)
    expected = 1000 * ((0.35 - 0.0385 * math.cos(angle)) / math.cos(angle)) if heard else 1000
    assert readings(bench)["front"] == pytest.approx(expected, abs=1e-6)


def test_a_lost_echo_is_not_the_next_object() -> None:
    bench = exact()
    bench.place("Y1", -0.3, 0, 0)
    bench.place("B1", 0, 0, math.radians(30))  # turned away, with the wall behind it within the range
    assert readings(bench)["front"] == 1000


def test_a_sonar_can_be_one_that_loses_no_echo() -> None:
    bench = exact({"kits": {"v2": {"devices": {"distancesensor front": {"lost_from_rad": 3.0}}}}})
    bench.place("Y1", 0.3, 0, 1.0)
    assert readings(bench)["front"] == pytest.approx(1000 * (0.35 / math.cos(1.0) - 0.0385), abs=1e-6)
    bench.place("Y1", 0, 0, math.pi / 2 + 0.3)
    bench.park("Y1")
    assert readings(bench)["front"] == 1000


def test_what_has_gone_is_not_seen_any_more() -> None:
    bench = exact({"field": {"wall_height_m": 0.05, "goals": {"blue_goal": None, "yellow_goal": None}}})
    bench.place("Y1", 0, 0, 0)
    bench.place("B1", 0.3, 0, 0)
    assert readings(bench)["front"] < 300
    bench.park("B1")
    assert readings(bench)["front"] == 1000


def test_a_robot_pressed_into_a_wall_reads_zero() -> None:
    bench = exact()
    bench.place("Y1", 0.65 - 0.0375 + 0.0005, 0, 0)
    assert readings(bench)["front"] < 1
    bench.place("Y1", 0.65 - 0.0375 + 0.003, 0, 0)
    assert readings(bench)["front"] == 0


def test_a_parked_robot_sees_nothing() -> None:
    bench = exact()
    assert set(readings(bench).values()) == {1000}


def test_the_noise_is_five_per_cent_of_the_value_times_the_distance() -> None:
    bench = Bench()
    bench.enable("Y1", *(f"distancesensor {side}" for side in SIDES))
    bench.place("Y1", 0.25, 0, 0)
    true = {"front": 361.5, "back": 861.5, "left": 711.5, "right": 711.5}
    errors: dict[str, list[float]] = {side: [] for side in SIDES}
    for _ in range(800):
        for side, value in readings(bench).items():
            errors[side].append(value / true[side] - 1)
    for side, sample in errors.items():
        spread = math.sqrt(sum(e * e for e in sample) / len(sample))
        assert spread == pytest.approx(0.05 * true[side] / 1000, rel=0.1)
        assert abs(sum(sample) / len(sample)) < 0.006


def test_the_noise_of_a_tick_does_not_depend_on_what_else_is_sampled() -> None:
    alone, among_all = Bench(), Bench()
    alone.enable("Y1", "distancesensor front", period=2)
    among_all.enable("B2", "distancesensor left")
    among_all.enable("Y1", *(f"distancesensor {side}" for side in SIDES))
    for bench in (alone, among_all):
        bench.place("Y1", 0.2, 0.1, 0.1)
        bench.sense(ticks=600)
    assert alone.read("Y1", "distancesensor front") == among_all.read("Y1", "distancesensor front")


def test_the_noise_is_another_in_another_half_for_another_seed_and_another_device() -> None:
    first = set()
    for info in (half(1), half(2), half(1, seed=8)):
        bench = Bench(info=info)
        bench.enable("Y1", "distancesensor left", "distancesensor right")
        bench.place("Y1", 0, 0, 0)
        bench.sense()
        first |= {bench.read("Y1", "distancesensor left")[0], bench.read("Y1", "distancesensor right")[0]}
    assert len(first) == 6


@pytest.mark.parametrize("senses", [False, True])
def test_a_pole_stops_a_robot_whether_it_senses_or_not(senses: bool) -> None:
    """Sensors and the contacts at poles are both switched by the same number of MuJoCo's."""
    pole = {"shape": "cylinder", "radius_m": 0.03, "centre_m": [0, 0]}
    bench = Bench(change={"obstacles": {"pole": pole}})
    bench.place("Y1", -0.09, 0.03 + 0.05 - 0.004)  # it has 4 mm of a wheel in the pole's way
    bench.drive("Y1", 10.0, 10.0)
    if senses:
        bench.enable("Y1", "distancesensor front")
    bench.play(ticks=60)
    assert bench.world.data.qpos[bench.world.tables.qpos_at[bench.roster.index["Y1"]]] < 0.0


def test_measuring_leaves_what_others_have_switched_since() -> None:
    bench = exact()
    options = bench.world.model.opt
    options.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MULTICCD)
    switched = options.disableflags
    readings(bench)
    assert options.disableflags == switched
