"""Two teams of one name are distinguished on every page and picture, not by their colours alone."""

from pathlib import Path

import pytest

from rcj_challenges.records.result import read_result
from rcj_challenges.scenario.load import load
from rcj_challenges.views.live.encoder import live_facts
from rcj_challenges.views.naming import distinct_names
from rcj_challenges.views.replay import page
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.video.footage import Footage
from tests.made_up_runs import write_made_up_run

TWICE = {"blue": "Hanse", "yellow": "Hanse"}


@pytest.mark.parametrize(
    ("names", "shown"),
    [
        (TWICE, ["Hanse (blue)", "Hanse (yellow)"]),
        ({"blue": "Hanse", "yellow": "Alster"}, ["Hanse", "Alster"]),
        ({"blue": "a" * 40 + "1", "yellow": "a" * 40 + "2"}, ["a" * 40 + "1 (blue)", "a" * 40 + "2 (yellow)"]),
    ],
)
def test_identical_names_are_shown_with_their_seats(names: dict[str, str], shown: list[str]) -> None:
    assert list(distinct_names(names).values()) == shown


def test_a_team_that_changes_sides_is_shown_with_its_first_seat() -> None:
    assert distinct_names(TWICE, sides_change=True) == {"blue": "Hanse (blue first)", "yellow": "Hanse (yellow first)"}


def test_replay_live_page_and_pictures_distinguish_teams_of_one_name(tmp_path: Path) -> None:
    folder = write_made_up_run(tmp_path, ticks=50, halves=2, names=("Hanse", "Hanse"))
    text = page.write_replay(folder).read_text("utf-8")
    assert all(f'"title":"Hanse ({seat} first)"' in text.replace(": ", ":") for seat in TWICE)
    footage = Footage.open(folder)
    assert list(footage.titles.values()) == ["Hanse (blue first)", "Hanse (yellow first)"]
    letters = [[footage.seat_of(half, team)["letter"] for team in TWICE] for half in footage.halves]
    assert letters == [["B", "Y"], ["Y", "B"]]
    facts = live_facts(load("match").scenario, TWICE, 1)
    assert [team["title"] for team in facts["teams"]] == ["Hanse (blue first)", "Hanse (yellow first)"]
    assert read_result(folder).entrants["blue"].name == "Hanse"


def test_letters_are_shown_only_where_they_distinguish_seats() -> None:
    assert [seat["letter"] for seat in visible_things(load("match").scenario)["seats"]] == ["B", "Y"]
    assert {seat["letter"] for seat in visible_things(load("fast_shooter").scenario)["seats"]} == {""}
