"""The camera: pictures at its own rate, of what stands around its robot, and nothing else."""

from __future__ import annotations

import math
from typing import Any

import pytest

from rcj_challenges.programs.program_side.controller.camera import Camera
from tests.devices.device_bench import Bench, half

EYE = {"front camera": {"device": "camera", "width": 32, "height": 24}}


def camera_bench(settings: dict[str, Any] | None = None, *, info: Any = None) -> Bench:
    camera = {**EYE["front camera"], **(settings or {})}
    bench = Bench(change={"kits": {"v2": {"devices": {"front camera": camera}}}}, info=info)
    bench.place("Y1", 0.0, 0.0, math.pi / 2)
    return bench


def pictures(bench: Bench, robot: str = "Y1", ticks: int = 1) -> list[tuple[int, bytes]]:
    """Return the pictures of so many ticks, each with the tick at which it came."""
    found = []
    for _ in range(ticks):
        bench.sense()
        found += [(bench.tick, packet.data) for packet in bench.heard(robot, "front camera")]
    return found


class Shown(Camera):
    """The camera of a program that has received one picture."""

    def __init__(self, data: bytes, width: int = 32) -> None:
        self._rcj_pictures: Any = [(data, 0.0, 0.0, 0.0, 0.0)]
        self._rcj_packet, self._rcj_image, self._rcj_period_ms = None, b"", 32
        self._rcj_width = width

    def rgb(self, x: int, y: int) -> tuple[int, int, int]:
        image = self.getImage()
        return tuple(
            part(image, self._rcj_width, x, y) for part in (self.imageGetRed, self.imageGetGreen, self.imageGetBlue)
        )


def test_pictures_come_at_multiples_of_the_cameras_own_period_whenever_it_is_enabled() -> None:
    bench = camera_bench()
    bench.sense(ticks=4)
    bench.enable("Y1", "front camera")
    assert [tick for tick, _ in pictures(bench, ticks=9)] == [6, 9, 12]


def test_a_program_may_ask_for_fewer_pictures_but_not_for_more() -> None:
    bench = camera_bench()
    bench.enable("Y1", "front camera", period=5)
    assert [tick for tick, _ in pictures(bench, ticks=11)] == [5, 10]


def test_a_camera_that_is_off_takes_no_pictures() -> None:
    bench = camera_bench()
    assert pictures(bench, ticks=6) == []


def test_a_ball_ahead_is_in_the_middle_and_orange() -> None:
    bench = camera_bench()
    bench.place("ball", 0.0, 0.25)
    bench.enable("Y1", "front camera")
    ((_, data),) = pictures(bench, ticks=3)
    shown = Shown(data)
    orange = [(x, y) for x in range(32) for y in range(24) if shown.rgb(x, y) == (0xE8, 0x59, 0x0C)]
    assert orange
    assert sum(x for x, _ in orange) / len(orange) == pytest.approx(15.5)


def test_a_ball_behind_is_seen_by_a_camera_that_looks_back_and_one_to_the_left_is_left_in_the_panorama() -> None:
    for settings, ball, column in (
        ({"bearing_rad": math.pi}, (0.0, -0.25), 15.5),
        ({"field_of_view_rad": math.tau}, (-0.25, 0.0), 7.5),
    ):
        bench = camera_bench(settings)
        bench.place("ball", *ball)
        bench.enable("Y1", "front camera")
        ((_, data),) = pictures(bench, ticks=3)
        shown = Shown(data)
        xs = [x for x in range(32) for y in range(24) if shown.rgb(x, y) == (0xE8, 0x59, 0x0C)]
        assert sum(xs) / len(xs) == pytest.approx(column, abs=1)


def test_a_robot_in_front_hides_the_ball_and_the_own_robot_hides_nothing() -> None:
    bench = camera_bench()
    bench.place("ball", 0.0, 0.4)
    bench.place("B1", 0.0, 0.25, 0.0)
    bench.enable("Y1", "front camera")
    ((_, data),) = pictures(bench, ticks=3)
    shown = Shown(data)
    colours = {shown.rgb(x, y) for x in range(32) for y in range(24)}
    assert (0, 0, 255) in colours
    assert (0xE8, 0x59, 0x0C) not in colours
    assert (255, 255, 0) not in colours


def test_a_robot_off_the_field_sees_black() -> None:
    bench = camera_bench()
    bench.enable("Y1", "front camera")
    bench.park("Y1")
    ((_, data),) = pictures(bench, ticks=3)
    assert set(Shown(data).getImage()) == {0, 255}
    assert Shown(data).rgb(16, 20) == (0, 0, 0)


def test_a_program_gets_colours_and_pixels_and_no_number_beside() -> None:
    bench = camera_bench()
    bench.enable("Y1", "front camera")
    bench.sense(ticks=3)
    (packet,) = bench.heard("Y1", "front camera")
    assert (packet.strength, packet.direction) == (0.0, (0.0, 0.0, 0.0))
    colours = packet.data[0]
    assert len(packet.data) == 1 + 3 * colours + 32 * 24
    assert max(packet.data[1 + 3 * colours :]) < colours


def test_six_cameras_enabled_at_different_ticks_are_taken_together(monkeypatch: pytest.MonkeyPatch) -> None:
    taken: list[int] = []
    bench = camera_bench()
    sight = bench.devices._cameras._sight
    usual = sight.take
    monkeypatch.setattr(sight, "take", lambda eyes: taken.append(len(eyes)) or usual(eyes))
    for number, robot in enumerate(bench.scenario.robots):
        bench.place(robot, -0.5 + 0.2 * number, 0.4, 0.0)
        bench.enable(robot, "front camera")
        bench.sense()
    taken.clear()
    bench.sense(ticks=6)
    assert taken == [6, 6]


def test_the_light_is_drawn_for_each_half_and_the_same_for_the_same_seed() -> None:
    def first(number: int) -> bytes:
        bench = camera_bench({"light": [0.5, 1.0]}, info=half(number))
        bench.enable("Y1", "front camera")
        return pictures(bench, ticks=3)[0][1]

    assert first(1) == first(1)
    assert first(1) != first(2)


def test_arrays_are_indexed_by_column_then_row() -> None:
    data = bytes([2, 10, 20, 30, 40, 50, 60]) + bytes([0, 1, 1, 0, 0, 0])
    shown = Shown(data, width=3)
    assert shown.getImage()[:8] == bytes([30, 20, 10, 255, 60, 50, 40, 255])
    assert shown.getImageArray() == [
        [[10, 20, 30], [10, 20, 30]],
        [[40, 50, 60], [10, 20, 30]],
        [[40, 50, 60], [10, 20, 30]],
    ]
    assert shown.imageGetGray(shown.getImage(), 3, 1, 0) == 50
