"""Many matches at once: each in its own process, in the order of the jobs, one failure harming no other."""

import errno
import os

import pytest

from rcj_challenges.cli.simulate import parse_seeds, summary
from rcj_challenges.core.errors import RcjError
from rcj_challenges.match import batch
from rcj_challenges.match.batch import Job, Outcome
from rcj_challenges.match.worker_pool import run_all


@pytest.mark.parametrize(
    ("text", "seeds"),
    [("1..3", [1, 2, 3]), ("7", [7]), ("1,4,7..9", [1, 4, 7, 8, 9]), ("5..5", [5])],
)
def test_seeds_can_be_written_as_ranges_and_lists(text, seeds):
    assert parse_seeds(text) == seeds


@pytest.mark.parametrize(
    "text",
    [
        "",
        "x",
        "3..1",
        "1..",
        "..4",
        "1.5",
        "-1",
        "1_0",
        "+3",
        "0..99999999",
        "9" * 5000,
        "1.." + "9" * 5000,
        "x" * 5000,
    ],
)
def test_seeds_that_make_no_sense_are_refused_with_what_is_allowed(text):
    with pytest.raises(RcjError, match="--seeds") as caught:
        parse_seeds(text)
    assert caught.value.help
    assert len(str(caught.value)) < 500


def result(blue, yellow, *events):
    return {
        "score": {"blue": blue, "yellow": yellow},
        "events": [{"event": event} for event in events],
        "faults": [],
        "folder": f"runs/{blue}",
        "inputs": "a" * 64,
        "states": "b" * 64,
        "digest": "c" * 64,
    }


def test_the_summary_has_the_spread_by_entrant():
    outcomes = [Outcome(Job(seed, ()), result(seed, 2, "GOAL")) for seed in (1, 2, 6)]
    summarized = summary(outcomes)
    assert summarized["spread"]["blue"] == {"least": 1, "median": 2, "mean": 3.0, "most": 6}
    assert summarized["events"] == {"GOAL": 3}
    assert summarized["played"] == 3
    assert summarized["records"][2] == {
        "seed": 6,
        "folder": "runs/6",
        "inputs": "a" * 64,
        "states": "b" * 64,
        "digest": "c" * 64,
    }


def test_a_match_whose_process_cannot_be_started_is_a_fault_of_the_computer(monkeypatch):
    def refuse(*_, **__):
        raise OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))

    monkeypatch.setattr(batch.MatchProcess, "__init__", refuse)
    (outcome,) = run_all([Job(1, ())], 1, lambda _: None)
    assert outcome.result is None
    assert outcome.wrong_input
    assert "cannot start one more match" in outcome.complaint


def test_where_no_signal_lets_a_match_close_its_record_the_end_of_its_lifeline_does(monkeypatch):
    """As on Windows. The process ends by itself, and not by a signal."""
    monkeypatch.setattr(batch, "_START", "import sys; sys.exit(len(sys.stdin.read()))")
    monkeypatch.setattr(batch, "_HAS_SIGNALS", False)
    job = Job(1, ())
    process = job.start()
    job.interrupt(process)
    assert process.wait(10) == 0
    process.communicate()


def test_a_match_that_could_not_be_played_is_named_with_its_seed():
    summarized = summary([Outcome(Job(4, ()), None, "it broke")])
    assert summarized["failed"] == [{"seed": 4, "message": "it broke"}]


def test_a_match_that_ends_with_an_error_has_the_code_of_the_error():
    (outcome,) = run_all([Job(1, ("no_such_scenario.yaml",))], 1, lambda _: None)
    assert (outcome.result, outcome.wrong_input, outcome.code) == (None, True, "no-such-file")
