"""Lint of starts in a zone in which nobody may stay."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: empty_field\nmatch: {half_s: 60}\n"
HERE = "{shape: circle, centre_m: [-0.3, -0.3], radius_m: 0.15}"
STAYS = "{trigger: stays_in, entity: each, zone: home, limit_s: 5}"
PUT_BACK = "{action: place, entity: each, at: start}"


def found(
    zone: str = HERE, trigger: str = STAYS, action: str = PUT_BACK, more: str = "", sections: str = ""
) -> list[str]:
    """Return what is said of a rule that puts a robot back from the zone where Y1 starts, at (-0.3, -0.3)."""
    rule = f"  parked: {{for_each: robots, {more}triggers: [{trigger}], actions: [{action}]}}\n"
    text = f"{HEAD}zones: {{home: {zone}}}\n{sections}rules:\n{rule}"
    return [str(one) for one in lint(load_text(text, file="it.yaml")) if one.kind == "put_back_into_the_zone"]


def test_the_start_lies_in_the_zone():
    assert found() == [
        (
            "it.yaml:8:41: warning: rules.parked.triggers[0] (stays_in): the start of 'Y1' lies in 'home', and the rule "
            "puts it there: who does not drive off is in the zone again, and the rule fires again and again; give the zone "
            "or the start another place, put it elsewhere, or limit the rule: max_executions, cooldown_s, a condition "
            "[put_back_into_the_zone]"
        )
    ]


@pytest.mark.parametrize(
    "zone",
    [
        "{shape: rect, x_max_m: -0.2, y_max_m: -0.2}",
        "{shape: polygon, points_m: [[-0.4, -0.4], [-0.2, -0.4], [-0.3, -0.2]]}",
        "{shape: half_plane, through_m: [0, -0.2], normal: [0, -1]}",
        "{shape: circle, centre_m: [0.3, 0.3], radius_m: 0.1, inverted: true}",
    ],
)
def test_whatever_its_shape(zone):
    assert len(found(zone)) == 1


@pytest.mark.parametrize(
    "trigger", ["{trigger: holds, condition: {condition: in_zone, entity: each, zone: home}, for_s: 5}", STAYS]
)
@pytest.mark.parametrize(
    "action", [PUT_BACK, "{action: remove, entity: each, for_s: 3}", "{action: place, layout: all}"]
)
def test_whatever_puts_it_there(trigger, action):
    assert (
        len(found(trigger=trigger, action=action, sections="placements: {all: [{entity: robots, at: start}]}\n")) == 1
    )


@pytest.mark.parametrize(
    "wholesome",
    [
        {"zone": "{shape: circle, centre_m: [0.3, 0], radius_m: 0.1}"},
        {"zone": HERE.replace("}", ", inverted: true}").replace("-0.3, -0.3", "0, 0").replace("0.15", "0.9")},
        {"action": "{action: place, entity: each, at: {point: [0, 0]}}"},
        {"action": "{action: remove, entity: each}"},
        # What is placed has not come in, and a placement makes nothing true for a `holds` that waits for the moment.
        {"trigger": "{trigger: enters, entity: each, zone: home}"},
        {"trigger": "{trigger: holds, condition: {condition: in_zone, entity: each, zone: home}}"},
        {
            "trigger": "{trigger: holds, condition: {condition: in_zone, entity: each, zone: home, negate: true}, for_s: 5}"
        },
        {"more": "max_executions: 1, "},
        {"more": "cooldown_s: 10, "},
        {"more": "conditions: [{condition: counter, counter: n, at_most: 3}], ", "sections": "counters: {n: {}}\n"},
    ],
)
def test_what_is_no_such_thing(wholesome):
    assert found(**wholesome) == []


def test_others_than_the_one_that_stays_may_start_there():
    assert found(trigger=STAYS.replace("each", "Y2"), action=PUT_BACK.replace("each", "Y1")) == []


def test_a_rule_that_leaves_the_phase_ends_a_round_which_begins_where_it_began():
    both_stay = "{trigger: holds, condition: {condition: in_zone, entity: robots, zone: home, of: any}, for_s: 20}"
    new_round = PUT_BACK + ", {action: set_phase, phase: countdown}"
    phases = "phases: {countdown: {lasts_s: 3, robots: held}}\nfirst_phase: countdown\n"
    assert found(trigger=both_stay, action=new_round, sections=phases) == []
    assert len(found(trigger=both_stay, sections=phases)) == 1


def test_a_rule_that_ends_the_half_fires_once():
    assert found(action=PUT_BACK + ", {action: end}") == []
