"""A half is called as the scenario says, in the terminal, on the rule sheet and on the pages."""

import io

import pytest
from rich.console import Console

from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.live.encoder import live_facts
from rcj_challenges.views.scoreboard import PlainLines
from rcj_challenges.views.sentences import event_title
from tests.views.sheets import HEAD, sheet

BASEBALL = "match: {halves: 9, half_s: 60, called: [inning, innings], swap_sides: true}\n"
DARTS = "match: {halves: 5, half_s: 60, called: leg}\n"
RULES = """
rules:
  serve:
    triggers: [{trigger: half_started}, {trigger: half_ended}]
    conditions: [{word: halftime, at_least: 2}]
    max_executions: 1
    actions: [{action: score, entrant: blue}]
"""


def test_the_sheet_names_them_with_their_own_article_and_plural():
    text = sheet(BASEBALL + RULES)
    assert "9 innings of 60 s; the teams change sides between innings." in text
    assert "When an inning starts, or when an inning is over, provided that it is inning 2 or a later one" in text
    assert "at most once an inning" in text
    assert "5 legs of 60 s." in sheet(DARTS)
    assert "A leg begins in the phase “pause”" in sheet(
        f"{DARTS}phases: {{pause: {{lasts_s: 2}}}}\nfirst_phase: pause\n"
    )


def test_a_half_that_has_no_name_is_a_half():
    assert "2 halves of 60 s." in sheet("match: {halves: 2, half_s: 60}\n")


def test_the_terminal_names_them():
    loaded, out = load_text(HEAD + DARTS), io.StringIO()
    PlainLines(Console(file=out, width=200), loaded.scenario).half_started(half_of(loaded.scenario, 3))
    assert "leg 3 of 5 " in out.getvalue()


def test_their_beginnings_and_ends_are_named_in_the_list_of_events():
    leg = load_text(HEAD + DARTS).scenario.match.period
    assert event_title("MATCH_START", 2, 5, leg) == "START OF LEG 2"
    assert event_title("MATCH_FINISH", 2, 5, leg) == "END OF LEG 2"
    assert event_title("MATCH_FINISH", 2, 5) == "END OF HALF 2"


@pytest.mark.parametrize(("match", "called"), [(DARTS, "leg"), (BASEBALL, "inning"), ("", "half")])
def test_pages_have_the_name(match, called):
    assert live_facts(load_text(HEAD + match).scenario, {}, 1)["period"] == called
