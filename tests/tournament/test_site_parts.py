"""Parts of the site by themselves: brackets, replays read back, logs cut by halves, similarity, names of files."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.core.files import is_device_of_windows, slug
from rcj_challenges.scenario.resources import TEAMS_FOLDER
from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.season import Tie
from rcj_challenges.tournament.site import site_source
from rcj_challenges.tournament.site.bracket import bracket_svg
from rcj_challenges.tournament.site.plots import distribution_plot, form_plot, score_plot
from rcj_challenges.tournament.site.private import own_log
from rcj_challenges.tournament.site.public import public_result, read_replay
from rcj_challenges.tournament.site.similarity import similar_pairs, token_rows
from rcj_challenges.tournament.store.store import Store
from rcj_challenges.views.replay.page import page_text
from tests.tournament.site_play import HOSTILE, NOW, SECRET, make_season

ROUNDS = ("round_of_64", "round_of_32", "round_of_16", "quarter_finals", "semi_finals", "final")


def ties(first_round: int) -> tuple[Tie, ...]:
    names = ROUNDS[-first_round.bit_length() :]
    found = [
        Tie(f"k/{name}/{number}", name, number, (f"t{number}", HOSTILE), scores=(1, 0), winner=f"t{number}")
        for at, name in enumerate(names)
        for number in range(1, (first_round >> at) + 1)
    ]
    return (*found, Tie("k/third_place/1", "third_place", 1, ("", ""), ("loser of a", "loser of b"), decided_by="lot"))


@pytest.mark.parametrize("first_round", [1, 2, 4, 8, 16, 32])
def test_no_two_ties_of_a_bracket_overlap_and_all_are_inside(first_round: int) -> None:
    picture = ET.fromstring(bracket_svg(ties(first_round), lambda team: team, "x", {}, alone=True))
    _, _, wide, tall = map(float, picture.attrib["viewBox"].split())
    boxes = [
        tuple(float(box.attrib[name]) for name in ("x", "y", "width", "height"))
        for box in picture.iter("{http://www.w3.org/2000/svg}rect")
    ]
    assert len(boxes) == 2 * first_round
    for x, y, width, height in boxes:
        assert x >= 0
        assert x + width <= wide
        assert y >= 0
        assert y + height <= tall
    for at, (x, y, width, height) in enumerate(boxes):
        for other_x, other_y, _, _ in boxes[:at]:
            assert abs(x - other_x) >= width or abs(y - other_y) >= height


def test_a_bracket_links_to_the_last_match_of_each_tie() -> None:
    tie = Tie("k/final/1", "final", 1, ("a", "b"), fixtures=("one", "two"))
    svg = bracket_svg((tie,), str, "x", {"one": "1.html", "two": "2.html"})
    assert re.findall(r'href="([^"]*)"', svg) == ["2.html"]


def test_plots_are_well_formed_whatever_the_names_and_numbers() -> None:
    for svg in (
        score_plot([HOSTILE, "b"], [(10.0, [(0.0, [0, 0]), (3.0, [-2, 1.5])]), (0.0, [])], HOSTILE),
        form_plot([(HOSTILE, -3), ("x", 0)]),
        distribution_plot({HOSTILE: [1.0, 1.0], "one": []}, "time (s)"),
        distribution_plot({"a": [-1e9, 1e9, 0.1]}, "score"),
    ):
        ET.fromstring(svg)


IDS = st.text(st.sampled_from("aB1/_- é🤖"), max_size=150)


@given(IDS, IDS)
def test_two_ids_never_share_a_file(one: str, other: str) -> None:
    assert re.fullmatch(r"[A-Za-z0-9_.-]*", slug(one))
    if re.fullmatch(r"[A-Za-z0-9_/-]*", one + other):
        assert (slug(one) == slug(other)) == (one == other)


@pytest.mark.parametrize("name", ["index", "Index", "con", "NUL", "aux/round1/ada-bee", "com1", "index/con"])
def test_a_team_or_stage_takes_neither_the_name_of_a_page_nor_of_a_device_of_windows(name: str) -> None:
    assert slug(name).casefold() != "index"
    assert not is_device_of_windows(slug(name))


def test_a_replay_is_read_back_as_it_was_written() -> None:
    facts = {"halves": [{"half": 1}], "teams": [{"title": HOSTILE}], "about": [["scenario", "x"]]}
    page = page_text(facts, {1: "QUJD"}, {"sensors-1": "secret", "output-1": "secret"})
    data = read_replay(page)
    assert data.facts == facts
    assert data.poses == {1: "QUJD"}


@pytest.mark.parametrize("text", ["", "<html>", '<script id="facts">[]</script>', '<script id="facts">{</script>'])
def test_what_is_no_replay_is_refused(text: str) -> None:
    with pytest.raises(ValueError):  # noqa: PT011 - of JSON or of ours
        read_replay(text)


def test_the_public_result_has_nothing_but_what_is_listed() -> None:
    payload = {"robot_name": "B1", "kind": "crash", "detail": SECRET}
    result = {
        "score": {"blue": 1},
        "sandbox": {"mode": "auto"},
        "hints": [SECRET],
        "folder": "/home/someone",
        "events": [
            {"half": 1, "tick": 3, "event": "PROGRAM_FAULT", "payload": payload},
            {"half": 1, "tick": 9, "event": "GOAL", "payload": {"team_name": "x"}},
        ],
        "faults": [{"robot": "B1", "half": 1, "tick": 3, "kind": "crash", "detail": SECRET, "traceback": SECRET}],
    }
    public = public_result(result)
    assert SECRET not in str(public)
    assert public.keys() == {"score", "events", "faults"}
    assert public["faults"] == [{"robot": "B1", "half": 1, "tick": 3, "kind": "crash"}]


FIRST = "--- half 1: blue.py ---\none\n"


@pytest.mark.parametrize(
    ("text", "own", "expected"),
    [
        (FIRST + "--- half 2: y.py ---\ntwo\n", [1, 2], FIRST + "--- half 2: y.py ---\ntwo\n"),
        (FIRST + "--- half 2: y.py ---\ntwo\n", [1], FIRST),
        (FIRST + "--- half 2: y.py ---\ntwo\n", [2], "--- half 2: y.py ---\ntwo\n"),
        (FIRST + "no line end--- half 2: y.py ---\ntwo\n", [1], FIRST + "no line end"),
        (FIRST + "no line end--- half 2: y.py ---\ntwo\n", [2], "--- half 2: y.py ---\ntwo\n"),
        # A program of the first half says that the second one begins.
        (FIRST + "--- half 2: z ---\n--- half 2: y.py ---\ntwo\n", [1], FIRST + "--- half 2: z ---\n"),
        (FIRST + "--- half 2: z ---\n--- half 2: y.py ---\ntwo\n", [2], "--- half 2: y.py ---\ntwo\n"),
        (FIRST, [1], FIRST),
        (FIRST, [2], ""),
        (FIRST, [], ""),
    ],
)
def test_a_log_is_cut_where_the_robot_changes_teams(text: str, own: list[int], expected: str) -> None:
    assert own_log(text, [1, 2], own) == expected


def test_a_log_of_more_than_two_halves_is_withheld_unless_all_are_own() -> None:
    assert own_log(FIRST, [1, 2, 3, 4], [1, 3]) == ""
    assert own_log(FIRST, [1, 2, 3, 4], [1, 2, 3, 4]) == FIRST


# --- similarity ------------------------------------------------------------------------------------------------------

PROGRAM = b"""
def dribble(ball, heading):
    turn = 3.1 * ball.angle - heading
    while abs(turn) > 0.2 and ball.strength >= 40:
        left, right = 10 - turn, 10 + turn
        drive(max(-10, left), min(10, right))
    return [sum(pair) for pair in zip(ball.history, ball.history[1:])]
"""


def submission(folder: Path, name: str, content: bytes) -> Path:
    (folder / name).mkdir()
    (folder / name / "robot.py").write_bytes(content)
    return folder / name


def test_a_program_with_other_names_and_comments_is_alike(tmp_path: Path) -> None:
    renamed = PROGRAM.replace(b"ball", b"kugel").replace(b"3.1", b"4") + b"# mine\n"
    other = (TEAMS_FOLDER / "keeper").rglob("*.py")
    sample = submission(tmp_path, "sample", next(other).read_bytes())
    pairs, unread = similar_pairs(
        {
            "one": {"": submission(tmp_path, "one", PROGRAM)},
            "two": {"": sample, "skills/shooting": submission(tmp_path, "two", renamed)},
            "sample": {"": sample},
            "gone": {"": tmp_path / "gone"},
        }
    )
    assert [(pair.first, pair.second) for pair in pairs] == [("one", "two")]
    assert pairs[0].share > 0.9
    assert [names[:2] for names in pairs[0].files] == [("robot.py", "skills/shooting: robot.py")]
    assert unread == ["gone"]


def test_what_teams_took_from_the_samples_is_not_counted(tmp_path: Path) -> None:
    sample = next((TEAMS_FOLDER / "ball_chaser").rglob("*.py")).read_bytes()
    pairs, _ = similar_pairs({name: {"": submission(tmp_path, name, sample)} for name in ("one", "two")})
    assert pairs == []


@given(st.binary(max_size=300))
def test_any_bytes_can_be_compared(source: bytes) -> None:
    token_rows(source)


# --- from the store --------------------------------------------------------------------------------------------------


def test_premieres_need_a_stage_with_a_time_of_release(tmp_path: Path) -> None:
    season = make_season(tmp_path, ticks=10).engine
    with Store(tmp_path / "data", writing=True) as store:
        tournament = OpenTournament(load_tournament(season.loaded.path), store)
        source = site_source(tournament, NOW, url="https://cup.example")
        assert source.url == "https://cup.example/"
        assert source.state.outcomes == {}
        with pytest.raises(DiagnosticError) as caught:
            site_source(tournament, NOW, ["finals", "nothing"])
    assert [one.code for one in caught.value.diagnostics] == ["no-release", "unknown-stage"]
