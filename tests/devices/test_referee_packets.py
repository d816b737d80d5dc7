"""What the referee tells programs: bytes, age and period, in all three versions (reference, 4.1 and 4.2)."""

from __future__ import annotations

import json
import struct
from typing import Any

import pytest

from rcj_challenges.core.play import RefereeOutput
from tests.devices.device_bench import BLANK, WAITING, Bench

RECEIVER = "supervisor receiver"


def received(bench: Bench, robot: str = "Y1", receiver: str = RECEIVER) -> list[bytes]:
    return [packet.data for packet in bench.heard(robot, receiver)]


def kit_2021(**settings: Any) -> dict[str, Any]:
    return {"kits": {"legacy_2021": settings}}


# --- v2 ---------------------------------------------------------------------------------------------------------------


def test_there_is_one_packet_a_tick_of_one_byte() -> None:
    bench = Bench()
    bench.enable("Y1", RECEIVER)
    bench.sense(ticks=3)
    assert received(bench) == [b"\x00"] * 3
    assert struct.unpack("?", b"\x00") == (False,)


def test_a_receiver_that_is_disabled_or_on_another_channel_does_not_receive_the_referee() -> None:
    bench = Bench()
    for robot in ("Y1", "Y2", "Y3"):
        bench.enable(robot, RECEIVER)
    bench.sense(ticks=3)
    bench.enable("Y1", RECEIVER, period=0)
    bench.tune("Y2", RECEIVER, 77)
    for robot in ("Y1", "Y2", "Y3"):
        received(bench, robot)
    bench.sense(ticks=3)
    assert [received(bench, robot) for robot in ("Y1", "Y2", "Y3")] == [[], [], [b"\x00"] * 3]
    bench.enable("Y1", RECEIVER, period=3)
    bench.sense(ticks=2)
    assert received(bench) == []
    bench.sense()
    assert received(bench) == [b"\x00"] * 3


def test_observation_k_has_the_phase_after_the_actions_of_tick_k_minus_1() -> None:
    bench = Bench()
    bench.enable("Y1", RECEIVER)
    bench.sense(WAITING)  # the goal's own tick
    assert received(bench) == [b"\x00"]
    bench.sense(BLANK)
    assert received(bench) == [b"\x01"]
    bench.sense(BLANK)
    assert received(bench) == [b"\x00"]


def test_the_first_packet_is_about_tick_0() -> None:
    bench = Bench()
    bench.devices.begin(WAITING)
    bench.enable("Y1", RECEIVER)
    bench.sense(BLANK)
    assert received(bench) == [b"\x01"]


def test_v2_2_sends_json_text() -> None:
    bench = Bench(change={"kits": {"v2": {"messages": "v2.2"}}})
    bench.enable("Y1", RECEIVER)
    bench.sense(WAITING)
    bench.sense(BLANK)
    assert received(bench) == [b'{"waiting_for_kickoff": false}', b'{"waiting_for_kickoff": true}']
    assert bench.devices.specs[bench.roster.index["Y1"]].getdata_returns == "text"


def test_a_declared_broadcast_follows_the_official_packet_as_json() -> None:
    bench = Bench()
    bench.enable("Y1", RECEIVER)
    bench.sense(RefereeOutput(broadcast={"target": "left", "score": 3, "gold": [0.1, None]}))
    bench.sense(BLANK)
    bench.sense(BLANK)
    first, official, broadcast, last = received(bench)
    assert (first, official, last) == (b"\x00", b"\x00", b"\x00")
    assert json.loads(broadcast) == {"target": "left", "score": 3, "gold": [0.1, None]}


def test_what_is_for_some_robots_only_stands_in_their_object_alone() -> None:
    bench = Bench()
    robots = ("Y1", "Y2", "Y3", "B1")
    for name in robots:
        bench.enable(name, RECEIVER)
    own = {bench.roster.index["Y1"]: {"way": "left"}, bench.roster.index["B1"]: {"way": "right", "more": 1}}
    bench.sense(RefereeOutput(broadcast={"score": 3}, private_broadcasts=own))
    bench.sense(BLANK)
    objects = [json.loads(packets[2]) for packets in (received(bench, name) for name in robots) if len(packets) == 3]
    assert objects == [
        {"score": 3, "way": "left"}, {"score": 3}, {"score": 3}, {"score": 3, "way": "right", "more": 1}
    ]  # fmt: skip


def test_an_empty_broadcast_is_not_sent() -> None:
    bench = Bench()
    for name in ("Y1", "Y2"):
        bench.enable(name, RECEIVER)
    bench.sense(RefereeOutput(broadcast={}, private_broadcasts={bench.roster.index["Y1"]: {"way": "left"}}))
    bench.sense(BLANK)
    bench.sense(BLANK)
    assert received(bench, "Y1") == [b"\x00", b"\x00", b'{"way": "left"}', b"\x00"]
    assert received(bench, "Y2") == [b"\x00"] * 3


def test_a_receiver_enabled_later_receives_its_private_broadcast() -> None:
    bench = Bench()
    secret = RefereeOutput(broadcast={}, private_broadcasts={bench.roster.index["Y1"]: {"way": "left"}})
    bench.enable("Y2", RECEIVER)
    bench.sense(secret, ticks=3)
    bench.enable("Y1", RECEIVER)
    bench.sense(secret)
    assert received(bench, "Y1") == [b"\x00", b'{"way": "left"}']


def test_robots_off_the_field_receive_the_referee_too() -> None:
    bench = Bench()
    for name in ("B1", "Y3"):
        bench.enable(name, RECEIVER)
    bench.place("B1", 0, 0)  # Y3 stays parked
    bench.sense()
    assert received(bench, "B1") == received(bench, "Y3") == [b"\x00"]


# --- 2021 -------------------------------------------------------------------------------------------------------------


def test_the_worked_example_of_2021() -> None:
    bench = Bench("soccersim_2021", kit_2021(packet_lists=["Y3"]))
    bench.place("Y3", -0.3, 0.2, 0.5)
    bench.place("ball", 0.1, -0.2)
    bench.enable("Y3", "receiver", period=2)
    bench.sense(ticks=4)
    (data,) = received(bench, "Y3", "receiver")
    assert len(data) == 41
    assert struct.unpack("ddddd?", data) == pytest.approx((0.2, -0.3, 0.5, -0.2, 0.1, False))


@pytest.mark.parametrize(("yaw", "orientation"), [(1.57, 1.57), (-1.57, -1.57), (0, 0), (3, 3), (4, 4 - 6.283185307)])
def test_orientation_is_the_yaw_blue_goal_is_plus_1_57(yaw: float, orientation: float) -> None:
    bench = Bench("soccersim_2021", kit_2021(packet_lists=["Y3"]))
    bench.place("Y3", 0, 0, yaw)
    bench.enable("Y3", "receiver")
    bench.sense(ticks=3)
    assert struct.unpack("ddd", received(bench, "Y3", "receiver")[0][:24])[2] == pytest.approx(orientation, abs=1e-6)


@pytest.mark.parametrize(
    ("settings", "length"),
    [
        ({}, 161),
        ({"packet_has_flag": False}, 160),
        ({"packet_lists": ["Y3"]}, 41),
        ({"packet_lists": ["B1", "B2", "Y1", "Y2"]}, 113),
        ({"packet_lists": []}, 17),
    ],
)
def test_every_length_of_the_2021_packet(settings: dict[str, Any], length: int) -> None:
    bench = Bench("soccersim_2021", kit_2021(**settings))
    bench.enable("Y3", "receiver")
    bench.sense(ticks=3)
    assert [len(data) for data in received(bench, "Y3", "receiver")] == [length]


def test_the_order_of_a_2021_match_is_blue_yellow_ball() -> None:
    bench = Bench("soccersim_2021")
    for index, name in enumerate(bench.roster.entities):
        bench.place(name, -0.5 + 0.15 * index, 0.1 * index)
    bench.enable("B1", "receiver")
    bench.sense(ticks=3)
    numbers = struct.unpack("ddd" * 6 + "dd?", received(bench, "B1", "receiver")[0])
    assert numbers[0::3][:6] == pytest.approx([0.1 * index for index in range(6)])
    assert numbers[18:20] == pytest.approx((0.6, 0.4))


def test_the_first_64_ms_step_of_2021_finds_an_empty_queue_and_then_one_packet_each() -> None:
    bench = Bench("soccersim_2021")
    bench.enable("Y1", "receiver", period=2)
    counts = []
    for _ in range(5):
        bench.sense(ticks=2)
        counts.append(len(received(bench, "Y1", "receiver")))
    assert counts == [0, 1, 1, 1, 1]


def test_a_2021_packet_is_one_control_step_old() -> None:
    bench = Bench("soccersim_2021", kit_2021(packet_lists=["Y1"]))
    bench.enable("Y1", "receiver", period=2)
    seen = []
    for tick in range(1, 9):
        bench.place("Y1", 0, tick / 100)
        bench.sense()
        if tick % 2 == 0:
            seen.append([struct.unpack("d", data[:8])[0] for data in received(bench, "Y1", "receiver")])
    assert seen == [[], [pytest.approx(0.02)], [pytest.approx(0.04)], [pytest.approx(0.06)]]


def test_the_flag_of_2021_is_of_the_same_tick_as_the_positions() -> None:
    bench = Bench("soccersim_2021", kit_2021(packet_lists=[]))
    bench.enable("Y1", "receiver", period=2)
    bench.sense(ticks=3)
    bench.sense(WAITING)
    bench.sense(BLANK, ticks=2)
    assert [data[-1] for data in received(bench, "Y1", "receiver")] == [0, 1]


def test_a_broadcast_of_2021_waits_for_the_next_official_packet() -> None:
    bench = Bench("soccersim_2021", kit_2021(packet_lists=[]))
    bench.enable("Y1", "receiver")
    bench.sense(RefereeOutput(broadcast={"round": 1}))
    bench.sense(BLANK, ticks=2)
    official, broadcast = received(bench, "Y1", "receiver")
    assert len(official) == 17
    assert json.loads(broadcast) == {"round": 1}


def test_several_balls_stand_in_the_packet_in_their_order() -> None:
    bench = Bench("soccersim_2021", {**kit_2021(packet_lists=[]), "balls": {"second": {}}})
    bench.place("ball", 0.1, 0.2)
    bench.place("second", 0.3, 0.4)
    bench.enable("Y1", "receiver")
    bench.sense(ticks=3)
    assert struct.unpack("dddd?", received(bench, "Y1", "receiver")[0]) == pytest.approx((0.2, 0.1, 0.4, 0.3, False))


def test_robots_of_different_kits_get_their_own_packets() -> None:
    legacy = {
        "legacy_2021": {
            "messages": "2021",
            "packet_every_ticks": 2,
            "devices": {"receiver": {"device": "supervisor_receiver", "channel": 0}},
        }
    }
    bench = Bench(change={"kits": legacy, "robots": {"B1": {"kit": "legacy_2021"}}})
    bench.enable("B1", "receiver")
    bench.enable("Y1", RECEIVER)
    bench.sense(ticks=3)
    assert [len(data) for data in received(bench, "B1", "receiver")] == [17]
    assert [len(data) for data in received(bench)] == [1, 1, 1]
