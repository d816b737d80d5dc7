"""Draws that decide among names: `each` and `other` as what was drawn, and what is wrong with them."""

import pytest

from rcj_challenges.scenario.lint.registry import lint
from tests.scenario.writing import loaded, problems_of, rule

DRAWS = """draws:
  catcher: {values: [B1, B2, Y1]}
  poisoned: {values: [ball, red]}
  odd: {values: [each, other, one]}
balls: {red: {start_m: [0.3, 0]}}
"""
TOUCH = "{trigger: touches, entity: robots, other: balls}"


def said(body):
    return [f"{problem.path}: {problem.message}" for problem in problems_of(loaded, DRAWS + body)]


def asked(condition, for_each="", trigger="{trigger: half_started}"):
    more = f"    for_each: {for_each}\n" if for_each else ""
    return said(rule(trigger, rest=f"    conditions: [{{condition: {condition}}}]\n{more}"))


def done(action, for_each="", trigger="{trigger: half_started}"):
    return said(rule(trigger, f"{{action: {action}}}", f"    for_each: {for_each}\n" if for_each else ""))


GOOD = [
    (asked, "drawn, draw: catcher, equals: each", "robots"),
    (asked, "drawn, draw: catcher, equals: each, negate: true", "yellow"),
    (asked, "drawn, draw: poisoned, equals: other", "", TOUCH),
    (asked, "any_of, conditions: [{condition: drawn, draw: catcher, equals: each}]", "blue"),
    (done, "draw, draw: poisoned, as: other", "", TOUCH),
    (done, "draw, draw: poisoned, as: each", "balls"),
    # Where the rule has no such name, a value may be called so, as before there were names.
    (asked, "drawn, draw: odd, equals: other"),
    (asked, "drawn, draw: odd, equals: each", "", TOUCH),
    (done, "draw, draw: odd, as: other", "robots"),
]


@pytest.mark.parametrize("case", GOOD, ids=[case[1] for case in GOOD])
def test_a_rule_asks_whether_its_own_one_is_drawn(case):
    write, *arguments = case
    assert write(*arguments) == []


BAD = [
    (asked, "drawn, draw: catcher, equals: each", "", "{trigger: half_started}", "conditions[0] (drawn)",
     "'each' is known only in a rule with for_each"),
    (asked, "drawn, draw: poisoned, equals: other", "robots", "{trigger: half_started}", "conditions[0] (drawn)",
     "'other' is known only in a rule whose triggers are all touches; give what else sets it off its own rule"),
    (asked, "drawn, draw: catcher, equals: each", "balls", "{trigger: half_started}", "conditions[0] (drawn)",
     "'each' stands for 'ball', which is never drawn; it draws from B1, B2, Y1"),
    (asked, "drawn, draw: odd, equals: other", "", TOUCH, "conditions[0] (drawn)",
     "'other' is a value of the draw and a name that this rule has; give the value another name"),
    (done, "draw, draw: catcher, as: each", "robots", "{trigger: half_started}", "actions[0] (draw)",
     "'each' stands for 'B3', which is never drawn; it draws from B1, B2, Y1"),
    (done, "draw, draw: catcher, as: other", "", TOUCH, "actions[0] (draw)",
     "'other' stands for 'ball', which is never drawn; it draws from B1, B2, Y1"),
]  # fmt: skip


@pytest.mark.parametrize(("write", "text", "for_each", "trigger", "where", "message"), BAD)
def test_what_is_wrong_with_it_is_said(write, text, for_each, trigger, where, message):
    (found,) = write(text, for_each, trigger)
    assert found.startswith(f"rules.r.{where}")
    assert found.endswith(message)


def warned(values, more="", for_each="robots"):
    body = f"draws: {{d: {{values: {values}}}}}\n" + rule(
        rest=f"    for_each: {for_each}\n    conditions: [{{condition: drawn, draw: d, equals: each}}]\n"
    )
    return [found for found in lint(loaded(body + more)) if found.code == "drawn_name_of_nobody"]


class TestDrawnNameOfNobody:
    @pytest.mark.parametrize("values", ["[B1, Y3]", "[B1, nobody]", "[B1, ball]", "[B1, 3]"])
    def test_names_and_what_stands_for_nobody_are_in_order(self, values):
        assert warned(values) == []


KEEPERS = (
    "robots: {keeper_one: {colour: blue, number: 7, kit: v2, start: {x_m: 0.2, y_m: 0, yaw_rad: 0}}, "
    "keeper_two: {colour: blue, number: 8, kit: v2, start: {x_m: 0.4, y_m: 0, yaw_rad: 0}}}\n"
)


class TestLintOfTwoRules:
    PUT = "{action: place, entity: ball, at: start}"

    def moving(self, *rules):
        text = "".join(
            f"  {name}: {{triggers: [{trigger}], actions: [{self.PUT}], conditions: [{condition}]{more}}}\n"
            for name, (trigger, condition, more) in zip("ab", rules, strict=True)
        )
        found = lint(loaded(DRAWS + "rules:\n" + text))
        return [one.code for one in found if one.code == "two-rules-move-one-thing"]

    EACH = "{trigger: touches, entity: each, other: walls}"
