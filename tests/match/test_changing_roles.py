"""Two against one, then the other way round: teams that change sides take over the seats as they are."""

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load_text
from rcj_challenges.submissions.archive import TeamError
from rcj_challenges.submissions.team import open_team
from rcj_challenges.views.sheet import sheet_markdown

DUEL = """schema_version: 2
id: duel
title: Duel
extends: soccersim_v2
match: {halves: 2, half_s: 0.1, swap_sides: true}
robots: {B2: null, B3: null, Y3: null}
entrants:
  blue: {robots: {B1: defend.py, B2: null, B3: null}}
  yellow: {robots: {Y1: attack.py, Y2: attack.py, Y3: null}}
counters: {runs: {per: robots}}
rules:
  counted:
    triggers: [{trigger: half_started}]
    actions:
      - {action: count, counter: runs, entity: B1, by: 100}
      - {action: count, counter: runs, entity: Y1, by: 10}
      - {action: count, counter: runs, entity: Y2}
      - {action: score, entrant: yellow, points: {word: halftime}}
result: {rank: [{sum: {counter: runs, entity: each}, better: more, says: R}, {score: each, better: more}]}
"""
DRIVES = "from controller import Robot\nrobot = Robot()\nprint('{team} {does} as', robot.getName())\nrobot.step(32)\n"


@pytest.fixture(scope="module")
def duel():
    return load_text(DUEL)


def submission(folder, team, *does):
    (folder / team).mkdir()
    for one in does:
        (folder / team / f"{one}.py").write_text(DRIVES.format(team=team, does=one), encoding="utf-8")
    return folder / team


@pytest.fixture(scope="module")
def played(duel, tmp_path_factory):
    folder = tmp_path_factory.mktemp("duel")
    given = {seat: submission(folder, team, "attack", "defend") for seat, team in (("blue", "Ada"), ("yellow", "Ben"))}
    seats = tuple(duel.scenario.entrants.values())
    teams = {seat: open_team(path, *seats) for seat, path in given.items()}
    return play_match(MatchPlan(duel, teams, {}, seed=1, out=folder / "runs"))


@pytest.mark.parametrize(
    ("robot", "said"),
    [("B1", ["Ada defend", "Ben defend"]), ("Y1", ["Ben attack", "Ada attack"]), ("Y2", ["Ben attack", "Ada attack"])],
)
def test_in_the_second_half_the_other_team_drives_each_robot_of_the_seat(played, robot, said):
    log = (played.folder / "logs" / f"{robot}.log").read_text("utf-8")
    assert [log.index(f"{one} as {robot}") for one in said] == sorted(log.index(f"{one} as {robot}") for one in said)
    assert log.count(f" as {robot}") == 2


def test_points_and_counters_count_for_the_team_that_drove(played):
    assert played.result["score"] == {"blue": 2, "yellow": 1}
    # 100 as the one, 11 as the two, in either order.
    ranked = [(entry["place"], entry["team"], entry["values"]) for entry in played.result["ranking"]]
    assert ranked == [(1, "blue", [111, 2]), (2, "yellow", [111, 1])]
    assert [half["sides"]["blue"] for half in played.result["halves"]] == ["blue", "yellow"]


def test_the_sheet_asks_each_team_for_all_programs(duel):
    said = "each of them hands in the programs of both"
    assert said in sheet_markdown(duel.scenario, duel.roster)
    once = load_text(DUEL.replace("halves: 2", "halves: 1"))
    assert said not in sheet_markdown(once.scenario, once.roster)


def test_a_team_without_the_programs_of_the_other_seat_is_refused(duel, tmp_path):
    with pytest.raises(TeamError, match=r"attack\.py"):
        open_team(submission(tmp_path, "Cem", "defend"), *duel.scenario.entrants.values())
