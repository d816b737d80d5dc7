"""What rules do as a half starts: one that leaves the phase keeps those after it from firing, and from what they set."""

from __future__ import annotations

import pytest

from tests.scenario.linting import found_in, kinds, rule

START = "{trigger: half_started}"
INTRO = "phases: {intro: {lasts_s: 1, next: play}}"
ENTER = "{action: set_phase, phase: intro}"


@pytest.mark.parametrize(
    ("leaves", "stays", "warned"),
    [
        ("", "", True),
        (", exclusive: one", "", False),
        ("", ", phases: any", False),
        ("", ", priority: -1", False),
        (", priority: 1", "", False),
    ],
)
def test_a_rule_never_fires_whose_phase_another_rule_has_left_by_then(leaves, stays, warned):
    rules = rule("a", START, ENTER, more=leaves) + rule("b", START, more=stays)
    found = [str(one) for one in found_in(INTRO, rules=rules) if one.kind == "rule_never_fires"]
    told = (
        "rules.b.triggers[0] (half_started): as a half starts another rule enters intro before it, in which this rule "
        "does not live; add 'intro' to its phases, or let it come first: it needs a lower priority"
    )
    assert [told in one for one in found] == [True] * warned


@pytest.mark.parametrize(
    ("more", "warned"),
    [
        ("", False),
        (", phases: any", True),
        (", phases: [play, intro]", True),
        (", phases: any, exclusive: one", False),
        (", priority: -1", True),
    ],
)
def test_a_rule_that_others_keep_from_firing_sets_no_draw(more, warned):
    asked = rule("a", "{trigger: time_reached, at_s: 1}", more=", conditions: [{condition: drawn, draw: d, equals: 1}]")
    test = "expect: {t: {lasts_s: 1, keyframes: [{at_s: 0}], draws: {d: 2}}}"
    rules = asked + rule("b", START, ENTER) + rule("c", START, "{action: draw, draw: d, as: 1}", more=more)
    found = kinds("draws: {d: {values: [1, 2]}}", INTRO, test, rules=rules)
    assert ("draw_decided_in_vain" in found) == warned
