"""Lint of flags that lock themselves: only who finds them set would set them."""

from __future__ import annotations

import pytest

from tests.scenario.linting import found_in

FLAGS = ("flags: {seen: {}, open: {initial: true}, kept: {per: robots}}",)


def rule(name: str, conditions: str, actions: str, more: str = "") -> str:
    return (
        f"  {name}: {{{more} triggers: [{{trigger: touches, entity: robots, other: ball}}], conditions: [{conditions}], "
        f"actions: [{actions}, {{action: emit, event: E}}], says: So.}}\n"
    )


def locked(rules: str) -> list[str]:
    return [str(one) for one in found_in(*FLAGS, rules=rules) if one.kind == "rule_never_fires"]


SEEN, UNSEEN = "{condition: flag, flag: seen}", "{condition: flag, flag: seen, negate: true}"
SEE = "{action: set_flag, flag: seen}"


def test_a_rule_that_asks_for_what_only_it_sets():
    (one,) = locked(rule("a", SEEN, SEE))
    assert one.endswith(
        "rules.a.conditions[0] (flag): it asks that flag 'seen' is set, and no other rule sets it; negate: true asks that it "
        "is not set yet; else set it in a rule without this condition [rule_never_fires]"
    )


def test_several_that_wait_for_each_other():
    found = locked(rule("a", SEEN, SEE) + rule("b", SEEN, "{action: toggle_flag, flag: seen}"))
    assert len(found) == 2
    assert "is set, and only rules that ask the same set it: a, b;" in found[0]


def test_a_flag_that_begins_set_and_is_never_cleared():
    closed, close = "{condition: flag, flag: open, negate: true}", "{action: set_flag, flag: open, to: false}"
    (one,) = locked(rule("a", closed, close))
    assert (
        "it asks that flag 'open' is not set, and no other rule clears it; without negate it asks that it is still set;"
        in one
    )
    assert locked(rule("a", "{condition: flag, flag: open}", close)) == []


def test_whose_flag_it_is_does_not_matter_where_nobody_has_one():
    each = "{condition: flag, flag: kept, entity: each}"
    assert len(locked(rule("a", each, "{action: set_flag, flag: kept, entity: Y1}", "for_each: robots,"))) == 1


IN_ZONE = "{condition: in_zone, entity: ball, zone: blue_goal}"


@pytest.mark.parametrize(
    "asked",
    [
        f"{{condition: all_of, conditions: [{IN_ZONE}, {SEEN}]}}",
        f"{{condition: any_of, conditions: [{SEEN}, {{condition: all_of, conditions: [{SEEN}, {IN_ZONE}]}}]}}",
    ],
)
def test_so_it_is_where_the_flag_is_asked_for_among_other_things(asked):
    (one,) = locked(rule("a", asked, SEE))
    assert "rules.a.conditions[0]" in one


def holding(condition: str, more: str = "") -> str:
    holds = f"{{trigger: holds, condition: {condition}, for_s: 2}}"
    return f"  a: {{triggers: [{holds}{more}], actions: [{SEE}, {{action: emit, event: E}}], says: So.}}\n"


def test_and_where_a_trigger_waits_for_it():
    both = f"{{condition: all_of, conditions: [{IN_ZONE}, {SEEN}]}}"
    (one,) = locked(holding(both))
    assert "rules.a.triggers[0] (holds): it asks that flag 'seen' is set, and no other rule sets it" in one
    assert locked(holding(both, ", {trigger: half_started}")) == []
    assert locked(holding(f"{{condition: all_of, conditions: [{IN_ZONE}, {SEEN}], negate: true}}")) == []
    assert locked(holding(f"{{condition: any_of, conditions: [{IN_ZONE}, {SEEN}]}}")) == []


@pytest.mark.parametrize(
    "rules",
    [
        rule("a", UNSEEN, SEE),
        rule("a", SEEN, SEE) + rule("b", "{condition: half, equals: 1}", SEE),
        rule("a", SEEN, "{action: set_flag, flag: seen, to: false}") + rule("b", UNSEEN, SEE),
        rule("a", "{condition: any_of, conditions: [" + SEEN + ", {condition: half, equals: 1}]}", SEE),
        rule("a", "{condition: flag, flag: kept, of: none}", "{action: set_flag, flag: kept, entity: Y1}"),
    ],
)
def test_what_another_rule_or_the_opposite_opens_is_not_locked(rules):
    assert locked(rules) == []
