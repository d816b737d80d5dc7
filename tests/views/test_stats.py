"""Figures of runs: each is what its definition says."""

import contextlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.play import Event, Fault, Firing, HalfInfo, Placement, RefereeOutput, Snapshot
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.stats import merge_stats, run_stats, stats_as_json
from rcj_challenges.views.stats.ends import attacked_ends, own_end
from rcj_challenges.views.stats.motion import motion_of, play_mask
from rcj_challenges.views.stats.touches import Contacts, Goals, Shot, owners, shots_of, touch_ends
from tests.made_up_runs import (
    GOAL_EVERY_TICKS,
    begun_run,
    small_scenario,
    with_changes,
    write_made_up_run,
    write_run,
)

UP, DOWN, BOTH = frozenset({1}), frozenset({-1}), frozenset({1, -1})
GOALS = Goals(0.75, 0.59, {1: 0.4, -1: 0.4})
TICK_S = 0.032


def contacts(*touched: tuple[int, int]) -> Contacts:
    """Contacts in the last sub-step of ticks: (tick, robot)."""
    return Contacts(np.array([4 * tick - 1 for tick, _ in touched], int), np.array([r for _, r in touched], int))


def rolling(ticks: int, touched_at: int, start: tuple[float, float], velocity: tuple[float, float]) -> np.ndarray:
    """Places of a ball that lies still until a tick and then rolls straight on."""
    places = np.tile(np.array(start), (ticks, 1))
    for tick in range(touched_at + 1, ticks + 1):
        places[tick - 1] = np.array(start) + (tick - touched_at) * TICK_S * np.array(velocity)
    return places


# --- which end -----------------------------------------------------------------------------------------------------------


def test_a_field_without_goals_has_no_attacked_ends() -> None:
    # The robots of empty_field start in halves of their own, and no rule says what a ball at an end is worth.
    text = "schema_version: 2\nid: it\ntitle: It\nextends: %s\nmatch: {half_s: 60}\n"
    ends = {}
    for base in ("empty_field", "soccersim_v2"):
        loaded = load_text(text % base)
        ends[base] = attacked_ends(loaded.scenario, loaded.roster)
    assert ends["empty_field"] == {"blue": frozenset(), "yellow": frozenset()}
    assert ends["soccersim_v2"] == {"blue": DOWN, "yellow": UP}


@pytest.mark.parametrize(
    ("name", "ends"),
    [
        ("match", {"blue": DOWN, "yellow": UP}),
        ("fast_shooter", {"yellow": UP}),
        ("precision_lidar", {"yellow": BOTH}),
    ],
)
def test_a_seat_attacks_the_end_where_the_rules_give_it_points(name: str, ends: dict) -> None:
    loaded = load(name)
    assert attacked_ends(loaded.scenario, loaded.roster) == ends
    assert own_end(UP) == -1
    assert own_end(BOTH) is None


@pytest.mark.parametrize(
    ("each", "trigger"),
    [("goals", "entity: ball, zone: each"), ("balls", "entity: each, zone: goals")],
)
def test_a_rule_over_goals_or_balls_gives_points_at_the_ends_of_all_its_goals(each: str, trigger: str) -> None:
    loaded = load_text(
        "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\ngroups: {goals: [blue_goal, yellow_goal]}\n"
        f"rules: {{goal: {{for_each: {each}, triggers: [{{trigger: enters, {trigger}}}], "
        "actions: [{action: score, entrant: yellow}]}}\n"
    )
    assert attacked_ends(loaded.scenario, loaded.roster)["yellow"] == BOTH


GOAL_RULES = """schema_version: 2
id: goals
title: Goals
extends: soccersim_v2
rules:
  goal:
    {each}triggers: [{{trigger: enters, entity: ball, zone: yellow_goal}}]
    conditions: [{{last_touch: ball, equals: {by}}}]
    actions: [{{action: score, entrant: {who}}}]
"""


@pytest.mark.parametrize(
    ("each", "by", "who", "ends"),
    [
        # Against the way they start: only the rule can tell.
        ("for_each: yellow\n    ", "each", "each", {"yellow": {-1}, "blue": set()}),
        ("", "yellow", "yellow", {"yellow": {-1}, "blue": set()}),
        # Of the last to touch it nothing is known beforehand: each attacks the end at which the others start.
        ("", "robots", "{last_touch: ball}", {"yellow": {1}, "blue": {-1}}),
    ],
)
def test_an_end_is_attacked_by_teams_that_may_get_points_there(each, by, who, ends):
    loaded = load_text(GOAL_RULES.format(each=each, by=by, who=who))
    assert attacked_ends(loaded.scenario, loaded.roster) == ends


@pytest.mark.parametrize(
    ("zone", "end"),
    [
        ("shape: rect, y_min_m: 0.65", 1),
        ("shape: rect, y_max_m: -0.65", -1),
        ("shape: circle, centre_m: [0, 0.7], radius_m: 0.1", 1),
        ("shape: circle, centre_m: [0, -0.7], radius_m: 0.1", -1),
        ("shape: polygon, points_m: [[0, 0.6], [0.2, 0.74], [-0.2, 0.74]]", 1),
        ("shape: polygon, points_m: [[0, -0.6], [0.2, -0.74], [-0.2, -0.74]]", -1),
        ("shape: half_plane, through_m: [0, 0.7], normal: [0, 1]", 1),
        ("shape: half_plane, through_m: [0, -0.7], normal: [0, -1]", -1),
    ],
)
def test_a_zone_in_which_a_team_gets_points_lies_at_the_end_that_it_attacks(zone, end):
    team = "blue" if end == 1 else "yellow"  # against the way they start
    rules = GOAL_RULES.format(each="", by=team, who=team).replace("yellow_goal", "there")
    loaded = load_text(f"{rules}zones: {{there: {{{zone}}}}}\n")
    assert attacked_ends(loaded.scenario, loaded.roster)[team] == {end}


# --- touches -------------------------------------------------------------------------------------------------------------


def test_contacts_close_to_each_other_are_one_touch() -> None:
    made = contacts((10, 0), (12, 0), (13, 1), (18, 0), (25, 0))  # ticks; 0.2 s are 6.25
    assert touch_ends(made, 0) == [18, 25]
    assert touch_ends(made, 1) == [13]
    assert touch_ends(made, 2) == []


def test_who_touched_the_ball_last_has_it_until_another_touches_it_or_it_is_put_elsewhere() -> None:
    found = owners(contacts((3, 0), (5, 1), (6, 1), (9, 2)), ["blue", "yellow", "blue"], 12, [7])
    assert found.tolist() == [-1, -1, 0, 0, 1, 1, 1, -1, 2, 2, 2, 2]


def test_ball_touched_by_two_teams_at_once_stays_with_its_owner() -> None:
    both = Contacts(np.array([3, 19, 19]), np.array([0, 0, 1]))
    assert owners(both, ["blue", "yellow"], 6, []).tolist() == [0, 0, 0, 0, 0, 0]
    assert owners(Contacts(np.array([3, 3]), np.array([0, 1])), ["blue", "yellow"], 2, []).tolist() == [-1, -1]


@given(
    touched=st.lists(st.tuples(st.integers(1, 40), st.integers(0, 2)), max_size=12).map(sorted),
    placed_at=st.lists(st.integers(0, 40), max_size=4),
)
def test_the_owner_is_always_the_last_to_touch_the_ball(touched: list, placed_at: list) -> None:
    made = contacts(*touched)
    seats = ["blue", "blue", "yellow"]
    found = owners(made, seats, 40, placed_at)
    for row in range(40):
        since = max([tick for tick in placed_at if tick <= row], default=0)
        before = [(tick, robot) for tick, robot in touched if since < tick <= row + 1]
        if not before:
            assert found[row] == -1
        elif found[row] >= 0:
            assert found[row] in {robot for _, robot in before}
            last = [seats[robot] for tick, robot in before if tick == before[-1][0]]
            if len(set(last)) == 1:
                assert seats[found[row]] == last[0]


# --- shots ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("start", "velocity", "shot"),
    [
        ((0.0, 0.5), (0.0, 0.3), True),  # 0.83 s to the line, between the posts
        ((0.0, 0.5), (0.3, 0.3), False),  # crosses it beside the goal
        ((0.0, 0.0), (0.0, 0.3), None),  # 2.5 s: too slow for a shot
        ((0.0, 0.2), (0.0, 0.3), True),
        ((0.0, 0.5), (0.9, 0.3), None),  # meets the side wall before
        ((0.0, 0.5), (0.0, -0.9), None),  # goes to the own end
        ((0.0, 0.5), (0.3, 0.0), None),
    ],
)
def test_a_shot_would_cross_the_goal_line_within_two_seconds(start: tuple, velocity: tuple, shot: bool | None) -> None:
    places = rolling(20, 10, start, velocity)
    assert shots_of(contacts((10, 0)), places, [], {0: UP}, GOALS) == ([] if shot is None else [Shot(10, 0, shot)])


def test_a_ball_that_is_touched_or_put_elsewhere_too_soon_was_no_shot() -> None:
    places = rolling(20, 10, (0, 0.5), (0, 0.3))
    assert not shots_of(contacts((10, 0), (12, 1)), places, [], {0: UP}, GOALS)
    assert not shots_of(contacts((10, 0)), places, [11], {0: UP}, GOALS)
    assert not shots_of(contacts((10, 0)), places[:11], [], {0: UP}, GOALS)
    assert shots_of(contacts((10, 0), (13, 1)), places, [], {0: UP}, GOALS)


def test_the_last_touch_before_a_goal_is_a_shot_on_goal_however_long_the_ball_took() -> None:
    slow = rolling(200, 10, (0, 0.3), (0, 0.1))
    assert shots_of(contacts((10, 0)), slow, [], {0: UP}, GOALS) == [Shot(10, 0, on_goal=True)]
    carried = contacts(*((tick, 0) for tick in range(10, 201)))
    assert [shot.on_goal for shot in shots_of(carried, slow, [], {0: UP}, GOALS)] == [True]
    assert not shots_of(contacts((10, 0)), slow, [], {0: DOWN}, GOALS)  # an own goal is no shot
    assert not shots_of(contacts((10, 0)), slow, [50], {0: UP}, GOALS)  # it was put there


def test_a_shot_that_went_in_is_counted_once() -> None:
    # Sent beside the goal, it came in off something.
    places = rolling(60, 10, (0.0, 0.5), (0.3, 0.3))
    places[30:] = (0.1, 0.8)
    assert shots_of(contacts((10, 0)), places, [], {0: UP}, GOALS) == [Shot(10, 0, on_goal=True)]


# --- motion --------------------------------------------------------------------------------------------------------------


def track(places: np.ndarray, placements: dict[int, tuple[Placement, ...]]) -> HalfTrack:
    ticks, entities, _ = places.shape
    poses = np.concatenate([places, np.zeros((ticks, entities, 1))], axis=2).astype(np.float32)
    start = Snapshot(0, [[tuple(pose) for pose in poses[0].tolist()]], [0.0] * entities, [1.0] * entities, ())
    counts, pairs = np.zeros((ticks, 4), np.uint16), np.zeros((0, 2), np.uint16)
    info = HalfInfo(1, 1, ticks, 1, 0, {}, {}, {})
    return HalfTrack(
        info, start, np.repeat(poses[:, None], 4, axis=1), np.zeros((ticks, entities)), np.ones((ticks, entities)),
        counts, pairs, placements, {},
    )  # fmt: skip


def test_being_put_elsewhere_is_no_way_and_beside_the_field_nothing_counts() -> None:
    places = np.zeros((6, 1, 2))
    places[:, 0, 0] = [0.0, 0.1, 0.6, 0.7, 5.0, 5.0]
    placements = {2: (Placement(0, 0.5, 0.0, 0.0),), 4: (Placement(0, 5.0, 5.0, 0.0, parked=True),)}
    motion = motion_of(track(places, placements))
    assert motion.steps_m[:, 0].tolist() == pytest.approx([0, 0.1, 0.1, 0.1, 0, 0], abs=1e-6)
    assert motion.on_field[:, 0].tolist() == [True] * 4 + [False] * 2


def test_a_number_that_is_no_number_at_all_is_no_way_either() -> None:
    half = track(np.zeros((3, 1, 2), np.float32), {})
    # A signalling NaN, as a damaged file may hold it: numpy warns when it becomes a float64.
    half.substeps[1].view(np.uint32)[...] = 0x7FA00000
    assert motion_of(half).steps_m.sum() == 0


def test_play_excludes_phases_that_wait_for_a_kick_off() -> None:
    play = play_mask(6, [(0, "play", False), (2, "kickoff", True), (4, "play", False)])
    assert play.tolist() == [True, True, False, False, True, True]
    assert play_mask(2, []).tolist() == [True, True]


# --- runs ----------------------------------------------------------------------------------------------------------------


@pytest.fixture
def record(tmp_path: Path) -> Callable[..., Path]:
    """Write a run of one half: B1 and Y1; touches of the ball (or of one of several bodies) and outputs are given by tick."""

    def write(
        ticks: int,
        touches: dict[int, int | tuple[int, int]],
        outputs: dict[int, RefereeOutput] | None = None,
        faults: tuple[Fault, ...] = (),
        scenario: Scenario | None = None,
    ) -> Path:
        made = scenario or small_scenario(1, 1)
        output, play = RefereeOutput(), []
        for tick in range(ticks + 1):
            balls = [(0.1 * number, 0.0, 0.0) for number in range(len(made.balls))]
            poses = [(0.3, 0.3, 0.0), (-0.3, -0.3 + 0.004 * tick, 0.0), *balls]
            touched = touches.get(tick)
            touching = () if touched is None else (touched if isinstance(touched, tuple) else (touched, 2),)
            heights = [0.0375, 0.0375, *[0.021] * len(balls)]
            failed = tuple(fault for fault in faults if fault.tick == tick)
            snapshot = Snapshot(tick, [poses] * 4, heights, [1.0] * len(poses), (touching, (), (), touching), failed)
            waiting = RefereeOutput(phase=output.phase, waiting_for_kickoff=output.waiting_for_kickoff)
            output = (outputs or {}).get(tick, waiting)
            play.append((snapshot, output))
        return write_run(tmp_path, made, lambda half: with_changes(play, half.scores), ticks=ticks)

    return write


def test_possession_is_the_share_of_play_since_the_last_touch(record: Callable[..., Path]) -> None:
    # 100 ticks of which 41..60 are a pause: blue has the ball from 11 to 40, yellow from 61 on.
    outputs = {40: RefereeOutput(phase="pause", waiting_for_kickoff=True), 60: RefereeOutput()}
    stats = run_stats(record(100, {11: 0, 61: 1}, outputs))
    assert stats.play_ticks == 80
    exported = stats_as_json(stats)["teams"]
    assert exported["Hanse"]["possession"] == 37.5
    assert exported["Alster"]["possession"] == 50.0
    assert exported["Alster"]["touches"] == 1


def with_balls(*names: str) -> Scenario:
    """Return the scenario of two robots with other balls."""
    made = small_scenario(1, 1)
    ball = next(iter(made.balls.values()))
    balls = {name: ball.model_copy(update={"start_m": (0.1 * at, 0.0)}) for at, name in enumerate(names)}
    return made.model_copy(update={"balls": balls, "rules": {}})


def test_of_several_balls_possession_is_the_mean_so_that_all_shares_are_100_at_most(
    record: Callable[..., Path],
) -> None:
    # 100 ticks: blue has the first ball from 21 on and the second one from 61 on; yellow has the third one from 51 on.
    stats = run_stats(record(100, {21: (0, 2), 61: (0, 3), 51: (1, 4)}, scenario=with_balls("one", "two", "three")))
    exported = stats_as_json(stats)["teams"]
    assert exported["Hanse"]["possession"] == exported["Hanse"]["robots"]["B1"]["possession"] == 40.0
    assert exported["Alster"]["possession"] == pytest.approx(50 / 3, abs=0.05)
    twice = stats_as_json(merge_stats([stats, stats]))["teams"]
    assert twice["Hanse"]["possession"] == 40.0


def test_way_and_speeds_are_those_of_play(record: Callable[..., Path]) -> None:
    pause = {50: RefereeOutput(phase="pause", waiting_for_kickoff=True)}
    exported = stats_as_json(run_stats(record(100, {}, pause)))["teams"]["Alster"]
    assert exported["distance_m"] == pytest.approx(0.2, abs=1e-3)
    assert exported["mean_mps"] == exported["max_mps"] == pytest.approx(0.125, abs=1e-3)


def test_the_own_half_is_that_of_the_goal_which_the_team_defends(record: Callable[..., Path]) -> None:
    # Yellow scores at +y, so its own half is y < 0: it drives from there over the middle at tick 75.
    exported = stats_as_json(run_stats(record(100, {})))["teams"]
    assert exported["Alster"]["own_half"] == 74.0
    assert exported["Hanse"]["own_half"] is None  # nothing gives points to blue here


def test_calls_are_counted_for_the_robot_that_the_event_or_the_rule_names(record: Callable[..., Path]) -> None:
    named = RefereeOutput(events=(Event(10, "LACK_OF_PROGRESS", {"type": "robot", "robot_name": "Y1"}),))
    ball = RefereeOutput(events=(Event(20, "LACK_OF_PROGRESS", {"type": "ball"}),))
    goal = RefereeOutput(
        events=(Event(30, "GOAL", {"team_name": "Alster"}),),
        firings=(Firing(30, "goal", None, "enters", scored={"yellow": 1}),),
    )
    start = RefereeOutput(events=(Event(0, "KICKOFF", {"robot_name": "B1"}), Event(0, "MATCH_START")))
    fault = Fault("B1", "crash", 40, 1, "boom")
    stats = run_stats(record(50, {}, {0: start, 10: named, 20: ball, 30: goal}, (fault,)))
    assert stats.teams["Alster"].robots["Y1"].calls == {"LACK_OF_PROGRESS": 1}
    assert stats.teams["Hanse"].robots["B1"].calls == {}
    assert stats.calls == {"LACK_OF_PROGRESS": 1}
    assert stats.teams["Hanse"].robots["B1"].faults == {"crash": 1}
    assert stats.teams["Alster"].points == 1


def test_a_robot_that_changed_sides_is_one_robot(tmp_path: Path) -> None:
    stats = run_stats(write_made_up_run(tmp_path, ticks=60, halves=2))
    assert list(stats.teams["Hanse"].robots) == ["B1/Y1", "B2/Y2", "B3/Y3"]
    assert stats.teams["Hanse"].robots["B1/Y1"].field_ticks == 120
    assert stats.teams["Alster"].robots["Y1/B1"].field_ticks == 120


def test_several_runs_are_added_up_by_team(tmp_path: Path) -> None:
    out = [
        write_made_up_run(tmp_path, ticks=500, halves=1, names=names)
        for names in (("Hanse", "Alster"), ("Alster", "Elbe"))
    ]
    single = [run_stats(folder) for folder in out]
    both = merge_stats(single)
    assert list(both.teams) == ["Hanse", "Alster", "Elbe"]
    assert both.teams["Alster"].runs == 2
    assert both.teams["Alster"].points == sum(one.teams["Alster"].points for one in single)
    assert both.teams["Alster"].total.distance_m == pytest.approx(
        sum(one.teams["Alster"].total.distance_m for one in single)
    )
    assert both.play_ticks == sum(one.play_ticks for one in single)


def test_a_robot_of_a_team_that_was_blue_first_and_then_yellow_first_is_one_robot(tmp_path: Path) -> None:
    out = [
        write_made_up_run(tmp_path, ticks=60, halves=2, names=names)
        for names in (("Hanse", "Alster"), ("Alster", "Hanse"))
    ]
    both = merge_stats([run_stats(folder) for folder in out])
    assert list(both.teams["Hanse"].robots) == ["B1/Y1", "B2/Y2", "B3/Y3"]
    assert list(both.teams["Alster"].robots) == ["Y1/B1", "Y2/B2", "Y3/B3"]
    assert both.teams["Hanse"].robots["B1/Y1"].field_ticks == 240


def test_possession_over_several_runs_is_a_share_of_those_that_the_team_played(record: Callable[..., Path]) -> None:
    one = run_stats(record(100, {11: 0, 61: 1}))  # the first team has the ball for 50 ticks of 100, the second for 40
    other = run_stats(record(300, {151: 0}))
    other.teams = {"Elbe": other.teams["Hanse"], "Weser": other.teams["Alster"]}
    both = stats_as_json(merge_stats([one, other]))
    assert both["play_s"] == pytest.approx(400 * TICK_S)
    assert {name: team["possession"] for name, team in both["teams"].items()} == {
        "Hanse": 50.0, "Alster": 40.0, "Elbe": 50.0, "Weser": 0.0,
    }  # fmt: skip
    assert both["teams"]["Hanse"]["robots"]["B1"]["possession"] == 50.0
    again = stats_as_json(merge_stats([one, one, other]))["teams"]
    assert (again["Hanse"]["possession"], again["Elbe"]["possession"]) == (50.0, 50.0)


def test_several_submissions_of_one_name_are_noted(tmp_path: Path) -> None:
    out = [write_made_up_run(tmp_path, ticks=50, halves=1, names=("Hanse", "Alster")) for _ in range(3)]
    for folder, programs in zip(out, ("a" * 64, "b" * 64, "b" * 64), strict=True):
        result = json.loads((folder / "result.json").read_text("utf-8"))
        result["entrants"]["blue"]["programs"] = programs
        (folder / "result.json").write_text(json.dumps(result), encoding="utf-8")
    note_text = "Hanse: 2 different submissions have this name; they are added up as one team"
    several = [run_stats(folder) for folder in out]
    assert [note for note in merge_stats(several).notes if "submissions" in note] == [note_text]
    assert not [note for note in merge_stats(several[1:]).notes if "submissions" in note]


@pytest.mark.parametrize(
    ("halves", "apart"), [(1, ["Hanse (blue)", "Hanse (yellow)"]), (2, ["Hanse (blue first)", "Hanse (yellow first)"])]
)
def test_two_teams_of_one_name_are_counted_separately_and_noted(tmp_path: Path, halves: int, apart: list[str]) -> None:
    alike = run_stats(write_made_up_run(tmp_path, ticks=450, halves=halves, names=("Hanse", "Hanse")))
    other = run_stats(write_made_up_run(tmp_path, ticks=450, halves=halves, names=("Hanse", "Alster")))
    assert list(alike.teams) == apart
    assert [team.points for team in alike.teams.values()] == [team.points for team in other.teams.values()]
    assert [set(team.robots) for team in alike.teams.values()] == [set(team.robots) for team in other.teams.values()]
    assert any("their seats tell them apart" in note for note in alike.notes)
    assert other.notes == []


def test_every_figure_has_its_definition(tmp_path: Path) -> None:
    exported = stats_as_json(run_stats(write_made_up_run(tmp_path, ticks=450, halves=1)))
    assert json.loads(json.dumps(exported, allow_nan=False)) == exported
    for team in exported["teams"].values():
        assert set(team) - {"runs", "points", "robots"} == set(exported["definitions"])
        for robot in team["robots"].values():
            assert set(robot) == set(exported["definitions"])
    assert all(len(definition["text"]) > 40 for definition in exported["definitions"].values())


def test_points_of_a_run_that_was_killed_are_those_of_its_log(tmp_path: Path) -> None:
    writer = begun_run(tmp_path, 2 * GOAL_EVERY_TICKS + 50)  # its result tells of whole halves only
    killed = Path(shutil.copytree(writer.folder, tmp_path / "killed"))
    writer.finish({"complete": False})
    teams = run_stats(killed).teams
    assert (teams["Alster"].points, teams["Hanse"].points) == (2, 0)
    # The log goes on for longer than the poses: like judge and the page, the figures end with these.
    log = killed / "referee.jsonl"
    (goal, *_) = (line for line in log.read_text("utf-8").splitlines() if '"kind": "score"' in line)
    with log.open("a", encoding="utf-8") as stream:
        stream.write(json.dumps(json.loads(goal) | {"tick": 2 * GOAL_EVERY_TICKS + 60}) + "\n")
        late = {"kind": "event", "half": 1, "tick": 2 * GOAL_EVERY_TICKS + 60, "event": "LATE", "payload": {}}
        stream.write(json.dumps(late) + "\n")
    stats = run_stats(killed)
    assert stats.teams["Alster"].points == 2
    assert "LATE" not in stats.calls
    (killed / "referee.jsonl").unlink()
    assert run_stats(killed).teams["Alster"].points == 0


# --- bad input -----------------------------------------------------------------------------------------------------------


def test_the_readable_part_of_a_damaged_run_is_counted_and_the_damage_reported(tmp_path: Path) -> None:
    folder = write_made_up_run(tmp_path, ticks=100, halves=2)
    data = (folder / "trajectory.chunks").read_bytes()
    (folder / "trajectory.chunks").write_bytes(data[: len(data) * 2 // 3])
    (folder / "referee.jsonl").write_bytes((folder / "referee.jsonl").read_bytes() + b"{nonsense\n")
    stats = run_stats(folder)
    assert 100 < stats.ticks < 200
    assert any("poses are damaged" in note and folder.name in note for note in stats.notes)
    assert any("1 line of the referee's log is damaged" in note for note in stats.notes)
    (folder / "referee.jsonl").write_bytes((folder / "referee.jsonl").read_bytes() + b"{more\n")
    assert any("2 lines of the referee's log are damaged" in note for note in run_stats(folder).notes)


DAMAGED = given(
    name=st.sampled_from(["result.json", "scenario.json", "referee.jsonl", "trajectory.chunks"]),
    damage=st.lists(st.tuples(st.integers(0, 120_000), st.integers(0, 255)), min_size=1, max_size=12),
)


@DAMAGED
@pytest.mark.nightly
def test_whatever_is_damaged_figures_and_page_are_made_or_refused_with_a_message(
    name: str, damage: list, tmp_path_factory: pytest.TempPathFactory
) -> None:
    assert_made_or_refused(name, damage, tmp_path_factory)


def assert_made_or_refused(name: str, damage: list, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("runs") / "run"
    shutil.copytree(Path(__file__).parents[1] / "goldens" / "record", folder)
    path = next(path for path in folder.rglob("*") if path.is_file() and name in path.name)
    data = bytearray(path.read_bytes())
    for place, byte in damage:
        data[place % len(data)] = byte
    path.write_bytes(bytes(data))
    for made in (run_stats, write_replay):
        with contextlib.suppress(RecordError):
            made(folder)
    shutil.rmtree(folder)
