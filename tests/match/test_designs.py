"""Matches of teams that have designed their robots."""

import time

import pytest
from typer.testing import CliRunner

from rcj_challenges.checker.designs import check_designs
from rcj_challenges.cli.commands import load_app
from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.match.designs import with_designs
from rcj_challenges.match.rejudge import differences, recorded, rejudge
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.records.folder import REPLAY
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.referee_log import read_referee_log
from rcj_challenges.records.result import read_result
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.scenario.designs import ROBOT_FILE
from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.kits import chassis_of, devices_of
from rcj_challenges.scenario.load import load_recorded, load_text
from rcj_challenges.submissions.team import SuperTeam, open_team
from rcj_challenges.tournament.site.public import read_replay
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.video.footage import Footage
from tests.match.playing import Place
from tests.scenario.test_designs import GUIDELINES, HOSTILE, design

PROGRAM = """
from controller import Robot
robot = Robot()
print(robot.getName(), sorted(robot.devices))
while robot.step(32) != -1:
    pass
"""
FOUR_A_SIDE = """robots:
  B4: {colour: blue, number: 4, kit: v2, start: {x_m: -0.45, y_m: 0.4, yaw_rad: -1.57}}
  Y4: {colour: yellow, number: 4, kit: v2, start: {x_m: 0.45, y_m: -0.4, yaw_rad: 1.57}}
"""
WITH_FOUR = (
    GUIDELINES.replace("design: workshop}", "design: workshop, robots: {B4: robot1/robot1.py}}", 1).replace(
        "yellow: {design: workshop}", "yellow: {design: workshop, robots: {Y4: robot1/robot1.py}}"
    )
    + FOUR_A_SIDE
)
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


def test_record_is_judged_and_played_again_with_the_designs_of_both_halves(played):
    *_, teams, outcome = played
    trajectory, scenario = Trajectory.open(outcome.folder), read_scenario(outcome.folder)
    _, events = recorded(trajectory, read_referee_log(outcome.folder), read_result(outcome.folder).score)
    assert differences(events, rejudge(trajectory, scenario).events) == []
    given = [word for team in teams.values() for word in ("--team", str(team.source))]
    done = CliRunner().invoke(load_app(), ["verify", str(outcome.folder), *given])
    assert done.exit_code == 0


def test_replay_page_and_video_show_each_body_where_its_team_plays(played):
    *_, outcome = played
    write_replay(outcome.folder)
    facts = read_replay((outcome.folder / REPLAY).read_text("utf-8")).facts
    footage = Footage.open(outcome.folder)
    sizes = {"striker": 0.075, "goalie": 0.09, "usual": 0.075}
    wheels = {"striker": 4, "goalie": 4, "usual": 2}
    ours, theirs = ("striker", "striker", "goalie"), ("usual",) * 3
    for half, wanted in ((1, ours + theirs), (2, theirs + ours)):
        on_page = facts["halves"][half - 1]["bodies"]
        in_video = footage.dressed(half).things["entities"]
        for number, name in enumerate(wanted):
            for looks in (on_page[str(number)], in_video[number]):
                assert (looks["size_m"], len(looks["wheels"])) == (sizes[name], wheels[name])


def test_super_team_of_four_plays_with_four_designs_on_both_sides(tmp_path):
    place, base = Place(tmp_path), load_text(WITH_FOUR)
    sizes_m = [0.07, 0.08, 0.085, 0.09]
    members = tuple(team(place, design(f", size_m: {size_m}"), base.scenario) for size_m in sizes_m)
    scenario = with_designs(base, {"blue": SuperTeam(members)}).scenario
    for half, ours in ((1, "B"), (2, "Y")):
        here = in_half(scenario, half)
        assert [chassis_of(here, f"{ours}{number}").size_m for number in (1, 2, 3, 4)] == sizes_m


@pytest.mark.parametrize("data", HOSTILE.values(), ids=HOSTILE)
def test_run_and_check_refuse_a_hostile_file_for_the_same_reasons_within_a_second(tmp_path, data):
    place, base = Place(tmp_path), load_text(GUIDELINES)
    ours = team(place, None, base.scenario)
    (ours.source / ROBOT_FILE).write_bytes(data)
    ours = open_team(ours.source, *base.scenario.entrants.values())
    began = time.process_time()
    with pytest.raises(DiagnosticError) as caught:
        with_designs(base, {"blue": ours})
    between = time.process_time()
    stage = check_designs(ours, base)
    ended = time.process_time()
    assert max(between - began, ended - between) < 1
    assert {one.code for one in caught.value.diagnostics} == {one.code for one in stage.findings} != set()
    assert stage.level == "error"
