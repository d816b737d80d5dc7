"""Team radio: delay, speed, order, channels (reference 4.1; tick contract, lines 8 and 9)."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.devices.team_emitter import BACKLOG_PACKETS, Emitter
from tests.devices.device_bench import Bench

BLUE, YELLOW = ("B1", "B2", "B3"), ("Y1", "Y2", "Y3")


@pytest.fixture
def bench() -> Bench:
    bench = Bench()
    for index, robot in enumerate((*BLUE, *YELLOW)):
        bench.place(robot, -0.5 + 0.2 * index, 0, 0)
        bench.enable(robot, "team receiver")
    return bench


def heard(bench: Bench, robot: str) -> list[bytes]:
    return [packet.data for packet in bench.heard(robot, "team receiver")]


def test_what_is_sent_on_observation_k_is_in_observation_k_plus_1(bench: Bench) -> None:
    bench.sense(ticks=5)
    bench.send("Y1", b"hello")
    assert heard(bench, "Y2") == []
    bench.sense()
    assert heard(bench, "Y2") == [b"hello"]
    bench.sense()
    assert heard(bench, "Y2") == []


def test_all_team_mates_receive_a_message_but_not_the_sender_or_the_other_team(bench: Bench) -> None:
    bench.send("Y2", b"pass")
    bench.sense()
    assert {robot: heard(bench, robot) for robot in (*BLUE, *YELLOW)} == {
        "B1": [], "B2": [], "B3": [], "Y1": [b"pass"], "Y2": [], "Y3": [b"pass"],
    }  # fmt: skip


def test_packets_of_one_tick_arrive_in_the_order_of_robots_and_of_sending(bench: Bench) -> None:
    bench.send("Y3", b"3a", b"3b")
    bench.send("Y1", b"1a", b"1b")
    bench.sense()
    assert heard(bench, "Y2") == [b"1a", b"1b", b"3a", b"3b"]


def test_460_bytes_fit_into_a_tick_and_461_do_not(bench: Bench) -> None:
    bench.send("Y1", bytes(460))
    bench.send("Y3", bytes(461))
    bench.sense()
    assert [len(data) for data in heard(bench, "Y2")] == [460]
    bench.sense()
    assert [len(data) for data in heard(bench, "Y2")] == [461]


def test_of_many_tiny_packets_32_arrive_a_tick_and_the_others_after_them(bench: Bench) -> None:
    sent = [bytes([number]) for number in range(70)]
    bench.send("Y1", *sent)
    bench.send("Y3", b"also")
    arrived = []
    for most in (33, 32, 6, 0):
        bench.sense()
        packets = heard(bench, "Y2")
        assert len(packets) == most
        arrived += packets
    assert [packet for packet in arrived if packet != b"also"] == sent


def test_a_longer_packet_arrives_later_and_holds_up_those_behind_it(bench: Bench) -> None:
    bench.send("Y1", bytes(1000), b"after")  # 1000 / 460.8 = 2.17 ticks
    arrived = []
    for _ in range(4):
        bench.sense()
        arrived.append([len(data) for data in heard(bench, "Y2")])
    assert arrived == [[], [], [1000, 5], []]


def test_a_stream_above_the_limit_lags_more_and_more(bench: Bench) -> None:
    for _ in range(100):
        bench.send("Y1", bytes(512))
        bench.sense()
    assert len(heard(bench, "Y2")) == 90  # 100 · 460.8 / 512


def test_strength_and_direction_are_those_of_the_sender(bench: Bench) -> None:
    bench.place("Y1", 0.3, 0.4, 0)
    bench.place("Y2", 0, 0, math.pi / 2)
    bench.send("Y1", b"here")
    bench.sense()
    (packet,) = bench.heard("Y2", "team receiver")
    assert packet.strength == pytest.approx(4)
    assert packet.direction == pytest.approx((0.8, -0.6, 0))


def test_nothing_hides_a_radio(bench: Bench) -> None:
    bench.send("Y3", b"through the others")
    bench.sense()
    assert heard(bench, "Y1") == [b"through the others"]


@pytest.mark.parametrize(
    ("emitter_m", "receiver_m"), [(0.5, 10.0), (10.0, 0.5)], ids=["of the emitter", "of the receiver"]
)
def test_a_message_is_not_received_beyond_the_shorter_range(emitter_m: float, receiver_m: float) -> None:
    devices = {"team emitter": {"range_m": emitter_m}, "team receiver": {"range_m": receiver_m}}
    bench = Bench(change={"kits": {"v2": {"devices": devices}}})
    for robot, x in (("Y1", 0.0), ("Y2", 0.45), ("Y3", -0.55)):
        bench.place(robot, x, 0)
        bench.enable(robot, "team receiver")
    bench.send("Y1", b"near")
    bench.sense()
    assert (heard(bench, "Y2"), heard(bench, "Y3")) == ([b"near"], [])


def test_blue_has_channel_2_and_yellow_3() -> None:
    specs = Bench().devices.specs
    channels = {
        spec.name: {d.facts["channel"] for d in spec.devices if d.name.startswith("team")} for spec in specs.values()
    }
    assert channels == {name: {2 if name in BLUE else 3} for name in (*BLUE, *YELLOW)}


def test_the_other_teams_channel_is_refused(bench: Bench) -> None:
    bench.tune("B1", "team receiver", 3)
    bench.send("Y1", b"secret")
    bench.send("B2", b"to yellow", channel=3)
    bench.send("B2", b"still blue")
    bench.sense()
    assert heard(bench, "B1") == [b"still blue"]
    assert heard(bench, "Y2") == [b"secret"]


@pytest.mark.parametrize("channel", [1, -1])
def test_no_emitter_can_speak_in_the_referees_place(bench: Bench, channel: int) -> None:
    bench.enable("Y2", "supervisor receiver")
    bench.send("Y1", b"\x01", channel=channel)
    bench.sense()
    assert [packet.data for packet in bench.heard("Y2", "supervisor receiver")] == [b"\x00"]


def test_a_team_may_use_a_free_channel_and_even_there_is_among_itself(bench: Bench) -> None:
    for robot in ("Y1", "Y2", "B1"):
        bench.tune(robot, "team receiver", 77)
    bench.send("Y3", b"private", channel=77)
    bench.sense()
    assert (heard(bench, "Y1"), heard(bench, "Y2"), heard(bench, "B1")) == ([b"private"], [b"private"], [])


def test_robots_of_both_colours_are_one_team_if_one_entrant_drives_them() -> None:
    robots = dict.fromkeys(("Y1", "Y2", "B1", "B2"), "play.py")
    bench = Bench(change={"entrants": {"blue": None, "yellow": None, "passers": {"robots": robots}}})
    assert [spec.name for spec in bench.devices.specs.values()] == ["B1", "B2", "Y1", "Y2"]
    for name in robots:
        bench.place(name, 0.1 * len(name), 0)
    bench.place("B1", -0.3, 0)
    bench.enable("B1", "team receiver")
    bench.send("Y1", b"to you")
    bench.sense()
    assert heard(bench, "B1") == [b"to you"]


def test_two_entrants_never_share_a_channel() -> None:
    bench = Bench(change={"entrants": {"blue": {"radio_channel": 5}, "yellow": {"radio_channel": 5}}})
    channels = {
        d.facts["channel"] for spec in bench.devices.specs.values() for d in spec.devices if d.name == "team receiver"
    }
    assert channels == {5, 6}


def test_a_team_never_has_the_referees_channel() -> None:
    specs = Bench(change={"entrants": {"blue": {"radio_channel": 1}}}).devices.specs
    assert next(d.facts["channel"] for d in specs[0].devices if d.name == "team emitter") == 2


def test_a_receiver_on_all_channels_receives_its_team_and_the_referee_on_all(bench: Bench) -> None:
    bench.tune("Y2", "team receiver", -1)
    bench.send("Y1", b"nine", channel=9)
    bench.send("Y3", b"three")
    bench.send("B1", b"blue")
    bench.sense()
    assert heard(bench, "Y2") == [b"\x00", b"nine", b"three"]


def test_each_packet_of_a_tick_goes_out_on_the_channel_on_which_it_was_sent(bench: Bench) -> None:
    emitter = bench.device("Y1", "team emitter")
    bench.tune("Y2", "team receiver", 12)
    bench.tune("Y3", "team receiver", 13)
    bench.ask("Y1", emissions=((emitter, 12, b"to Y2"), (emitter, 13, b"to Y3"), (emitter, 12, b"and more")))
    bench.sense()
    assert (heard(bench, "Y2"), heard(bench, "Y3")) == ([b"to Y2", b"and more"], [b"to Y3"])


def test_a_removed_robot_is_silent_and_deaf_on_team_radio(bench: Bench) -> None:
    bench.park("Y1")
    bench.sense()
    bench.send("Y1", b"from outside")
    bench.send("Y3", b"to the field")
    bench.sense()
    assert (heard(bench, "Y1"), heard(bench, "Y2")) == ([], [b"to the field"])


def test_what_a_robot_had_not_sent_when_it_was_removed_is_lost(bench: Bench) -> None:
    bench.send("Y1", bytes(900))
    bench.sense()
    bench.park("Y1")
    bench.sense()
    bench.place("Y1", 0.3, 0.3)
    bench.sense(ticks=5)
    assert heard(bench, "Y2") == []


def test_a_dead_program_sends_nothing_more(bench: Bench) -> None:
    bench.send("Y1", b"last words")
    bench.devices.silence(bench.roster.index["Y1"])
    bench.send("Y1", b"from beyond")
    bench.sense(ticks=3)
    assert heard(bench, "Y2") == []


@given(st.lists(st.lists(st.integers(1, 1500), max_size=4), min_size=1, max_size=12))
def test_no_emitter_ever_sends_faster_than_its_baud_and_none_is_lost_or_overtaken(sizes: list[list[int]]) -> None:
    emitter = Emitter(0, 10.0, 115_200, 1_000_000)
    sent, arrived, number = [], [], 0
    for tick, packets in enumerate([*sizes, *([[]] * 60)]):
        arrived += [(tick, data) for _, data in emitter.arriving(tick)]
        for size in packets:
            data = number.to_bytes(2, "big").rjust(max(size, 2), b"\0")
            emitter.send(2, data, tick)
            sent.append(data)
            number += 1
    assert [data for _, data in arrived] == sent[: len(arrived)]
    for begin in range(len(sizes)):
        for end in range(begin + 1, len(sizes) + 60):
            within = sum(len(data) for tick, data in arrived if begin < tick <= end)
            # A packet whose end arrives in the window may have begun before it.
            assert within <= 460.8 * (end - begin) + 1500
    if sum(map(sum, sizes)) + 2 * number < 460 * 60:
        assert len(arrived) == len(sent)


def test_a_packet_that_is_empty_or_too_large_is_not_sent() -> None:
    emitter = Emitter(0, 10.0, 115_200, 100)
    emitter.send(2, b"", 0)
    emitter.send(2, bytes(101), 0)
    emitter.send(2, bytes(100), 0)
    assert emitter.arriving(1) == [(2, bytes(100))]


def test_millions_of_packets_do_not_fill_the_memory() -> None:
    emitter = Emitter(0, 10.0, 115_200, 100)
    for _ in range(BACKLOG_PACKETS + 100):
        emitter.send(2, b"spam", 0)
    assert len(emitter.waiting) == BACKLOG_PACKETS
