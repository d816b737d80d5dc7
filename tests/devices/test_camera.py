"""The camera: pictures at its own rate, of what stands around its robot, and nothing else."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest

from rcj_challenges.devices.camera import RECOGNITION, SEEN
from rcj_challenges.programs.program_side.controller._wire import request_frame
from rcj_challenges.programs.program_side.controller.camera import Camera, CameraRecognitionObject
from rcj_challenges.programs.protocol import Codec, ProtocolError
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


def recognized(bench: Bench, *, ticks: int = 3, period: int = 1) -> list[tuple[int, list[CameraRecognitionObject]]]:
    """Return what the camera of Y1 recognizes in so many ticks, each with the tick at which it came."""
    number = bench.device("Y1", "front camera") + RECOGNITION
    bench.ask("Y1", sampling=((number, period),))
    found = []
    for _ in range(ticks):
        bench.sense()
        packets = bench.devices.observe(bench.roster.index["Y1"], bench.tick).packets
        found += [
            (bench.tick, [CameraRecognitionObject(one) for one in SEEN.iter_unpack(packet.data)])
            for packet in packets
            if packet.device == number
        ]
    return found


def recognizing_bench(**placed: tuple[float, float, float]) -> Bench:
    bench = camera_bench({"recognition": True, "width": 64, "height": 48})
    for name, where in placed.items():
        bench.place(name, *where)
    return bench


def test_a_recognized_ball_has_the_fields_of_webots() -> None:
    ((_, (ball,)),) = recognized(recognizing_bench(ball=(0.0, 0.33, 0.0)))
    assert (ball.model, ball.number_of_colors, ball.colors) == ("ball", 1, [0xE8 / 255, 0x59 / 255, 0x0C / 255])
    assert ball.position == pytest.approx([0.3, 0.0, 0.0209 - 0.06], abs=2e-4)
    assert (ball.orientation, ball.size) == ([0.0, 0.0, 1.0, 0.0], [0.042, 0.042])
    assert ball.position_on_image == [32, 25]
    assert ball.size_on_image == [8, 7]
    assert ball.getId() == ball.id > 0
    assert (ball.getPosition(), ball.getModel(), ball.getColors()) == (ball.position, "ball", ball.colors)


def test_things_are_listed_by_depth_and_keep_their_numbers() -> None:
    bench = recognizing_bench(ball=(0.1, 0.5, 0.0), B1=(-0.1, 0.3, 0.0))
    ((_, first),) = recognized(bench)
    assert [one.model for one in first] == ["robot", "ball"]
    bench.place("ball", 0.05, 0.2)
    ((_, second),) = recognized(bench)
    assert [one.model for one in second] == ["ball", "robot"]
    assert {one.model: one.id for one in first} == {one.model: one.id for one in second}


def test_a_ball_behind_a_robot_is_not_listed_and_of_half_a_ball_the_visible_half() -> None:
    bench = recognizing_bench(ball=(0.0, 0.5, 0.0))
    ((_, (whole,)),) = recognized(bench)
    bench.place("B1", 0.0, 0.3, 0.0)
    ((_, hidden),) = recognized(bench)
    assert [one.model for one in hidden] == ["robot"]
    bench.place("B1", -0.0375, 0.3, 0.0)  # its right edge is on the way to the middle of the ball
    ((_, (_, half_ball)),) = recognized(bench)
    assert (whole.position_on_image, whole.size_on_image) == ([32, 22], [4, 5])
    assert (half_ball.position_on_image, half_ball.size_on_image) == ([33, 22], [2, 5])
    assert half_ball.position == whole.position


def test_recognition_comes_at_the_cameras_own_rate_or_less_often_and_without_pictures() -> None:
    bench = recognizing_bench(ball=(0.0, 0.3, 0.0))
    bench.sense()
    assert [tick for tick, _ in recognized(bench, ticks=8)] == [3, 6, 9]
    assert [tick for tick, _ in recognized(bench, ticks=9, period=4)] == [12, 16]
    assert bench.heard("Y1", "front camera") == []


def test_a_robot_off_the_field_recognizes_nothing() -> None:
    bench = recognizing_bench(ball=(0.0, 0.3, 0.0))
    bench.park("Y1")
    assert recognized(bench) == [(3, [])]


def test_recognition_is_asked_for_only_from_cameras_that_have_it() -> None:
    for has_it in (False, True):
        bench = camera_bench({"recognition": has_it})
        codec = Codec(bench.devices.specs[bench.roster.index["Y1"]], 1000)
        number = bench.device("Y1", "front camera") + RECOGNITION
        asked = request_frame(0, 1, 0, 0, (), sampling=((number, 1),))[4:]
        if has_it:
            assert codec.decode(asked, 0).sampling == ((number, 1),)
        else:
            with pytest.raises(ProtocolError):
                codec.decode(asked, 0)


def test_a_program_asks_for_recognition_beside_pictures() -> None:
    asked: list[tuple[int, int]] = []
    data = SEEN.pack(7, 1, 255, 0, 51, 0.3, 0.1, -0.04, 0.0, 0.042, 0.042, 10, 20, 4, 5)
    queue = [(data, 0.0, 0.0, 0.0, 0.0)]
    camera = Camera.__new__(Camera)
    camera._rcj_index, camera._rcj_facts, camera._rcj_name = 4, {"recognition": True}, "eye"
    camera._rcj_recognition_ms = 0
    camera._rcj_connection = SimpleNamespace(
        sample=lambda *setting: asked.append(setting),
        ticks_from_ms=lambda ms: ms // 32,
        queues={4 + RECOGNITION: queue},
    )
    assert camera.getRecognitionObjects() == []
    camera.recognitionEnable(64)
    (ball,) = camera.getRecognitionObjects()
    assert (ball.id, ball.model, ball.position, ball.size_on_image) == (7, "ball", [0.3, 0.1, -0.04], [4, 5])
    assert camera.getRecognitionSamplingPeriod() == camera.recognition_sampling_period == 64
    camera.recognitionDisable()
    assert (camera.getRecognitionNumberOfObjects(), asked) == (0, [(4 + RECOGNITION, 2), (4 + RECOGNITION, 0)])
