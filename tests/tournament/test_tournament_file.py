"""Tournament files: what is refused, with which code, and where."""

from functools import cache

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.reading.yaml_strict import parse_text
from rcj_challenges.tournament import load as loading
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.entries import id_of
from rcj_challenges.tournament.load import load_tournament, load_tree

HEAD = "tournament_version: 1\ntitle: T\nseed: 1\n"
TEAMS = (
    "teams: {a: {sample: ball_chaser}, b: {sample: ball_chaser}, c: {sample: ball_chaser}, d: {sample: ball_chaser}}\n"
)
LEAGUE = "stages:\n  league: {stage: round_robin}\n"
LOT = "tie_breaks: [points, lot]\n"


@pytest.fixture(autouse=True)
def _scenarios_loaded_once(monkeypatch):
    monkeypatch.setattr(loading, "load", _load_once)


@cache
def _load_once(source, overrides=()):
    return load(source, overrides)


def loaded(text, folder):
    return load_tree(parse_text(text, "t.yaml"), folder / "t.yaml")


def refused(text, folder):
    """Return code and path of all that is wrong with a file."""
    with pytest.raises(ScenarioError) as caught:
        loaded(text, folder)
    return [(one.code, one.where.path) for one in caught.value.diagnostics]


def test_a_small_file_has_sensible_defaults(tmp_path):
    one = loaded(HEAD + TEAMS + LEAGUE, tmp_path)
    assert one.tournament.tie_breaks == ("points", "goal_difference", "goals", "head_to_head")
    assert (one.tournament.points.win, one.tournament.withdrawn, one.records("league")) == (3, "annulled", "replay")
    assert list(one.entries) == ["a", "b", "c", "d"]
    assert Season(one).state({}).stages[0].expected_matches == 6


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (HEAD + TEAMS + "stage:\n  league: {stage: round_robin}\n", [("unknown-key", "")]),
        ("tournament_version: 2\n" + HEAD.partition("\n")[2] + TEAMS + LEAGUE, [("wrong-value", "tournament_version")]),
        ("tournament_version: 1\nseed: 1\n" + TEAMS + LEAGUE, [("missing-key", "")]),
        (HEAD + TEAMS + "stages: {league: {stage: round_robbin}}\n", [("unknown-word", "stages.league")]),
        (HEAD + TEAMS + "stages: {league: {legs: 2}}\n", [("missing-key", "stages.league")]),
        (HEAD + TEAMS + "stages: {league: {stage: round_robin, leg: 2}}\n", [("unknown-key", "stages.league")]),
        (HEAD + TEAMS + "stages: {league: {stage: round_robin, legs: 3}}\n", [("wrong-value", "stages.league.legs")]),
        (HEAD + TEAMS + "stages:\n  league:\n    stage: round_robin\n    legs:\n", [("missing-value", "stages.league.legs")]),
        (HEAD + TEAMS + "stages: {sw: {stage: swiss}}\n", [("missing-key", "stages.sw")]),
        (HEAD + TEAMS + "stages: {my league: {stage: round_robin}}\n", [("wrong-name", "stages.my league")]),
        (HEAD + TEAMS + "tie_breaks: [point]\n" + LEAGUE, [("wrong-value", "tie_breaks[0]")]),
        (HEAD + TEAMS + "withdrawn: {lost: [1]}\n" + LEAGUE, [("wrong-value", "withdrawn.lost")]),
        (HEAD + TEAMS + "stages: {l: {stage: round_robin, groups: {A: [a, 1]}}}\n", [("wrong-value", "stages.l.groups.A[1]")]),
        (HEAD + "teams: {a-b: {sample: ball_chaser}}\n" + LEAGUE, [("wrong-name", "teams.a-b")]),
    ],
)  # fmt: skip
def test_a_mistake_of_form_is_reported_once_with_its_place(text, expected, tmp_path):
    assert refused(text, tmp_path) == expected


def test_more_rounds_than_half_the_teams_are_a_warning(tmp_path):
    (warning,) = loaded(HEAD + TEAMS + "stages:\n  s: {stage: swiss, rounds: 3}\n", tmp_path).warnings
    assert (warning.code, warning.where.path) == ("rematch-possible", "stages.s.rounds")


def test_a_time_that_comes_twice_is_a_warning_that_names_both(tmp_path):
    text = HEAD + TEAMS + "time_zone: Europe/Berlin\nstages: {l: {stage: round_robin, release: 2026-10-25 02:45}}\n"
    (warning,) = loaded(text, tmp_path).warnings
    assert (warning.code, warning.level, warning.where.path) == ("ambiguous-time", "warning", "stages.l.release")
    assert "02:45 CEST (00:45 UTC) and 02:45 CET (01:45 UTC)" in warning.message
    wrong = text.replace("release: ", "groups: 9, release: ")
    with pytest.raises(ScenarioError) as caught:
        loaded(wrong, tmp_path)
    assert [one.code for one in caught.value.diagnostics] == ["too-few-teams", "ambiguous-time"], "with an error too"


def test_the_error_of_a_time_shows_its_form_and_time_zone(tmp_path):
    text = HEAD + TEAMS + "time_zone: Europe/Berlin\nstages: {l: {stage: round_robin, release: tomorrow}}\n"
    with pytest.raises(ScenarioError) as caught:
        loaded(text, tmp_path)
    assert "2021-06-22 18:00" in caught.value.diagnostics[0].help
    assert "Europe/Berlin" in caught.value.diagnostics[0].help


def test_what_comes_with_archives_of_a_mac_is_no_team(tmp_path):
    for folder in ("__MACOSX", "ada", "bee"):
        (tmp_path / "teams" / folder).mkdir(parents=True)
    for file in ("._cid.zip", ".DS_Store", "cid.zip"):
        (tmp_path / "teams" / file).touch()
    assert list(loaded(HEAD + "teams_folder: teams\n" + LEAGUE, tmp_path).entries) == ["ada", "bee", "cid"]


def test_mistakes_have_line_column_and_a_hint():
    with pytest.raises(ScenarioError) as caught:
        load_tree(parse_text(HEAD + TEAMS + "stages:\n  league: {stage: round_robbin}\n", "t.yaml"), None)
    (problem,) = caught.value.diagnostics
    assert (problem.where.file, problem.where.line, problem.where.column) == ("t.yaml", 6, 19)
    assert "'round_robin'" in problem.help


def test_all_mistakes_are_reported_at_once_in_the_order_of_the_file(tmp_path):
    text = (
        HEAD + "teams: {a: {sample: ball_chaser, pot: x}}\npoint: {}\n" + "stages: {l: {stage: round_robin, legs: 9}}\n"
    )
    codes = [("wrong-value", "teams.a.pot"), ("unknown-key", ""), ("wrong-value", "stages.l.legs")]
    assert refused(text, tmp_path) == codes


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # Names
        (HEAD + TEAMS + "stages: {a: {stage: round_robin}, A: {stage: round_robin}}\n", [("same-name", "stages.A")]),
        (HEAD + TEAMS + "stages: {a: {stage: challenge, scenarios: {x: {scenario: slalom}, X: {scenario: slalom}}}}\n", [("same-name", "stages.a.scenarios.X")]),
        # Teams
        (HEAD + LEAGUE, [("missing-key", "")]),
        (HEAD + "teams: {a: {sample: ball_chaser}}\n" + LEAGUE, [("too-few-teams", "teams")]),
        (HEAD + "teams: {a: {sample: ball_chaser}, A: {sample: ball_chaser}}\n" + LEAGUE, [("same-team-id", "teams.A")]),
        (HEAD + "teams: {a: {sample: bal_chaser}, b: {sample: ball_chaser}, c: {sample: ball_chaser}}\n" + LEAGUE, [("unknown-sample", "teams.a")]),
        (HEAD + "teams: {a: {path: a.zip}, b: {sample: ball_chaser}, c: {sample: ball_chaser}}\n" + LEAGUE, [("no-submission", "teams.a")]),
        (HEAD + "teams: {a: {}, b: {sample: ball_chaser}, c: {sample: ball_chaser}}\n" + LEAGUE, [("no-submission", "teams.a")]),
        (HEAD + "teams: {a: {path: x, sample: y}, b: {sample: ball_chaser}, c: {sample: ball_chaser}}\n" + LEAGUE, [("two-sources", "teams.a")]),
        (HEAD + TEAMS + "teams_folder: nowhere\n" + LEAGUE, [("teams-folder", "teams_folder")]),
        # The whole file
        (HEAD + TEAMS + "tie_breaks: [points, goals, points]\n" + LEAGUE, [("useless-tie-break", "tie_breaks[2]")]),
        (HEAD + TEAMS + "tie_breaks: [lot, points]\n" + LEAGUE, [("useless-tie-break", "tie_breaks[0]")]),
        (HEAD + TEAMS + "time_zone: Middle/Earth\n" + LEAGUE, [("unknown-time-zone", "time_zone")]),
        (HEAD + TEAMS + "scenario: mach\n" + LEAGUE, [("unknown-scenario", "scenario")]),
        (HEAD + TEAMS + "set: {match.half: 10}\n" + LEAGUE, [("wrong-scenario", "scenario")]),
        (HEAD + TEAMS + "scenario: fast_shooter\n" + LEAGUE, [("wrong-seats", "stages.league")]),
        # Where teams come from
        (HEAD + TEAMS + LEAGUE + "  f: {stage: knock_out, from: leage}\n", [("unreachable-stage", "stages.f.from")]),
        (HEAD + TEAMS + "stages:\n  f: {stage: knock_out, from: l}\n  l: {stage: round_robin}\n", [("unreachable-stage", "stages.f.from")]),
        (HEAD + TEAMS + "stages:\n  f: {stage: knock_out, from: f}\n", [("unreachable-stage", "stages.f.from")]),
        (HEAD + TEAMS + "stages:\n  s: {stage: super_team}\n  f: {stage: knock_out, from: s}\n", [("unreachable-stage", "stages.f.from")]),
        (HEAD + TEAMS + LEAGUE + "  f: {stage: knock_out, places: 1-2}\n", [("no-source", "stages.f.places")]),
        (HEAD + TEAMS + LEAGUE + "  f: {stage: knock_out, from: league, places: 3-2}\n", [("wrong-places", "stages.f.places")]),
        (HEAD + TEAMS + LOT + LEAGUE + "  f: {stage: knock_out, from: league, places: 3-5}\n", [("too-few-teams", "stages.f.places")]),
        (HEAD + TEAMS + LOT + LEAGUE + "  f: {stage: knock_out, from: league, places: 4}\n", [("too-few-teams", "stages.f")]),
        # Stages
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, groups: 3}\n", [("too-few-teams", "stages.l.groups")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, groups: {A: [a, b], B: [c, x]}}\n", [("listed-teams", "stages.l.groups"), ("unknown-team", "stages.l.groups.B[1]")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, groups: {A: [a, b], B: [c, d, a]}}\n", [("listed-teams", "stages.l.groups.B[2]")]),
        (HEAD + TEAMS + LEAGUE + "  l: {stage: round_robin, from: league, groups: {A: [a, b]}}\n", [("listed-teams", "stages.l.groups")]),
        (HEAD + TEAMS + "stages:\n  s: {stage: swiss, rounds: 4}\n", [("too-many-rounds", "stages.s.rounds")]),
        (HEAD + TEAMS + "stages:\n  k: {stage: knock_out, legs: 2, best_of: 3}\n", [("legs-and-best-of", "stages.k.best_of")]),
        (HEAD + TEAMS + LOT + LEAGUE + "  k: {stage: knock_out, from: league, places: 1-3, third_place: true}\n", [("too-few-teams", "stages.k.third_place")]),
        (HEAD + TEAMS + "stages:\n  c: {stage: challenge, scenarios: {m: {scenario: match}}}\n", [("wrong-seats", "stages.c.scenarios.m.scenario")]),
        (HEAD + TEAMS + LOT + LEAGUE + "  s: {stage: super_team, from: league, places: 1-3}\n", [("too-few-teams", "stages.s")]),
        (HEAD + TEAMS + "stages:\n  s: {stage: super_team, super_teams: {x: [a, b, c], y: [d, b]}}\n", [("listed-teams", "stages.s.super_teams.y"), ("listed-teams", "stages.s.super_teams.y[1]")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, release: [2021-06-22 18:00, 2021-06-23 18:00]}\n", [("wrong-release", "stages.l.release")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, release: 2021-02-30 18:00}\n", [("wrong-time", "stages.l.release")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, release: 22.6.2021 18:00}\n", [("wrong-time", "stages.l.release")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, release: 2021-6-22 8:00}\n", [("wrong-time", "stages.l.release")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, release: 0001-01-01 00:00}\ntime_zone: Europe/Berlin\n", [("wrong-time", "stages.l.release")]),
        (HEAD + TEAMS + "stages:\n  l: {stage: round_robin, release: 2026-03-29 02:30}\ntime_zone: Europe/Berlin\n", [("wrong-time", "stages.l.release")]),
    ],
)  # fmt: skip
def test_a_tournament_that_cannot_be_played_is_refused(text, expected, tmp_path):
    assert refused(text, tmp_path) == expected


@pytest.mark.parametrize(
    ("stages", "is_refused"),
    [
        ("  l: {stage: round_robin}\n  f: {stage: knock_out, from: l, places: 1-2}\n", True),
        ("  l: {stage: round_robin}\n  f: {stage: knock_out, from: l, places: 1-4}\n", False),
        ("  l: {stage: round_robin}\n  f: {stage: knock_out, from: l}\n", False),
        ("  l: {stage: round_robin, play_off: true}\n  f: {stage: knock_out, from: l, places: 1-2}\n", False),
        ("  l: {stage: round_robin, groups: 2}\n  f: {stage: knock_out, from: l, places: 1}\n", True),
        ("  s: {stage: swiss, rounds: 2}\n  f: {stage: knock_out, from: s, places: 3-4}\n", True),
        ("  k: {stage: knock_out}\n  f: {stage: round_robin, from: k, places: 1-2}\n", False),
        ("  k: {stage: knock_out}\n  f: {stage: round_robin, from: k, places: 1-3}\n", True),
        ("  k: {stage: knock_out, third_place: true}\n  f: {stage: round_robin, from: k, places: 1-3}\n", False),
    ],
)
def test_a_shared_place_that_decides_advancement_needs_a_lot_or_a_play_off(stages, is_refused, tmp_path):
    text = HEAD + TEAMS + "stages:\n" + stages
    if is_refused:
        assert refused(text, tmp_path) == [("undecided-places", "stages.f.places")]
    else:
        loaded(text, tmp_path)
    loaded(HEAD + TEAMS + LOT + "stages:\n" + stages, tmp_path)


# --- folders -----------------------------------------------------------------------------------------------------------


def test_each_zip_and_each_folder_is_a_team_and_other_files_are_not(tmp_path):
    for name in ("ada.zip", "Bee.ZIP", "readme.txt", ".hidden.zip"):
        (tmp_path / "in" / name).parent.mkdir(exist_ok=True)
        (tmp_path / "in" / name).write_bytes(b"")
    (tmp_path / "in" / "cat").mkdir()
    text = HEAD + "teams_folder: in\nteams: {cat: {pot: 1, name: The Cats}}\n" + LEAGUE
    one = loaded(text, tmp_path)
    assert {key: entry.source.name for key, entry in one.entries.items()} == {
        "cat": "cat",
        "Bee": "Bee.ZIP",
        "ada": "ada.zip",
    }
    assert (one.teams()["cat"].name, one.teams()["cat"].pot, one.teams()["ada"].name) == ("The Cats", 1, "ada")


def test_a_submission_that_a_team_names_is_not_also_a_team_of_its_own(tmp_path):
    for name in ("ada_new", "bee"):
        (tmp_path / "in" / name).mkdir(parents=True)
    one = loaded(HEAD + "teams_folder: in\nteams: {ada: {path: in/ada_new}}\n" + LEAGUE, tmp_path)
    assert list(one.entries) == ["ada", "bee"]


@pytest.mark.parametrize("path", ['"\\0"', "x" * 5000, '""', "🤖", "a: b"])
@pytest.mark.parametrize(
    "key",
    [
        "teams_folder: {}\n",
        "scenario: {}\n",
        "teams: {{a: {{path: {}}}, b: {{sample: keeper}}, c: {{sample: keeper}}}}\n",
    ],
)
def test_paths_that_no_system_can_open_are_refused_without_a_traceback(key, path, tmp_path):
    text = HEAD + (TEAMS if "teams:" not in key else "") + key.format(path) + LEAGUE
    (tmp_path / "t.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError):
        load_tournament(tmp_path / "t.yaml")


def test_submissions_whose_names_differ_by_case_only_are_refused(tmp_path):
    for name in ("ada.zip", "ADA"):
        (tmp_path / "in" / name).mkdir(parents=True)
    (tmp_path / "in" / "ada.zip").rmdir()
    (tmp_path / "in" / "ada.zip").write_bytes(b"")
    (tmp_path / "in" / "bee").mkdir()
    assert refused(HEAD + "teams_folder: in\n" + LEAGUE, tmp_path) == [("same-team-id", "teams_folder")]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("Team 1", "Team_1"),
        ("team-1.final", "team_1_final"),
        ("Équipe", "Equipe"),
        ("__x__", "x"),
        ("a" * 99, "a" * 40),
    ],
)
def test_an_id_is_made_of_the_latin_letters_and_digits_of_a_name(name, expected):
    assert id_of(name) == expected


@pytest.mark.parametrize("name", ["🤖🤖", "שלום", "🙂"])
def test_a_name_without_latin_letters_gets_an_id_of_its_own(name):
    assert id_of(name).startswith("team_")
    assert id_of(name) != id_of(name + "!?")


def test_submissions_for_a_challenge_lie_in_a_folder_of_their_own(tmp_path):
    for name in ("a", "stranger"):
        (tmp_path / "fast" / name).mkdir(parents=True)
    challenge = "stages:\n  c: {stage: challenge, scenarios: {fast: {scenario: fast_shooter, teams_folder: fast}}}\n"
    assert refused(HEAD + TEAMS + challenge, tmp_path) == [("unknown-team", "stages.c.scenarios.fast.teams_folder")]
    (tmp_path / "fast" / "stranger").rmdir()
    teams = "teams: {a: {path: fast/a}, b: {path: fast/a}, s: {sample: ball_chaser}}\n"
    one = loaded(HEAD + teams + challenge, tmp_path)
    found = {key: entry.submission("c", "fast") for key, entry in one.entries.items()}
    assert (found["a"], found["b"]) == (tmp_path / "fast" / "a", None)
    assert found["s"].name == "fast_shooter"  # a sample team has the sample team of the challenge
    assert [fixture.sides[0].teams[0] for fixture in Season(one).state({}).open_fixtures()] == ["a", "s"]


# --- files -------------------------------------------------------------------------------------------------------------


def test_a_file_that_does_not_exist_is_refused_with_the_shipped_ones():
    with pytest.raises(ScenarioError) as caught:
        load_tournament("cupp")
    (problem,) = caught.value.diagnostics
    assert problem.code == "no-such-file"
    assert "'cup'" in problem.help


@pytest.mark.parametrize(
    ("text", "code"),
    [("tournament_version: 1\ntitle: [\n", "invalid-yaml"), ("- 1\n", "wrong-value"), ("", "empty-file")],
)
def test_a_file_that_is_no_mapping_in_yaml_is_refused(text, code, tmp_path):
    (tmp_path / "t.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        load_tournament(tmp_path / "t.yaml")
    assert [one.code for one in caught.value.diagnostics] == [code]
