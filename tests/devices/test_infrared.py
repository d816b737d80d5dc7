"""The ball's infra-red: strength, direction, occlusion (reference, 4.1)."""

from __future__ import annotations

import math
import statistics
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.traffic import Packet
from tests.devices.device_bench import Bench


@pytest.fixture
def bench() -> Bench:
    bench = Bench()
    bench.enable("Y1", "ball receiver")
    return bench


def ball_heard(bench: Bench) -> list[Packet]:
    bench.sense()
    return bench.heard("Y1", "ball receiver")


def test_the_worked_example(bench: Bench) -> None:
    bench.place("Y1", 0.2, -0.4, 2)
    bench.place("ball", 0, -0.1)
    (packet,) = ball_heard(bench)
    assert packet.direction == pytest.approx((0.986, 0.158, -0.046), abs=0.0005)
    assert packet.strength == pytest.approx(7.68, abs=0.005)


_SHARED: list[Bench] = []


@given(st.floats(0.1, 0.55), st.floats(-math.pi, math.pi), st.floats(-math.pi, math.pi))
def test_direction_and_strength_give_the_position_of_the_ball(distance: float, bearing: float, yaw: float) -> None:
    if not _SHARED:
        _SHARED.append(Bench())
        _SHARED[0].enable("Y1", "ball receiver")
    bench = _SHARED[0]
    bench.place("Y1", 0, 0, yaw)
    bench.place("ball", distance * math.cos(yaw + bearing), distance * math.sin(yaw + bearing))
    (packet,) = ball_heard(bench)
    x, y, z = packet.direction
    assert math.hypot(x, y, z) == pytest.approx(1)
    assert math.remainder(math.atan2(y, x) - bearing, math.tau) == pytest.approx(0, abs=1e-9)
    assert 1 / math.sqrt(packet.strength) == pytest.approx(math.hypot(distance, 0.0166), abs=1e-9)
    assert z < 0


def test_the_ball_is_received_up_to_0_6_m_away(bench: Bench) -> None:
    bench.place("Y1", -0.3, 0)
    bench.place("ball", -0.3 + 0.5997, 0)  # with the 16.6 mm of height: 0.59993
    assert len(ball_heard(bench)) == 1
    bench.place("ball", -0.3 + 0.5999, 0)  # 0.60013
    assert ball_heard(bench) == []


def test_another_robots_cube_hides_the_ball(bench: Bench) -> None:
    bench.place("Y1", -0.3, 0)
    bench.place("ball", 0.1, 0)
    bench.place("B1", -0.1, 0.03, 0)
    assert ball_heard(bench) == []
    bench.place("B1", -0.1, 0.06, 0)
    assert len(ball_heard(bench)) == 1


def test_another_robots_wheel_hides_the_ball(bench: Bench) -> None:
    bench.place("Y1", -0.3, 0)
    bench.place("ball", 0.1, 0)
    # The cube ends 0.0065 beside the line; the wheel reaches over it (outside 0.05 from the middle).
    bench.place("B1", -0.1, 0.044, 0)
    assert ball_heard(bench) == []
    bench.place("B1", -0.1, 0.044, math.pi / 2)  # now the wheels are before and behind the cube, none on this side
    assert len(ball_heard(bench)) == 1


def test_to_the_sonars_wheels_are_nothing_and_to_the_ball_receiver_they_are_still_in_the_way(bench: Bench) -> None:
    bench.enable("Y1", "distancesensor front")
    bench.place("Y1", -0.3, 0)
    bench.place("ball", 0.1, 0)
    bench.place("B1", -0.1, 0.044, 0)
    assert ball_heard(bench) == []
    assert bench.read("Y1", "distancesensor front")[0] > 800  # the wall beyond the wheel
    assert ball_heard(bench) == []


@pytest.mark.parametrize("yaw", [0, math.pi / 2, -math.pi / 2, math.pi, 0.9])
def test_the_robot_itself_never_hides_the_ball(bench: Bench, yaw: float) -> None:
    bench.place("Y1", 0, 0, yaw)
    bench.place("ball", 0.08, 0)
    assert len(ball_heard(bench)) == 1


def test_an_obstacle_hides_the_ball() -> None:
    bench = Bench(change={"obstacles": {"box": {"shape": "box", "centre_m": [0, 0], "size_m": [0.02, 0.2]}}})
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", -0.2, 0)
    bench.place("ball", 0.2, 0)
    assert ball_heard(bench) == []
    bench.place("ball", -0.1, 0)
    assert len(ball_heard(bench)) == 1


def test_several_balls_are_received_in_order_and_do_not_hide_each_other() -> None:
    balls = {"second": {"start_m": [0.2, 0.2]}, "silent": {"start_m": [0.3, 0.3], "emits": False}}
    bench = Bench(change={"balls": balls})
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.4, 0)
    bench.place("second", 0.2, 0)
    bench.place("silent", 0.1, 0)
    packets = ball_heard(bench)
    assert [round(1 / math.sqrt(packet.strength), 1) for packet in packets] == [0.4, 0.2]


def test_the_packet_is_fresh(bench: Bench) -> None:
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.2, 0)
    bench.sense()
    bench.place("ball", 0, 0.3)
    bench.sense()
    old, new = bench.heard("Y1", "ball receiver")
    assert old.direction[0] > 0.99
    assert new.direction[1] > 0.99


@pytest.mark.parametrize(("messages", "data"), [("v2.1", b"\x01"), ("v2.2", b"x")])
def test_the_packet_is_never_empty(messages: str, data: bytes) -> None:
    bench = Bench(change={"kits": {"v2": {"messages": messages}}})
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.2, 0)
    (packet,) = ball_heard(bench)
    assert packet.data == data


def test_a_parked_ball_is_not_received_and_a_parked_robot_receives_none() -> None:
    # A range that reaches as far as things are parked: being parked alone must be enough.
    bench = Bench(change={"kits": {"v2": {"devices": {"ball receiver": {"range_m": 1e9}}}}})
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", 0, 0)
    assert ball_heard(bench) == []
    bench.place("ball", 0.2, 0)
    bench.park("Y1")
    assert ball_heard(bench) == []
    bench.place("Y1", 0, 0)
    assert len(ball_heard(bench)) == 1


def test_a_parked_robot_hides_nothing(bench: Bench) -> None:
    bench.place("Y1", -0.3, 0)
    bench.place("ball", 0.1, 0)
    bench.place("B1", -0.1, 0)
    bench.park("B1")
    assert len(ball_heard(bench)) == 1


def test_a_receiver_on_another_channel_does_not_receive_the_ball(bench: Bench) -> None:
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.2, 0)
    bench.tune("Y1", "ball receiver", 5)
    assert ball_heard(bench) == []
    bench.tune("Y1", "ball receiver", 4)
    assert len(ball_heard(bench)) == 1


def test_a_ball_receiver_on_all_channels_receives_the_ball_and_no_radio(bench: Bench) -> None:
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.2, 0)
    bench.tune("Y1", "ball receiver", -1)
    bench.send("Y2", b"radio")
    assert [packet.data for packet in ball_heard(bench)] == [b"\x01"]


def test_strength_and_direction_can_be_noisy() -> None:
    noise = {"strength_noise": 0.1, "direction_noise_rad": 0.05}
    bench = Bench(change={"kits": {"v2": {"devices": {"ball receiver": noise}}}})
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.12, 0.16)
    bench.sense(ticks=500)
    packets = bench.heard("Y1", "ball receiver")
    true, ahead = 1 / (0.2**2 + 0.0166**2), math.atan2(0.16, 0.12)
    strength = math.sqrt(sum((packet.strength / true - 1) ** 2 for packet in packets) / 500)
    turns = [math.atan2(packet.direction[1], packet.direction[0]) - ahead for packet in packets]
    assert strength == pytest.approx(0.1, rel=0.15)
    assert math.sqrt(sum(turn**2 for turn in turns) / 500) == pytest.approx(0.05, rel=0.15)
    assert all(math.hypot(*packet.direction) == pytest.approx(1) for packet in packets)


@pytest.mark.parametrize("noise", ["strength_noise", "direction_noise_rad"])
def test_either_noise_comes_without_the_other(noise: str) -> None:
    bench = Bench(change={"kits": {"v2": {"devices": {"ball receiver": {noise: 0.1}}}}})
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.2, 0)
    bench.sense(ticks=20)
    packets = bench.heard("Y1", "ball receiver")
    assert len({packet.strength for packet in packets}) == (20 if noise == "strength_noise" else 1)
    assert len({packet.direction for packet in packets}) == (20 if noise == "direction_noise_rad" else 1)


def test_each_of_several_balls_has_its_own_noise() -> None:
    noise = {"strength_noise": 0.1, "direction_noise_rad": 0.05}
    change = {"kits": {"v2": {"devices": {"ball receiver": noise}}}, "balls": {"second": {"start_m": [0.2, 0.2]}}}
    bench = Bench(change=change)
    bench.enable("Y1", "ball receiver")
    bench.place("Y1", 0, 0)
    bench.place("ball", 0.2, 0)
    bench.place("second", 0, 0.2)
    bench.sense(ticks=500)
    packets = bench.heard("Y1", "ball receiver")
    ahead = [(packet.strength, math.atan2(packet.direction[1], packet.direction[0])) for packet in packets[::2]]
    left = [(packet.strength, math.atan2(-packet.direction[0], packet.direction[1])) for packet in packets[1::2]]
    strengths, turns = ([error[part] for error in ahead] for part in (0, 1))
    others, other_turns = ([error[part] for error in left] for part in (0, 1))
    series = (strengths, turns, others, other_turns)
    assert all(abs(statistics.correlation(one, other)) < 0.2 for one, other in combinations(series, 2))
    assert statistics.pstdev(other_turns) == pytest.approx(0.05, rel=0.15)
