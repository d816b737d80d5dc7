"""Draws that decide among names: `each` and `other` as what was drawn, and what is wrong with them."""

import pytest

from tests.scenario.writing import in_short, loaded, problems_of, rule

DRAWS = """draws:
  catcher: {values: [B1, B2, Y1]}
  poisoned: {values: [ball, red]}
  odd: {values: [each, other, one]}
balls: {red: {start_m: [0.3, 0]}}
"""
TOUCH = "{trigger: touches, entity: robots, other: balls}"


def said(body):
    return [in_short(problem) for problem in problems_of(loaded, DRAWS + body)]


def asked(condition, for_each="", trigger="{trigger: half_started}"):
    more = f"    for_each: {for_each}\n" if for_each else ""
    return said(rule(trigger, rest=f"    conditions: [{{{condition}}}]\n{more}"))


def done(action, for_each="", trigger="{trigger: half_started}"):
    return said(rule(trigger, f"{{action: {action}}}", f"    for_each: {for_each}\n" if for_each else ""))


GOOD = [
    (asked, "draw: catcher, equals: each", "robots"),
    (asked, "draw: catcher, equals: each, negate: true", "yellow"),
    (asked, "draw: poisoned, equals: other", "", TOUCH),
    (asked, "any_of: [{draw: catcher, equals: each}]", "blue"),
    (asked, "draw: catcher, equals: each", "obstacles"),  # of which there are none
    (done, "draw, draw: poisoned, as: other", "", TOUCH),
    (done, "draw, draw: poisoned, as: each", "balls"),
    # Where the rule has no such name, a value may be called so, as before there were names.
    (asked, "draw: odd, equals: other"),
    (asked, "draw: odd, equals: each", "", TOUCH),
    (done, "draw, draw: odd, as: other", "robots"),
]


@pytest.mark.parametrize("case", GOOD, ids=[case[1] for case in GOOD])
def test_a_rule_asks_whether_its_own_one_is_drawn(case):
    write, *arguments = case
    assert write(*arguments) == []


BAD = [
    (asked, "draw: catcher, equals: each", "", "{trigger: half_started}", "unbound-name"),
    (asked, "draw: poisoned, equals: other", "robots", "{trigger: half_started}", "unbound-name"),
    (asked, "draw: catcher, equals: each", "balls", "{trigger: half_started}", "never-drawn"),
    (done, "draw, draw: catcher, as: each", "robots", "{trigger: half_started}", "never-drawn"),
    (done, "draw, draw: catcher, as: other", "", TOUCH, "never-drawn"),
]


@pytest.mark.parametrize(("write", "text", "for_each", "trigger", "code"), BAD)
def test_name_that_cannot_be_drawn_is_refused(write, text, for_each, trigger, code):
    assert write(text, for_each, trigger) == [
        f"{code} rules.r.{'conditions' if write is asked else 'actions'}[0] (draw)"
    ]
