"""Lint of two rules that move one thing: which conditions exclude each other, and what helps where they do not."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.trials import try_expectation
from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

SECTIONS = """schema_version: 1
id: it
title: It
extends: soccersim_v2
match: {half_s: 60, halves: 2}
balls: {silver: {start_m: [-0.3, 0]}}
groups: {goals: [blue_goal, yellow_goal], sides: [left, right]}
zones: {left: {shape: rect, x_max_m: 0}, right: {shape: rect, x_min_m: 0}, disc: {shape: circle, centre_m: [0.3, 0], radius_m: 0.1}}
draws: {side: {values: [a, b]}}
flags: {hot: {}}
counters: {n: {}}
sequences: {way: {entity: ball, steps: [left, right]}, own: {per: robots, steps: [left, right]}}
"""
RULE = "  %s: {%striggers: [%s], conditions: [%s], actions: [{action: place, entity: %s, at: start}], says: So.}\n"
IN_GOALS = "{trigger: enters, entity: %s, zone: goals}"


def rule(
    name: str, conditions: str = "", more: str = "", trigger: str = IN_GOALS % "ball", entity: str = "ball"
) -> str:
    return RULE % (name, more, trigger, conditions, entity)


def found(rules: str, kind: str = "two_rules_move_one_thing") -> list[Finding]:
    return [one for one in lint(load_text(f"{SECTIONS}rules:\n{rules}", file="it.yaml")) if one.kind == kind]


def either(*conditions: str, word: str = "any_of", negate: bool = False) -> str:
    turned = "negate: true, " if negate else ""
    return f"{{condition: {word}, {turned}conditions: [{', '.join(conditions)}]}}"


HOT, COLD = "{condition: flag, flag: hot}", "{condition: flag, flag: hot, negate: true}"
A, B = (f"{{condition: drawn, draw: side, equals: {side}}}" for side in "ab")
N = "{condition: counter, counter: n, %s}"
AT = "{condition: sequence_at, sequence: %s, step: %s}"
FAST = "{condition: speed, entity: ball, %s}"


@pytest.mark.parametrize(
    ("one", "other", "both_can"),
    [
        (HOT, COLD, False),
        (either(HOT, A), COLD, True),
        (either(HOT, A), f"{COLD}, {B}", False),
        (either(HOT, A), either(COLD, B), True),
        (either(HOT, A, word="all_of"), either(COLD, B, word="all_of"), False),
        (either(HOT, A), either(HOT, A, negate=True), False),
        (either(HOT, A, word="all_of", negate=True), f"{HOT}, {A}", False),
        (either(HOT, either(A, B, word="all_of")), COLD, False),  # both sides are never drawn at once
        (A, B, False),
        (N % "at_most: 2", N % "at_least: 3", False),
        (N % "at_most: 3", N % "equals: 3", True),
        (N % "at_most: {counter: yellow}", N % "at_least: 9", True),
        (FAST % "at_least: 0.3", FAST % "at_most: 0.2", False),
        (FAST % "at_least: 0.3", FAST.replace("ball", "silver") % "at_most: 0.2", True),
        ("{condition: last_touch, by: blue}", "{condition: last_touch, by: [Y1, Y2]}", False),
        ("{condition: last_touch, by: blue}", "{condition: last_touch, by: robots}", True),
        ("{condition: half, equals: 1}", "{condition: half, at_least: 2}", False),
        (AT % ("way", "left"), AT % ("way", "right"), False),
        (AT % ("way", "left"), AT % ("own", "right, entity: Y1"), True),
        (AT % ("own", "left, entity: Y1"), AT % ("own", "right, entity: Y1"), False),
        (AT % ("own", "left, entity: Y1"), AT % ("own", "right, entity: Y2"), True),
        (AT % ("own", "left, of: all"), AT % ("own", "right, of: all"), False),
        (AT % ("own", "left"), AT % ("own", "right"), True),  # some of them here, others there
        (AT % ("own", "left, of: none"), AT % ("own", "right, of: none"), True),
        *(
            (f"{{condition: in_zone, entity: Y1, zone: {here}}}", f"{{condition: in_zone, entity: {who}, zone: {there}}}", can)
            for here, who, there, can in (
                ("left", "Y1", "right", False),
                ("left", "Y1", "disc", False),
                ("right", "Y1", "disc", True),
                ("left", "Y2", "right", True),
                ("left", "Y1", "[right, pitch]", True),
            )
        ),
        ("{condition: in_zone, entity: yellow, zone: left}", "{condition: in_zone, entity: yellow, zone: right}", True),
    ],
)  # fmt: skip
def test_conditions_of_which_only_one_can_hold(one, other, both_can):
    assert len(found(rule("a", one) + rule("b", other))) == both_can


@pytest.mark.parametrize(
    ("one", "other", "both_can"),
    [
        ("of: none", "of: any", False),
        ("of: none", "of: none, negate: true", False),
        ("of: none, negate: true", "of: any", True),
        ("of: any", "of: all", True),
    ],
)
def test_none_of_them_is_not_any_of_them(one, other, both_can):
    first, second = (f"{{condition: in_zone, entity: yellow, zone: left, {of}}}" for of in (one, other))
    assert bool(found(rule("a", first) + rule("b", second))) == both_can


TOLD = "{condition: told, %s}"


@pytest.mark.parametrize(
    ("one", "other", "both_can"),
    [
        ("entity: Y1, text: a", "entity: Y1, text: b", False),
        ("entity: Y1, text: a", "entity: Y2, text: b", True),
        ("entity: yellow, text: a", "entity: yellow, text: b", True),  # each of two may have said one of them
        ("entity: yellow, text: a, of: all", "entity: yellow, text: b, of: all", False),
        ("entity: Y1, text: [a, 2]", "entity: Y1, text: ['2.0', c]", True),
        ("entity: Y1, text: [a, 2]", "entity: Y1, text: [b, 3]", False),
        ("entity: Y1, text: a", "entity: Y1", True),
        ("entity: Y1, text: a", "entity: Y1, is_a: number", False),
        ("entity: Y1, is_a: position", "entity: Y1, is_a: number", False),
        ("entity: Y1, text: {draw: side}", "entity: Y1, text: c", False),
        ("entity: Y1, text: {draw: side}", "entity: Y1, text: b", True),
        ("entity: Y1, text: a", "entity: Y1, text: a, negate: true", False),
        ("entity: Y1, text: a", "entity: Y1, text: b, negate: true", True),
    ],
)
def test_a_robot_has_said_one_thing_last(one, other, both_can):
    assert bool(found(rule("a", TOLD % one) + rule("b", TOLD % other))) == both_can


def test_the_edge_itself_says_where_its_entity_is():
    into_blue = "{trigger: enters, entity: ball, zone: blue_goal}"
    asked = "{condition: in_zone, entity: %s, zone: %s}"
    for who, zone, both_can in (("ball", "yellow_goal", False), ("ball", "blue_goal", True), ("silver", "left", True)):
        assert len(found(rule("a", trigger=into_blue) + rule("b", asked % (who, zone)))) == both_can


def test_each_is_the_one_that_the_edge_is_about():
    each = {"trigger": IN_GOALS % "each", "entity": "each", "more": "for_each: balls, "}
    silver_moves_ball = rule("b", trigger=IN_GOALS % "silver", entity="ball")
    assert found(rule("a", **each) + silver_moves_ball) == []
    asked = "{condition: in_zone, entity: %s, zone: left}"
    right = rule("b", "{condition: in_zone, entity: ball, zone: right}")
    assert found(rule("a", asked % "each", **each) + right) == []
    assert len(found(rule("a", asked % "silver", **each) + right)) == 1


class TestAdvice:
    BOTH = "give both the same exclusive:, or conditions of which only one can hold"

    def test_exclusive_helps_two_rules_without_for_each_or_for_the_same(self):
        (one,) = found(rule("a") + rule("b"))
        assert one.remedy == self.BOTH
        assert found(rule("a", more="exclusive: e, ") + rule("b", more="exclusive: e, ")) == []
        each = rule("b", more="for_each: balls, ", trigger=IN_GOALS % "each", entity="each")
        single = rule("a", more="for_each: ball, ", trigger=IN_GOALS % "each", entity="each")
        (one,) = found(single + each)
        assert one.remedy == self.BOTH
        together = (single + each).replace("for_each", "exclusive: e, for_each")
        assert found(together) == found(together, "exclusive_never_meets") == []

    def test_where_only_one_has_for_each_both_need_it_first(self):
        each = rule("b", more="for_each: balls, ", trigger=IN_GOALS % "each", entity="each")
        (one,) = found(rule("a") + each)
        assert one.remedy.startswith("give them conditions of which only one can hold, or a for_each to both")
        (same,) = found(rule("a", more="exclusive: e, ") + each.replace("for_each", "exclusive: e, for_each"))
        assert same.remedy == one.remedy

    def test_where_they_are_for_different_entities_no_exclusive_helps(self):
        for_blue, for_yellow = (
            rule(colour, "{condition: in_zone, entity: each, zone: pitch}", f"for_each: {colour}, exclusive: e, ")
            for colour in ("blue", "yellow")
        )
        (one,) = found(for_blue + for_yellow)
        assert one.remedy.endswith("exclusive: counts per entity, and theirs differ")


def test_two_balls_in_one_tick_set_off_both_rules_as_the_finding_says():
    """One is right and one is wrong; the condition of the wrong one names both, not the one that came."""
    rules = rule("right", trigger="{trigger: enters, entity: ball, zone: blue_goal}") + rule(
        "wrong",
        either(
            "{condition: in_zone, entity: ball, zone: yellow_goal}",
            "{condition: in_zone, entity: silver, zone: blue_goal}",
        ),
        "for_each: balls, ",
        IN_GOALS % "each",
        "each",
    )
    assert len(found(rules)) == 1
    counted = rules.replace("actions: [", "actions: [{action: count, counter: n}, ")
    test = (
        "expect: {it: {keyframes: [{at_s: 1, place: {ball: [-0.1, 0.8], silver: [0.1, 0.8]}}], lasts_s: 2, "
        "counters: {n: 3}}}\n"
    )
    loaded = load_text(f"{SECTIONS}{test}rules:\n{counted}", file="it.yaml")
    assert try_expectation(loaded, "it").differences == ()


class TestRulesThatHearSequences:
    OF = "{trigger: sequence_completed, sequence: own%s}"

    @pytest.mark.parametrize(
        ("one", "other", "meet"),
        [
            ("", "", True),
            ("", ", entity: Y1", True),
            (", entity: blue", ", entity: [B2, Y1]", True),
            (", entity: blue", ", entity: yellow", False),
        ],
    )
    def test_two_rules_meet_on_the_sequence_of_one_and_the_same(self, one, other, meet):
        rules = rule("a", trigger=self.OF % one) + rule("b", trigger=self.OF % other)
        assert bool(found(rules)) == meet

    def test_each_is_the_one_whose_sequence_it_is(self):
        each = rule("a", more="for_each: robots, ", trigger=self.OF % ", entity: each", entity="each")
        assert found(each + rule("b", trigger=self.OF % ", entity: Y1", entity="Y1"))
        assert not found(each + rule("b", trigger=self.OF % ", entity: Y1", entity="Y2"))


def test_of_a_step_that_each_stands_for_any_of_them_may_be_meant():
    over = rule("a", AT % ("way", "each"), more="for_each: sides, ")
    assert found(over + rule("b", AT % ("way", "right")))
    assert not found(over.replace("sides", "left") + rule("b", AT % ("way", "right")))


FLAGS = (
    "obstacles: {f: {shape: cylinder, centre_m: [0, 0.6], radius_m: 0.02, movable: true}, "
    "g: {shape: cylinder, centre_m: [0, -0.6], radius_m: 0.02, movable: true}}\n"
)
TAKES = (
    "{for_each: %s, exclusive: one, triggers: [{trigger: touches, entity: each, other: %s}], "
    "actions: [{action: hold, entity: other, for_s: 1}], says: T.}"
)


@pytest.mark.parametrize(("first", "warned"), [("yellow", False), ("Y1", True)])
def test_rules_that_each_stop_themselves_need_not_meet(first, warned):
    # Where a flag is touched by two at once, the second of them is stopped, whatever other rules share the group.
    rules = f"rules: {{a: {TAKES % ('f', first)}, b: {TAKES % ('g', 'blue' if first == 'yellow' else 'B1')}}}\n"
    loaded = load_text(
        "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + FLAGS + rules
    )
    assert ("exclusive_never_meets" in {one.kind for one in lint(loaded)}) is warned
