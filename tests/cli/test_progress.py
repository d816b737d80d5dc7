"""The lines that are shown while a match is played."""

import io

from rich.console import Console

from rcj_challenges.match.watching import Progress
from rcj_challenges.referee.script import half_of
from rcj_challenges.scenario.load import load
from rcj_challenges.views.scoreboard import PlainLines, Scoreboard


def progress(remaining_s):
    return Progress(half_of(load("match").scenario), 1875, {"blue": 0, "yellow": -1}, "play", 49.0, remaining_s)


def test_the_time_to_wait_cannot_be_taken_for_the_time_left_to_play():
    shown = io.StringIO()
    PlainLines(Console(file=shown, width=200), "Match").progressed(progress(1.2))
    line = shown.getvalue().splitlines()[-1]
    assert line == " 1:00.0  Blue 0 : -1 Yellow  (49 x real time, done in about 1 s)"


def test_the_board_says_it_in_the_same_words():
    shown = io.StringIO()
    board = Scoreboard(Console(file=shown, width=200, force_terminal=True, force_interactive=True), "Match")
    board.half_started(progress(0).half)
    board.progressed(progress(61))
    board.finished({})
    assert "49 x real time, done in about 61 s" in shown.getvalue()
    assert "left" not in shown.getvalue()
