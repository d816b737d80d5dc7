"""Counters that keep the lowest or highest of what they are given, and what goes back to its beginning."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from tests.referee.building import emitting, fail, on_fault, payload, place

SECOND = "schema_version: 2\n"


def count(value: str, counter: str = "n", robot: str = "B1") -> str:
    return on_fault(robot, f"{{action: count, counter: {counter}, {value}}}", name=f"count_{robot}")


class TestTheBestCounts:
    """Of several attempts only the best one counts; who has made none has no result."""

    @pytest.mark.parametrize(("keeps", "best"), [("lowest", [3, 3, 2]), ("highest", [3, 5, 5])])
    def test_of_three_attempts(self, stage, keeps, best):
        play = stage(SECOND, f"counters: {{x: {{}}, n: {{keeps: {keeps}}}}}", count("to: {counter: x}"))
        seen = [play.referee.counters["n"]]
        for attempt in (3, 5, 2):
            play.referee.counters["x"] = attempt
            seen.append(fail(play, "B1").referee.counters["n"])
        assert seen == [None, *best]

    def test_an_attempt_without_a_result_changes_nothing(self, stage):
        play = stage(SECOND, "counters: {n: {keeps: lowest}}", count("to: {told: Y1}"))
        assert fail(play, "B1").referee.counters["n"] is None

    def test_it_may_begin_with_a_mark_to_beat(self, stage):
        play = stage(SECOND, "counters: {n: {keeps: lowest, initial: 20}}", count("to: 30"))
        assert fail(play, "B1").referee.counters["n"] == 20

    def test_what_has_no_result_has_nothing_added(self, stage):
        play = stage(SECOND, "counters: {n: {initial: none}}", count("by: 1"))
        assert fail(play, "B1").referee.counters["n"] is None

    def test_programs_and_events_get_nothing_and_comparisons_are_false(self, stage):
        told = (
            "{n: {counter: n}, sum: {counter: n, plus: 1}, best: {highest: {counter: of}}, all: {sum: {counter: of}}}"
        )
        play = stage(
            SECOND,
            "counters: {n: {initial: none}, of: {per: robots, keeps: highest}}",
            emitting(told),
            "rules: {low: {triggers: [{trigger: program_fault}], conditions: [{counter: n, below: 9}],"
            " actions: [{action: score, entrant: blue}]}}",
        )
        assert payload(play) == {"n": None, "sum": None, "best": None, "all": 0}
        assert play.referee.scores["blue"] == 0

    def test_in_the_sum_of_several_those_without_a_result_are_passed_over(self, stage):
        play = stage(
            SECOND,
            "counters: {n: {per: robots, keeps: highest}}",
            count("entity: B2, to: 4"),
            emitting("{n: {counter: n}}"),
        )
        assert payload(play, fault="B1") == {"n": 4}

    def test_a_result_that_is_kept_for_the_match_may_be_none(self, stage):
        play = stage(SECOND, "counters: {n: {keep: match, keeps: lowest}}", count("to: 3"))
        assert play.referee.kept["counters"] == {"n": None}


class TestReset:
    STATE = """
counters: {a: {initial: 3}, b: {per: robots}}
flags: {c: {per: robots, initial: true}}
zones: {west: {shape: rect, x_max_m: -0.3}, east: {shape: rect, x_min_m: 0.3}}
sequences: {d: {per: robots, steps: [west, east], when_placed: goes_on}}
rules:
  change:
    triggers: [{trigger: program_fault, robot: Y1}]
    actions: [{action: count, counter: a}, {action: count, counter: b, by: 2}, {action: set_flag, flag: c, to: false}]
  across: {triggers: [{trigger: sequence_completed, sequence: d}], actions: [{action: emit, event: ACROSS}]}
"""

    def after(self, stage, reset: str, *, more: str = "", robot: str = "B1", failing: str = "B1"):
        play = stage(SECOND, self.STATE, on_fault(robot, f"{{action: reset, {reset}}}", more=more))
        for x in (-0.5, 0):
            place(play, "B1", x, 0)
            place(play, "B2", x, 0.3)
        fail(fail(play), failing)
        place(play, "B1", 0.5, 0)
        place(play, "B2", 0.5, 0.3)
        across = [event.payload for event in play.events_named("ACROSS")]
        counters, flags = play.referee.counters, play.referee.flags
        return counters["a"], counters["b"]["B1"], counters["b"]["B2"], flags["c"]["B1"], flags["c"]["B2"], len(across)

    def test_without_it_nothing_is_as_at_the_beginning(self, stage):
        assert self.after(stage, "counter: a", failing="B2") == (4, 2, 2, False, False, 2)

    def test_all_that_is_named_goes_back_to_its_beginning(self, stage):
        assert self.after(stage, "counter: [a, b], flag: c, sequence: d") == (3, 0, 0, True, True, 0)

    def test_in_a_rule_for_each_it_is_what_belongs_to_that_robot(self, stage):
        state = self.after(stage, "counter: [a, b], flag: c, sequence: d", more="for_each: robots,", robot="each")
        assert state == (3, 0, 2, True, False, 1)

    @pytest.mark.parametrize(("whose", "second"), [("B1", 2), ("blue", 0), ("[B1, B2]", 0)])
    def test_it_may_name_whose(self, stage, whose, second):
        state = self.after(stage, f"counter: b, flag: c, entity: {whose}")
        assert state[1:5] == (0, second, True, second == 0)

    def test_a_preset_of_a_test_is_not_the_beginning(self):
        text = """
schema_version: 2
id: it
title: It
extends: soccersim_v2
counters: {n: {initial: 1}, m: {per: robots}}
rules: {r: {triggers: [{trigger: half_started}], actions: [{action: reset, counter: [n, m]}]}}
expect: {it: {given: {counters: {n: 7, m: 4}}, keyframes: [{at_s: 1}], lasts_s: 2, counters: {n: 1, m: 0}}}
"""
        assert run_test(load_text(text), "it").differences == ()

    @pytest.mark.parametrize("names", ["", "entity: B1", "flag: nothing", "counter: [a, n]", "counter: a, entity: B1"])
    def test_it_must_name_what_there_is(self, names):
        with pytest.raises(ScenarioError):
            load_text(
                f"{SECOND}id: it\ntitle: It\nextends: soccersim_v2\ncounters: {{a: {{}}}}\n"
                f"rules: {{r: {{triggers: [{{trigger: half_started}}], actions: [{{action: reset, {names}}}]}}}}\n"
            )


def test_a_flag_is_turned_over(stage):
    play = stage(SECOND, "flags: {f: {}}", on_fault("B1", "{action: set_flag, flag: f, to: opposite}"))
    assert [fail(play, "B1").referee.flags["f"] for _ in range(2)] == [True, False]
