"""Programs that stay away for long, in a step of many ticks: their threads run on, so they are looked at now and then."""

from dataclasses import replace

import pytest

from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import Request
from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.match.loop import TickLoop
from rcj_challenges.match.stage import build_stage
from rcj_challenges.scenario.load import load

FAULT = Fault("Y1", "output_flood", 128, 1, "it writes on and on")


class Away:
    """A program that asks for steps of so many ticks, and is found out at tick 128 if it is looked at then."""

    def __init__(self, ticks):
        self.ticks, self.looked_at = ticks, []

    def collect(self, if_long=None):
        return Request(self.ticks)

    collect_soon = collect

    def release(self, observation):
        pass

    def share_cpus(self, share):
        pass

    def computed_s(self):
        return 0.0

    def overstepped(self, tick):
        self.looked_at.append(tick)
        return FAULT if tick == 128 else None


@pytest.fixture
def played():
    """Return what plays 300 ticks in which Y1 asks for steps of so many ticks: the program, and the faults by tick."""

    def play(ticks):
        loaded = load("match")
        half = replace(half_of(loaded.scenario), ticks=300)
        robots = loaded.roster.entities[: loaded.roster.robots]
        drivers = {index: Away(ticks if name == "Y1" else 1) for index, name in enumerate(robots)}
        stage = build_stage(loaded.scenario, loaded.roster, half, drivers)
        told = []
        play = TickLoop(stage, half, lambda *_: None, lambda fault: told.append((play.tick, fault)), lambda _: None)
        play.play()
        assert not any(driver.looked_at for index, driver in drivers.items() if robots[index] != "Y1")
        return drivers[robots.index("Y1")], told

    return play


def test_one_that_is_away_for_more_than_64_ticks_is_looked_at_every_64_and_ended_when_it_takes_too_much(played):
    program, told = played(1000)
    assert program.looked_at == [64, 128]
    assert told == [(128, FAULT)]


@pytest.mark.parametrize("ticks", [60, 64])
def test_one_that_comes_back_within_64_ticks_is_looked_at_only_then(played, ticks):
    program, told = played(ticks)
    assert program.looked_at == []
    assert told == []
