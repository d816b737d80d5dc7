"""Matches of teams that have designed their robots."""

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.match.designs import with_designs
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.result import read_result
from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.kits import chassis_of, devices_of
from rcj_challenges.scenario.load import load_recorded, load_text
from rcj_challenges.submissions.team import SuperTeam, open_team
from tests.match.playing import Place
from tests.scenario.test_designs import GUIDELINES, design

PROGRAM = """
from controller import Robot
robot = Robot()
print(robot.getName(), sorted(robot.devices))
while robot.step(32) != -1:
    pass
"""
TWO = design() + "  goalie: {chassis: {drive: omni, size_m: 0.09}, devices: {}}\nrobots: [striker, striker, goalie]\n"


def team(place: Place, text: str | None, scenario):
    folder = place.team_folder(PROGRAM)
    if text is not None:
        (folder / "robot.yaml").write_text(text, encoding="utf-8")
    return open_team(folder, *scenario.entrants.values())


@pytest.fixture(scope="module")
def played(tmp_path_factory):
    place = Place(tmp_path_factory.mktemp("designs"))
    base = load_text(GUIDELINES)
    teams = {"blue": team(place, TWO, base.scenario), "yellow": team(place, None, base.scenario)}
    loaded = with_designs(base, teams)
    played = play_match(MatchPlan(loaded, teams, {}, out=place.folder / "runs"))
    return base, loaded, teams, played


def test_robots_are_as_designed_and_follow_their_team(played):
    _, loaded, _, _ = played
    for half, ours, theirs in ((1, "B", "Y"), (2, "Y", "B")):
        here = in_half(loaded.scenario, half)
        assert [chassis_of(here, f"{ours}{number}").size_m for number in (1, 2, 3)] == [0.075, 0.075, 0.09]
        assert {chassis_of(here, f"{theirs}{number}").drive for number in (1, 2, 3)} == {"differential"}
        assert devices_of(here, f"{ours}3").keys() == {"team emitter"}
        assert devices_of(here, f"{ours}1").keys() == {"team emitter", "m0", "m1", "m2", "m3"}


def test_programs_find_the_devices_that_were_designed_in_both_halves(played):
    *_, outcome = played
    logs = {name: (outcome.folder / "logs" / f"{name}.log").read_text("utf-8") for name in ("B1", "Y1", "Y3")}
    assert "B1 ['m0', 'm1', 'm2', 'm3', 'team emitter']" in logs["B1"]
    assert "Y1 ['m0', 'm1', 'm2', 'm3', 'team emitter']" in logs["Y1"]
    assert "Y3 ['team emitter']" in logs["Y3"]


def test_record_holds_the_designs_and_reads_them_again_with_overrides(played):
    _, loaded, _, outcome = played
    recorded = read_scenario(outcome.folder)
    assert recorded == loaded.scenario
    again = load_recorded(loaded.resolved, loaded.unresolved, ["match.half_s=3"]).scenario
    assert again.kits == recorded.kits
    assert read_result(outcome.folder).complete


def test_designs_of_a_scenario_that_has_them_already_change_nothing(played):
    _, loaded, teams, _ = played
    assert with_designs(loaded, teams).scenario == loaded.scenario


def test_match_without_designs_is_the_same_as_ever(tmp_path):
    place, base = Place(tmp_path), load_text(GUIDELINES)
    teams = {seat: team(place, None, base.scenario) for seat in base.scenario.entrants}
    assert with_designs(base, teams) is base


def test_file_does_not_count_where_no_guideline_asks_for_it(tmp_path):
    place, base = Place(tmp_path), load_text(GUIDELINES.replace("blue: {design: workshop}", "blue: {title: Blues}"))
    teams = {seat: team(place, TWO, base.scenario) for seat in base.scenario.entrants}
    assert base.scenario.entrants["blue"].kits == with_designs(base, teams).scenario.entrants["blue"].kits


@pytest.mark.parametrize("text", ["nonsense", design(", mass_kg: 3"), design(", wheel_ring_m: 1.0e-9")])
def test_invalid_design_plays_no_match(tmp_path, text):
    place, base = Place(tmp_path), load_text(GUIDELINES)
    with pytest.raises(DiagnosticError):
        with_designs(base, {"blue": team(place, text, base.scenario)})


def test_each_member_of_a_super_team_drives_its_own_design(tmp_path):
    place, base = Place(tmp_path), load_text(GUIDELINES)
    texts = design(", size_m: 0.08"), design(", size_m: 0.09"), None
    super_team = SuperTeam(tuple(team(place, text, base.scenario) for text in texts))
    scenario = in_half(with_designs(base, {"blue": super_team}).scenario, 1)
    assert [chassis_of(scenario, name).size_m for name in ("B1", "B2", "B3")] == [0.08, 0.09, 0.075]
    assert chassis_of(scenario, "B3").drive == "differential"
