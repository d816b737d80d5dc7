"""Conditions: each word asked by a rule that fires whenever B1's program fails."""

import pytest

from tests.referee.building import ASKING, fail, on_fault, place, rule, touch


def asking(condition: str) -> str:
    return ASKING % f"{{{condition}}}"


def on_each_fault(*actions: str) -> str:
    return on_fault("each", *actions, more="for_each: yellow,")


SATISFIES = {
    "entity: yellow, in: middle": ("", lambda play, robot: play.place(robot, 0.0, 0.0)),
    "distance: [yellow, [0, 0]], at_most: 0.1": ("", lambda play, robot: play.place(robot, 0.0, 0.0)),
    "entity: yellow, looks: 0": ("", lambda play, robot: play.place(robot, *play.pose(robot)[:2], 0.0)),
    "way: yellow, at_least: 0.2": ("", lambda play, robot: play.glide(robot, (0.0, -0.5), 1)),
    "told: yellow, text: GO": ("", lambda play, robot: play.tell(robot, "GO")),
    "flag: hit, entity: yellow": (
        "flags: {hit: {per: robots}}\n" + on_each_fault("{action: set_flag, flag: hit, entity: each}"),
        lambda play, robot: play.fail(robot),
    ),
    "counter: falls, entity: yellow, at_least: 2": (
        "counters: {falls: {per: robots}}\n" + on_each_fault("{action: count, counter: falls, entity: each, by: 2}"),
        lambda play, robot: play.fail(robot),
    ),
    "timer: away, entity: yellow": (
        "timers: {away: {lasts_s: 30, per: robots}}\n" + on_each_fault("{action: timer, timer: away, entity: each}"),
        lambda play, robot: play.fail(robot),
    ),
    "timer: away, entity: yellow, at_least: 0.032": (
        "timers: {away: {lasts_s: 30, per: robots}}\n" + on_each_fault("{action: timer, timer: away, entity: each}"),
        lambda play, robot: play.fail(robot),
    ),
    "sequence: way, entity: yellow, equals: middle": (
        "sequences: {way: {per: robots, steps: [middle, right]}}", lambda play, robot: play.place(robot, 0.0, 0.0),
    ),
    "entity: yellow, held: true": (
        on_each_fault("{action: hold, entity: each}"), lambda play, robot: play.fail(robot),
    ),
}  # fmt: skip
"""By condition: what it needs, and what makes a robot satisfy it."""


@pytest.mark.parametrize("condition", SATISFIES)
@pytest.mark.parametrize(
    ("of", "answers"),
    [
        ("any", [False, True, True]),
        ("all", [False, False, True]),
        ("none", [True, False, False]),
        ("{at_least: 2}", [False, False, True]),
        ("all, negate: true", [True, True, False]),
    ],
)
def test_of_a_group_so_many_must_satisfy_a_condition(stage, ask, condition, of, answers):
    sections, satisfy = SATISFIES[condition]
    play = stage(sections, asking(f"{condition}, of: {of}"))
    found = [ask(play)]
    for robot in ("Y1", "Y2"):
        satisfy(play, robot)
        play.play(2)
        found.append(ask(play))
    assert found == answers


@pytest.mark.parametrize(("of", "holds"), [("any", False), ("all", False), ("none", True), ("{at_least: 1}", False)])
def test_of_a_group_that_is_off_the_field_as_a_whole_all_is_no_statement(stage, ask, of, holds):
    gone = rule("trigger: half_started", "{action: remove, entity: yellow}")
    play = stage(asking(f"entity: yellow, in: middle, of: {of}"), gone)
    play.play()
    assert ask(play) is holds


def test_a_robot_off_the_field_is_in_no_zone_and_at_no_distance(stage, ask):
    for condition in (
        "entity: [B1, B2], in: middle, of: all",
        "distance: [B2, centre], at_most: 2",
    ):
        play = stage(asking(condition), on_fault("Y1", "{action: remove, entity: B2}"))
        play.place("B1", 0.0, 0.0)
        before = ask(play)
        fail(play, "Y1")
        assert ask(play) is not before


@pytest.mark.parametrize(
    ("condition", "places", "answers"),
    [
        ("entity: ball, in: [left, right]", [(0.0, 0.0), (0.2, 0.0)], [False, True]),
        ("distance: [ball, Y1], at_most: 0.2001", [(0.6, -0.6), (-0.4, -0.3)], [False, True]),
        ("distance: [ball, centre], at_most: 0.2001", [(0.6, -0.6), (0.0, 0.2)], [False, True]),
        ("distance: [ball, [0.3, 0.3]], at_most: 0.2001", [(0.6, -0.6), (0.3, 0.1)], [False, True]),
        # To a group the nearest counts.
        ("distance: [ball, blue], at_most: 0.15", [(0.0, 0.0), (0.4, 0.4)], [False, True]),
        ("spot_free: corner_blue_right", [(0.0, 0.0), (0.3, 0.3799), (0.3, 0.3801)], [True, False, True]),
    ],
)
def test_where_the_ball_is(stage, ask, condition, places, answers):
    play, found = stage(asking(condition)), []
    for where in places:
        play.place("ball", *where)
        found.append(ask(play))
    assert found == answers


def test_nothing_is_near_itself(stage, ask):
    play = stage(asking("distance: [yellow, yellow], at_most: 0.15"))
    assert not ask(play)
    play.place("Y2", -0.3, -0.5)
    assert ask(play)


class TestConditionSpeed:
    def test_it_is_the_way_of_the_last_tick_over_its_time(self, stage, ask):
        play = stage(asking("speed: ball, at_least: 0.1, at_most: 0.2"))
        assert not ask(play)
        play.glide("ball", (0.15 * 0.032, 0.0), 1)
        assert ask(play)
        play.glide("ball", (0.15 * 0.032 + 0.3 * 0.032, 0.0), 1)
        assert not ask(play)

    @pytest.mark.parametrize(
        ("compared", "holds"),
        [
            ("at_least: 0.25", False), ("at_most: 0.25", False), ("at_least: 0", False),
            ("at_least: 0.25, of: none", True), ("at_most: 0.25, negate: true", True),
        ],
    )  # fmt: skip
    def test_where_a_test_puts_something_by_hand_its_speed_is_unknown_for_a_tick(self, stage, ask, compared, holds):
        play = stage(asking(f"speed: ball, {compared}"))
        play.place("ball", 0.3, 0.0)
        assert ask(play) is holds

    def test_afterwards_it_is_at_rest_or_as_fast_as_it_glides(self, stage, ask):
        play = stage(asking("speed: ball, at_most: 0.01"))
        place(play, "ball", 0.3, 0.0)
        assert ask(play)
        play.place("ball", 0.0, 0.0)
        play.glide("ball", (0.1, 0.0), 10)
        play.play()
        assert not ask(play)

    def test_a_placement_is_no_speed(self, stage, ask):
        put = on_fault("Y1", "{action: place, entity: ball, at: {point: [0.3, 0]}}")
        play = fail(stage(asking("speed: ball, at_most: 0.01"), put), "Y1")
        assert play.pose("ball")[0] == pytest.approx(0.3)
        assert ask(play)


class TestConditionCounter:
    def test_it_is_compared_with_a_number_or_a_counter(self, stage, ask):
        counted = on_fault("Y1", "{action: count, counter: bells}")
        play = stage(
            "counters: {bells: {}, goal: {initial: 3}}",
            counted,
            asking("counter: bells, equals: {counter: goal}"),
        )
        for _ in range(3):
            assert not ask(play)
            fail(play, "Y1")
        assert ask(play)

    @pytest.mark.parametrize(
        ("kept", "change", "condition"),
        [
            ("counters: {n: {per: robots}}", "count, counter: n, by: 2", "counter: n, at_least: 2"),
            ("flags: {n: {per: robots}}", "set_flag, flag: n", "flag: n"),
        ],
    )
    def test_what_is_kept_per_entity_is_that_of_one_or_the_sum_or_any(self, stage, ask, kept, change, condition):
        begin = rule("trigger: half_started", f"{{action: {change}, entity: Y1}}")
        whose = (", entity: Y1", ", entity: B1", "")
        assert [ask(stage(kept, begin, asking(condition + one))) for one in whose] == [True, False, True]

    def test_an_entrants_name_is_its_score(self, stage, ask):
        assert ask(stage(asking("score: yellow, at_least: 2"), scores={"blue": 0, "yellow": 2}))


@pytest.mark.parametrize(("compared", "first", "then"), [(", at_least: 0.32", False, True), ("", True, False)])
def test_timer_is_compared_by_its_time_or_tested_for_running(stage, ask, compared, first, then):
    lasts_s = 0.64 if compared else 0.32
    play = stage(f"timers: {{egg: {{lasts_s: {lasts_s}, starts: true}}}}", asking(f"timer: egg{compared}"))
    play.play(8)
    assert (ask(play), ask(play)) == (first, then)  # ticks 9 and 10


class TestConditionLastTouch:
    ASKED = asking("last_touch: ball, equals: yellow")

    def test_last_toucher_of_the_ball_is_tested(self, stage, ask):
        play = stage(self.ASKED)
        assert not ask(play)
        play.touch("ball", "Y1")
        assert ask(play)
        play.play(3)
        assert ask(play)  # none since
        play.touch("ball", "B2")
        assert not ask(play)

    def test_a_new_contact_counts_before_one_that_goes_on(self, stage, ask):
        play = stage(self.ASKED)
        touch(play, "ball", "B1")
        play.touch("ball", "B1")
        play.touch("ball", "Y1")
        assert ask(play)

    def test_walls_and_others_contacts_do_not_count(self, stage, ask):
        play = stage(self.ASKED)
        touch(play, "ball", "Y1")
        play.touch("ball", "walls")
        play.touch("B1", "Y2")
        assert ask(play)

    def test_a_placement_forgets_it(self, stage, ask):
        play = stage(self.ASKED, on_fault("Y1", "{action: place, entity: ball, at: {point: [0.3, 0]}}"))
        play.touch("ball", "Y1")
        assert not ask(fail(play, "Y1"))


@pytest.mark.parametrize(
    ("asked", "answers"),
    [
        ("equals: 2", [False, True, False]),
        ("at_least: 2", [False, True, True]),
        ("at_most: 2", [True, True, False]),
        ("at_least: 2, at_most: 2", [False, True, False]),
        ("equals: 2, negate: true", [True, False, True]),
    ],
)
def test_number_of_the_half_is_compared(stage, ask, asked, answers):
    three = "match: {halves: 3, half_s: 60}"
    assert [ask(stage(three, asking(f"word: halftime, {asked}"), half=half)) for half in (1, 2, 3)] == answers
