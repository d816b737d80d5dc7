"""Lint of conditions that a trigger denies, also within any_of and all_of, and of sequences whose steps decide nothing."""

import pytest

from rcj_challenges.scenario.lint import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD, rule

IN = "{condition: in_zone, entity: ball, zone: blue_goal}"
OUT = "{condition: in_zone, entity: ball, zone: blue_goal, negate: true}"
Y1_OUT = OUT.replace("ball", "Y1")


def findings(body):
    return [str(one) for one in lint(load_text(HEAD + body, file="a.yaml"))]


def never_fires(condition):
    enters = "triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [{action: end}]"
    text = f"rules: {{r: {{{enters}, conditions: [{condition}]}}}}\n"
    return any("rule_never_fires" in one for one in findings(text))


@pytest.mark.parametrize(
    ("condition", "denied"),
    [
        (OUT, True),
        (f"{{condition: any_of, conditions: [{OUT}]}}", True),
        (f"{{condition: any_of, conditions: [{OUT}, {OUT}]}}", True),
        (f"{{condition: any_of, conditions: [{OUT}, {Y1_OUT}]}}", False),
        (f"{{condition: any_of, conditions: [{IN}]}}", False),
        (f"{{condition: any_of, negate: true, conditions: [{IN}, {Y1_OUT}]}}", True),
        (f"{{condition: any_of, negate: true, conditions: [{OUT}]}}", False),
        (f"{{condition: all_of, conditions: [{OUT}, {Y1_OUT}]}}", True),
        (f"{{condition: all_of, conditions: [{IN}, {Y1_OUT}]}}", False),
        (f"{{condition: all_of, negate: true, conditions: [{IN}, {IN}]}}", True),
        (f"{{condition: all_of, negate: true, conditions: [{IN}, {Y1_OUT}]}}", False),
        (f"{{condition: any_of, conditions: [{OUT}, {{condition: all_of, conditions: [{OUT}, {IN}]}}]}}", True),
    ],
)
def test_a_rule_whose_trigger_denies_all_of_several_conditions_never_fires(condition, denied):
    assert never_fires(condition) is denied


def test_of_a_sequence_that_rules_only_begin_anew_the_steps_decide_nothing():
    way = "sequences: {way: {entity: ball, steps: [blue_goal, yellow_goal]}}\n"
    (text,) = [one for one in findings(way + rule(action="{action: sequence, sequence: way}")) if "sequence" in one]
    assert "sequence 'way' only begins anew: its steps decide nothing; " in text
    (unnamed,) = [one for one in findings(way + rule()) if "sequence" in one]
    assert "sequence 'way' is never used; name it in a rule, or remove it" in unnamed
