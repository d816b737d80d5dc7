"""The referee's part of the tick contract: one test for each of its sentences in ADR 1, named by its number."""

import re
from pathlib import Path

import pytest

from tests.referee.building import EMIT, IN_MIDDLE, event_ticks, fail, feed, once, place

ADR = Path(__file__).parents[2] / "docs" / "adr" / "0001-tick-contract.md"


class TestLine0:
    def test_0_2_score_and_what_is_kept_carry_over(self, stage):
        sections = """
        draws: {kept: {values: [a, b, c, d, e, f, g, h], keep: match}, fresh: {values: [a]}}
        flags: {kept: {keep: match}, fresh: {}}
        counters: {goals: {}}
        rules:
          all:
            triggers: [{trigger: time_reached, at_s: 0.032}]
            max_executions: 1
            actions:
              - {action: score, entrant: blue, points: 2}
              - {action: set_flag, flag: kept}
              - {action: set_flag, flag: fresh}
              - {action: count, counter: goals}
        """
        first = stage(sections, draws={"kept": "g"})
        first.play(3)
        second = stage(sections, half=2, kept=first.referee.kept, scores=dict(first.referee.scores))
        assert second.referee.scores == {"blue": 2, "yellow": 0}
        assert (second.referee.draws["kept"], second.referee.flags, second.referee.counters) == (
            "g", {"kept": True, "fresh": False}, {"goals": 0},
        )  # fmt: skip
        second.play(3)
        assert second.referee.scores["blue"] == 4

    def test_a_counter_that_is_kept_carries_over_as_it_was_left_and_is_the_next_half_s_own(self, stage):
        sections = """
        counters: {laps: {initial: 1, keep: match}, hits: {per: robots, keep: match}, fresh: {initial: 4}, half: {keep: half}}
        rules:
          all:
            triggers: [{trigger: time_reached, at_s: 0.032}]
            actions:
              - {action: count, counter: laps, by: 0.1}
              - {action: count, counter: hits, entity: Y2, by: 3}
              - {action: count, counter: fresh}
              - {action: count, counter: half}
        """
        first = stage(sections)
        first.play(3)
        left = first.referee.kept
        second = stage(sections, half=2, kept=left)
        assert (second.referee.counters["laps"], second.referee.counters["hits"]["Y2"]) == (1.1, 3)
        assert (second.referee.counters["fresh"], second.referee.counters["half"]) == (4, 0)
        second.play(3)
        assert (second.referee.counters["laps"], second.referee.counters["hits"]["Y2"]) == (1.2, 6)
        assert left["counters"] == {"laps": 1.1, "hits": {"B1": 0, "B2": 0, "Y1": 0, "Y2": 3}}

    def test_0_3_tick_0_is_draws_layouts_arming_and_half_started(self, stage):
        play = stage(f"""
        draws: {{side: {{values: [left]}}}}
        rules:
          begin:
            triggers: [{{trigger: half_started}}]
            conditions: [{{draw: side, equals: left}}]
            actions: [{{action: place, entity: ball, at: {{point: [0.3, 0]}}}}, {EMIT}]
          came: {{triggers: [{IN_MIDDLE}], actions: [{{action: emit, event: CAME}}]}}
        """)
        assert (event_ticks(play), play.tick) == ([0], 0)
        assert play.pose("ball")[0] == pytest.approx(0.3)
        place(play, "ball", 0.0, 0.0)
        assert event_ticks(play, "CAME") == [1]  # armed with the ball where the layout put it

    def test_0_4_start_noise_is_drawn_at_tick_0(self, stage):
        noisy = (
            "robots: {B1: {colour: blue, number: 1, kit: v2, start: {x_m: 0, y_m: 0.4, yaw_rad: 0, noise_m: [0.1, 0]}}}"
        )
        assert [placed.entity for _, placed in stage(noisy).placements] == [0]
        ruled = "rules: {put: {triggers: [{trigger: half_started}], actions: [{action: place, entity: B1, at: {point: [0, 0.3]}}]}}"
        assert stage(noisy, ruled).pose("B1")[:2] == pytest.approx((0.0, 0.3))


class TestLine2:
    def test_2_1_zone_and_gate_facts_are_latched_in_each_sub_step(self, stage):
        play = stage(
            f"rules: {{came: {{triggers: [{IN_MIDDLE}], actions: [{EMIT}]}}, "
            "over: {triggers: [{trigger: crosses, entity: ball, gate: halfway}], actions: [{action: emit, event: OVER}]}}",
            "balls: {ball: {start_m: [0.2, 0.2]}}",
        )
        feed(play, (0.05, 0.05), (0.05, -0.05), (0.05, 0.05), (0.2, 0.2))
        assert (event_ticks(play), event_ticks(play, "OVER")) == ([1], [1])

    def test_2_2_contact_facts_are_latched_in_each_sub_step(self, stage):
        play = stage(
            f"rules: {{hit: {{triggers: [{{trigger: touches, entity: ball, other: B1, apart_s: 0}}], actions: [{EMIT}]}}}}"
        )
        pair = (play.roster.index["B1"], play.roster.index["ball"])
        feed(play, *[(0.0, 0.0)] * 4, touches=((), (pair,), (), ()))
        feed(play, *[(0.0, 0.0)] * 4, touches=((pair,), (), (), ()))
        feed(play, *[(0.0, 0.0)] * 4, touches=((), (), (), (pair,)))
        feed(play, *[(0.0, 0.0)] * 4, touches=((pair,), (pair,), (), ()))  # still the one that began a tick ago
        assert event_ticks(play) == [1, 2, 3]

    def test_2_3_levels_are_judged_on_the_last_sub_step(self, stage):
        play = stage(once(1, EMIT, more="conditions: [{entity: ball, in: right}],"))
        feed(play, (0.3, 0.0), (0.3, 0.0), (0.3, 0.0), (0.0, 0.0))
        assert event_ticks(play) == []


class TestLine3:
    def test_3_1_timers_and_sequences_advance_before_anything_is_judged(self, stage):
        play = stage(
            "timers: {egg: {lasts_s: 3.2, starts: true}}\n"
            "sequences: {way: {entity: ball, steps: [middle, right], cyclic: true}}",
            once(10, EMIT, more="conditions: [{timer: egg, equals: 0.32}, "
                                "{sequence: way, equals: right}],"),
        )  # fmt: skip
        play.play(9)
        place(play, "ball", 0.3, 0.0)
        assert event_ticks(play) == [10]

    def test_3_2_all_are_evaluated_against_the_state_at_the_start_of_the_tick(self, stage):
        flag = "{flag: up}"
        play = stage(
            "flags: {up: {}}",
            once(5, "{action: set_flag, flag: up}", name="first"),
            once(5, "{action: emit, event: SAW}", name="second", more=f"conditions: [{flag}],"),
            once(6, "{action: emit, event: SAW}", name="third", more=f"conditions: [{flag}],"),
        )
        play.play(10)
        assert event_ticks(play, "SAW") == [6]

    def test_3_3_actions_read_current_values(self, stage):
        play = stage(
            "counters: {rounds: {}}",
            once(
                5,
                "{action: count, counter: rounds, by: 3}",
                "{action: score, entrant: blue, points: {counter: rounds}}",
            ),
        )
        play.play(5)
        assert play.referee.scores["blue"] == 3

    def test_3_4_a_phase_that_runs_out_does_so_at_the_start_of_the_tick(self, stage):
        play = stage(
            "phases: {pause: {lasts_s: 0.32}}",
            once(5, "{action: set_phase, phase: pause}"),
            "rules: {back: {triggers: [{trigger: phase_entered, phase: play}], actions: [{action: emit, event: BACK}]}}",
            once(15, EMIT, name="in_play"),
        )
        play.play(20)
        assert (event_ticks(play, "BACK"), event_ticks(play)) == ([15], [15])

    def test_3_5_the_clock_stands_still_while_timers_go_on(self, stage):
        play = stage(
            "phases: {pause: {lasts_s: 0.32, clock: stops}}\ntimers: {egg: {lasts_s: 0.64, starts: true}}",
            once(5, "{action: set_phase, phase: pause}"),
            once(12, EMIT, name="late"),
            "rules: {egg: {triggers: [{trigger: timer_expired, timer: egg}], actions: [{action: emit, event: EGG}]}}",
        )
        play.play(30)
        assert (event_ticks(play), event_ticks(play, "EGG")) == ([22], [20])
        assert play.referee.clock_ticks == 20


class TestLine4:
    def test_4_1_priority_then_file_order_then_entity_order(self, stage):
        rule = "triggers: [{trigger: time_reached, at_s: 0.032}], actions: [{action: score, entrant: blue}]"
        play = stage(f"""
        groups: {{backwards: [Y2, B2, B1]}}
        rules:
          late: {{priority: 1, {rule}}}
          one: {{for_each: backwards, {rule}}}
          two: {{{rule}}}
          early: {{priority: -1, {rule}}}
        """)
        play.play()
        assert [(firing.rule, firing.entity) for firing in play.firings] == [
            ("early", None), ("one", "B1"), ("one", "B2"), ("one", "Y2"), ("two", None), ("late", None),
        ]  # fmt: skip

    def test_4_2_a_rule_fires_at_most_once_a_tick_about_its_first_trigger(self, stage):
        play = stage("""
        rules:
          any:
            triggers: [{trigger: enters, entity: ball, zone: right}, {trigger: enters, entity: robots, zone: middle}]
            actions: [{action: score, entrant: blue}]
        """)
        for name, x in (("ball", 0.3), ("Y1", 0.0), ("B2", 0.01)):
            play.place(name, x, 0.0)
        play.play()
        assert [(firing.entity, firing.trigger) for firing in play.firings] == [("ball", "enters")]
        assert play.referee.scores["blue"] == 1

    RULE = "triggers: [{trigger: program_fault, robot: each}], actions: [{action: emit, event: TOLD}]"

    def test_4_3_within_an_exclusive_group_the_first_wins_and_the_rest_are_logged(self, stage):
        play = stage(
            once(5, EMIT, name="one", more="exclusive: only,"), once(5, EMIT, name="two", more="exclusive: only,")
        )
        play.play(5)
        assert event_ticks(play) == [5]
        assert [(firing.rule, firing.suppressed) for firing in play.firings] == [("one", None), ("two", "exclusive")]

    def test_4_4_exclusive_cooldown_and_max_executions_count_per_entity(self, stage):
        play = stage(f"""
        rules:
          one: {{for_each: robots, exclusive: only, cooldown_s: 0.32, max_executions: 2, {self.RULE}}}
          two: {{for_each: robots, exclusive: only, {self.RULE.replace("TOLD", "TWO")}}}
        """)
        for tick in range(1, 31):
            if tick in {1, 5, 11, 25}:
                play.fail("B1")
            if tick == 5:
                play.fail("Y1")
            play.play()
        record = [(f.tick, f.rule, f.entity, f.suppressed) for f in play.firings]
        assert record == [
            (1, "one", "B1", None), (1, "two", "B1", "exclusive"),
            (5, "one", "B1", "cooldown"), (5, "one", "Y1", None), (5, "two", "B1", None), (5, "two", "Y1", "exclusive"),
            (11, "one", "B1", None), (11, "two", "B1", "exclusive"),
            (25, "one", "B1", "max_executions"), (25, "two", "B1", None),
        ]  # fmt: skip

    def test_4_5_max_executions_counts_per_half(self, stage):
        rules = f"rules: {{one: {{max_executions: 1, triggers: [{{trigger: program_fault}}], actions: [{EMIT}]}}}}"
        for half in (1, 2):
            play = stage(rules, half=half)
            for _ in range(3):
                fail(play, "B1")
            assert event_ticks(play) == [1]

    def test_4_6_only_a_firing_that_ran_its_actions_counts(self, stage):
        play = stage(f"""
        rules:
          worn: {{exclusive: only, max_executions: 1, triggers: [{{trigger: program_fault}}], actions: [{EMIT}]}}
          next: {{exclusive: only, cooldown_s: 0.32, triggers: [{{trigger: program_fault}}], actions: [{EMIT}]}}
        """)
        for _ in range(3):
            fail(play, "B1")
        record = [(f.tick, f.rule, f.suppressed) for f in play.firings]
        assert record == [
            (1, "worn", None), (1, "next", "exclusive"),
            (2, "worn", "max_executions"), (2, "next", None),
            (3, "worn", "max_executions"), (3, "next", "cooldown"),
        ]  # fmt: skip

    def test_4_7_what_a_time_sets_off_fires_after_all_else_of_its_priority(self, stage):
        play = stage("timers: {egg: {lasts_s: 0.16, starts: true}}",
                     "rules: {late: {triggers: [{trigger: timer_expired, timer: egg}], actions: [{action: emit, event: LATE}]}}",
                     "rules: {came: {triggers: [{trigger: enters, entity: ball, zone: middle}], actions: [{action: timer, timer: egg}]}}",
                     "balls: {ball: {start_m: [0.3, 0]}}")  # fmt: skip
        play.play(4)
        place(play, "ball", 0.0, 0.0)
        assert [firing.rule for firing in play.firings] == ["came"]  # the timer that was restarted has not run out
        play.play(5)
        assert event_ticks(play, "LATE") == [10]

    def test_4_8_the_rules_of_a_later_round_see_what_the_earlier_one_counted(self, stage):
        play = stage("counters: {hits: {}}", once(5, "{action: count, counter: hits}"),
                     *[once(5, EMIT, name=name, more=f"{more}conditions: [{{counter: hits, at_least: 1}}],")
                       for name, more in (("same", ""), ("later", "priority: 1, "))])  # fmt: skip
        play.play(5)
        assert [firing.rule for firing in play.firings] == ["act", "later"]


class TestLine5:
    PHASES = "phases: {pause: {}, other: {}}"

    def test_5_1_a_phase_begins_when_its_round_ends_whatever_the_order_in_the_file(self, stage):
        play = stage(
            self.PHASES,
            once(5, "{action: set_phase, phase: pause}"),
            once(5, EMIT, name="same_round"),
            once(5, EMIT, name="gone", more="priority: 1,"),
            once(5, "{action: emit, event: STAYS}", name="stays", more="priority: 1, phases: any,"),
        )
        play.play(5)
        assert [(firing.rule, firing.suppressed) for firing in play.firings] == [
            ("act", None), ("same_round", None), ("gone", "phase"), ("stays", None),
        ]  # fmt: skip

    def test_of_two_phases_set_in_one_round_the_first_in_the_file_begins(self, stage):
        play = stage(
            self.PHASES,
            once(5, "{action: set_phase, phase: pause}"),
            once(5, "{action: set_phase, phase: other}", EMIT, name="late"),
        )
        play.play(5)
        assert play.referee.phase == "pause"
        assert [(firing.rule, firing.suppressed) for firing in play.firings] == [
            ("act", None), ("late", None), ("late", "phase_taken"),
        ]  # fmt: skip

    def test_a_rule_of_a_phase_that_began_in_this_tick_waits_for_the_next(self, stage):
        play = stage(self.PHASES, once(5, "{action: set_phase, phase: pause}"),
                     once(5, EMIT, name="new", more="priority: 1, phases: [pause],"))  # fmt: skip
        play.play(6)
        assert event_ticks(play) == []

    def test_5_2_entering_a_phase_arms_the_rules_that_did_not_live_in_the_one_left(self, stage):
        came = f"triggers: [{IN_MIDDLE}], actions: [{{action: emit, event: %s}}]"
        play = stage(
            self.PHASES + "\nballs: {ball: {start_m: [0.3, 0]}}",
            once(5, "{action: set_phase, phase: pause}"),
            once(10, "{action: set_phase, phase: play}", name="back", more="phases: any,"),
            f"rules: {{new: {{{came % 'NEW'}}}, both: {{phases: [play, pause], {came % 'BOTH'}}}}}",
        )
        play.play(6)
        play.place("ball", 0.0, 0.0)  # comes in during the pause
        play.play(10)
        assert (event_ticks(play, "NEW"), event_ticks(play, "BOTH")) == ([], [7])
        place(play, "ball", 0.3, 0.0)
        place(play, "ball", 0.0, 0.0)
        assert (event_ticks(play, "NEW"), event_ticks(play, "BOTH")) == ([18], [7, 18])

    def test_5_3_entering_the_same_phase_arms_all_rules(self, stage):
        stuck = f"rules: {{stuck: {{triggers: [{{trigger: no_progress, entity: ball, distance_m: 1, within_s: 0.32}}], actions: [{EMIT}]}}}}"
        play = stage(stuck, once(8, "{action: set_phase, phase: play}"))
        play.play(40)
        assert event_ticks(play) == [19]  # 11 ticks after tick 8, not after tick 0

    def test_5_4_after_an_action_entered_it_phase_entered_fires_in_the_next_tick(self, stage):
        play = stage(
            self.PHASES,
            once(5, "{action: set_phase, phase: pause}"),
            f"rules: {{heard: {{phases: any, triggers: [{{trigger: phase_entered, phase: pause}}], actions: [{EMIT}]}}}}",
        )
        play.play(10)
        assert event_ticks(play) == [6]

    def test_5_5_end_takes_effect_after_the_last_firing(self, stage):
        play = stage(once(5, "{action: end}"), once(5, EMIT, name="later"))
        output = play.play(5)
        assert (output.ended, event_ticks(play)) == ("act", [5])

    def test_5_6_a_goal_in_the_final_tick_counts(self, stage):
        play = stage(
            "match: {half_s: 0.32}",
            "rules: {goal: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [{action: score, entrant: yellow}]}}",
        )
        play.play(9)
        assert not play.referee.time_is_up
        place(play, "ball", 0.0, 0.8)
        assert play.referee.time_is_up
        assert play.referee.scores["yellow"] == 1

    def test_5_7_half_ended_rules_still_run(self, stage):
        play = stage(
            once(5, "{action: end}"), f"rules: {{last: {{triggers: [{{trigger: half_ended}}], actions: [{EMIT}]}}}}"
        )
        play.play(5)
        play.finish()
        assert event_ticks(play) == [5]

    @staticmethod
    def _settled(stage, *sections: str):
        play = stage(*sections)
        play.play(5)
        play.finish()
        return play

    END = once(5, "{action: end}", name="over")
    TOTAL = "counters: {hits: {}}"

    def test_5_9_events_of_the_last_tick_still_set_rules_off(self, stage):
        play = self._settled(
            stage, self.END, once(5, "{action: emit, event: ONE}"),
            "rules: {two: {triggers: [{trigger: event, event: ONE}], actions: [{action: emit, event: TWO}]}, "
            "three: {triggers: [{trigger: event, event: TWO}], actions: [{action: emit, event: THREE}]}}",
        )  # fmt: skip
        assert [(one.rule, one.tick, one.settling) for one in play.firings if one.settling] == [
            ("two", 5, 1),
            ("three", 5, 2),
        ]

    def test_what_half_ended_counts_is_compared(self, stage):
        play = self._settled(
            stage, self.END, self.TOTAL,
            "rules: {last: {triggers: [{trigger: half_ended}], actions: [{action: count, counter: hits, by: 3}]}, "
            "enough: {triggers: [{trigger: holds, conditions: [{counter: hits, at_least: 3}]}], "
            "actions: [{action: score, entrant: yellow}]}}",
        )  # fmt: skip
        assert play.referee.scores["yellow"] == 1

    def test_no_time_passes_while_the_rules_settle(self, stage):
        play = self._settled(
            stage, self.END, "timers: {egg: {lasts_s: 0.192, starts: true}}",
            "rules: {rings: {triggers: [{trigger: timer_expired, timer: egg}, {trigger: time_reached, at_s: 0.192}], "
            "actions: [{action: emit, event: LATE}]}}",
            "rules: {waits: {triggers: [{trigger: holds, conditions: [{entity: ball, in: middle}], for_s: 0.192}], "
            "actions: [{action: emit, event: LATE}]}}",
        )  # fmt: skip
        assert event_ticks(play, "LATE") == []

    def test_rules_that_set_each_other_off_end_after_16_passes_and_the_log_says_so(self, stage):
        play = self._settled(
            stage, self.END, once(5, "{action: emit, event: PING}"),
            "rules: {ping: {triggers: [{trigger: event, event: PING}], actions: [{action: emit, event: PONG}]}, "
            "pong: {triggers: [{trigger: event, event: PONG}], actions: [{action: emit, event: PING}]}}",
        )  # fmt: skip
        assert max(one.settling for one in play.firings) == 16
        assert play.firings[-1].suppressed == "unsettled"

    def test_while_the_rules_settle_only_the_match_can_end(self, stage):
        ends = "rules: {last: {triggers: [{trigger: half_ended}], actions: [{action: end, what: %s, reason: later}]}}"
        assert self._settled(stage, self.END, ends % "half").output.ended == "over"
        assert self._settled(stage, self.END, ends % "match").output.ends_match

    def test_a_settling_removal_is_seen_by_the_next_pass(self, stage):
        play = self._settled(
            stage, self.END,
            "rules: {last: {triggers: [{trigger: half_ended}], actions: [{action: remove, entity: Y1}, {action: emit, event: GONE}]}, "
            "then: {triggers: [{trigger: event, event: GONE}], conditions: [{distance: [Y1, ball], at_most: 9}], "
            "actions: [{action: emit, event: SEEN}]}}",
        )  # fmt: skip
        assert play.names() == ["GONE"]


class TestLine10:
    def test_10_1_emitted_events_are_seen_one_tick_later(self, stage):
        play = stage(
            once(5, "{action: emit, event: ONE}"),
            "rules: {two: {triggers: [{trigger: event, event: ONE}], actions: [{action: emit, event: TWO}]}, "
            "three: {triggers: [{trigger: event, event: TWO}], actions: [{action: emit, event: THREE}]}}",
        )
        play.play(10)
        assert [(event.name, event.tick) for event in play.events] == [("ONE", 5), ("TWO", 6), ("THREE", 7)]

    def test_10_2_every_firing_leaves_a_record(self, stage):
        play = stage("""
        rules:
          far:
            for_each: blue
            triggers: [{trigger: displaced, entity: each, distance_m: 0.25}]
            actions: [{action: score, entrant: yellow, points: 2}]
        """)
        place(play, "B2", -0.4, 0.0)
        (firing,) = play.firings
        assert (firing.tick, firing.rule, firing.entity, firing.trigger) == (1, "far", "B2", "displaced")
        assert (firing.measured, firing.limit, firing.scored) == (0.5, 0.25, {"yellow": 2})


def test_every_sentence_of_the_referees_part_has_a_test_that_names_it():
    sentences = re.findall(r"^- \*\*(\d+)\.(\d+)\*\* (.*(?:\n  .*)*)", ADR.read_text(encoding="utf-8"), re.MULTILINE)
    ours = {f"{line}_{number}" for line, number, text in sentences if not text.rstrip().endswith("]")}
    files = Path(__file__).parent.glob("test_tick_contract*.py")
    tests = [name for file in files for name in re.findall(r"def test_(\d+_\d+)_", file.read_text(encoding="utf-8"))]
    assert len(sentences) >= 40
    assert set(tests) == ours
    assert len(tests) == len(set(tests))
