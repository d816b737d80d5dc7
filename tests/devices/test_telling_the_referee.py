"""Robots that tell the referee something: on its channel, as fast as the radio is, and no robot hears it."""

from __future__ import annotations

import pytest

from rcj_challenges.core.traffic import RobotSpec
from rcj_challenges.devices.team_emitter import BACKLOG_BYTES, BACKLOG_PACKETS, Emitter
from tests.devices.device_bench import Bench

LISTENS = {
    "rules": {
        "told": {
            "triggers": [{"trigger": "tells", "entity": "robots"}],
            "actions": [{"action": "emit", "event": "TOLD"}],
        }
    }
}
ROBOTS = ("B1", "B2", "B3", "Y1", "Y2", "Y3")


@pytest.fixture
def bench() -> Bench:
    bench = Bench(change=LISTENS)
    for index, robot in enumerate(ROBOTS):
        bench.place(robot, -0.5 + 0.2 * index, 0)
        bench.enable(robot, "team receiver", "supervisor receiver")
    return bench


def received(bench: Bench) -> dict[str, str]:
    """Let a tick pass; return what the referee hears at its judgement."""
    heard = bench.devices.messages_to_referee(bench.tick + 1)
    bench.sense()
    return {ROBOTS[robot]: text for robot, text in heard}


def emitter_of(spec: RobotSpec) -> dict[str, object]:
    return next(device.facts for device in spec.devices if device.kind == "emitter")


def test_9_4_referee_receives_a_message_in_the_tick_after_it_was_sent(bench: Bench) -> None:
    bench.send("Y1", b"FOUND", channel=1)
    assert received(bench) == {"Y1": "FOUND"}
    assert received(bench) == {}


def test_robots_and_referee_do_not_receive_messages_for_each_other(bench: Bench) -> None:
    bench.send("Y1", b"FOUND", channel=1)
    bench.send("Y2", b"hello")
    assert received(bench) == {"Y1": "FOUND"}
    heard = {robot: bench.devices.observe(bench.roster.index[robot], bench.tick).packets for robot in ROBOTS}
    teams = {
        robot: [p.data for p in heard[robot] if p.device == bench.device(robot, "team receiver")] for robot in ROBOTS
    }
    assert teams == {robot: [b"hello"] if robot in {"Y1", "Y3"} else [] for robot in ROBOTS}
    assert {p.data for packets in heard.values() for p in packets} == {b"hello", b"\0"}  # the team's and the referee's


def test_referee_receives_one_message_per_robot_and_tick_in_the_order_sent(bench: Bench) -> None:
    bench.send("B2", b"1", b"2", channel=1)
    bench.send("Y3", b"3", channel=1)
    assert [received(bench) for _ in range(3)] == [{"B2": "1", "Y3": "3"}, {"B2": "2"}, {}]


def test_messages_of_a_robot_off_the_field_or_silenced_are_not_received(bench: Bench) -> None:
    bench.send("Y1", b"a", b"b", channel=1)
    bench.send("Y2", b"a", b"b", channel=1)
    assert received(bench) == {"Y1": "a", "Y2": "a"}
    bench.park("Y1")
    bench.devices.silence(ROBOTS.index("Y2"))
    bench.sense()
    assert received(bench) == {}
    bench.place("Y1", 0, 0)
    bench.sense()
    assert received(bench) == {}


def test_the_emitter_may_be_set_to_its_channel_only_where_a_rule_listens(bench: Bench) -> None:
    listening = emitter_of(bench.devices.specs[0])
    assert listening["referee_channels"] == [1]
    assert listening["refused_channels"] == [-1, 3]
    silent = Bench()
    facts = emitter_of(silent.devices.specs[0])
    assert "referee_channels" not in facts
    assert facts["refused_channels"] == [-1, 1, 3]
    silent.send("B1", b"FOUND", channel=1)
    assert silent.devices.messages_to_referee(1) == ()


def test_messages_waiting_for_the_referee_do_not_block_the_team_radio(bench: Bench) -> None:
    # It receives one message per robot and tick: a robot that sends more delays only its own.
    bench.send("Y1", *[b"x"] * (BACKLOG_PACKETS + 10), channel=1)
    bench.send("Y1", b"hello")
    bench.sense(ticks=(BACKLOG_PACKETS + 10) // 460 + 2)
    assert [p.data for p in bench.heard("Y2", "team receiver")] == [b"hello"]


def test_a_flood_of_messages_has_its_bounds_in_packets_and_in_bytes() -> None:
    emitter = Emitter(0, 1.0, baud=10**9, max_packet_bytes=BACKLOG_BYTES)
    for data in (b"x" * (BACKLOG_BYTES - 1), b"y", b"lost"):
        emitter.send_to_referee(data, 0)
    assert [len(emitter.messages_to_referee(99) or b"") for _ in range(3)] == [BACKLOG_BYTES - 1, 1, 0]
    for _ in range(BACKLOG_PACKETS + 1):
        emitter.send_to_referee(b"x", 99)
    assert sum(emitter.messages_to_referee(200) is not None for _ in range(BACKLOG_PACKETS + 1)) == BACKLOG_PACKETS
