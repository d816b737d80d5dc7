"""Lint of rules that mean who is off the field: what is negated is true of what is nowhere."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = (
    "schema_version: 1\nid: it\ntitle: It\nextends: empty_field\nmatch: {half_s: 60}\n"
    "zones: {hill: {shape: circle, centre_m: [0, 0], radius_m: 0.3}}\n"
    "flags: {playing: {per: robots, initial: true}}\ntimers: {round: {lasts_s: 5, starts: true}}\nrules:\n"
)
OUT = (
    "  out: {for_each: robots, triggers: [{trigger: touches, entity: each, other: walls}], "
    "actions: [{action: remove, entity: each%s}, {action: set_flag, flag: playing, entity: each, to: false}]}\n"
)
NOT_THERE = "{condition: in_zone, entity: each, zone: hill, negate: true}"
LASTS = f"{{trigger: holds, condition: {NOT_THERE}, for_s: 2}}"
TIME = "{trigger: timer_expired, timer: round}"
BACK = "{action: place, entity: each, at: start}"


def found(trigger: str = LASTS, conditions: str = "", action: str = BACK, *, away: str = "") -> list[str]:
    """Return what is said of a rule for who is not on the hill, while another one takes robots off the field."""
    rule = f"  late: {{for_each: robots, triggers: [{trigger}], conditions: [{conditions}], actions: [{action}]}}\n"
    text = HEAD + OUT % away + rule
    return [str(one) for one in lint(load_text(text, file="it.yaml")) if one.kind == "meant_off_the_field"]


def test_who_is_nowhere_is_not_on_the_hill_either_and_is_brought_back():
    assert found() == [
        (
            "it.yaml:11:39: warning: rules.late.triggers[0] (holds): what it asks is true of 'B1' (and of 5 more) also "
            "while 'out' has taken it off the field, for it is nowhere then: the rule brings it back; add what is true on "
            "the field only to its conditions: {condition: in_zone, entity: each, zone: pitch} [meant_off_the_field]"
        )
    ]


def test_or_points_are_taken_for_it():
    (one,) = found(action="{action: score, entrant: each, points: -1}")
    assert "the rule gives or takes points for it" in one


@pytest.mark.parametrize(
    "trigger", [TIME, "{trigger: time_reached, at_s: 5, every_s: 5}", "{trigger: phase_entered, phase: play}"]
)
def test_whatever_the_moment_is(trigger):
    assert len(found(trigger, NOT_THERE)) == 1


@pytest.mark.parametrize(
    "condition",
    [
        "{condition: distance, entity: each, to: centre, at_most: 0.3, negate: true}",
        "{condition: speed, entity: each, at_least: 0.01, negate: true}",
        "{condition: looks, entity: each, towards: centre, negate: true}",
        "{condition: in_zone, entity: each, zone: hill, of: none}",
        "{condition: speed, entity: each, of: none, at_least: 0.01}",
    ],
)
def test_so_it_is_with_whatever_is_measured(condition):
    assert len(found(TIME, condition)) == 1


@pytest.mark.parametrize(
    "asked",
    [
        "{condition: in_zone, entity: each, zone: pitch}",
        "{condition: flag, flag: playing, entity: each}",
        "{condition: distance, entity: each, to: centre, at_least: 0.4}",
    ],
)
def test_what_keeps_them_apart_is_enough(asked):
    assert found(conditions=asked) == []


def test_who_asks_for_those_off_the_field_means_them():
    assert found(TIME, "{condition: in_zone, entity: each, zone: pitch, negate: true}") == []


def test_not_none_of_them_is_one_that_is_there():
    assert found(TIME, "{condition: in_zone, entity: each, zone: hill, of: none, negate: true}") == []


def test_everything_but_the_middle_is_not_the_whole_field():
    around = HEAD.replace("radius_m: 0.3}", "radius_m: 0.3, inverted: true}") + OUT % ""
    rule = f"  late: {{for_each: robots, triggers: [{LASTS}], actions: [{BACK}]}}\n"
    assert [one.kind for one in lint(load_text(around + rule))].count("meant_off_the_field") == 1


def test_who_comes_in_or_goes_out_is_on_the_field():
    assert found("{trigger: leaves, entity: each, zone: hill}", NOT_THERE) == []


def test_what_becomes_true_by_the_removal_itself_is_not_heard_without_a_time():
    assert found(f"{{trigger: holds, condition: {NOT_THERE}}}") == []


@pytest.mark.parametrize(("away", "count"), [(", for_s: 1", 0), (", for_s: 2", 0), (", for_s: 10", 1)])
def test_who_comes_back_in_time_is_not_meant(away, count):
    assert len(found(away=away)) == count


def test_a_rule_that_does_nothing_for_it_may_fire():
    assert found(action="{action: emit, event: LATE, payload: {who: {word: robot_name}}}") == []


def test_where_nobody_is_taken_off_there_is_nothing_to_say():
    rule = f"  late: {{for_each: robots, triggers: [{LASTS}], actions: [{BACK}]}}\n"
    assert [one for one in lint(load_text(HEAD + rule)) if one.kind == "meant_off_the_field"] == []


# --- a rule that takes off itself, and goes on meaning whom it has taken off ---------------------------------------------


def of_itself(
    trigger: str = LASTS, conditions: str = "", action: str = "", *, away: str = "", more: str = ""
) -> list[str]:
    """Return what is said of a rule that takes who is not on the hill off the field, and announces it."""
    doing = f"{{action: remove, entity: each{away}}}, {action or '{action: emit, event: OUT}'}"
    rule = f"  wet: {{for_each: robots{more}, triggers: [{trigger}], conditions: [{conditions}], actions: [{doing}]}}\n"
    return [str(one) for one in lint(load_text(HEAD + rule, file="it.yaml")) if one.kind == "meant_off_the_field"]


def test_who_is_taken_off_for_not_being_there_is_not_there_ever_after():
    (one,) = of_itself()
    assert "rules.wet.triggers[0] (holds)" in one
    assert "also while this rule itself has taken it off the field" in one
    assert "it fires for it again and again" in one
    assert "{condition: in_zone, entity: each, zone: pitch}" in one


@pytest.mark.parametrize("action", ["{action: score, entrant: each, points: -1}", "{action: count, counter: outs}"])
def test_so_its_points_and_counts_come_again_and_again(action):
    with_counter = HEAD.replace("rules:\n", "counters: {outs: {}}\nrules:\n")
    rule = f"  wet: {{for_each: robots, triggers: [{LASTS}], actions: [{{action: remove, entity: each}}, {action}]}}\n"
    assert [one.kind for one in lint(load_text(with_counter + rule))].count("meant_off_the_field") == 1


def test_so_it_is_at_each_time_that_comes_again():
    assert len(of_itself("{trigger: time_reached, at_s: 5, every_s: 5}", NOT_THERE)) == 1
    again = "{action: emit, event: OUT}, {action: timer, timer: round}"
    assert len(of_itself(TIME, NOT_THERE, again)) == 1


@pytest.mark.parametrize("trigger", [TIME, "{trigger: time_reached, at_s: 5}", "{trigger: phase_entered, phase: play}"])
def test_what_comes_once_finds_nobody_taken_off_by_itself(trigger):
    assert of_itself(trigger, NOT_THERE) == []


def test_who_may_be_taken_off_only_once_is_meant_once():
    assert of_itself(more=", max_executions: 1") == []


def test_who_asks_whether_it_plays_is_not_told():
    assert of_itself(conditions="{condition: flag, flag: playing, entity: each}") == []


def test_who_is_back_before_it_is_meant_again_is_not_told():
    assert of_itself(away=", for_s: 1") == []


def test_a_rule_that_only_takes_off_may_do_so_twice():
    assert of_itself(action="{action: set_flag, flag: playing, entity: each, to: false}") == []


def test_where_the_rule_ends_the_play_nothing_comes_again():
    assert of_itself(action="{action: emit, event: OUT}, {action: end}") == []
