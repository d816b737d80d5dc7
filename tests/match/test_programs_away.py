"""Programs that stay away for long, in a step of many ticks: their threads run on, so they are looked at now and then."""

import pytest

from rcj_challenges.core.play import Fault
from rcj_challenges.match.loop import TickLoop
from tests.match.playing import StandIn, staged

FAULT = Fault("Y1", "output_flood", 128, 1, "it writes on and on")


class Away(StandIn):
    """A program that is found out at tick 128 if it is looked at then."""

    def __init__(self, ticks):
        super().__init__(ticks)
        self.looked_at = []

    def limit_fault(self, tick):
        self.looked_at.append(tick)
        return FAULT if tick == 128 else None


@pytest.mark.parametrize(("ticks", "looked_at"), [(1000, [64, 128]), (64, []), (60, [])])
def test_one_that_is_away_for_more_than_64_ticks_is_looked_at_every_64_and_ended_when_it_takes_too_much(
    ticks, looked_at
):
    half, stage = staged(300, lambda name: Away(ticks if name == "Y1" else 1))
    faults = []
    loop = TickLoop(stage, half, lambda *_: None, lambda fault: faults.append((loop.tick, fault)), lambda _: None)
    loop.play()
    assert [program.looked_at for program in stage.drivers.values()] == [[], [], [], looked_at, [], []]
    assert faults == [(128, FAULT)] * (128 in looked_at)
