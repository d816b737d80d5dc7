"""The loop of a half applies the CPU policy."""

from dataclasses import replace

import pytest

from rcj_challenges.controllers.cpu_policy import DEFAULT_SHARE, CpuPolicy, CpuShare
from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import Request
from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.match.loop import TickLoop
from rcj_challenges.match.stage import build_stage
from rcj_challenges.scenario.load import load


class Noted:
    """A program that asks for steps of so many ticks; notes whether it was to busy-wait."""

    def __init__(self, name, notes, ticks, fails_at=None, computes_at=None):
        self.name, self.ticks, self.notes = name, ticks, notes
        self.fails_at, self.computes_at = fails_at, computes_at
        self.steps, self.shares = 0, []

    def collect(self, if_long=None):
        if if_long is not None:
            if_long()
        self.steps += 1
        return Fault(self.name, "crash", 0, 1, "made up") if self.steps == self.fails_at else Request(self.ticks)

    def collect_soon(self):
        return None if self.steps == self.computes_at else self.collect()

    def release(self, observation):
        self.notes.append((self.name, observation.soon))

    def share_cpus(self, share):
        self.shares.append(share)

    def computed_s(self):
        return float(self.steps)

    def overstepped(self, tick):
        return None


@pytest.fixture
def stage():
    """Return what sets up a half of some ticks with six of them: the half, the stage, and what they noted."""

    def set_up(ticks, **asks):
        loaded = load("match")
        half = replace(half_of(loaded.scenario), ticks=ticks)
        notes = []
        names = loaded.roster.entities[: loaded.roster.robots]
        drivers = {index: Noted(name, notes, *asks.get(name, (1,))) for index, name in enumerate(names)}
        return half, build_stage(loaded.scenario, loaded.roster, half, drivers), notes

    return set_up


@pytest.fixture
def told(monkeypatch, stage):
    """Return what plays some ticks: by tick, who was released, and whether it was told to stay awake."""

    def play(ticks, *, soon=True, **asks):
        monkeypatch.setattr(CpuPolicy, "should_busy_wait", lambda *_: soon)
        half, set_up, notes = stage(ticks, **asks)
        by_tick = []

        def on_tick(*_):
            by_tick.append(notes.copy())
            notes.clear()

        TickLoop(set_up, half, on_tick, lambda _: None, lambda _: None).play()
        return by_tick[1:]

    return play


def awake(ticks):
    return [[name for name, is_awake in notes if is_awake] for notes in ticks]


def test_program_that_is_released_first_busy_waits(told):
    ticks = told(3)
    assert awake(ticks)[:2] == [["B1"], ["B1"]]
    assert [len(notes) for notes in ticks] == [6, 6, 0]


def test_first_of_the_programs_that_are_due_busy_waits(told):
    assert awake(told(5, B1=(2,)))[:4] == [["B2"], ["B1"], ["B2"], ["B1"]]


def test_failed_program_does_not_busy_wait(told):
    assert awake(told(4, B1=(1, 2)))[:3] == [["B1"], ["B2"], ["B2"]]


def test_no_program_busy_waits_if_the_policy_says_so(told):
    assert not any(awake(told(4, soon=False)))


def test_every_change_of_the_share_reaches_all_programs(monkeypatch, stage):
    room, apart = CpuShare(is_batch=True), CpuShare(is_batch=True, leaves_cpu=1)
    wanted = iter([DEFAULT_SHARE, DEFAULT_SHARE, room, room, apart, DEFAULT_SHARE, DEFAULT_SHARE, room, room])

    def should_busy_wait(policy, _):
        policy.share = next(wanted)
        return False

    monkeypatch.setattr(CpuPolicy, "should_busy_wait", should_busy_wait)
    half, set_up, _ = stage(10, B1=(1, 5))
    TickLoop(set_up, half, lambda *_: None, lambda _: None, lambda _: None).play()
    first, *others = set_up.drivers.values()
    assert first.shares == [room]  # it fails at its fifth step
    # When the half is over they all clean up at once, and the match has nothing to do.
    assert all(one.shares == [room, apart, DEFAULT_SHARE, room, DEFAULT_SHARE] for one in others)


def test_wait_for_a_program_that_computes_for_long_gives_all_programs_all_cpus(monkeypatch, stage):
    apart, room, notes = CpuShare(is_batch=True, leaves_cpu=1), CpuShare(is_batch=True), []

    def should_busy_wait(policy, _):
        policy.share = apart if not notes else policy.share
        notes.append(policy.share)
        return False

    monkeypatch.setattr(CpuPolicy, "should_busy_wait", should_busy_wait)
    half, set_up, _ = stage(5, Y2=(1, None, 2))
    TickLoop(set_up, half, lambda *_: None, lambda _: None, lambda _: None).play()
    assert notes == [apart, apart, room, room]
    assert all(one.shares == [apart, room, DEFAULT_SHARE] for one in set_up.drivers.values())


def test_policy_reads_the_time_of_each_living_program(monkeypatch, stage):
    told = []
    monkeypatch.setattr(CpuPolicy, "should_busy_wait", lambda policy, _: told.append(policy._computed_s_now()))
    half, set_up, _ = stage(4, B1=(1, 3))
    TickLoop(set_up, half, lambda *_: None, lambda _: None, lambda _: None).play()
    assert told == [dict.fromkeys(range(6), 1.0), dict.fromkeys(range(6), 2.0), dict.fromkeys(range(1, 6), 3.0)]
