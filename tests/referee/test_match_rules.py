"""The match, rule by rule, on scripted snapshots: `scenarios/match.yaml` is the rule book of reference section 5."""

import math

import pytest

from rcj_challenges.core.timing import s_from_ticks
from tests.referee.building import place

ROBOTS = ("B1", "B2", "B3", "Y1", "Y2", "Y3")
# A place for everybody far from all spots, so that spots are free; and the ball's.
CORNERS = {
    "B1": (0.55, 0.45), "B2": (-0.55, 0.45), "B3": (0.55, 0.1), "Y1": (-0.55, -0.45), "Y2": (0.55, -0.45), "Y3": (-0.55, 0.1),
}  # fmt: skip


def scatter(play) -> None:
    """Put all robots where they leave all spots free."""
    for name, where in CORNERS.items():
        play.place(name, *where)


def keep_moving(play, ticks: int, *, still: tuple[str, ...] = ()) -> None:
    """Play on with everybody else going to and fro fast enough to make progress (0.15 m/s)."""
    for _ in range(ticks):
        for name in (*ROBOTS, "ball"):
            if name not in still:
                x, y, _ = play.pose(name)
                play.place(name, x + (0.0048 if (play.tick // 10) % 2 else -0.0048), y)
        play.play()


def calls(play, name: str = "LACK_OF_PROGRESS") -> list[tuple[int, str]]:
    """Return tick and robot (or type) of the events of a name."""
    return [
        (event.tick, event.payload.get("robot_name", event.payload.get("type"))) for event in play.events_named(name)
    ]


class TestStartAndEnd:
    def test_the_log_begins_with_the_kickoff_and_then_the_start_of_the_match(self, match_play):
        play = match_play(
            match_id=99, team_names={"blue": "Phase Moon", "yellow": "SPLaT"}, scores={"blue": 2, "yellow": 1}
        )
        assert [(event.tick, event.name) for event in play.events] == [(0, "KICKOFF"), (0, "MATCH_START")]
        assert play.events[0].payload == {"robot_name": "Y3", "team_name": "Y"}
        assert list(play.events[1].payload.items()) == [
            ("score_yellow", 1), ("score_blue", 2), ("total_match_time", 600), ("team_name_yellow", "SPLaT"),
            ("team_name_blue", "Phase Moon"), ("match_id", 99), ("halftime", 1),
        ]  # fmt: skip

    def test_the_end_reports_the_result(self, match_play):
        play = match_play()
        play.play(3)
        play.finish()
        assert play.events[-1].name == "MATCH_FINISH"
        assert list(play.events[-1].payload) == [
            "total_match_time", "score_yellow", "score_blue", "team_name_yellow", "team_name_blue",
        ]  # fmt: skip

    @pytest.mark.parametrize(("kickoff", "robot", "y"), [("blue", "B3", 0.1), ("yellow", "Y3", -0.1)])
    def test_the_kickoff_robot_stands_at_the_ball_and_the_others_near_their_start(self, match_play, kickoff, robot, y):
        play = match_play(kickoff=kickoff)
        assert play.pose(robot)[:2] == pytest.approx((0.0, y))
        assert play.pose("ball")[:2] == (0.0, 0.0)
        for name in set(ROBOTS) - {robot}:
            start = play.referee._state.scenario.robots[name].start
            x, y, yaw = play.pose(name)
            assert abs(x - start.x_m) <= 0.0751
            assert abs(y - start.y_m) <= 0.0751
            assert yaw == pytest.approx(start.yaw_rad)

    def test_the_kickoff_is_drawn_and_the_other_team_has_it_in_the_second_half(self, match_play):
        seats = set()
        for seed in range(1, 20):
            first = match_play(seed=seed, kickoff=None)
            seat = first.referee.draws["first_kickoff"]
            second = match_play(seed=seed, kickoff=None, half=2, kept=first.referee.kept)
            assert second.referee.draws["first_kickoff"] == seat  # the teams changed seats
            seats.add(seat)
        assert seats == {"blue", "yellow"}


class TestGoal:
    @pytest.mark.parametrize(
        ("ball", "scorer", "conceded"), [((0.0, 0.8), "yellow", "B3"), ((0.15, -0.746), "blue", "Y3")]
    )
    def test_the_point_goes_to_the_other_team_and_the_conceding_team_kicks_off(
        self, match_play, ball, scorer, conceded
    ):
        play = match_play()
        play.play(99)
        place(play, "ball", *ball, ticks=95)
        goal, kickoff = play.events[-2:]
        assert (goal.tick, goal.name, goal.payload["team_name"]) == (100, "GOAL", scorer.title())
        assert goal.payload[f"score_{scorer}"] == 1
        assert (kickoff.tick, kickoff.name, kickoff.payload["robot_name"]) == (194, "KICKOFF", conceded)
        assert play.referee.scores[scorer] == 1
        assert math.hypot(*play.pose(conceded)[:2]) == pytest.approx(0.1)

    @pytest.mark.parametrize("ball", [(0.2, 0.8), (0.0, 0.7449), (0.0, 0.85), (-0.201, -0.8)])
    def test_all_limits_of_the_goal_are_strict(self, match_play, ball):
        play = match_play()
        place(play, "ball", *ball)
        assert play.events_named("GOAL") == []

    def test_94_observations_wait_for_the_kickoff(self, match_play):
        play = match_play()
        play.place("ball", 0.0, 0.8)
        flags = [play.play().waiting_for_kickoff for _ in range(100)]
        assert flags == [True] * 94 + [False] * 6
        assert not match_play().output.waiting_for_kickoff

    def test_no_other_rule_runs_in_the_pause(self, match_play):
        play = match_play()
        play.play(460)  # just before lack of progress
        place(play, "ball", 0.0, 0.8, ticks=3)
        play.place("ball", 0.0, -0.8)
        place(play, "B1", 0.9, 0.0, ticks=91)
        assert [event.name for event in play.events if event.tick > 460] == ["GOAL"]
        play.play()
        assert play.events[-1].name == "KICKOFF"

    def test_windows_start_again_after_the_kickoff(self, match_play):
        play = match_play()
        play.place("ball", 0.0, 0.8)
        play.play(95 + 313)
        assert calls(play) == []
        play.play()
        assert calls(play) == [(95 + 314, "ball")]

    def test_a_goal_beats_everything_else_in_its_tick(self, match_play):
        play = match_play()
        play.play(469)
        before = len(play.events)
        place(play, "ball", 0.0, 0.8)
        assert [event.name for event in play.events[before:]] == ["GOAL"]
        suppressed = [firing for firing in play.firings if firing.suppressed == "phase"]
        assert {firing.rule for firing in suppressed} == {"robot_lack_of_progress"}


class TestLackOfProgress:
    def test_a_robot_that_makes_no_progress_is_put_on_a_neutral_spot(self, match_play):
        play = match_play()
        scatter(play)
        keep_moving(play, 469, still=("B1",))
        assert calls(play) == []
        keep_moving(play, 2, still=("B1",))
        # The jump by hand at tick 1 is path in no window: the first judged position is that of tick 1.
        assert calls(play) == [(470, "B1")]
        assert s_from_ticks(470) == 15.04
        x, y, yaw = play.pose("B1")
        assert (round(x, 3), round(y, 3)) in {(0.3, 0.3), (0.3, -0.3), (0.0, 0.2), (0.0, 0.0)}
        assert yaw == pytest.approx(-1.57)

    def test_a_robot_that_moves_half_a_metre_in_15_s_is_left_alone(self, match_play):
        play = match_play()
        scatter(play)
        keep_moving(play, 1500)
        assert calls(play) == []

    def test_the_ball_has_10_seconds(self, match_play):
        play = match_play()
        scatter(play)
        keep_moving(play, 313, still=("ball",))
        assert calls(play) == []
        keep_moving(play, 1, still=("ball",))
        assert calls(play) == [(314, "ball")]
        assert s_from_ticks(314) == 10.048
        assert play.events[-1].payload == {"type": "ball"}
        # Its own present place counts: the centre is not free for it.
        assert (round(play.pose("ball")[0], 3), round(play.pose("ball")[1], 3)) != (0.0, 0.0)

    def test_if_no_spot_is_free_nothing_moves_and_the_event_is_not_repeated(self, match_play):
        play = match_play()
        spots = [(0, 0), (0.3, 0.3), (-0.3, 0.3), (0.3, -0.3), (-0.3, -0.3), (0, 0.2)]
        for name, where in zip(ROBOTS, spots, strict=True):
            play.place(name, *where)
        play.place("ball", 0.0, -0.25)  # within 0.08 of the last spot
        play.play(400)
        assert calls(play) == [(314, "ball")]
        assert play.placements[7:] == []
        place(play, "B2", 0.5, 0.5)
        assert [(tick, placement.entity) for tick, placement in play.placements[7:]] == [(401, 6)]
        assert calls(play) == [(314, "ball")]


class TestOutOfTheField:
    @pytest.mark.parametrize("where", [(0.656, 0.0), (-0.656, 0.3), (0.3, 0.756), (0.0, 0.86)])
    def test_robot_and_ball_outside_are_put_on_a_neutral_spot(self, match_play, where):
        for name in ("B1", "ball"):
            play = match_play()
            play.play(5)
            place(play, name, *where)
            assert calls(play) == [(6, name)]
            assert abs(play.pose(name)[1]) <= 0.3001

    @pytest.mark.parametrize("where", [(0.654, 0.0), (0.3, 0.754), (0.1, 0.8)])
    def test_in_the_field_or_in_a_goal_is_not_outside(self, match_play, where):
        play = match_play()
        place(play, "B1", *where)
        assert calls(play) == []


class TestPenaltyArea:
    def stay(self, play, name: str, ticks: int, x: float = 0.2, y: float = 0.65) -> None:
        for _ in range(ticks):
            place(play, name, x + 0.01 * (play.tick % 5), y)

    def test_a_robot_that_stays_more_than_15_s_is_put_on_the_furthest_free_spot(self, match_play):
        play = match_play("robot_progress_s=60")  # so that no other robot takes the spot in the same tick
        scatter(play)
        play.place("ball", 0.6, 0.6)
        self.stay(play, "B1", 469)
        assert play.events_named("INSIDE_PENALTY_FOR_TOO_LONG") == []
        self.stay(play, "B1", 1)
        (event,) = play.events_named("INSIDE_PENALTY_FOR_TOO_LONG")
        assert (event.tick, event.payload) == (470, {"type": "robot", "robot_name": "B1"})
        assert play.pose("B1") == pytest.approx((-0.3, -0.3, -1.57))

    def test_the_area_has_no_far_end(self, match_play):
        play = match_play()
        self.stay(play, "Y1", 470, x=0.0, y=-0.8)
        assert len(play.events_named("INSIDE_PENALTY_FOR_TOO_LONG")) == 1

    @pytest.mark.parametrize(("absent", "called"), [(62, True), (70, False)])
    def test_excursions_of_up_to_2_s_count_as_inside(self, match_play, absent, called):
        play = match_play()
        self.stay(play, "B1", 300)
        self.stay(play, "B1", absent, y=0.5)
        self.stay(play, "B1", 180)
        assert bool(play.events_named("INSIDE_PENALTY_FOR_TOO_LONG")) is called

    def test_it_is_called_inside_only(self, match_play):
        play = match_play()
        self.stay(play, "B1", 460)
        self.stay(play, "B1", 40, y=0.5)
        assert play.events_named("INSIDE_PENALTY_FOR_TOO_LONG") == []
        self.stay(play, "B1", 1)
        assert [event.tick for event in play.events_named("INSIDE_PENALTY_FOR_TOO_LONG")] == [501]


class TestDamagedRobot:
    def stuck(self, play, ticks: int) -> None:
        keep_moving(play, ticks, still=("B1",))

    def test_the_fourth_put_back_without_moving_away_takes_it_off_for_a_minute(self, match_play):
        play = match_play()
        scatter(play)
        play.place("ball", 0.55, 0.6)
        self.stuck(play, 4 * 470)
        assert calls(play) == [(470, "B1"), (940, "B1"), (1410, "B1")]
        assert calls(play, "ROBOT_DAMAGED") == [(1880, "B1")]
        assert play.placements[-1][1].parked
        self.stuck(play, 1874)
        assert play.placements[-1][0] == 1880
        self.stuck(play, 1)
        tick, placement = play.placements[-1]
        assert (tick, placement.entity, placement.parked) == (1880 + 1875, 0, False)
        assert (placement.x_m, placement.y_m) == pytest.approx((-0.3, -0.3))  # furthest from the ball

    def test_one_that_moved_away_in_between_is_not_damaged(self, match_play):
        play = match_play()
        scatter(play)
        self.stuck(play, 2 * 470 + 10)
        x, y, _ = play.pose("B1")
        play.place("B1", x + 0.051, y)
        self.stuck(play, 3 * 470)
        assert len(calls(play)) == 5
        assert calls(play, "ROBOT_DAMAGED") == []

    def test_a_kickoff_brings_it_back_earlier(self, match_play):
        play = match_play()
        scatter(play)
        self.stuck(play, 4 * 470 + 100)
        place(play, "ball", 0.0, 0.8, ticks=95)
        assert (play.placements[-1][0], play.events[-1].name) == (play.tick, "KICKOFF")
        assert 0 in {placement.entity for tick, placement in play.placements if tick == play.tick}
        before = len(play.placements)
        keep_moving(play, 1900)
        assert play.placements[before:] == []  # it does not come back a second time

    def test_the_count_starts_again_with_a_kickoff(self, match_play):
        play = match_play()
        scatter(play)
        self.stuck(play, 3 * 470)
        assert play.referee.counters["put_backs"]["B1"] == 3
        place(play, "ball", 0.0, 0.8, ticks=95)
        assert play.referee.counters["put_backs"]["B1"] == 0


@pytest.mark.parametrize(
    ("override", "poses", "ticks", "event", "first"),
    [
        ("goal_pause_s=1", {"ball": (0.0, 0.8)}, 40, "KICKOFF", (1 + 32, "B3")),
        ("robot_progress_s=5", {}, 200, "LACK_OF_PROGRESS", (158, "B1")),
        ("ball_progress_s=5", {}, 200, "LACK_OF_PROGRESS", (158, "ball")),
        ("penalty_area_s=3", {"B1": (0.0, 0.65)}, 100, "INSIDE_PENALTY_FOR_TOO_LONG", (95, "B1")),
        ("zones.pitch.x_max_m=0.5", {"B1": (0.55, 0.0)}, 1, "LACK_OF_PROGRESS", (1, "B1")),
        ("damaged_after_put_backs=1", {}, 2 * 470, "ROBOT_DAMAGED", (940, "B1")),
    ],
)
def test_limits_come_from_the_file(match_play, override, poses, ticks, event, first):
    play = match_play(override)
    for name, (x_m, y_m) in poses.items():
        play.place(name, x_m, y_m)
    play.play(ticks)
    assert next(call for call in calls(play, event) if call[0]) == first
