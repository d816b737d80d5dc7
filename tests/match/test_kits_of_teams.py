"""Teams with kits of their own, which they take along when they change sides."""

import pytest

from rcj_challenges.match.rejudge import differences, recorded, rejudge
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.run_record import read_run
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.replay.things import bodies_in, visible_things
from rcj_challenges.views.sheet import sheet_markdown
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.scene import build_scene
from rcj_challenges.world import contact
from tests.match.playing import Place

TEXT = """
schema_version: 2
id: kits
title: Kits
extends: match
match: {halves: 2, half_s: 2}
kits:
  round:
    chassis: {drive: omni}
    devices: {front motor: {device: motor, wheel: 0}, rear motor: {device: motor, wheel: 2}}
entrants:
  blue: {kits: [round, round, v2]}
"""
PROGRAM = """
from controller import Robot
robot = Robot()
print(robot.getName(), sorted(robot.devices)[0])
while robot.step(32) != -1:
    pass
"""


def test_kits_follow_the_team() -> None:
    scenario = load_text(TEXT).scenario
    for half, ours, theirs in ((1, "B", "Y"), (2, "Y", "B"), (3, "B", "Y")):
        kinds = {name: chassis_of(in_half(scenario, half), name).drive for name in scenario.robots}
        assert kinds[f"{ours}1"] == kinds[f"{ours}2"] == "omni"
        assert kinds[f"{ours}3"] == kinds[f"{theirs}1"] == kinds[f"{theirs}2"] == kinds[f"{theirs}3"] == "differential"


def test_scenario_in_which_no_team_has_kits_is_the_same_in_every_half() -> None:
    scenario = load_text(TEXT.replace("kits: [round, round, v2]", "title: Blues")).scenario
    assert in_half(scenario, 2) is scenario


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    place = Place(tmp_path_factory.mktemp("kits"))
    team = place.team_folder(PROGRAM)
    return place.play("match.halves=2", "match.half_s=2", blue=team, yellow=team, scenario=TEXT)


def test_programs_find_the_devices_of_their_robots_in_both_halves(run) -> None:
    assert "B1 front motor" in run.log("B1")
    assert "B1 ball receiver" in run.log("B1")
    assert run.log("B1").index("front motor") < run.log("B1").index("ball receiver")
    assert run.log("Y1").index("ball receiver") < run.log("Y1").index("front motor")


def test_record_is_judged_the_same_again(run) -> None:
    found = read_run(run.folder)
    trajectory = run.trajectory
    _, events = recorded(trajectory, found.log, {"blue": 0, "yellow": 0})
    assert differences(events, rejudge(trajectory, found.scenario).events) == []


def test_pages_and_videos_show_the_bodies_of_each_half(run) -> None:
    scenario = read_scenario(run.folder)
    first, second = (bodies_in(scenario, half) for half in (1, 2))
    assert (len(first["0"]["wheels"]), len(second["0"]["wheels"])) == (4, 2)
    assert (len(first["3"]["wheels"]), len(second["3"]["wheels"])) == (2, 4)
    assert [len(one["wheels"]) for one in visible_things(scenario)["entities"][:6]] == [4, 4, 2, 2, 2, 2]
    footage = Footage.open(run.folder)
    for half, wheels in ((1, [4, 4, 2, 2, 2, 2]), (2, [2, 2, 2, 4, 4, 2])):
        model = build_scene(footage.dressed(half), (64, 48), fine=False)
        groups = model.geom_group
        found = [
            int((groups[model.geom_bodyid == model.body(name).id] == contact.GROUP_WHEELS).sum())
            for name in scenario.robots
        ]
        assert dict(zip(scenario.robots, found, strict=True)) == dict(
            zip(("B1", "B2", "B3", "Y1", "Y2", "Y3"), wheels, strict=True)
        )


def test_sheet_says_that_teams_take_their_robots_along() -> None:
    loaded = load_text(TEXT)
    sheet = sheet_markdown(loaded.scenario, loaded.roster)
    assert "Teams take their robots along when they change sides" in sheet
    assert "Kit round: " in sheet


@pytest.mark.parametrize(
    ("change", "code", "path"),
    [
        ("kits: [round, v2]", "wrong-value", "entrants.blue.kits"),
        ("kits: [round, round, square]", "unknown-name", "entrants.blue.kits[2]"),
        (
            "kits: [v2, v2, round]}\n  yellow: {}\nrobots:\n  Y3: {devices: {m: {device: motor, wheel: left}}",
            "wrong-value",
            "robots.Y3.devices.m.wheel",
        ),
    ],
)
def test_kits_that_do_not_fit_are_refused(change: str, code: str, path: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        load_text(TEXT.replace("kits: [round, round, v2]", change))
    assert (code, path) in [(one.code, one.where.path) for one in caught.value.diagnostics]
