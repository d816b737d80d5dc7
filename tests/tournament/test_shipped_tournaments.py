"""The shipped tournaments: they load, follow the schema, and lead through all their stages."""

import json

import jsonschema
import pytest

from rcj_challenges.cli.schema import schema
from rcj_challenges.scenario.reading.yaml_strict import parse_bytes
from rcj_challenges.scenario.resources import SCHEMAS_FOLDER, TOURNAMENTS_FOLDER, names_in
from rcj_challenges.scenario.tree import plain
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.json_schema import FILE, schema_text, tournament_schema
from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.release import release_times
from rcj_challenges.tournament.season import FixtureKind
from tests.tournament.seasons import by_chance, by_strength, play, stage

VALIDATOR = jsonschema.Draft202012Validator(tournament_schema())
HEAD = {"tournament_version": 1, "title": "T", "seed": 1, "teams": {"a": {"sample": "x"}}}


def test_the_committed_schema_is_fresh(capsys):
    assert schema(check=True) == 0
    assert json.loads(schema_text()) == tournament_schema()
    jsonschema.Draft202012Validator.check_schema(tournament_schema())


@pytest.mark.parametrize("name", names_in(TOURNAMENTS_FOLDER))
def test_shipped_tournaments_follow_the_schema_and_name_it_for_editors(name):
    path = TOURNAMENTS_FOLDER / f"{name}.yaml"
    assert list(VALIDATOR.iter_errors(plain(parse_bytes(path.read_bytes(), path.name)))) == []
    first = path.read_text("utf-8").splitlines()[0]
    assert first.startswith("# yaml-language-server: $schema=")
    assert (path.parent / first.partition("=")[2]).resolve() == (SCHEMAS_FOLDER / FILE).resolve()


@pytest.mark.parametrize(
    ("more", "is_valid"),
    [
        ({"stages": {"a": {"stage": "round_robin"}}}, True),
        ({"stages": {"a": {"stage": "round_robin", "groups": {"A": ["a", "b"]}}}}, True),
        ({"stages": {"a": {"stage": "round_robin", "rounds": 3}}}, False),
        ({"stages": {"a": {"stage": "swiss"}}}, False),
        ({"stages": {"a": {"stage": "swiss", "rounds": 3, "from": "b", "places": "1-2"}}}, True),
        ({"stages": {"a": {"stage": "swiss", "rounds": {"param": "x"}}}}, False),
        ({"stages": {}}, False),
        ({"stages": {"a": {"stage": "knock_out"}}, "withdrawn": {"lost": [0, 3]}}, True),
        ({"stages": {"a": {"stage": "knock_out"}}, "withdrawn": "gone"}, False),
        ({"stages": {"a": {"stage": "knock_out"}}, "tie_breaks": ["points", "lot"]}, True),
    ],
)
def test_schema_accepts_what_the_loader_accepts(more, is_valid):
    assert VALIDATOR.is_valid(HEAD | more) == is_valid


def test_every_key_of_a_tournament_has_a_description():
    def undescribed(schema, where=""):
        for key, inner in schema.get("properties", {}).items():
            if not inner.get("description"):
                yield f"{where}.{key}"
        for key, inner in schema.get("$defs", {}).items():
            yield from undescribed(inner, key)

    assert list(undescribed(tournament_schema())) == []


def test_cup_is_small_and_has_a_swiss_stage():
    one = load_tournament("cup")
    state = play(Season(one), by_strength)
    assert {found.kind for found in state.stages} >= {"swiss", "knock_out"}
    assert sum(found.expected_matches for found in state.stages) == 13
    assert max(info.duration_s for info in one.scenarios.values()) <= 120


def test_championship_has_the_shape_of_2021_and_leads_through_all_stages():
    one = load_tournament("championship")
    state = play(Season(one), by_chance(1))
    assert [found.kind for found in state.stages] == ["round_robin", "knock_out", "challenge", "super_team"]
    assert {str(found.status) for found in state.stages} == {"finished"}
    groups, finals = stage(state, "groups"), stage(state, "finals")
    assert [len(table.rows) for table in groups.tables] == [5, 5, 4, 4]
    pairs = [frozenset(side.teams for side in fixture.sides) for fixture in groups.fixtures]
    assert {pairs.count(pair) for pair in pairs} == {2}
    assert list(dict.fromkeys(tie.round for tie in finals.ties)) == [
        "round_of_16",
        "quarter_finals",
        "semi_finals",
        "third_place",
        "final",
    ]
    assert [table.name for table in stage(state, "challenges").tables] == [
        "fast_shooter",
        "pass_the_ball",
        "precision_lidar",
        "total",
    ]
    assert all(len(side.teams) == 3 for one in stage(state, "super_team").fixtures for side in one.sides)


def test_championship_is_released_day_by_day():
    one = load_tournament("championship")
    state = play(Season(one), by_chance(1))
    times = release_times(one.tournament, state)
    assert set(times) == set(state.outcomes)
    final = stage(state, "finals").ties[-1]
    assert (
        str(times[final.fixtures[0]]) == "2021-06-26 14:25:00+00:00"
    )  # 16:25 in its time zone, 25 minutes after the one for third place


def test_sample_teams_of_the_championship_have_programs_for_what_they_play():
    one = load_tournament("championship")
    state = Season(one).state({})
    played = {
        (fixture.kind, fixture.group, one.entries[side.teams[0]].submission(fixture.stage, fixture.group).name)
        for fixture in state.open_fixtures()
        for side in fixture.sides
    }
    challenges = {(group, sample) for kind, group, sample in played if kind is FixtureKind.CHALLENGE}
    assert challenges == {(name, name) for name in ("fast_shooter", "pass_the_ball", "precision_lidar")}
