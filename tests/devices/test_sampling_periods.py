"""When values are ready: ``enable`` and ``step`` (reference, section 3)."""

from __future__ import annotations

import math

import pytest

from rcj_challenges.core.traffic import Request
from rcj_challenges.robots.sensors import Schedule
from tests.devices.device_bench import Bench

NUMBERS = ("left wheel sensor", "gps", "compass", "distancesensor left")


@pytest.mark.parametrize("device", NUMBERS)
def test_numbers_are_nan_before_the_first_sample_and_after_disable(device: str) -> None:
    bench = Bench()
    bench.sense()
    assert all(map(math.isnan, bench.read("Y1", device)))
    bench.enable("Y1", device)
    bench.sense()
    bench.enable("Y1", device, period=0)
    bench.sense()
    assert all(map(math.isnan, bench.read("Y1", device)))


def test_enable_64_with_steps_of_32_is_ready_after_the_second_and_then_held() -> None:
    bench = Bench()
    bench.enable("Y1", "gps", period=2)
    seen = []
    for tick in range(1, 7):
        bench.place("Y1", tick / 100, 0)
        bench.sense()
        seen.append(bench.read("Y1", "gps")[0])
    assert math.isnan(seen[0])
    assert seen[1:] == pytest.approx([0.02, 0.02, 0.04, 0.04, 0.06])


def test_periods_count_from_when_the_device_was_enabled() -> None:
    bench = Bench()
    bench.sense(ticks=3)
    bench.enable("Y1", "gps", period=3)
    ready = []
    for _ in range(4):
        bench.sense()
        ready.append(not math.isnan(bench.read("Y1", "gps")[0]))
    assert ready == [False, False, True, True]


def test_enabling_again_with_the_same_period_does_not_put_the_sample_off() -> None:
    bench = Bench()
    for _ in range(4):
        bench.enable("Y1", "gps", period=2)
        bench.sense()
    assert not math.isnan(bench.read("Y1", "gps")[0])


def test_a_receiver_delivers_at_its_period_all_that_arrived_meanwhile() -> None:
    bench = Bench()
    bench.enable("Y1", "supervisor receiver", period=3)
    counts = []
    for _ in range(6):
        bench.sense()
        counts.append(len(bench.heard("Y1", "supervisor receiver")))
    assert counts == [0, 0, 3, 0, 0, 3]


def test_what_a_receiver_held_back_is_gone_when_it_is_disabled() -> None:
    bench = Bench()
    bench.enable("Y1", "supervisor receiver", period=5)
    bench.sense(ticks=2)
    bench.enable("Y1", "supervisor receiver", period=0)
    bench.sense(ticks=10)
    assert bench.heard("Y1", "supervisor receiver") == []
    bench.enable("Y1", "supervisor receiver")
    bench.sense()
    assert len(bench.heard("Y1", "supervisor receiver")) == 1


def test_a_slow_receiver_of_a_program_that_never_samples_is_bounded() -> None:
    bench = Bench()
    bench.enable("Y1", "supervisor receiver", period=10**9)
    bench.sense(ticks=18_000)
    receiver = bench.devices._radio._receivers[bench.roster.index["Y1"], bench.device("Y1", "supervisor receiver")]
    assert len(receiver._held.take()) <= 16_384 + 32


def test_observations_do_not_change_afterwards() -> None:
    bench = Bench()
    bench.enable("Y1", "gps")
    bench.sense()
    robot = bench.roster.index["Y1"]
    first = bench.devices.observe(robot, bench.tick)
    values, packets = list(first.values), list(first.packets)
    bench.place("Y1", 0.4, 0.4)
    bench.sense()
    assert (first.values, first.packets) == (values, packets)
    assert bench.devices.observe(robot, bench.tick, over=True).over


def test_a_request_for_devices_that_are_not_there_changes_nothing() -> None:
    bench = Bench()
    robot = bench.roster.index["Y1"]
    motor = bench.device("Y1", "left wheel motor")
    request = Request(
        1,
        sampling=((99, 1), (motor, 1)),
        channels=((99, 5), (motor, 5)),
        emissions=((99, 3, b"x"), (motor, 3, b"x")),
        frequencies=((99, 5.0), (bench.device("Y1", "gps"), 5.0)),
    )
    bench.devices.apply(robot, request)
    bench.sense()
    observation = bench.devices.observe(robot, 1)
    assert all(map(math.isnan, observation.values))
    assert observation.packets == []


def test_a_dead_program_costs_no_more_sampling() -> None:
    bench = Bench()
    bench.enable("Y1", *NUMBERS, "supervisor receiver")
    bench.devices.silence(bench.roster.index["Y1"])
    bench.enable("Y1", *NUMBERS)
    bench.sense(ticks=5)
    assert not bench.devices._sensors[bench.roster.index["Y1"]]._due
    assert bench.heard("Y1", "supervisor receiver") == []


def test_a_schedule_mixes_members_that_are_always_due_with_those_that_are_seldom() -> None:
    schedule = Schedule()
    schedule.set(3, 1, now=0)
    schedule.set(1, 2, now=0)
    schedule.set(2, 3, now=0)
    assert [list(schedule.due(tick)) for tick in range(1, 7)] == [[3], [1, 3], [2, 3], [1, 3], [3], [1, 2, 3]]
    schedule.set(3, 0, now=6)
    assert list(schedule.enabled()) == [1, 2]


def test_what_a_receiver_has_held_back_is_delivered_first_when_its_period_becomes_a_tick() -> None:
    bench = Bench()
    for robot, x in (("Y1", 0.0), ("Y2", 0.4)):
        bench.place(robot, x, 0)
    bench.enable("Y1", "team receiver", period=3)
    for data in (b"first", b"second"):
        bench.send("Y2", data)
        bench.sense()
    assert bench.heard("Y1", "team receiver") == []
    bench.enable("Y1", "team receiver")
    bench.send("Y2", b"third")
    bench.sense()
    assert [packet.data for packet in bench.heard("Y1", "team receiver")] == [b"first", b"second", b"third"]
