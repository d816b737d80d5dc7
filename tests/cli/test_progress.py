"""The lines that are shown while a match is played."""

import io
from dataclasses import replace
from types import MappingProxyType, SimpleNamespace

import pytest
from rich.console import Console
from rich.text import Text

from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.match.observers import Observer, Progress
from rcj_challenges.match.pacing import TickEffects
from rcj_challenges.scenario.load import load
from rcj_challenges.views.scoreboard import PlainLines, Scoreboard, create_observer


class Counting:
    """As much of a referee as the effects asks."""

    def __init__(self, clock_ticks):
        self.clock_ticks = clock_ticks
        self.scores = {"blue": 0, "yellow": 0}


class Nothing:
    """A record, a crew and a verdict of which nothing is wanted here."""

    programs = MappingProxyType({})
    events = ()
    phase = "play"

    def tick(self, *_):
        pass


class Listening(Observer):
    progress_every_ticks = 100

    def __init__(self):
        self.heard = []

    def progressed(self, progress):
        self.heard.append(progress)


def heard_at(tick, clock_ticks, later_ticks):
    """Return what an observer hears of a half of 300 ticks, so many ticks after it began."""
    listening = Listening()
    half = replace(half_of(load("match").scenario), ticks=300)
    effects = TickEffects(
        half, later_ticks, Counting(clock_ticks), Nothing(), listening, Nothing(), (), real_time=False
    )
    effects.after_tick(SimpleNamespace(tick=tick), Nothing(), b"", b"")
    (progress,) = listening.heard
    return progress


def test_how_long_programs_took_to_start_is_not_taken_for_the_pace_of_the_match(monkeypatch):
    now = SimpleNamespace(s=0.0)
    monkeypatch.setattr("rcj_challenges.match.pacing.time", SimpleNamespace(perf_counter=lambda: now.s))
    listening, half = Listening(), replace(half_of(load("match").scenario), ticks=301)
    effects = TickEffects(half, 0, Counting(101), Nothing(), listening, Nothing(), (), real_time=False)
    for tick, took_s in ((0, 30.0), *((tick, 0.01) for tick in range(1, 101))):
        effects.after_tick(SimpleNamespace(tick=tick), Nothing(), b"", b"")
        now.s += took_s
    (progress,) = listening.heard
    assert progress.remaining_s == pytest.approx(2.0)
    assert progress.factor == pytest.approx(3.2)


def test_while_the_clock_stops_the_time_to_wait_does_not_shrink_under_nothing():
    progress = heard_at(400, 200, later_ticks=0)
    assert (progress.tick, progress.clock_ticks) == (400, 200)
    assert progress.remaining_s > 0


def test_the_clock_that_is_shown_is_that_of_the_half():
    shown = io.StringIO()
    PlainLines(Console(file=shown, width=200), load("match").scenario).progressed(heard_at(400, 250, later_ticks=0))
    assert shown.getvalue().splitlines()[-1].startswith(" 0:08.0  Blue")


def after_half_time():
    """Half-time is over: Hanse plays in yellow now and leads by 2 : 1, Alster in blue."""
    half = replace(
        half_of(load("match").scenario),
        half=2,
        team_names={"blue": "Alster", "yellow": "Hanse"},
        teams={"blue": "yellow", "yellow": "blue"},
    )
    return Progress(half, 20000, 1875, {"blue": 1, "yellow": 2}, "play", 49.0, 9.0)


def test_teams_keep_their_places_in_the_score_when_they_change_sides():
    shown = io.StringIO()
    PlainLines(Console(file=shown, width=200), load("match").scenario).progressed(after_half_time())
    assert " Hanse 2 : 1 Alster  (" in shown.getvalue()


def test_the_board_shows_which_team_plays_in_which_colour():
    shown = io.StringIO()
    board = Scoreboard(
        Console(file=shown, width=200, force_terminal=True, force_interactive=True), load("match").scenario
    )
    board.half_started(after_half_time().half)
    board.progressed(after_half_time())
    board.finished({})
    assert "Hanse 2 : 1 Alster" in Text.from_ansi(shown.getvalue()).plain
    assert "SoccerSim match   blue: Alster, yellow: Hanse" in shown.getvalue()


@pytest.mark.parametrize(
    ("terminal", "kind", "shown_by"),
    [
        (True, "xterm", Scoreboard),
        (True, "dumb", PlainLines),
        (True, "unknown", PlainLines),
        (False, "xterm", PlainLines),
    ],
)
def test_a_terminal_that_cannot_be_drawn_over_shows_plain_lines(monkeypatch, terminal, kind, shown_by):
    """One inside an editor, for instance: no scoreboard can be drawn there, and without lines the match is silent."""
    monkeypatch.setenv("TERM", kind)
    console = Console(file=io.StringIO(), force_terminal=terminal)
    assert type(create_observer(console, load("match").scenario, quiet=False, shared=False)) is shown_by
