"""Triggers at moments, about bodies, and holds."""

import pytest

from rcj_challenges.core.timing import ticks_from_s
from tests.referee.building import event_ticks, fail, hears, once, payloads, place, rule, touch

PAUSE = "phases: {pause: {lasts_s: 0.32}, other: {}}"
REST = "phases: {rest: {lasts_s: %s}}"
EGG = "timers: {egg: {lasts_s: 0.32}}"


@pytest.mark.parametrize(
    ("trigger", "more", "sections", "ticks"),
    [
        pytest.param("phase_entered, phase: play, from: other", "", [PAUSE, once(5, "{action: set_phase, phase: pause}")],
                     [], id="a phase entered from another one than is asked for"),
        pytest.param("phase_entered, phase: play", "", [], [], id="the first phase of a half is not entered"),
        pytest.param("time_reached, at_s: 0.5", "", [], [16], id="a time within a tick is reached at its end"),
        pytest.param("time_reached, at_s: 0.64, every_s: 0.96", "", [], [20, 50, 80], id="again after each interval"),
        pytest.param("time_reached, at_s: 0.05, every_s: 0.032", "", [], list(range(2, 101)), id="at every tick"),
        pytest.param("time_reached, at_s: 0.32, every_s: 0.32", "phases: any,",
                     [REST % "1.6, clock: stops", once(10, "{action: set_phase, phase: rest}")],
                     [10, 70, 80, 90, 100], id="while the clock stands no time comes"),
        pytest.param("time_reached, at_s: 0.32, every_s: 0.32", "",
                     [REST % "0.5", once(13, "{action: set_phase, phase: rest}")],
                     [10, 30, 40, 50, 60, 70, 80, 90, 100], id="a time in a phase of other rules is past"),
        pytest.param("timer_expired, timer: egg", "", [EGG, once(20, "{action: timer, timer: egg}")], [30],
                     id="a started timer runs out"),
    ],
)  # fmt: skip
def test_moment_at_which_a_trigger_fires(stage, trigger, more, sections, ticks):
    play = stage(*sections, hears(trigger, more))
    play.play(100)
    assert event_ticks(play) == ticks


def test_drawn_length_of_a_phase_counts_as_drawn_when_it_is_entered(stage):
    play = stage(
        "draws: {long: {values: [0.32, 0.64]}}",
        "phases: {pause: {lasts_s: {draw: long}}}\nfirst_phase: pause",
        rule("trigger: half_started", "{action: draw, draw: long, as: 0.64}", name="too_late", more="phases: any,"),
        rule("trigger: phase_entered, phase: play, from: pause", "{action: set_phase, phase: pause}", name="once_more",
             more="max_executions: 1,"),
        hears("phase_entered, phase: play"),
        draws={"long": 0.32},
    )  # fmt: skip
    play.play(60)
    assert event_ticks(play) == [10, 30]  # 10 ticks as drawn before the half, then 20 ticks


class TestTriggerTimeReached:
    def test_intervals_that_are_no_whole_ticks_do_not_add_up_to_a_delay(self, stage):
        play = stage(hears("time_reached, at_s: 0.1, every_s: 0.1"))
        play.play(320)
        # 10.2 s of 10.24 s; with each rounded up it would be 80 times
        assert event_ticks(play) == [ticks_from_s(times / 10) for times in range(1, 103)]

    def test_it_measures_the_time_that_has_come_and_its_limit_is_the_first(self, stage):
        reported = "{action: emit, event: TOLD, payload: {at: {word: measured}, limit: {word: limit}}}"
        play = stage(
            rule("trigger: time_reached, at_s: 0.1, every_s: 0.1", reported, more="says: '{measured} of {limit}',")
        )
        play.play(7)
        assert payloads(play) == [{"at": 0.1, "limit": 0.1}, {"at": 0.2, "limit": 0.1}]
        assert [firing.says for firing in play.firings] == ["0.1 of 0.1", "0.2 of 0.1"]


class TestTriggerTimerExpired:
    @pytest.mark.parametrize("lasts_s", ["1", "{draw: long}"])
    def test_its_limit_is_what_the_author_wrote_and_whole_ticks_are_measured(self, stage, lasts_s):
        play = stage(
            "draws: {long: {values: [1]}}",
            f"timers: {{egg: {{lasts_s: {lasts_s}, starts: true}}}}",
            hears("timer_expired, timer: egg", "says: 'After {limit} s ({measured} s).',"),
        )
        play.play(60)
        (fired,) = play.firings
        assert (fired.limit, fired.measured, fired.says) == (1, 1.024, "After 1 s (1.024 s).")

    @pytest.mark.parametrize("do", ["restart", "start"])
    def test_drawn_length_counts_as_it_is_drawn_when_the_timer_starts_from_0(self, stage, do):
        play = stage(
            "draws: {long: {values: [0.32, 0.64, 0.96]}}\ntimers: {egg: {lasts_s: {draw: long}}}",
            once(10, "{action: draw, draw: long, as: 0.64}", f"{{action: timer, timer: egg, do: {do}}}", name="begun"),
            once(15, "{action: draw, draw: long, as: 0.96}", "{action: timer, timer: egg, do: stop}",
                 "{action: timer, timer: egg, do: start}", name="drawn_while_it_runs"),
            hears("timer_expired, timer: egg"),
            draws={"long": 0.32},
        )  # fmt: skip
        play.play(60)
        assert event_ticks(play) == [30]

    def test_of_a_timer_per_entity_that_of_each_counts(self, stage):
        who = "{action: emit, event: %s, payload: {who: {word: robot_name}}}"
        expired = "trigger: timer_expired, timer: egg"
        play = stage(
            "timers: {egg: {lasts_s: 0.32, per: robots}}",
            once(20, "{action: timer, timer: egg, entity: Y1}"),
            rule(expired, who % "TOLD", name="each", more="for_each: robots,"),
            rule(expired, who % "ANY", name="any"),
        )
        play.play(60)
        assert [(one.name, one.tick) for one in play.events] == [("TOLD", 30), ("ANY", 30)]
        assert [one.payload for one in play.events] == [{"who": "Y1"}] * 2


class TestTriggerEventOfOne:
    WHO = "{action: emit, event: TOLD, payload: {who: {word: robot_name}}}"

    @pytest.mark.parametrize(
        ("each", "entity", "reported"),
        [
            ("for_each: robots,", ", entity: each", ["B2", "Y1"]),
            ("for_each: yellow,", ", entity: each", ["Y1"]),
            ("for_each: robots,", "", ["B1", "B2", "Y1", "Y2"]),
            ("", ", entity: Y1", ["Y1"]),
            ("", ", entity: [Y2, blue]", ["B2"]),
            ("", ", entity: Y2", []),
            ("", "", [""]),
        ],
    )
    def test_program_fault_fires_rules_about_the_same_robot(self, stage, each, entity, reported):
        play = stage(
            hears("program_fault, robot: each", "for_each: robots,", "HIT"),
            rule(f"trigger: event, event: HIT{entity}", self.WHO, more=each),
        )
        play.fail("Y1")
        play.fail("B2")
        play.play(2)
        assert [one["who"] for one in payloads(play)] == reported

    def test_of_a_rule_without_for_each_it_is_about_what_the_trigger_found(self, stage):
        play = stage(
            hears("touches, entity: blue, other: walls", event="HIT"),
            rule("trigger: event, event: HIT, entity: each", self.WHO, more="for_each: blue,"),
        )
        touch(play, "B2", "walls", ticks=2)
        assert payloads(play) == [{"who": "B2"}]


def test_fault_of_another_robot_does_not_fire(stage):
    assert event_ticks(fail(stage(hears("program_fault, robot: B1")), "Y2")) == []


class TestTriggerTouches:
    def test_it_fires_when_they_come_into_contact_not_while_they_stay_so(self, stage):
        play = stage(hears("touches, entity: ball, other: robots"))
        for tick in range(1, 20):
            if tick in {3, 4, 5, 12}:
                play.touch("ball", "B1")
            play.play()
        assert event_ticks(play) == [3, 12]

    @pytest.mark.parametrize(
        ("apart", "ticks"), [("", [1, 20]), (", apart_s: 0", [1, 3, 8, 20]), (", apart_s: 0.1", [1, 8, 20])]
    )
    def test_a_contact_that_is_interrupted_for_a_moment_is_one_contact(self, stage, apart, ticks):
        play = stage(hears(f"touches, entity: ball, other: walls{apart}"))
        for tick in range(1, 30):
            if tick in {1, 3, 8, 20}:
                play.touch("ball", "walls")
            play.play()
        assert event_ticks(play) == ticks

    def test_a_placement_ends_a_contact(self, stage):
        back = once(2, "{action: place, entity: ball, at: {point: [0, 0]}}")
        play = stage(hears("touches, entity: ball, other: walls"), back)
        touch(play, "ball", "walls", ticks=2)
        touch(play, "ball", "walls")
        assert event_ticks(play) == [1, 3]

    def test_what_is_apart_for_a_moment_still_touches_at_intervals(self, stage):
        play = stage(hears("touches, entity: ball, other: walls, every_s: 0.32"))
        for tick in range(1, 22):
            if tick % 3:
                play.touch("ball", "walls")
            play.play()
        assert event_ticks(play) == [1, 11, 21]

    def test_walls_are_a_thing_too(self, stage):
        play = stage(hears("touches, entity: [B1, ball], other: walls"))
        play.touch("ball", "walls")
        touch(play, "Y1", "walls", ticks=2)
        assert [(one.tick, one.entity) for one in play.firings] == [(1, "ball")]

    def test_a_placed_entity_has_no_contacts(self, stage):
        play = stage(
            hears("touches, entity: ball, other: B1"), once(2, "{action: place, entity: ball, at: {point: [0, 0.2]}}")
        )
        for _ in range(4):
            touch(play, "ball", "B1")
        assert event_ticks(play) == [1, 3]


def test_robot_tips_over_when_it_falls_and_again_only_after_it_stood(stage):
    play = stage(hears("tips_over, entity: robots, angle_rad: 1.0"))
    play.play(3)
    play.tip("B2")
    play.play(5)
    assert event_ticks(play) == [4]
    assert play.firings[0].measured == pytest.approx(1.5708, abs=1e-4)
    place(play, "B2", 0.0, 0.3)
    play.tip("B2")
    play.play()
    assert event_ticks(play) == [4, 10]


def in_zone(more: str) -> str:
    return hears(f"holds, conditions: [{{entity: ball, in: right}}], {more}")


class TestTriggerHolds:
    @pytest.mark.parametrize(
        ("more", "course", "ticks"),
        [
            pytest.param("for_s: 0.32", [(0, 4), (1, 50)], [15], id="once after it held for a time"),
            pytest.param("for_s: 0.32, every_s: 0.64", [(1, 55)], [11, 31, 51], id="again at intervals"),
            pytest.param("for_s: 0.32, grace_s: 0.064", [(1, 9), (0, 2), (1, 1)], [12],
                         id="a short interruption counts as holding"),
            pytest.param("for_s: 0.32, grace_s: 0.064", [(1, 9), (0, 3), (1, 20)], [23], id="after a longer one again"),
            pytest.param("for_s: 0", [(1, 3), (0, 3), (1, 3)], [1, 7], id="without a time when it becomes true"),
        ],
    )  # fmt: skip
    def test_it_fires_while_the_condition_holds(self, stage, more, course, ticks):
        play = stage(in_zone(more))
        for inside, count in course:
            place(play, "ball", 0.3 * inside, 0.0, ticks=count)
        assert event_ticks(play) == ticks

    def test_what_pays_by_the_second_pays_a_minute_sixty_times(self, stage):
        play = stage(in_zone("for_s: 1, every_s: 1"))
        place(play, "ball", 0.3, 0.0, ticks=1 + 60 * 1000 // 32)
        ticks = event_ticks(play)
        assert ticks[:3] == [33, 64, 95]  # 32, 63 and 94 ticks after tick 1: 1, 2 and 3 s, each rounded up
        assert len(ticks) == 60

    @pytest.mark.parametrize(("for_s", "heard"), [(0, []), (0.05, [4])])
    def test_a_removal_starts_the_duration_of_a_condition_that_it_makes_true(self, stage, for_s, heard):
        empty = "{entity: [ball, Y1], in: right, of: none}"
        play = stage(
            hears(f"holds, conditions: [{empty}], for_s: {for_s}"),
            rule("trigger: touches, entity: Y2, other: ball", "{action: remove, entity: ball}"),
        )
        place(play, "ball", 0.3, 0.0)
        touch(play, "Y2", "ball", ticks=9)  # in tick 2, at whose end it is taken off
        assert event_ticks(play) == heard

    def test_what_was_true_when_the_rule_became_active_does_not_fire(self, stage):
        play = stage("balls: {ball: {start_m: [0.3, 0]}}", in_zone("for_s: 0"))
        play.play(10)
        assert event_ticks(play) == []

    def test_a_placement_starts_it_again(self, stage):
        play = stage(in_zone("for_s: 0.32"), once(5, "{action: place, entity: ball, at: {point: [0.3, 0.1]}}"))
        place(play, "ball", 0.3, 0.0, ticks=30)
        assert event_ticks(play) == [15]
