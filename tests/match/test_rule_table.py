"""One test per row of the rule table: its limit is changed in the YAML, and the reflog changes.

The same without physics and programs, and so in the suite: `tests/referee/test_match_rules.py`.
"""

import pytest

from tests.match.programs import AHEAD

pytestmark = pytest.mark.nightly

YELLOW_KICKS_OFF = 3  # the seed with which yellow draws the kick-off

# A clear way for yellow's third robot: it kicks off and drives straight ahead, the ball before it.
CLEAR_WAY = (
    *(f"robots.{robot}.start.x_m={x}" for robot, x in (("B1", 0.5), ("B2", -0.5), ("B3", 0.35))),
    "robots.B3.start.noise_m=[0,0]",
    "robots.B1.start.noise_m=[0,0]",
    "robots.B2.start.noise_m=[0,0]",
)


def times(lines):
    return [line["matchtime"] for line in lines]


def test_goal_zone_decides_when_it_is_a_goal(play, team_folder):
    def goal(*overrides):
        return play(*CLEAR_WAY, *overrides, seed=YELLOW_KICKS_OFF, yellow=team_folder(AHEAD)).events("GOAL")

    late, early = goal(), goal("zones.blue_goal.y_min_m=0.3")
    assert late[0]["payload"] == {"team_name": "Testers", "score_yellow": 1, "score_blue": 0}
    assert times(early)[0] < times(late)[0] - 0.5


def test_goal_pause_decides_when_the_conceding_team_kicks_off(play, team_folder):
    def kickoffs(pause_s):
        run = play(*CLEAR_WAY, f"goal_pause_s={pause_s}", "match.half_s=9", seed=YELLOW_KICKS_OFF,
                   yellow=team_folder(AHEAD))  # fmt: skip
        goal = times(run.events("GOAL"))[0]
        return [
            (line["payload"]["robot_name"], round(line["matchtime"] - goal, 3)) for line in run.events("KICKOFF")[1:2]
        ]

    assert kickoffs(3) == [("B3", 3.008)]  # 94 ticks
    assert kickoffs(1) == [("B3", 1.024)]  # 32 ticks


@pytest.mark.parametrize(("window_s", "first_s"), [(3, 3.04), (2, 2.048)])
def test_lack_of_progress_of_a_robot_comes_when_its_window_is_full(play, window_s, first_s):
    calls = play(f"robot_progress_s={window_s}", "ball_progress_s=5").events("LACK_OF_PROGRESS")
    assert times(calls)[0] == first_s
    assert {line["payload"]["robot_name"] for line in calls[:6]} == {"B1", "B2", "B3", "Y1", "Y2", "Y3"}


def test_the_first_calls_of_the_shipped_match_come_at_10_05_and_15_04_s(play):
    calls = play("match.half_s=15.1").events("LACK_OF_PROGRESS")
    assert calls[0]["payload"] == {"type": "ball"}
    assert calls[0]["matchtime"] == 10.048
    assert times([line for line in calls if line["payload"]["type"] == "robot"])[0] == 15.04


@pytest.mark.parametrize("window_s", [2, 4])
def test_lack_of_progress_of_the_ball_comes_when_its_window_is_full(play, window_s):
    calls = play(f"ball_progress_s={window_s}").events("LACK_OF_PROGRESS")
    assert calls[0]["payload"] == {"type": "ball"}
    assert window_s < calls[0]["matchtime"] < window_s + 0.07


def test_out_of_the_field_is_where_the_pitch_ends(play, team_folder):
    def calls(*overrides):
        return play(*overrides, "robot_progress_s=5", "ball_progress_s=5", yellow=team_folder(AHEAD)).events(
            "LACK_OF_PROGRESS"
        )

    assert calls() == []
    left = calls("zones.pitch.y_max_m=-0.1")
    assert left
    assert all(line["payload"]["type"] == "robot" for line in left)


def test_penalty_area_is_left_within_its_limit(play):
    def calls(limit_s):
        run = play("robots.Y1.start.y_m=-0.66", "robots.Y1.start.x_m=-0.2", "robots.Y1.start.noise_m=[0,0]",
                   f"penalty_area_s={limit_s}", "robot_progress_s=5")  # fmt: skip
        return run.events("INSIDE_PENALTY_FOR_TOO_LONG")

    soon = calls(2)
    assert [line["payload"] for line in soon] == [{"type": "robot", "robot_name": "Y1"}]
    assert 2 < soon[0]["matchtime"] < 2.1
    assert calls(4)[0]["matchtime"] >= 4


def test_a_robot_put_back_too_often_is_taken_off_as_damaged(play):
    def damaged(put_backs):
        run = play("robot_progress_s=1", "ball_progress_s=5", f"damaged_after_put_backs={put_backs}")
        return run.events("ROBOT_DAMAGED")

    once, never = damaged(1), damaged(5)
    assert {line["payload"]["robot_name"] for line in once} == {"B1", "B2", "B3", "Y1", "Y2", "Y3"}
    assert never == []


def test_a_damaged_robot_comes_back_after_its_time(play):
    run = play("robot_progress_s=1", "ball_progress_s=5", "damaged_after_put_backs=1", "damaged_for_s=1")
    off = times(run.events("ROBOT_DAMAGED"))[0]
    track = run.trajectory
    snapshots = {snapshot.tick: snapshot for snapshot in track.snapshots(1)}
    name = run.events("ROBOT_DAMAGED")[0]["payload"]["robot_name"]
    entity = track.entities.index(name)
    tick = round(off / 0.032)
    assert abs(snapshots[tick + 1].substeps[-1][entity][0]) > 1.0  # parked
    assert abs(snapshots[tick + 33].substeps[-1][entity][0]) < 0.66  # back on the field


def test_the_half_has_the_length_that_the_yaml_says(play):
    for length_s in (2, 3):
        run = play(f"match.half_s={length_s}")
        start, finish = run.events("MATCH_START")[0], run.events("MATCH_FINISH")[0]
        assert start["matchtime"] == 0
        assert length_s <= finish["matchtime"] < length_s + 0.032
        assert start["payload"]["total_match_time"] == length_s


def test_the_kickoff_stands_before_the_start_in_the_log(play):
    assert [line["event"] for line in play("match.half_s=1").reflog[:2]] == ["KICKOFF", "MATCH_START"]


def test_the_other_team_kicks_off_the_second_half(play):
    run = play("match.halves=2", "match.half_s=1")
    seats = [line["payload"]["team_name"] for line in run.events("KICKOFF")]
    names = [line["payload"]["team_name_blue"] for line in run.events("MATCH_START")]
    assert len(set(seats)) == 1  # the same seat, in which the other team now sits
    assert len(names) == 2
    assert [half["sides"] for half in run.result["halves"]] == [
        {"blue": "blue", "yellow": "yellow"},
        {"blue": "yellow", "yellow": "blue"},
    ]
