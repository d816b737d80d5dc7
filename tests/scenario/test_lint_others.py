"""Lint of comparisons with the others, where there are none."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = (
    "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\ncounters: {laps: {per: %s}}\n"
    "rules:\n  lap:\n    for_each: robots\n    triggers: [{trigger: enters, entity: each, zone: blue_goal}]\n"
    "    actions: [{action: count, counter: laps, entity: %s}]\n    says: A lap.\n"
    "  ahead:\n    triggers: [{trigger: time_reached, at_s: 5}]\n"
    "    conditions: [{condition: counter, counter: laps, entity: B1, at_least: {%s: laps}}]\n"
    "    actions: [{action: end}]\n    says: Ahead.\n"
)


def found(per: str, entity: str, extreme: str) -> list[str]:
    """Return what is said of a comparison with the others."""
    findings = lint(load_text(HEAD % (per, entity, extreme), file="it.yaml"))
    return [str(one) for one in findings if one.kind == "no_others_to_compare_with"]


def test_of_one_thing_alone_there_are_no_others():
    assert found("B1", "B1", "highest") == [
        (
            "it.yaml:14:86: warning: rules.ahead.conditions[0] (counter): counter 'laps' is kept for B1 alone, "
            "so that there are no others; keep it per: robots, or write {counter: laps, entity: B1} "
            "[no_others_to_compare_with]"
        )
    ]


@pytest.mark.parametrize(("per", "extreme"), [("robots", "highest"), ("robots", "lowest")])
def test_of_several_there_are_others(per, extreme):
    assert found(per, "each", extreme) == []
