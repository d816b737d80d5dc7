"""Programs that let the match wait: findings of a short match, scaled up to a half."""

from types import SimpleNamespace

import pytest

from rcj_challenges.checker.playing import _slow
from rcj_challenges.match.observers import ProgramTimes
from rcj_challenges.scenario.load import load

# Of a half of 600 s, 18750 ticks, a program may take 60 s, and 2 s for a step.
REHEARSAL = SimpleNamespace(loaded=load("match", ["match.half_s=600", "limits.half_s=60", "limits.step_s=2"]))


def findings(waited_s: float, slowest_s: float = 0.1):
    """Return the findings on a program after 12 s of play: a fiftieth of a half."""
    match = SimpleNamespace(simulated_s=12.0, waits={"B1": ProgramTimes("B1", 375, 0.5, waited_s, slowest_s)})
    return _slow(REHEARSAL, match, "blue: ")


@pytest.mark.parametrize(("waited_s", "level"), [(0.59, None), (0.61, "warning"), (2.39, "warning"), (2.41, "error")])
def test_half_of_the_time_of_a_half_is_a_warning_and_twice_that_time_a_failure(waited_s, level):
    assert [(one.code, one.level, one.where) for one in findings(waited_s)] == (
        [] if level is None else [("play.slow", level, "B1")]
    )


@pytest.mark.parametrize(("slowest_s", "codes"), [(0.99, []), (1.01, ["play.slow_step"])])
def test_single_step_that_takes_half_of_its_limit_is_a_warning(slowest_s, codes):
    found = findings(0.3, slowest_s)
    assert [one.code for one in found] == codes
