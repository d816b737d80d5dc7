"""What people read of a match while it is played."""

import io
from dataclasses import replace

import pytest
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from rcj_challenges.core.changes import ScoreChange
from rcj_challenges.core.play import Event, Firing, RefereeOutput
from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.match.observers import Progress
from rcj_challenges.scenario.load import load
from rcj_challenges.views.commentary import Commentator
from rcj_challenges.views.scoreboard import PlainLines, Scoreboard

MATCH = load("match").scenario
NAMES = {"blue": "Die Kicker", "yellow": "Hanse"}
GOAL = RefereeOutput(
    (Event(509, "GOAL", {"team_name": "Die Kicker", "score_yellow": 1, "score_blue": 2}),),
    (Firing(509, "goal_in_yellow", None, "enters", scored={"blue": 1}, says="The ball is in the yellow goal."),),
    changes=(ScoreChange(509, {"blue": 2, "yellow": 1}),),
)
KICKOFF = RefereeOutput(
    (Event(0, "KICKOFF", {"robot_name": "Y3", "team_name": "Y"}),),
    (Firing(0, "first_kickoff_yellow", None, "half_started", says="Yellow kicks off."),),
)


@pytest.fixture
def half():
    return replace(half_of(MATCH), team_names=NAMES, scores={"blue": 1, "yellow": 1})


def said(output, half, scenario=MATCH):
    commentator = Commentator(scenario)
    commentator.begin(half)
    return [(remark.text, remark.seat) for remark in commentator.remarks(output)]


def test_a_goal_is_printed_with_team_score_and_time(half):
    assert said(GOAL, half) == [("GOAL  Die Kicker 2 : 1 Hanse  (Die Kicker, 0:16.3)", "blue")]


def test_an_event_is_printed_as_the_sentence_of_its_rule(half):
    assert said(KICKOFF, half) == [(" 0:00.0  Yellow kicks off.", "")]


def test_points_without_an_event_are_printed_and_lost_points_with_their_number(half):
    firing = Firing(50, "no_such_rule", None, "enters", scored={"yellow": -3})
    change = ScoreChange(50, {"blue": 1, "yellow": -2})
    assert said(RefereeOutput((), (firing,), changes=(change,)), half) == [
        ("POINTS  Die Kicker 1 : -2 Hanse  (Hanse, -3, 0:01.6)", "yellow")
    ]


def test_a_rule_that_scores_and_emits_two_events_scores_once(half):
    (firing,) = GOAL.firings
    actions = MATCH.rules["goal_in_yellow"].actions
    (emit,) = [action for action in actions if action.action == "emit"]
    rule = MATCH.rules["goal_in_yellow"].model_copy(
        update={"actions": [*actions, emit.model_copy(update={"event": "APPLAUSE"})]}
    )
    scenario = MATCH.model_copy(update={"rules": MATCH.rules | {"goal_in_yellow": rule}})
    output = replace(GOAL, events=(*GOAL.events, Event(509, "APPLAUSE")), firings=(firing,))
    assert [seat for _, seat in said(output, half, scenario)] == ["blue", ""]


def test_the_first_team_stands_first_in_every_score_also_after_sides_were_changed(half):
    half = replace(half, teams={"blue": "yellow", "yellow": "blue"})
    assert said(GOAL, half) == [("GOAL  Hanse 1 : 2 Die Kicker  (Die Kicker, 0:16.3)", "blue")]


def test_each_of_two_rules_that_score_in_one_tick_is_printed_with_the_score_that_it_made(half):
    firings = [
        Firing(50, "first", None, "enters", scored={"blue": 0.1}),
        Firing(50, "second", None, "enters", scored={"yellow": 1}),
    ]
    change = ScoreChange(50, {"blue": 1.1, "yellow": 2})
    texts = [text for text, _ in said(RefereeOutput((), tuple(firings), changes=(change,)), half)]
    assert [text.split("  ")[1] for text in texts] == ["Die Kicker 1.1 : 1 Hanse", "Die Kicker 1.1 : 2 Hanse"]


@pytest.mark.parametrize(("measured_m", "words"), [(0.4949, "0.495"), (0.4999996, "0.4999996")])
def test_a_rule_with_several_triggers_names_the_one_that_fired_with_numbers_that_do_not_contradict(
    half, measured_m, words
):
    firing = Firing(50, "robot_lack_of_progress", "Y1", "no_progress", measured_m, 0.5, says="Y1 made none or left.")
    event = Event(50, "LACK_OF_PROGRESS", {"type": "robot", "robot_name": "Y1"})
    assert said(RefereeOutput((event,), (firing,)), half) == [
        (f" 0:01.6  Y1 made no progress: {words} m in 15 s, at least 0.5 m", "")
    ]


def test_the_sentence_of_a_suppressed_rule_is_not_printed(half):
    (firing,) = GOAL.firings
    assert said(RefereeOutput((), (replace(firing, suppressed="cooldown"),)), half) == []


def shown_by(kind, half, *, width=80, **console):
    written = io.StringIO()
    observer = kind(Console(file=written, width=width, **console), MATCH)
    observer.half_started(half)
    observer.after_tick(None, KICKOFF)
    observer.after_tick(None, GOAL)
    observer.progressed(Progress(half, 625, 625, {"blue": 2, "yellow": 1}, "goal_pause", 49.0, 61.0))
    observer.finished({})
    return written.getvalue()


def test_without_a_terminal_lines_are_plain(half):
    lines = shown_by(PlainLines, half).splitlines()
    assert "GOAL  Die Kicker 2 : 1 Hanse  (Die Kicker, 0:16.3)" in lines
    assert " 0:00.0  Yellow kicks off." in lines
    assert not any("\x1b" in line for line in lines)


def test_a_goal_stays_when_the_board_is_taken_down(half):
    text = shown_by(Scoreboard, half, force_terminal=True, force_interactive=True)
    goal = text.index("GOAL  Die Kicker 2 : 1")
    # The board is drawn over by lines up from its last line; the goal was written once, above what is erased last.
    assert "GOAL" not in text[goal + 4 :]
    assert text[goal:].startswith("GOAL  Die Kicker 2 : 1 Hanse  (Die Kicker, 0:16.3)")


def test_the_board_holds_in_80_columns_with_the_longest_names(half):
    half = replace(half, team_names={"blue": "B" * 32, "yellow": "Y" * 32})
    text = shown_by(Scoreboard, half, force_terminal=True, force_interactive=True, no_color=True)
    lines = [Text.from_ansi(line).plain for line in text.splitlines()]
    assert max(map(cell_len, lines)) <= 80
    assert any("0:20.0 / 10:00.0" in line and "goal pause" in line for line in lines)


def test_team_colours_are_printed_unless_no_color_is_set(half, monkeypatch):
    terminal = {"force_terminal": True, "force_interactive": True, "color_system": "standard"}
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert "\x1b[1;34mGOAL" in shown_by(Scoreboard, half, **terminal)
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b[1mGOAL" in shown_by(Scoreboard, half, **terminal)
