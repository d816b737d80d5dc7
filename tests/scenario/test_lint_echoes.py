"""Lint of rules that set themselves off, on and on."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD


def found(*rules):
    text = HEAD + "phases: {wait: {lasts_s: 1}}\nrules:\n" + "".join(f"  {rule}\n" for rule in rules)
    return [str(one) for one in lint(load_text(text, file="a.yaml")) if one.kind == "rule_sets_itself_off"]


def rule(name, hears, emits, more=""):
    return (
        f"{name}: {{{more}triggers: [{{trigger: event, event: {hears}}}, {{trigger: enters, entity: ball, zone: pitch}}], "
        f"actions: [{{action: emit, event: {emits}}}], says: It goes on.}}"
    )


def test_a_rule_that_hears_its_own_event_fires_in_every_tick():
    (text,) = found(rule("go", "GO", "GO"))
    assert text.partition("warning: ")[2] == (
        "rules.go: it waits for GO, which it sets off itself: once it has fired it fires in every tick, to the end; wait "
        "for another event, or let something keep it from it: a condition, cooldown_s, max_executions "
        "[rule_sets_itself_off]"
    )


def test_two_rules_that_hear_each_other_are_one_finding():
    (text,) = found(rule("there", "BACK", "THERE"), rule("back", "THERE", "BACK"))
    assert "rules.there: it waits for BACK, which it sets off itself, by way of 'back': " in text
    assert "it fires every 2 ticks" in text


@pytest.mark.parametrize(
    "more",
    [
        "cooldown_s: 1, ",
        "max_executions: 3, ",
        "conditions: [{condition: in_zone, entity: ball, zone: blue_goal}], ",
        "phases: [wait], ",
    ],
)
def test_what_may_keep_it_from_firing_again_is_enough(more):
    assert found(rule("there", "BACK", "THERE"), rule("back", "THERE", "BACK", more)) == []


def test_a_rule_that_leaves_the_phase_does_not_go_on():
    leaves = rule("go", "GO", "GO").replace("event: GO}]", "event: GO}, {action: set_phase, phase: wait}]")
    assert found(leaves) == []


def test_an_event_of_another_one_sets_nobody_off():
    assert found(rule("there", "BACK", "THERE"), rule("back", "AWAY", "BACK")) == []


def of_each(name, hears, emits, group="robots"):
    return rule(name, hears, emits, f"for_each: {group}, ").replace(
        f"event: {hears}}},", f"event: {hears}, entity: each}},", 1
    )


def test_a_rule_for_each_that_hears_its_own_event_about_each():
    (text,) = found(of_each("go", "GO", "GO"))
    assert "it waits for GO, which it sets off itself: once it has fired it fires in every tick" in text


def test_two_rules_for_each_of_one_group_likewise():
    assert len(found(of_each("there", "BACK", "THERE"), of_each("back", "THERE", "BACK"))) == 1


def test_what_is_about_others_sets_nobody_off():
    assert found(of_each("there", "BACK", "THERE", "yellow"), of_each("back", "THERE", "BACK", "blue")) == []
