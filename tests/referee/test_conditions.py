"""Conditions: each word asked at every tick by a rule that fires whenever told to."""

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch
from tests.referee.building import ASKING


def as_programs_fail(play, ask):
    """The answers before, after Y1's program has failed, and after Y2's."""
    found = [ask(play)]
    for robot in ("Y1", "Y2"):
        play.fail(robot)
        play.play()
        found.append(ask(play))
    return found


class TestConditionInZone:
    def test_a_centre_is_in_or_not(self, stage, ask):
        play = stage(ASKING % "{condition: in_zone, entity: ball, zone: [left, right]}")
        assert not ask(play)
        play.place("ball", 0.2, 0.0)
        assert ask(play)

    @pytest.mark.parametrize(
        ("of", "answers"),
        [
            ("any", [False, True, True, True]),
            ("all", [False, False, False, True]),
            ("none", [True, False, False, False]),
            ("{at_least: 2}", [False, False, True, True]),
        ],
    )
    def test_of_a_group_so_many(self, stage, ask, of, answers):
        play = stage(
            "groups: {three: [B1, B2, Y1]}\n"
            + ASKING % f"{{condition: in_zone, entity: three, zone: middle, of: {of}}}"
        )
        found = [ask(play)]
        for robot in ("B1", "B2", "Y1"):
            play.place(robot, 0.0, 0.0)
            found.append(ask(play))
        assert found == answers

    @pytest.mark.parametrize(
        ("of", "holds"), [("any", False), ("all", False), ("none", True), ("{at_least: 1}", False)]
    )
    def test_of_a_group_that_is_off_the_field_as_a_whole_all_is_no_statement(self, stage, ask, of, holds):
        play = stage(
            "groups: {three: [B1, B2, Y1]}\n"
            + ASKING % f"{{condition: in_zone, entity: three, zone: middle, of: {of}}}",
            "rules: {gone: {triggers: [{trigger: half_started}], actions: [{action: remove, entity: three}]}}",
        )
        play.play()
        assert ask(play) is holds

    def test_negate_turns_it_over(self, stage, ask):
        play = stage(ASKING % "{condition: in_zone, entity: ball, zone: middle, negate: true}")
        assert not ask(play)
        play.place("ball", 0.5, 0.0)
        assert ask(play)

    def test_who_is_off_the_field_is_not_counted(self, stage, ask):
        play = stage(
            ASKING % "{condition: in_zone, entity: [B1, B2], zone: middle, of: all}",
            "rules: {aside: {triggers: [{trigger: program_fault, robot: Y1}], actions: [{action: remove, entity: B2}]}}",
        )
        play.place("B1", 0.0, 0.0)
        assert not ask(play)
        play.fail("Y1")
        play.play()
        assert ask(play)


class TestConditionSpeed:
    def test_it_is_the_way_of_the_last_tick_over_its_time(self, stage, ask):
        play = stage(ASKING % "{condition: speed, entity: ball, at_least: 0.1, at_most: 0.2}")
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
        play = stage(ASKING % f"{{condition: speed, entity: ball, {compared}}}")
        play.place("ball", 0.3, 0.0)
        assert ask(play) is holds

    def test_afterwards_it_is_at_rest_or_as_fast_as_it_glides(self, stage, ask):
        play = stage(ASKING % "{condition: speed, entity: ball, at_most: 0.01}")
        play.place("ball", 0.3, 0.0)
        play.play()
        assert ask(play)
        play.place("ball", 0.0, 0.0)
        play.glide("ball", (0.1, 0.0), 10)
        play.play()
        assert not ask(play)

    def test_a_ball_that_is_put_by_hand_has_come_to_rest_anew(self, stage):
        rests = "{trigger: holds, for_s: 0.1, condition: {condition: speed, entity: ball, at_most: 0.01}}"
        play = stage(f"rules: {{rest: {{triggers: [{rests}], actions: [{{action: emit, event: RESTS}}]}}}}")
        play.play(10)
        play.place("ball", 0.3, 0.0)
        play.play(10)
        assert len(play.events_named("RESTS")) == 2

    def test_a_placement_is_no_speed(self, stage, ask):
        play = stage(
            ASKING % "{condition: speed, entity: ball, at_most: 0.01}",
            "rules: {aside: {triggers: [{trigger: program_fault, robot: Y1}], "
            "actions: [{action: place, entity: ball, at: {point: [0.3, 0]}}]}}",
        )
        play.fail("Y1")
        play.play()
        assert play.pose("ball")[0] == pytest.approx(0.3)
        assert ask(play)


class TestConditionDistance:
    @pytest.mark.parametrize(("to", "near"), [("Y1", (-0.4, -0.3)), ("centre", (0.0, 0.2)), ("[0.3, 0.3]", (0.3, 0.1))])
    def test_to_an_entity_a_spot_or_a_point(self, stage, ask, to, near):
        play = stage(ASKING % f"{{condition: distance, entity: ball, to: {to}, at_most: 0.2001}}")
        play.place("ball", 0.6, -0.6)
        assert not ask(play)
        play.place("ball", *near)
        assert ask(play)

    def test_to_a_group_the_nearest_counts(self, stage, ask):
        play = stage(ASKING % "{condition: distance, entity: ball, to: blue, at_most: 0.15}")
        assert not ask(play)
        play.place("ball", 0.4, 0.4)
        assert ask(play)

    def test_nothing_is_near_itself(self, stage, ask):
        play = stage(ASKING % "{condition: distance, entity: yellow, to: yellow, at_most: 0.15}")
        assert not ask(play)
        play.place("Y2", play.pose("Y1")[0] + 0.1, play.pose("Y1")[1])
        assert ask(play)

    def test_who_is_off_the_field_is_not_far_away(self, stage, ask):
        play = stage(
            "rules: {gone: {triggers: [{trigger: program_fault, robot: Y1}], actions: [{action: remove, entity: B2}]}}",
            ASKING % "{condition: distance, entity: B2, to: centre, at_least: 0.3}",
        )
        assert ask(play)
        play.fail("Y1")
        play.play()
        assert not ask(play)


class TestConditionCounter:
    COUNTERS = """
    counters: {bells: {}, goal: {initial: 3}, each_bell: {per: robots}}
    rules:
      bell:
        triggers: [{trigger: program_fault, robot: [Y1, Y2]}]
        actions: [{action: count, counter: bells}, {action: count, counter: each_bell, entity: Y1, by: 2}]
    """

    def ring(self, play: ScriptedMatch) -> None:
        play.fail("Y1")
        play.play()

    def test_it_is_compared_with_a_number_or_a_counter(self, stage, ask):
        play = stage(self.COUNTERS, ASKING % "{condition: counter, counter: bells, equals: {counter: goal}}")
        for _ in range(3):
            assert not ask(play)
            self.ring(play)
        assert ask(play)

    def test_one_per_entity_is_that_entitys_or_the_sum(self, stage, ask):
        of_b1 = stage(self.COUNTERS, ASKING % "{condition: counter, counter: each_bell, entity: B1, at_least: 1}")
        total = stage(self.COUNTERS, ASKING % "{condition: counter, counter: each_bell, at_least: 2}")
        for play in (of_b1, total):
            self.ring(play)
        assert (ask(of_b1), ask(total)) == (False, True)

    @pytest.mark.parametrize(
        ("of", "whom", "answers"),
        [
            ("any", "yellow", [False, True, True]),
            ("all", "yellow", [False, False, True]),
            ("none", "yellow", [True, False, False]),
            ("{at_least: 2}", "[yellow, B1]", [False, False, True]),
            ("{at_least: 2}", "", [False, False, True]),
        ],
    )
    def test_of_a_group_so_many_each_by_its_own_counter(self, stage, ask, of, whom, answers):
        entity = f", entity: {whom}" if whom else ""
        play = stage(
            """
            counters: {falls: {per: robots}}
            rules:
              falls:
                for_each: yellow
                triggers: [{trigger: program_fault, robot: each}]
                actions: [{action: count, counter: falls, entity: each, by: 2}]
            """,
            ASKING % f"{{condition: counter, counter: falls{entity}, of: {of}, at_least: 2}}",
        )
        assert as_programs_fail(play, ask) == answers

    def test_an_entrants_name_is_its_score(self, stage, ask):
        play = stage(ASKING % "{condition: counter, counter: yellow, at_least: 2}", scores={"blue": 0, "yellow": 2})
        assert ask(play)


class TestConditionFlag:
    def test_it_asks_whether_a_flag_is_set(self, stage, ask):
        play = stage("flags: {up: {initial: true}, down: {}}", ASKING % "{condition: flag, flag: up}")
        assert ask(play)
        play = stage("flags: {up: {initial: true}, down: {}}", ASKING % "{condition: flag, flag: down}")
        assert not ask(play)

    def test_one_per_entity_is_that_entitys_or_any(self, stage, ask):
        flags = """
        flags: {seen: {per: robots}}
        rules:
          sees: {triggers: [{trigger: half_started}], actions: [{action: set_flag, flag: seen, entity: Y1}]}
        """
        answers = [
            ask(stage(flags, ASKING % f"{{condition: flag, flag: seen{whose}}}"))
            for whose in (", entity: Y1", ", entity: B1", "")
        ]
        assert answers == [True, False, True]

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
    def test_of_a_group_so_many(self, stage, ask, of, answers):
        play = stage(
            """
            flags: {touched: {per: robots}}
            rules:
              touched:
                for_each: yellow
                triggers: [{trigger: program_fault, robot: each}]
                actions: [{action: set_flag, flag: touched, entity: each}]
            """,
            ASKING % f"{{condition: flag, flag: touched, entity: yellow, of: {of}}}",
        )
        assert as_programs_fail(play, ask) == answers


class TestConditionDrawn:
    def test_it_asks_what_a_draw_decided(self, stage, ask):
        sections = ("draws: {side: {values: [left, right]}}", ASKING % "{condition: drawn, draw: side, equals: left}")
        assert ask(stage(*sections, draws={"side": "left"}))
        assert not ask(stage(*sections, draws={"side": "right"}))


class TestConditionTimer:
    TIMERS = "timers: {egg: {lasts_s: 0.64, starts: true}}"

    def test_it_asks_how_long_a_timer_has_run(self, stage, ask):
        play = stage(self.TIMERS, ASKING % "{condition: timer, timer: egg, at_least: 0.32}")
        play.play(8)
        assert not ask(play)  # tick 9
        assert ask(play)  # tick 10

    def test_without_a_comparison_it_asks_whether_it_runs(self, stage, ask):
        play = stage(self.TIMERS, ASKING % "{condition: timer, timer: egg}")
        play.play(18)
        assert ask(play)
        assert not ask(play)

    @pytest.mark.parametrize(
        ("of", "running", "long"),
        [("any", True, True), ("all", False, False), ("none", False, False), ("{at_least: 1}", True, True)],
    )
    def test_of_a_group_so_many(self, stage, ask, of, running, long):
        sections = (
            "timers: {away: {lasts_s: 30, per: robots}}",
            "rules: {away: {triggers: [{trigger: half_started}], actions: [{action: timer, timer: away, entity: Y1}]}}",
        )
        asked = f"{{condition: timer, timer: away, entity: [Y1, Y2], of: {of}"
        assert ask(stage(*sections, ASKING % f"{asked}}}")) is running
        play = stage(*sections, ASKING % f"{asked}, at_least: 0.32}}")
        play.play(20)
        assert ask(play) is long


class TestConditionLastTouch:
    ASKED = ASKING % "{condition: last_touch, by: yellow}"

    def test_it_asks_who_touched_the_ball_last(self, stage, ask):
        play = stage(self.ASKED)
        assert not ask(play)
        play.touch("ball", "Y1")
        assert ask(play)
        play.play(3)
        assert ask(play)  # nobody since
        play.touch("ball", "B2")
        assert not ask(play)

    def test_a_new_contact_counts_before_one_that_goes_on(self, stage, ask):
        play = stage(self.ASKED)
        play.touch("ball", "B1")
        play.play()
        play.touch("ball", "B1")
        play.touch("ball", "Y1")
        assert ask(play)

    def test_walls_and_others_contacts_do_not_count(self, stage, ask):
        play = stage(self.ASKED)
        play.touch("ball", "Y1")
        play.play()
        play.touch("ball", "walls")
        play.touch("B1", "Y2")
        assert ask(play)

    def test_a_placement_forgets_it(self, stage, ask):
        play = stage(
            self.ASKED,
            "rules: {aside: {triggers: [{trigger: program_fault, robot: Y1}], "
            "actions: [{action: place, entity: ball, at: {point: [0.3, 0]}}]}}",
        )
        play.touch("ball", "Y1")
        play.fail("Y1")
        play.play()
        assert not ask(play)


class TestConditionSpotFree:
    def test_a_spot_is_free_when_no_centre_is_near(self, stage, ask):
        play = stage(ASKING % "{condition: spot_free, spot: corner_blue_right}")
        assert ask(play)
        play.place("ball", 0.3, 0.3799)
        assert not ask(play)
        play.place("ball", 0.3, 0.3801)
        assert ask(play)

    def test_of_a_group_so_many(self, stage, ask):
        play = stage(ASKING % "{condition: spot_free, spot: neutral_spots, of: all}")
        assert not ask(play)  # the ball lies in the centre
        play.place("ball", 0.5, 0.0)
        assert ask(play)


class TestConditionSequenceAt:
    def test_it_asks_which_step_was_reached_last(self, stage, ask):
        play = stage(
            "sequences: {way: {entity: ball, steps: [middle, right], cyclic: true}}",
            ASKING % "{condition: sequence_at, sequence: way, step: right}",
        )
        assert not ask(play)  # it stands in the middle
        play.place("ball", 0.3, 0.0)
        assert ask(play)
        play.place("ball", 0.0, 0.3)
        assert ask(play)  # left, but nothing else reached
        play.place("ball", 0.0, 0.0)
        assert not ask(play)


class TestConditionHalf:
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
    def test_the_number_of_the_half_is_compared(self, stage, ask, asked, answers):
        halves = (
            stage("match: {halves: 3, half_s: 60}", ASKING % f"{{condition: half, {asked}}}", half=half)
            for half in (1, 2, 3)
        )
        assert [ask(play) for play in halves] == answers
