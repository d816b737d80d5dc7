"""The loop of a half applies the CPU policy."""

import pytest

from rcj_challenges.core.play import Fault
from rcj_challenges.match.loop import TickLoop
from rcj_challenges.programs.cpu_policy import DEFAULT_SHARE, CpuPolicy, CpuShare
from tests.match.playing import StandIn, staged


class Noted(StandIn):
    """A program that notes whether it was to busy-wait."""

    def __init__(self, name, notes, ticks, fails_at=None, computes_at=None):
        super().__init__(ticks)
        self.name, self.notes = name, notes
        self.fails_at, self.computes_at = fails_at, computes_at
        self.steps, self.shares = 0, []

    def collect(self, if_long=None):
        if if_long is not None:
            if_long()
        self.steps += 1
        return Fault(self.name, "crash", 0, 1, "made up") if self.steps == self.fails_at else super().collect()

    def collect_soon(self):
        return None if self.steps == self.computes_at else self.collect()

    def release(self, observation):
        self.notes.append((self.name, observation.soon))

    def share_cpus(self, share):
        self.shares.append(share)

    def computed_s(self):
        return float(self.steps)


@pytest.fixture
def play(monkeypatch):
    """Return a function that plays some ticks under a policy and returns the programs and, by tick, which were to busy-wait."""

    def play(ticks, should_busy_wait=lambda *_: True, **asks):
        monkeypatch.setattr(CpuPolicy, "should_busy_wait", should_busy_wait)
        notes, by_tick = [], []

        def on_tick(*_):
            by_tick.append(notes.copy())
            notes.clear()

        half, stage = staged(ticks, lambda name: Noted(name, notes, *asks.get(name, (1,))))
        TickLoop(stage, half, on_tick, lambda _: None, lambda _: None).play()
        return [*stage.drivers.values()], by_tick[1:]

    return play


def awake(ticks):
    return [[name for name, is_awake in notes if is_awake] for notes in ticks]


def test_program_that_is_released_first_busy_waits(play):
    _, ticks = play(3)
    assert awake(ticks)[:2] == [["B1"], ["B1"]]
    assert [len(notes) for notes in ticks] == [6, 6, 0]


def test_first_of_the_programs_that_are_due_busy_waits(play):
    assert awake(play(5, B1=(2,))[1])[:4] == [["B2"], ["B1"], ["B2"], ["B1"]]


def test_failed_program_does_not_busy_wait(play):
    assert awake(play(4, B1=(1, 2))[1])[:3] == [["B1"], ["B2"], ["B2"]]


def test_no_program_busy_waits_if_the_policy_forbids_it(play):
    assert not any(awake(play(4, lambda *_: False)[1]))


def test_every_change_of_the_share_reaches_all_programs(play):
    room, apart = CpuShare(is_batch=True), CpuShare(is_batch=True, leaves_cpu=1)
    wanted = iter([DEFAULT_SHARE, DEFAULT_SHARE, room, room, apart, DEFAULT_SHARE, DEFAULT_SHARE, room, room])

    def should_busy_wait(policy, _):
        policy.share = next(wanted)
        return False

    (first, *others), _ = play(10, should_busy_wait, B1=(1, 5))
    assert first.shares == [room]  # it fails at its fifth step
    # When the half is over they all clean up at once, and the match has nothing to do.
    assert all(one.shares == [room, apart, DEFAULT_SHARE, room, DEFAULT_SHARE] for one in others)


def test_wait_for_a_program_that_computes_for_long_gives_all_programs_all_cpus(play):
    apart, room, notes = CpuShare(is_batch=True, leaves_cpu=1), CpuShare(is_batch=True), []

    def should_busy_wait(policy, _):
        policy.share = apart if not notes else policy.share
        notes.append(policy.share)
        return False

    programs, _ = play(5, should_busy_wait, Y2=(1, None, 2))
    assert notes == [apart, apart, room, room]
    assert all(one.shares == [apart, room, DEFAULT_SHARE] for one in programs)


def test_policy_reads_the_time_of_each_living_program(play):
    read = []
    play(4, lambda policy, _: read.append(policy._computed_s_now()), B1=(1, 3))
    assert read == [dict.fromkeys(range(6), 1.0), dict.fromkeys(range(6), 2.0), dict.fromkeys(range(1, 6), 3.0)]
