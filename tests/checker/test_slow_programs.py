"""Programs that let the match wait: what `check` says of a short match, reckoned for a whole half."""

from types import SimpleNamespace

import pytest

from rcj_challenges.checker.playing import _slow
from rcj_challenges.match.observers import ProgramTimes
from rcj_challenges.scenario.load import load

# Of a half of 600 s, 18750 ticks, a program may take 60 s, and 2 s for a step.
REHEARSAL = SimpleNamespace(loaded=load("match", ["match.half_s=600", "limits.half_s=60", "limits.step_s=2"]))


def told(waited_s: float, slowest_s: float = 0.1):
    """Return what is said of a program after 12 s of play: a fiftieth of a half."""
    match = SimpleNamespace(simulated_s=12.0, waits={"B1": ProgramTimes("B1", 375, 0.5, waited_s, slowest_s)})
    return _slow(REHEARSAL, match, "blue: ")


@pytest.mark.parametrize(("waited_s", "level"), [(0.59, None), (0.61, "warning"), (2.39, "warning"), (2.41, "failure")])
def test_who_takes_half_of_what_a_half_allows_is_warned_and_who_takes_twice_as_much_as_it_allows_fails(waited_s, level):
    assert [(one.code, one.level, one.where) for one in told(waited_s)] == (
        [] if level is None else [("play.slow", level, "B1")]
    )


def test_it_is_told_in_seconds_of_a_half_and_as_what_is_left_for_each_tick():
    (found,) = told(0.9)
    assert found.message == ("blue: uses 0.9 s in 12 s of play, that is 45 s in a half; 60 s are allowed")
    assert found.remedy == "do less in each step: 3.2 ms for each tick of 32 ms is the limit in the long run"


@pytest.mark.parametrize(("slowest_s", "codes"), [(0.99, []), (1.01, ["play.slow_step"])])
def test_a_single_step_that_takes_half_of_what_a_step_allows_is_told(slowest_s, codes):
    found = told(0.3, slowest_s)
    assert [one.code for one in found] == codes
    assert all("the slowest step takes 1.0 s; 2 s are allowed" in one.message for one in found)
