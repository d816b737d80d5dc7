"""The laser scanner of the 2021 robots: reference, 4.2."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tests.devices.device_bench import Bench

FULL_TURN_TICKS = 4  # 3.125, and the head starts again within the fourth


def lidar_bench(**settings: Any) -> Bench:
    lidar = {"device": "lidar", **settings}
    bench = Bench("soccersim_2021", {"robots": {"Y3": {"devices": {"lidar": lidar}}}})
    bench.enable("Y3", "lidar")
    return bench


def scan(bench: Bench, ticks: int = 1) -> list[float]:
    bench.sense(ticks=ticks)
    return bench.read("Y3", "lidar")


def test_cell_0_is_the_front_and_the_index_grows_clockwise() -> None:
    bench = lidar_bench(rotating=False)
    bench.place("Y3", 0.25, 0.1, 0)
    cells = scan(bench)
    assert [cells[cell] for cell in (0, 90, 180, 270)] == pytest.approx([0.4, 0.85, 0.9, 0.65], abs=1e-6)


def test_the_worked_example_cell_90_looks_along_0_479_minus_0_878() -> None:
    bench = lidar_bench(rotating=False)
    bench.place("Y3", -0.3, 0.2, 0.5)
    x, y = 0.479, -0.878
    assert scan(bench)[90] == pytest.approx(min((0.65 + 0.3) / x, (-0.75 - 0.2) / y), rel=2e-3)


def test_it_sees_walls_goals_and_cubes() -> None:
    bench = lidar_bench(rotating=False)
    bench.place("Y3", 0, 0.2, math.pi / 2)
    bench.place("B1", 0.3, 0.2, 0)
    cells = scan(bench)
    assert cells[0] == pytest.approx(0.65, abs=1e-6)  # the goal's back wall at y = 0.85
    assert cells[90] == pytest.approx(0.3 - 0.0375, abs=1e-6)
    assert cells[180] == pytest.approx(1.05, abs=1e-6)
    assert cells[270] == pytest.approx(0.65, abs=1e-6)


def test_it_passes_over_the_ball_also_when_that_hops() -> None:
    bench = lidar_bench(rotating=False)
    bench.place("Y3", 0, 0, 0)
    bench.place("ball", 0.2, 0)
    assert scan(bench)[0] == pytest.approx(0.65, abs=1e-6)
    bench.world.data.joint("ball").qpos[2] = 0.03
    bench.world.place([])
    assert scan(bench)[0] == pytest.approx(0.65, abs=1e-6)


def test_its_own_cube_and_wheels_are_not_in_the_way() -> None:
    bench = lidar_bench(rotating=False, height_m=0.02)
    bench.place("Y3", 0, 0, 0.3)
    assert min(scan(bench)) > 0.6


def test_beyond_its_range_it_reads_infinity() -> None:
    bench = lidar_bench(rotating=False, max_range_m=0.7)
    bench.place("Y3", 0, 0, 0)
    cells = scan(bench)
    assert cells[0] == pytest.approx(0.65, abs=1e-6)
    assert cells[90] == math.inf


def test_nearer_than_its_smallest_range_it_reads_infinity() -> None:
    bench = lidar_bench(rotating=False, min_range_m=0.3)
    bench.place("Y3", 0, 0, 0)
    bench.place("B1", 0.2, 0, 0)
    assert scan(bench)[0] == math.inf


def test_a_rotating_head_refreshes_115_2_degrees_a_tick() -> None:
    bench = lidar_bench()
    bench.place("Y3", 0, 0, 0)
    swept = []
    for _ in range(3):
        cells = scan(bench)
        swept.append(sum(cell != 0.0 for cell in cells))
    assert swept == [116, 231, 346]  # cells at 0° … 115°, then up to 230.4°, then up to 345.6°
    assert cells[346:] == [0.0] * 14
    assert 0.0 not in scan(bench)


def test_a_rotating_head_shows_each_direction_as_it_was_when_it_passed() -> None:
    bench = lidar_bench()
    bench.place("Y3", 0, 0, 0)
    scan(bench, FULL_TURN_TICKS)  # the head stands at 100.8° in its second turn
    bench.place("Y3", 0.1, 0, 0)
    cells = scan(bench)  # cells 101 … 215
    assert cells[0] == pytest.approx(0.65, abs=1e-6)
    assert cells[180] == pytest.approx(0.75, abs=1e-6)


def test_over_25_ticks_the_head_makes_exactly_8_turns() -> None:
    """100 turns are exact: the head does not drift against its cells by rounding."""
    bench = lidar_bench()
    bench.place("Y3", 0, 0, 0)
    bench.sense(ticks=25 * 100)
    bench.place("Y3", 0.1, 0.1, 0)
    cells, old, new = scan(bench), scan_without_turning(0, 0), scan_without_turning(0.1, 0.1)
    assert old[115] != pytest.approx(new[115], abs=1e-3)
    assert cells == new[:116] + old[116:]


def scan_without_turning(x: float, y: float) -> list[float]:
    bench = lidar_bench(rotating=False)
    bench.place("Y3", x, y, 0)
    return scan(bench)


def test_a_faster_head_sweeps_more() -> None:
    bench = lidar_bench()
    bench.place("Y3", 0, 0, 0)
    bench.ask("Y3", frequencies=((bench.device("Y3", "lidar"), 20.0),))
    assert sum(cell != 0.0 for cell in scan(bench)) == 231
    bench.ask("Y3", frequencies=((bench.device("Y3", "lidar"), 1e9), (bench.device("Y3", "lidar"), math.nan)))
    bench.enable("Y3", "lidar", period=0)
    bench.enable("Y3", "lidar")
    assert sum(cell != 0.0 for cell in scan(bench)) == 288  # 25 Hz, the highest


def test_a_part_of_a_turn_runs_from_its_left_edge_to_its_right_edge() -> None:
    bench = lidar_bench(rotating=False, field_of_view_rad=math.pi, points=3)
    bench.place("Y3", 0.25, 0.1, 0)
    assert scan(bench) == pytest.approx([0.65, 0.4, 0.85], abs=1e-6)


def test_a_scanner_of_one_point_looks_ahead() -> None:
    bench = lidar_bench(rotating=False, field_of_view_rad=1, points=1)
    bench.place("Y3", 0.2, 0.1, 0)
    assert scan(bench) == pytest.approx([0.45], abs=1e-6)


def test_a_parked_robot_is_not_seen_and_sees_nothing() -> None:
    bench = lidar_bench(rotating=False)
    assert set(scan(bench)) == {math.inf}
    bench.place("Y3", 0, 0, 0)
    bench.place("B1", 0.3, 0, 0)
    bench.park("B1")
    assert scan(bench)[0] == pytest.approx(0.65, abs=1e-6)


def test_a_scanner_that_was_disabled_starts_again_at_the_front() -> None:
    bench = lidar_bench()
    bench.place("Y3", 0, 0, 0)
    scan(bench, 4)
    bench.enable("Y3", "lidar", period=0)
    assert set(scan(bench)) == {0.0}
    bench.enable("Y3", "lidar")
    assert sum(cell != 0.0 for cell in scan(bench)) == 116


def test_the_noise_has_the_spread_of_the_scenario() -> None:
    bench = lidar_bench(rotating=False, noise_m=0.01)
    bench.place("Y3", 0, 0, 0)
    exact = scan_without_turning(0, 0)
    errors = [noisy - true for _ in range(5) for noisy, true in zip(scan(bench), exact, strict=True)]
    assert math.sqrt(sum(error * error for error in errors) / len(errors)) == pytest.approx(0.01, rel=0.1)


def test_a_slow_head_with_few_cells_passes_none_of_them_in_most_ticks() -> None:
    bench = lidar_bench(points=4, frequency_hz=2)  # a cell every 3.9 ticks
    bench.place("Y3", 0.25, 0.1, 0)
    seen = [[round(cell, 6) for cell in scan(bench)] for _ in range(9)]
    ahead, right, behind = 0.4, 0.85, 0.9
    assert seen[:3] == [[ahead, 0, 0, 0]] * 3
    assert seen[3:7] == [[ahead, right, 0, 0]] * 4
    assert seen[7:] == [[ahead, right, behind, 0]] * 2
