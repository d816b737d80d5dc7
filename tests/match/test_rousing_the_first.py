"""The program that is released first is roused before it is judged and sensed what it will be told."""

from dataclasses import replace

import pytest

from rcj_challenges.facts.play import Fault
from rcj_challenges.facts.traffic import Request
from rcj_challenges.match.half import HalfPlay
from rcj_challenges.match.stage import build_stage
from rcj_challenges.referee.script import half_of
from rcj_challenges.scenario.load import load


class Noted:
    """A program of which it is noted what it is told; it asks for steps of so many ticks, and may fail."""

    def __init__(self, name, ticks, notes, fails_at=None):
        self.name, self.ticks, self.notes, self.fails_at = name, ticks, notes, fails_at
        self.steps = 0

    def collect(self):
        self.steps += 1
        return Fault(self.name, "crash", 0, 1, "made up") if self.steps == self.fails_at else Request(self.ticks)

    collect_soon = collect

    def rouse(self):
        self.notes.append((self.name, "roused"))

    def release(self, observation):
        self.notes.append((self.name, "released"))

    def overstepped(self, tick):
        return None


@pytest.fixture
def told():
    """Return what plays some ticks with six programs: by tick, who was roused or released, in order."""

    def play(ticks, **asks):
        loaded = load("match")
        half = replace(half_of(loaded.scenario), ticks=ticks)
        names = loaded.roster.entities[: loaded.roster.robots]
        notes, by_tick = [], []

        def on_tick(*_):
            by_tick.append(notes.copy())
            notes.clear()

        drivers = {index: Noted(name, *asks.get(name, (1, None))[:1], notes, asks.get(name, (1, None))[1])
                   for index, name in enumerate(names)}  # fmt: skip
        stage = build_stage(loaded.scenario, loaded.roster, half, drivers)
        HalfPlay(stage, half, on_tick, lambda _: None, lambda _: None).play()
        return by_tick[1:]

    return play


def roused(notes):
    return [name for name, what in notes if what == "roused"]


def test_one_in_each_tick_and_before_all_that_are_released(told):
    *ticks, last = told(4)
    for notes in ticks:
        first = next(name for name, what in notes if what == "released")
        assert notes[0] == (first, "roused")
        assert roused(notes) == [first]
        assert len(notes) == 7
    assert len(roused(last)) == 1  # and then the half is over: its end is what it will be told


def test_one_that_is_not_due_sleeps_on(told):
    ticks = told(7, B1=(3, None))
    firsts = [roused(notes) for notes in ticks]
    assert firsts == [["B2"], ["B2"], ["B1"], ["B2"], ["B2"], ["B1"], ["B2"]]


def test_nobody_is_roused_where_nobody_is_due(told):
    names = ("B1", "B2", "B3", "Y1", "Y2", "Y3")
    ticks = told(4, **dict.fromkeys(names, (2, None)))
    assert [bool(roused(notes)) for notes in ticks] == [False, True, False, True]


def test_one_that_has_failed_is_left_alone(told):
    ticks = told(4, B1=(1, 2))
    assert [roused(notes) for notes in ticks] == [["B1"], ["B2"], ["B2"], ["B2"]]
