"""Double elimination: who loses twice is out, and the winner of the lower bracket has lost once."""

import re
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.season import Outcome
from rcj_challenges.tournament.site.bracket import bracket_svg
from tests.tournament.seasons import by_chance, by_strength, names, order, play, season

CUP = "  cup: {{stage: double_elimination{}}}\n"


def cup(count, more="", head=""):
    return season(CUP.format(more), names(count), head)


def upset(fixture):
    """Return an outcome in which the favourite loses its first match, and wins all others."""
    is_first = fixture.stage == "cup" and fixture.round == 1
    return by_strength(fixture) if not is_first else Outcome(by_strength(fixture).scores[::-1])


@given(st.integers(3, 40), st.integers(0, 1000))
def test_every_team_but_the_winner_loses_two_ties(count, seed):
    state = play(cup(count), by_chance(seed)).stages[0]
    ties = [tie for tie in state.ties if tie.decided_by != "bye"]
    losses = Counter(team for tie in ties for team in tie.teams if team != tie.winner)
    champion = state.places[0].team
    assert losses.pop(champion, 0) <= 1
    assert losses == dict.fromkeys(set(names(count)) - {champion}, 2)
    assert sorted(order(state.places)) == names(count)
    assert state.expected_matches == len(state.fixtures)


def test_the_places_follow_the_round_of_the_second_loss():
    state = play(cup(8)).stages[0]
    assert [(row.team, row.place) for row in state.places][:4] == [("t01", 1), ("t02", 2), ("t03", 3), ("t04", 4)]
    assert [row.place for row in state.places][4:] == [5, 5, 7, 7]


@pytest.mark.parametrize(("more", "finals"), [("", 2), (", second_final: false", 1)])
def test_a_second_final_is_played_if_the_team_from_the_lower_bracket_wins_the_first(more, finals):
    state = play(cup(4, more), upset).stages[0]
    found = [tie for tie in state.ties if tie.round == "grand_final"]
    assert [tie.winner for tie in found] == ["t01"] * finals
    assert found[0].sources[1] == "winner of match 1 of the lower round 2"
    assert state.places[0].team == "t01"


@given(st.integers(3, 33), st.integers(0, 100))
def test_only_places_that_validate_reports_are_shared(count, seed):
    one = cup(count)
    model = one.loaded.tournament.stages["cup"]
    sizes = Counter(row.place for row in play(one, by_chance(seed)).stages[0].places)
    inside = {cut for place, size in sizes.items() for cut in range(place, place + size - 1)}
    assert inside <= model.shared_cuts(frozenset(range(1, count)), count)


@given(st.integers(3, 33))
def test_the_plan_has_as_many_matches_and_rounds_as_are_played(count):
    one = cup(count, ", second_final: false")
    state = play(one, by_chance(1)).stages[0]
    assert one.state({}).stages[0].expected_matches == len(state.fixtures) == 2 * count - 2
    assert max(fixture.round for fixture in state.fixtures) == 2 * (count - 1).bit_length()


def test_the_bracket_is_known_before_the_teams_are():
    stages = "  league: {stage: round_robin}\n  cup: {stage: double_elimination, from: league, places: 1-4}\n"
    (_, stage) = season(stages, names(4)).state({}).stages
    assert stage.status == "waiting"
    assert stage.ties[0].sources == ("place 1 of league", "place 4 of league")


def test_both_brackets_are_drawn_one_below_the_other():
    state = play(cup(8), upset).stages[0]
    svg = bracket_svg(state.ties, str, "Cup", {}, alone=True)
    boxes = re.findall(r'<rect class="box" x="([\d.]+)" y="([\d.]+)"', svg)
    assert len(boxes) == len(set(boxes)) == len(state.ties) == 15
    heads = dict(re.findall(r'<text class="head" x="[\d.]+" y="([\d.]+)">([^<]*)<', svg)[::-1])
    assert len(heads) == 2
    assert {"Upper round 1", "Lower round 1", "Lower round 4", "Grand final"} <= set(
        re.findall(r'">([^<]*)</text>', svg)
    )


def test_two_teams_are_too_few(tmp_path):
    text = "tournament_version: 1\ntitle: T\nseed: 1\nteams: {a: {sample: ball_chaser}, b: {sample: ball_chaser}}\n"
    (tmp_path / "t.yaml").write_text(f"{text}stages:\n{CUP.format('')}", encoding="utf-8")
    with pytest.raises(ScenarioError) as error:
        load_tournament(tmp_path / "t.yaml")
    assert [one.code for one in error.value.diagnostics] == ["too-few-teams"]
