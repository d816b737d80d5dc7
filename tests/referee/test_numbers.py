"""Values wherever a rule has a number: what stands beside them, what several are, what is counted, and none."""

import pytest

from tests.referee.building import at_tick_10, once, touch

SECOND = "schema_version: 2\n"
OFF = "{action: remove, entity: %s}"


def computed(stage, number: str, more: str = "", do: str = "") -> float:
    """Return what a counter that was 99 is set to at tick 11, after an action at tick 10."""
    counters = "counters: {found: {initial: 99}, two: {initial: 2}, laps: {per: robots, initial: 3}}\n"
    before = [at_tick_10(do)] if do else []
    counted = once(11, f"{{action: count, counter: found, to: {number}}}", name="counted")
    play = stage(SECOND, counters + more, *before, counted)
    play.play(12)
    return play.referee.counters["found"]


class TestWhatStandsBesideANumber:
    @pytest.mark.parametrize(
        ("number", "expected"),
        [
            ("{counter: two, times: 3}", 6),
            ("{counter: two, times: 3, plus: 1, minus: 0.5}", 6.5),
            ("{counter: two, plus: {counter: two, times: {counter: two}}}", 6),
            ("{counter: two, times: 0.7, round: down}", 1),
            ("{counter: two, times: 0.7, round: up}", 2),
            ("{counter: two, times: 0.75, round: nearest}", 2),
            ("{counter: two, times: -0.75, round: nearest}", -1),
            ("{counter: two, minus: 2.5, round: down}", -1),
            ("{counter: two, otherwise: 7}", 2),
            ("{sum: [{counter: two, times: 0.1}, 0.1], times: 10, round: down}", 3),
        ],
    )
    def test_it_is_worked_out_in_order(self, stage, number, expected):
        assert computed(stage, number) == expected

    def test_a_flag_is_one_or_nothing(self, stage):
        flags = "flags: {set: {initial: true}, unset: {}}\n"
        assert computed(stage, "{flag: set, times: 5, plus: {flag: unset, times: 3}}", flags) == 5

    def test_a_time_is_exact_unless_it_is_rounded(self, stage):
        assert computed(stage, "{word: time_s}") == 0.352
        assert computed(stage, "{word: time_s, times: 10, round: down}") == 3


class TestNone:
    def test_a_counter_keeps_its_value_if_there_is_no_number(self, stage):
        assert computed(stage, "{distance: [Y1, ball]}", do=OFF % "ball") == 99

    @pytest.mark.parametrize("beside", ["times: 2", "plus: 1", "minus: 1", "round: up"])
    def test_calculating_with_none_gives_none(self, stage, beside):
        assert computed(stage, f"{{distance: [Y1, ball], {beside}}}", do=OFF % "ball") == 99

    def test_none_beside_a_number_gives_none_too(self, stage):
        assert computed(stage, "{counter: two, plus: {speed: ball}}", do=OFF % "ball") == 99

    def test_otherwise_comes_first(self, stage):
        assert computed(stage, "{distance: [Y1, ball], otherwise: 3, times: 2, plus: 1}", do=OFF % "ball") == 7

    def test_a_message_that_never_came_has_no_number(self, stage):
        assert computed(stage, "{told: Y1}") == 99
        assert computed(stage, "{told: Y1, otherwise: 5}") == 5

    def test_several_pass_over_it_and_the_sum_of_nobody_is_0(self, stage):
        several = "[{speed: ball}, {counter: two}, 5]"
        assert computed(stage, f"{{highest: {several}}}", do=OFF % "ball") == 5
        assert computed(stage, f"{{lowest: {several}}}", do=OFF % "ball") == 2
        assert computed(stage, f"{{sum: {several}}}", do=OFF % "ball") == 7
        assert computed(stage, "{sum: [{speed: ball}]}", do=OFF % "ball") == 0
        assert computed(stage, "{highest: [{speed: ball}]}", do=OFF % "ball") == 99

    def test_no_points_and_no_hold(self, stage):
        play = stage(
            SECOND,
            at_tick_10(OFF % "ball"),
            """
rules:
  nothing:
    triggers: [{trigger: time_reached, at_s: 0.352}]
    actions:
      - {action: score, entrant: blue, points: {distance: [Y1, ball]}}
      - {action: hold, entity: Y1, for_s: {distance: [Y1, ball]}}
""",
        )
        play.play(12)
        assert (play.referee.scores["blue"], play.referee.held["Y1"]) == (0, False)

    def test_programs_receive_null(self, stage):
        fields = "{far: {distance: [Y1, ball]}, twice: {speed: ball, times: 2}}"
        play = stage(SECOND, f"broadcast: {{fields: {fields}}}", at_tick_10(OFF % "ball"))
        play.play(12)
        assert play.output.broadcast == {"far": None, "twice": None}


class TestSent:
    def test_every_number_may_be_sent(self, stage):
        fields = (
            "{most: {highest: {counter: laps}}, sum: {sum: [0.1, 0.2]}, here: {count: yellow}, score: {score: blue}, "
        )
        fields += "twice: {counter: laps, entity: Y1, times: 2}, no_one: {lowest: [{speed: ball}]}}"
        counters = "counters: {laps: {per: robots, initial: 3}}\n"
        play = stage(SECOND, counters, f"broadcast: {{fields: {fields}}}", at_tick_10(OFF % "ball"))
        play.play(12)
        assert play.output.broadcast == {"most": 3, "sum": 0.3, "here": 2, "score": 0, "twice": 6, "no_one": None}


class TestSeveral:
    LAPS = "{action: count, counter: laps, entity: Y1, to: 8}"

    @pytest.mark.parametrize(
        ("number", "expected"),
        [
            ("{highest: {counter: laps}}", 8),
            ("{lowest: {counter: laps, entity: yellow}}", 3),
            ("{sum: {counter: laps, entity: [Y1, B1]}, minus: 1}", 10),
            ("{highest: {counter: laps, entity: blue, times: 2}, plus: 1}", 7),
        ],
    )
    def test_of_each_member_of_a_group(self, stage, number, expected):
        assert computed(stage, number, do=self.LAPS) == expected

    def test_of_a_group_that_is_measured_who_is_off_the_field_does_not_count(self, stage):
        far = "{highest: {distance: [yellow, [-0.4, -0.4]]}}"
        assert computed(stage, far) == pytest.approx(0.806)
        assert computed(stage, far, do=OFF % "Y2") == 0.1

    def test_others_are_the_rest_of_the_group_on_the_field(self, stage):
        rule = """
rules:
  off: {triggers: [{trigger: half_started}], actions: [{action: remove, entity: Y2}]}
  counted:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: count, counter: seen, entity: each, to: {count: others}}]
"""
        play = stage(SECOND, "counters: {seen: {per: robots}}", rule)
        play.play(12)
        # For a robot that is itself off the field others are nobody.
        assert play.referee.counters["seen"] == {"B1": 2, "B2": 2, "Y1": 2, "Y2": 0}


class TestCount:
    def test_those_on_the_field(self, stage):
        assert computed(stage, "{count: robots}") == 4
        assert computed(stage, "{count: robots}", do=OFF % "[Y1, B1]") == 2

    def test_those_of_which_the_facts_are_true(self, stage):
        put = "{action: place, entity: Y1, at: {point: [0.4, 0]}}"
        assert computed(stage, "{count: yellow, in: right}") == 1
        assert computed(stage, "{count: yellow, in: right}", do=put) == 2
        assert computed(stage, "{count: yellow, in: right, held: true}", do=put) == 0
        assert computed(stage, "{count: robots, held: true}", do="{action: hold, entity: [Y1, B2]}") == 2
        flags = "flags: {out: {per: robots}}\n"
        assert computed(stage, "{count: blue, flag: out}", flags, "{action: set_flag, flag: out, entity: B1}") == 1

    def test_what_is_off_the_field_is_nowhere_but_keeps_its_flag(self, stage):
        flags = "flags: {out: {per: robots, initial: true}}\n"
        assert computed(stage, "{count: robots, flag: out}", flags, OFF % "Y1") == 4
        assert computed(stage, "{count: robots, in: pitch}", do=OFF % "Y1") == 3

    def test_a_contact_that_has_just_parted_still_counts(self, stage):
        rule = once(11, "{action: count, counter: found, to: {count: yellow, touching: ball}}")
        play = stage(SECOND, "counters: {found: {initial: 99}}", rule)
        play.play(8)
        touch(play, "Y1", "ball", 4)
        assert play.referee.counters["found"] == 1


class TestScore:
    def test_of_an_entrant_and_of_the_team_of_each(self, stage):
        rule = """
rules:
  given: {triggers: [{trigger: half_started}], actions: [{action: score, entrant: blue, points: 3}]}
  counted:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: count, counter: behind, entity: each, to: {score: blue, minus: {score: each}}}]
"""
        play = stage(SECOND, "counters: {behind: {per: robots}}", rule)
        play.play(12)
        assert play.referee.counters["behind"] == {"B1": 0, "B2": 0, "Y1": 3, "Y2": 3}


class TestWhereverARuleHasANumber:
    def test_a_timer_lasts_as_long_as_was_worked_out_when_it_started(self, stage):
        play = stage(
            SECOND,
            "counters: {two: {initial: 0.5}}\ntimers: {wait: {lasts_s: {counter: two, times: 2, plus: 0.28}}}",
            at_tick_10("{action: timer, timer: wait, do: start}", "{action: count, counter: two, to: 5}"),
            "rules: {over: {triggers: [{trigger: timer_expired, timer: wait}], actions: [{action: emit, event: TOLD}]}}",
        )
        play.play(60)
        assert [event.tick for event in play.events_named("TOLD")] == [50]

    def test_a_timer_without_a_length_runs_on(self, stage):
        play = stage(SECOND, "timers: {wait: {lasts_s: {told: Y1}, starts: true}}\ncounters: {ran_s: {}}",
                     once(100, "{action: count, counter: ran_s, to: {timer: wait}}"))  # fmt: skip
        play.play(101)
        assert play.referee.counters["ran_s"] == 3.2

    def test_a_condition_compares_with_it(self, stage):
        near = "{distance: [Y1, ball], at_most: {distance: [Y2, ball], plus: %s}}"
        told = once(10, "{action: emit, event: TOLD}", more=f"conditions: [{near}],")
        for plus, names in ((0.01, ["TOLD"]), (-0.01, [])):
            play = stage(SECOND, told % plus)
            play.play(12)
            assert [event.name for event in play.events_named("TOLD")] == names
