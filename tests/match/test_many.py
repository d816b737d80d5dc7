"""Many matches at once: each in its own process, in the order of the jobs, one failure harming no other."""

import errno
import os
import subprocess
import tempfile

import pytest

from rcj_challenges.cli.simulate import SeedsError, parse_seeds, summary
from rcj_challenges.controllers.private_folders import PrivateFolders
from rcj_challenges.match import apart, many
from rcj_challenges.match.many import Job, Outcome


@pytest.mark.parametrize(
    ("text", "seeds"),
    [("1..3", [1, 2, 3]), ("7", [7]), ("1,4,7..9", [1, 4, 7, 8, 9]), ("5..5", [5])],
)
def test_seeds_can_be_written_as_ranges_and_lists(text, seeds):
    assert parse_seeds(text) == seeds


@pytest.mark.parametrize(
    "text", ["", "x", "3..1", "1..", "..4", "1.5", "-1", "0..99999999", "9" * 5000, "1.." + "9" * 5000, "x" * 5000]
)
def test_seeds_that_make_no_sense_are_refused_with_what_is_allowed(text):
    with pytest.raises(SeedsError, match="--seeds") as caught:
        parse_seeds(text)
    assert len(str(caught.value)) < 500


def result(blue, yellow, *events):
    return {
        "score": {"blue": blue, "yellow": yellow},
        "events": [{"event": event} for event in events],
        "faults": [],
        "folder": f"runs/{blue}",
        "digest": "a" * 64,
    }


def test_the_summary_tells_the_spread_by_entrant():
    outcomes = [Outcome(Job(seed, ()), result(seed, 2, "GOAL")) for seed in (1, 2, 6)]
    told = summary(outcomes)
    assert told["spread"]["blue"] == {"least": 1, "median": 2, "mean": 3.0, "most": 6}
    assert told["events"] == {"GOAL": 3}
    assert told["played"] == 3
    assert told["records"][2] == {"seed": 6, "folder": "runs/6", "digest": "a" * 64}


def test_a_match_that_cannot_be_started_takes_no_other_with_it(monkeypatch):
    started = []

    class Played:
        returncode = 0

        def __init__(self, command, **_):
            started.append(command)
            if "2" in command:
                raise OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))

        def communicate(self):
            return '{"score": {}}', ""

    monkeypatch.setattr(subprocess, "Popen", Played)
    outcomes = many.play_many([Job(seed, ()) for seed in (1, 2, 3)], 1, lambda _: None)
    assert [outcome.result is not None for outcome in outcomes] == [True, False, True]
    assert "cannot start one more match" in outcomes[1].complaint
    assert len(started) == 3


def test_where_no_signal_lets_a_match_close_its_record_the_end_of_its_lifeline_does(monkeypatch):
    """As on Windows. The process ends by itself, and not by a signal."""
    monkeypatch.setattr(many, "_START", "import sys; sys.exit(len(sys.stdin.read()))")
    matches = many._Matches(by_lifeline=True)
    process = matches.start([])
    matches.end_all()
    assert process.returncode == 0
    matches.forget(process)
    process.communicate()


def test_what_a_process_that_had_to_be_killed_leaves_in_the_temporary_folder_is_removed(tmp_path, monkeypatch):
    """It takes too long to put its things in order; its lock is gone with it, that of another one is not."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    busy, other = PrivateFolders(), PrivateFolders()

    class Busy:
        def wait(self, timeout_s=None):
            if timeout_s is not None:
                raise subprocess.TimeoutExpired("match", timeout_s)

        def kill(self):
            os.close(busy._lock_fd)

    running = apart.Running(lambda _: None)
    running.begin(Busy)
    running.end_all()
    assert list(tmp_path.iterdir()) == [other.place]
    other.close()


def test_a_match_that_could_not_be_played_is_named_with_its_seed():
    told = summary([Outcome(Job(4, ()), None, "it broke")])
    assert told["failed"] == [{"seed": 4, "message": "it broke"}]
