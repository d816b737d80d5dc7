"""Lint: what is legal in a scenario and hardly meant is found at its place, with reason and remedy."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load, load_resolved, load_text
from tests.scenario.linting import SOUND, found_in, kinds, rule

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = sorted((ROOT / "scenarios").rglob("*.yaml"))


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_the_shipped_scenarios_are_free_of_lint(path):
    assert [str(finding) for finding in lint(load(path))] == []


def test_a_sound_scenario_has_no_finding():
    assert found_in() == []


def test_a_finding_names_its_place_the_reason_and_the_remedy():
    (finding,) = found_in("phases: {pause: {lasts_s: 3}}")
    assert str(finding) == (
        "it.yaml:6:10: warning: phases.pause: phase 'pause' is never entered; enter it by {action: set_phase, phase: "
        "pause} in a rule that can fire, or by 'next' of a phase that ends, or remove it [phase_never_entered]"
    )
    assert finding.as_json() == {
        "kind": "phase_never_entered",
        "file": "it.yaml",
        "line": 6,
        "column": 10,
        "path": "phases.pause",
        "reason": "phase 'pause' is never entered",
        "remedy": finding.remedy,
    }


def test_findings_come_in_the_order_of_the_file():
    lines = [
        finding.problem.line
        for finding in found_in("phases: {pause: {}}", "counters: {a: {}}", "draws: {b: {values: [1]}}")
    ]
    assert lines == sorted(lines)
    assert len(lines) == 3


def test_what_was_not_loaded_from_a_file_has_no_places_to_name():
    resolved = load("match").resolved
    with pytest.raises(ValueError, match="file or a text"):
        lint(load_resolved(resolved))


class TestPhases:
    def test_a_phase_that_only_a_dead_phase_leads_to_is_dead_too(self):
        found = kinds(
            "phases: {one: {lasts_s: 1, next: two}, two: {}}",
            rules=rule("lost", "{trigger: half_started}", more=", phases: [two]"),
        )
        assert found == ["phase_never_entered", "phase_never_entered", "rule_never_fires"]

    def test_a_phase_is_entered_by_a_rule_or_by_the_end_of_another(self):
        enter = rule("rest", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: one}")
        assert kinds("phases: {one: {lasts_s: 1, next: two}, two: {}}", rules=enter) == []

    def test_the_first_phase_may_be_another_one_than_play(self):
        assert kinds("first_phase: warm_up", "phases: {warm_up: {lasts_s: 2}}") == []
        assert "rule_never_fires" in kinds("first_phase: warm_up", "phases: {warm_up: {}}")

    def test_a_half_starts_in_its_first_phase_only(self):
        enter = rule("rest", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: one}")
        begin = rule("begin", "{trigger: half_started}", more=", phases: [one]")
        assert kinds("phases: {one: {lasts_s: 1}}", rules=enter + begin) == ["rule_never_fires"]

    def test_a_rule_must_live_in_the_phase_whose_entering_it_waits_for(self):
        enter = rule("rest", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: one}")
        wait = rule("wait", "{trigger: phase_entered, phase: one}")
        assert kinds("phases: {one: {lasts_s: 1}}", rules=enter + wait) == ["rule_never_fires"]
        assert kinds("phases: {one: {lasts_s: 1}}", rules=enter + wait.replace("says:", "phases: any, says:")) == []

    def test_a_phase_may_never_be_entered_from_where_a_rule_expects_it(self):
        enter = rule("rest", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: one}")
        back = rule("back", "{trigger: phase_entered, phase: play, from: two}")
        other = rule("more", "{trigger: time_reached, at_s: 3}", "{action: set_phase, phase: two}")
        phases = "phases: {one: {lasts_s: 1}, two: {}}"
        assert kinds(phases, rules=enter + back + other) == ["phase_never_entered"]
        assert kinds(phases, rules=enter + back.replace("two", "one") + other) == []

    def test_play_is_not_entered_by_the_start_of_a_half(self):
        assert kinds(rules=rule("begin", "{trigger: phase_entered, phase: play}")) == ["phase_never_entered"]


class TestEventsAndRules:
    def test_an_event_that_is_waited_for_and_never_emitted(self):
        emit = rule("a", "{trigger: half_started}", "{action: emit, event: STARTED}")
        (finding,) = found_in(rules=emit + rule("b", "{trigger: event, event: STARTET}"))
        assert finding.kind == "event_never_emitted"
        assert "did you mean 'STARTED'?" in finding.problem.message
        assert kinds(rules=emit + rule("b", "{trigger: event, event: STARTED}")) == []

    def test_an_event_or_a_point_without_a_sentence(self):
        silent = "  a: {triggers: [{trigger: half_started}], actions: [{action: emit, event: STARTED}]}\n"
        assert kinds(rules=silent) == ["event_without_a_sentence"]
        ends = silent.replace("half_started", "half_ended").replace("{action: emit, event: STARTED}", "{action: end}")
        assert kinds("counters: {n: {}}", rules=ends) == ["counter_never_read"]

    def test_a_rule_for_each_that_never_names_it(self):
        many = rule("a", "{trigger: half_started}", more=", for_each: robots")
        assert kinds(rules=many) == ["each_never_named"]
        assert kinds(rules=many.replace("half_started", "enters, entity: each, zone: pitch")) == []
        named = rule(
            "a",
            "{trigger: half_started}",
            "{action: emit, event: TOLD, payload: {who: {word: robot_name}}}",
            ", for_each: robots",
        )
        assert kinds(rules=named) == []

    @pytest.mark.parametrize(
        ("trigger", "condition", "contradicts"),
        [
            ("leaves, entity: ball, zone: a", "entity: ball, zone: a", True),
            ("leaves, entity: ball, zone: [a, b]", "entity: ball, zone: a", True),
            ("leaves, entity: ball, zone: a", "entity: ball, zone: [a, b]", False),
            ("leaves, entity: ball, zone: a", "entity: ball, zone: b", False),
            ("leaves, entity: ball, zone: a", "entity: ball, zone: a, negate: true", False),
            ("leaves, entity: ball, zone: a", "entity: Y1, zone: a", False),
            ("leaves, entity: yellow, zone: a", "entity: yellow, zone: a", False),  # another one may still be in it
            ("enters, entity: ball, zone: a", "entity: ball, zone: a, negate: true", True),
            ("enters, entity: ball, zone: a", "entity: ball, zone: a, of: none", True),
            ("enters, entity: ball, zone: a", "entity: ball, zone: a, of: none, negate: true", False),
            ("enters, entity: ball, zone: a", "entity: ball, zone: [a, b], negate: true", True),
            ("enters, entity: ball, zone: [a, b]", "entity: ball, zone: a, negate: true", False),
            ("enters, entity: ball, zone: a", "entity: ball, zone: a", False),
        ],
    )
    def test_who_has_just_left_a_zone_is_not_in_it_and_who_has_just_entered_it_is(
        self, trigger, condition, contradicts
    ):
        zones = "zones: {a: {shape: rect, x_min_m: 0.2}, b: {shape: rect, x_max_m: -0.2, drawn: true}}"
        when = f", conditions: [{{condition: in_zone, {condition}}}]"
        assert kinds(zones, rules=rule("r", f"{{trigger: {trigger}}}", more=when)) == ["rule_never_fires"] * contradicts

    def test_each_that_has_left_a_zone_is_not_in_it(self):
        when = ", for_each: robots, conditions: [{condition: in_zone, entity: each, zone: pitch}]"
        (finding,) = found_in(rules=rule("r", "{trigger: leaves, entity: each, zone: pitch}", more=when))
        assert (finding.kind, finding.problem.path) == ("rule_never_fires", "rules.r.triggers[0] (leaves)")

    def test_a_sequence_that_ignores_wrong_steps_never_breaks(self):
        broken = rule("a", "{trigger: sequence_broken, sequence: way}")
        way = "sequences: {way: {entity: ball, steps: [pitch, blue_goal], wrong_step: %s}}"
        assert kinds(way % "ignore", rules=broken) == ["sequence_never_breaks"]
        assert kinds(way % "break", rules=broken) == []

    def test_no_way_to_score_though_scores_decide(self):
        text = SOUND + rule("a", "{trigger: half_started}").join(("rules:\n", ""))
        assert [f.kind for f in lint(load_text(text))] == ["no_way_to_score"]
        by_time = lint(load_text(text + "result: {rank: [{time: ascending}]}\n"))
        assert "no_way_to_score" not in [f.kind for f in by_time]

    def test_without_points_the_advice_is_to_rank_by_something_else_or_by_what_follows_the_score(self):
        text = SOUND + rule("a", "{trigger: half_started}").join(("rules:\n", ""))
        (finding,) = lint(load_text(text))
        assert finding.remedy.endswith("or rank by a counter in result:")
        alone = text + "entrants: {blue: null}\nrobots: {B1: {idle: true}, B2: {idle: true}, B3: {idle: true}}\n"
        (finding,) = (f for f in lint(load_text(alone)) if f.kind == "no_way_to_score")
        assert finding.remedy.endswith("or rank by a time or a counter in result:")
        by_both = lint(load_text(text + "result: {rank: [{score: descending}, {time: ascending}]}\n"))
        (finding,) = (f for f in by_both if f.kind == "no_way_to_score")
        assert finding.remedy.endswith("or leave 'score' out of result:, so that what follows it decides")


class TestTwoRulesMoveOneThing:
    @staticmethod
    def pair(
        first: str = "", second: str = "", edge: str = "{trigger: enters, entity: ball, zone: yellow_goal}"
    ) -> str:
        put = "{action: place, entity: ball, at: {spot: %s}}"
        return rule(
            "a", "{trigger: enters, entity: ball, zone: [blue_goal, yellow_goal]}", put % "centre", first
        ) + rule("b", edge, put % "middle_blue", second)

    def test_on_one_edge_the_later_one_wins(self):
        (finding,) = found_in(rules=self.pair())
        assert finding.kind == "two_rules_move_one_thing"
        assert "it moves ball on the same edge (enters) as rule 'a'" in finding.problem.message

    def test_the_one_with_the_higher_priority_number_is_named(self):
        (finding,) = found_in(rules=self.pair(first=", priority: 5"))
        assert finding.problem.path == "rules.a"

    def test_a_touch_that_is_heard_again_begins_on_the_same_edge(self):
        touch = "{trigger: touches, entity: Y1, other: ball%s}"
        put = "{action: place, entity: ball, at: {spot: %s}}"
        rules = rule("a", touch % "", put % "centre") + rule("b", touch % ", every_s: 1", put % "middle_blue")
        assert kinds(rules=rules) == ["two_rules_move_one_thing"]

    def test_exclusive_contrary_conditions_other_phases_and_other_edges_are_sound(self):
        one = ", exclusive: outcome"
        assert kinds(rules=self.pair(one, one)) == []
        drawn = ", conditions: [{condition: drawn, draw: side, equals: %s}]"
        draws = "draws: {side: {values: [left, right]}}"
        assert kinds(draws, rules=self.pair(drawn % "left", drawn % "right")) == []
        assert kinds(draws, rules=self.pair(drawn % "left", drawn % "left")) == ["two_rules_move_one_thing"]
        counted = ", conditions: [{condition: counter, counter: yellow, %s}]"
        assert kinds(rules=self.pair(counted % "at_least: 3", counted % "at_most: 2")) == []
        assert kinds(rules=self.pair(counted % "at_least: 3", counted % "at_most: 3")) == ["two_rules_move_one_thing"]
        away = ", conditions: [{condition: last_touch, by: blue%s}]"
        assert kinds(rules=self.pair(away % "", away % ", negate: true")) == []
        assert kinds(rules=self.pair(edge="{trigger: leaves, entity: ball, zone: yellow_goal}")) == []

    @pytest.mark.parametrize(
        ("first", "second", "found"),
        [
            ("{action: place, entity: robots, at: start}", "{action: remove, entity: Y3}", False),
            ("{action: place, entity: robots, at: start}", "{action: remove, entity: yellow, for_s: 5}", False),
            ("{action: place, layout: all}", "{action: remove, entity: Y3}", False),
            # It puts nothing else: all in vain.
            ("{action: place, entity: Y3, at: start}", "{action: remove, entity: Y3}", True),
            # What is taken off is put back at once.
            ("{action: remove, entity: Y3}", "{action: place, entity: robots, at: start}", True),
            # Some of them have two places.
            ("{action: place, entity: robots, at: start}",
             "{action: remove, entity: Y3}, {action: place, entity: Y2, at: {point: [0, 0]}}", True),
            ("{action: place, entity: robots, at: start}, {action: remove, entity: Y3}", "{action: remove, entity: Y3}", True),
        ],
    )  # fmt: skip
    def test_a_later_rule_may_take_some_of_those_off_that_a_rule_puts(self, first, second, found):
        layouts = "placements: {all: [{entity: yellow, at: start}, {entity: blue, at: start}]}"
        rules = rule("a", "{trigger: half_started}", first) + rule("b", "{trigger: half_started}", second)
        assert ("two_rules_move_one_thing" in kinds(layouts, rules=rules)) is found

    def test_a_phase_that_the_first_one_enters_suppresses_the_second(self):
        rules = self.pair().replace("{spot: centre}}", "{spot: centre}}, {action: set_phase, phase: pause}")
        assert kinds("phases: {pause: {lasts_s: 1}}", rules=rules) == []

    def test_exclusive_counts_per_entity_and_does_not_help_against_a_rule_without_for_each(self):
        put = "{action: place, entity: robots, at: start}"
        one = rule("a", "{trigger: leaves, entity: each, zone: in_play}", put, ", for_each: robots, exclusive: moves")
        other = rule("b", "{trigger: leaves, entity: Y1, zone: in_play}", put, ", exclusive: moves")
        assert kinds(rules=one + other) == ["two_rules_move_one_thing", "exclusive_never_meets"]

    def test_layouts_and_drawn_layouts_move_what_is_in_them(self):
        layouts = (
            "placements: {one: [{entity: ball, at: {spot: centre}}], two: [{entity: ball, at: {spot: middle_blue}}]}"
        )
        begin = rule("a", "{trigger: half_started}", "{action: place, layout: one}")
        drawn = rule("b", "{trigger: half_started}", "{action: place, layout: {draw: which}}")
        assert kinds(layouts, "draws: {which: {values: [one, two]}}", rules=begin + drawn) == [
            "two_rules_move_one_thing"
        ]


class TestState:
    @pytest.mark.parametrize(
        ("section", "write", "read"),
        [
            ("counters: {it: {}}", "{action: count, counter: it}", "{condition: counter, counter: it, at_least: 1}"),
            ("flags: {it: {}}", "{action: set_flag, flag: it}", "{condition: flag, flag: it}"),
            ("flags: {it: {}}", "{action: toggle_flag, flag: it}", "{condition: flag, flag: it}"),
            ("timers: {it: {lasts_s: 5}}", "{action: timer, timer: it}", "{condition: timer, timer: it, at_least: 1}"),
            ("draws: {it: {values: [1, 2]}}", "{action: draw, draw: it}", "{condition: drawn, draw: it, equals: 1}"),
        ],
    )
    def test_what_is_remembered_is_both_written_and_read(self, section, write, read):
        noun = section.partition("s:")[0]
        writes = rule("a", "{trigger: half_started}", write)
        reads = rule("b", "{trigger: time_reached, at_s: 1}", more=f", conditions: [{read}]")
        assert kinds(section, rules=writes) == [f"{noun}_never_read"]
        assert kinds(section, rules=writes + reads) == []
        never = {
            "counter": ["counter_never_counted"],
            "flag": ["flag_never_set"],
            "timer": ["timer_never_started"],
            "draw": [],
        }
        assert kinds(section, rules=reads) == never[noun]

    def test_a_timer_that_starts_by_itself_and_a_counter_in_the_result_are_sound(self):
        expired = rule("a", "{trigger: timer_expired, timer: it}", "{action: count, counter: n}")
        assert (
            kinds(
                "timers: {it: {lasts_s: 5, starts: true}}",
                "counters: {n: {per: robots}}",
                "result: {rank: [{counter: n}]}",
                rules=expired,
            )
            == []
        )

    @pytest.mark.parametrize(("do", "starts"), [("restart", True), ("start", True), ("stop", False), ("reset", False)])
    def test_a_timer_that_is_only_stopped_or_reset_never_starts(self, do, starts):
        rules = rule("a", "{trigger: half_started}", f"{{action: timer, timer: t, do: {do}}}")
        rules += rule("b", "{trigger: timer_expired, timer: t}")
        assert kinds("timers: {t: {lasts_s: 5}}", rules=rules) == ([] if starts else ["timer_never_started"])
        assert kinds("timers: {t: {lasts_s: 5, starts: true}}", rules=rules) == []

    def test_a_counter_that_only_a_test_reads_is_not_read(self):
        count = rule("a", "{trigger: half_started}", "{action: count, counter: n}")
        test = "expect: {it: {keyframes: [{at_s: 1}], lasts_s: 1, counters: {n: 1}}}"
        assert kinds("counters: {n: {}}", test, rules=count) == ["counter_never_read"]

    def test_a_param_for_which_nothing_stands(self):
        assert kinds("params: {pause_s: 3}") == ["param_never_used"]
        assert kinds("params: {at: 3}", rules=rule("a", "{trigger: time_reached, at_s: {param: at}}")) == []

    def test_zones_gates_sequences_and_layouts_of_ones_own_that_nobody_names(self):
        found = kinds(
            "zones: {z: {shape: rect, x_min_m: 0}, line: {shape: rect, x_min_m: 0.2, drawn: true}}",
            "gates: {g: {from_m: [0, 0], to_m: [1, 0]}}",
            "sequences: {s: {entity: ball, steps: [pitch, blue_goal]}}",
            "placements: {l: [{entity: ball, at: {spot: centre}}]}",
        )
        assert found == ["zone_never_used", "gate_never_used", "sequence_never_used", "layout_never_used"]

    @pytest.mark.parametrize(
        ("body", "name"),
        [
            ("zones: {pitch: {y_max_m: 0.5}}", "pitch"),
            ("spots: {centre: {x_m: 0.1}}", "centre"),
            ("groups: {in_play: [pitch]}", "in_play"),
        ],
    )
    def test_what_the_base_brings_is_taken_away_by_null(self, body, name):
        # Left out it would be that of the base again, with numbers that the author has changed.
        (one,) = [str(one) for one in found_in(body) if one.kind.endswith("_never_used")]
        assert f"name it in a rule, or take away what the base brings by '{name}: null'" in one

    def test_a_zone_in_a_group_that_is_named_is_used(self):
        enters = rule("a", "{trigger: enters, entity: ball, zone: both}")
        assert kinds("zones: {z: {shape: rect, x_min_m: 0}}", "groups: {both: [z, blue_goal]}", rules=enters) == []

    @pytest.mark.parametrize(
        ("groups", "remedy"),
        [
            ("{doors: [g]}", "name it in a rule, or remove it together with the group that names it: doors"),
            (
                "{doors: [g, h], all: [doors], others: [h, g]}",
                "name it in a rule, or remove it together with the groups that name it: doors, others",
            ),
            ("{penalty_areas: [blue_penalty_area]}", "name it in a rule, or remove it"),
        ],
    )
    def test_what_a_group_without_a_use_names_goes_with_the_group(self, groups, remedy):
        gates = "gates: {g: {from_m: [0, 0], to_m: [1, 0]}, h: {from_m: [0, 0], to_m: [0, 1]}}"
        found = [one.remedy for one in found_in(gates, f"groups: {groups}") if one.kind == "gate_never_used"][:1]
        assert found == [remedy]


class TestTimes:
    @pytest.mark.parametrize(
        "trigger",
        [
            "{trigger: stays_in, entity: ball, zone: pitch, limit_s: %s}",
            "{trigger: no_progress, entity: ball, distance_m: 1, within_s: %s}",
            "{trigger: holds, condition: {condition: in_zone, entity: ball, zone: pitch}, for_s: %s}",
        ],
    )
    def test_a_limit_that_is_not_over_before_the_half_is(self, trigger):
        assert kinds(rules=rule("a", trigger % 60)) == ["limit_longer_than_the_half"]
        assert kinds(rules=rule("a", trigger % 59)) == []

    def test_timers_phases_absences_and_rests_too(self):
        enter = rule("a", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: long}")
        assert kinds("phases: {long: {lasts_s: 61}}", rules=enter) == ["limit_longer_than_the_half"]
        expired = rule("a", "{trigger: timer_expired, timer: t}")
        assert kinds("timers: {t: {lasts_s: 61, starts: true}}", rules=expired) == ["limit_longer_than_the_half"]
        assert kinds("timers: {t: {lasts_s: 60, starts: true}}", rules=expired) == []
        off = rule(
            "a", "{trigger: time_reached, at_s: 1}", "{action: remove, entity: Y1, for_s: 61}", ", cooldown_s: 61"
        )
        assert kinds(rules=off) == ["limit_longer_than_the_half"] * 2
        touched = rule("a", "{trigger: touches, entity: Y1, other: ball, every_s: %s}")
        assert kinds(rules=touched % 61) == ["limit_longer_than_the_half"]
        assert kinds(rules=touched % 1) == []
        again = rule("a", "{trigger: time_reached, at_s: 5, every_s: %s}")
        assert kinds(rules=again % 56) == ["limit_longer_than_the_half"]
        assert kinds(rules=again % 55) == []

    @pytest.mark.parametrize(
        "section", ["timers: {t: {lasts_s: {draw: d}, starts: true}}", "phases: {t: {lasts_s: {draw: d}}}"]
    )
    def test_of_a_drawn_duration_the_longest_counts(self, section):
        more = rule("a", "{trigger: timer_expired, timer: t}")
        if section.startswith("phases"):
            more = rule("a", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: t}")
        (found,) = found_in("draws: {d: {values: [5, 61]}}", section, rules=more)
        assert found.kind == "limit_longer_than_the_half"
        assert "61 s is not over before the half is, after 60 s: " in str(found)
        assert " when that is drawn; shorten it" in str(found)
        assert kinds("draws: {d: {values: [5, 60]}}", section, rules=more) == []

    @pytest.mark.parametrize(
        ("asked", "told"), [("equals: 3", "never"), ("at_least: 3", "never"), ("equals: 3, negate: true", "always")]
    )
    def test_a_half_that_is_not_played(self, asked, told):
        late = rule("a", "{trigger: half_started}", more=f", conditions: [{{condition: half, {asked}}}]")
        (found,) = found_in(rules=late, halves=2)
        assert found.kind == "half_never_played"
        assert f"only 2 halves are played: the condition {told} holds; correct" in str(found)
        assert kinds(rules=late, halves=3) == []

    def test_two_rules_for_different_halves_never_fire_together(self):
        put = "{action: place, entity: ball, at: start}"
        first, later, second = (
            rule(name, "{trigger: time_reached, at_s: 1}", put, f", conditions: [{{condition: half, {asked}}}]")
            for name, asked in (("a", "equals: 1"), ("b", "at_least: 2"), ("c", "equals: 2"))
        )
        assert kinds(rules=first + later, halves=2) == kinds(rules=first + second, halves=2) == []
        assert kinds(rules=later + second, halves=2) == ["two_rules_move_one_thing"]


class TestDraws:
    READ = rule("a", "{trigger: time_reached, at_s: 1}", more=", conditions: [{condition: drawn, draw: d, equals: 1}]")
    AGAIN = rule("b", "{trigger: time_reached, at_s: 2}", "{action: draw, draw: d}")

    @pytest.mark.parametrize(
        ("draw", "halves", "warned"),
        [
            ("not_again: half", 2, True),
            ("not_again: match", 1, True),
            ("not_again: match, keep: match", 2, True),
            ("not_again: match", 2, False),
        ],
    )
    def test_a_draw_without_repetition_that_is_drawn_only_once(self, draw, halves, warned):
        section = f"draws: {{d: {{values: [1, 2], {draw}}}}}"
        assert kinds(section, rules=self.READ, halves=halves) == ["draw_never_repeated"] * warned
        assert kinds(section, rules=self.READ + self.AGAIN, halves=halves) == []

    @pytest.mark.parametrize(("decided", "warned"), [("[1, 2]", True), ("[1]", False), ("1", False)])
    def test_a_test_that_decides_several_values_of_a_draw_that_is_drawn_once(self, decided, warned):
        section = "draws: {d: {values: [1, 2]}}"
        test = f"expect: {{t: {{lasts_s: 1, keyframes: [{{at_s: 0}}], draws: {{d: {decided}}}}}}}"
        assert kinds(section, test, rules=self.READ) == ["draw_never_repeated"] * warned
        assert kinds(section, test, rules=self.READ + self.AGAIN) == []

    @pytest.mark.parametrize(
        ("starts", "more", "warned"),
        [
            ("{action: draw, draw: d, as: 1}", "", True),
            ("{action: draw, draw: d, as: 1}", ", conditions: [{condition: half, equals: 2}]", False),
            ("{action: draw, draw: d}", "", True),
            ("{action: draw, draw: d}", ", conditions: [{condition: half, equals: 2}]", False),
            # What is drawn first is told before it is drawn anew.
            ("{action: emit, event: E, payload: {d: {draw: d}}}, {action: draw, draw: d}", "", False),
        ],
    )
    def test_a_test_that_decides_what_a_rule_sets_as_the_half_starts(self, starts, more, warned):
        test = "expect: {t: {lasts_s: 1, keyframes: [{at_s: 0}], draws: {d: 2}}}"
        rules = self.READ + rule("b", "{trigger: half_started}", starts, more=more)
        found = kinds("draws: {d: {values: [1, 2]}}", test, rules=rules, halves=2)
        assert found == ["draw_decided_in_vain"] * warned

    @pytest.mark.parametrize(("decided", "told"), [("2", "[2, 2]"), ("[1]", "[1, 1]"), ("[1, 2]", None)])
    def test_of_a_draw_that_a_rule_draws_anew_at_once_the_second_value_is_the_one_that_counts(self, decided, told):
        test = f"expect: {{t: {{lasts_s: 1, keyframes: [{{at_s: 0}}], draws: {{d: {decided}}}}}}}"
        rules = self.READ + rule("b", "{trigger: half_started}", "{action: draw, draw: d}")
        remedies = [one.remedy for one in found_in("draws: {d: {values: [1, 2]}}", test, rules=rules)]
        assert [f"'d: {told}'" in remedy for remedy in remedies] == ([True] if told else [])

    def test_a_draw_is_read_by_what_lasts_as_long_as_it_decides(self):
        expired = rule("a", "{trigger: timer_expired, timer: t}")
        timer = "timers: {t: {lasts_s: {draw: d}, starts: true}}"
        assert kinds("draws: {d: {values: [1, 2]}}", timer, rules=expired) == []


def test_every_kind_of_finding_is_explained_to_authors():
    source = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "rcj_challenges/scenario/lint").glob("*.py"))
    written = set(re.findall(r'^\s+"([a-z]+(?:_[a-z]+)+)",$', source, re.MULTILINE))
    page = (ROOT / "docs" / "authoring.md").read_text(encoding="utf-8")
    assert len(written) >= 10
    assert {kind for kind in written if kind not in page} == set()
