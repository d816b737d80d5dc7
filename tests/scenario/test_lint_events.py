"""Lint of events that come from one of a group, and that the rule of each hears."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HIT = "rules: {hit: {%s triggers: [{trigger: touches, entity: %s, other: walls}], actions: [{action: emit, event: HIT}], says: H.}"


@pytest.mark.parametrize(
    ("hit", "hears", "warned"),
    [
        (("for_each: robots,", "each"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (("for_each: yellow,", "each"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (
            ("for_each: robots,", "each"),
            "for_each: robots, triggers: [{trigger: event, event: HIT, entity: each}]",
            False,
        ),
        (("for_each: robots,", "each"), "triggers: [{trigger: event, event: HIT}]", False),
        (("for_each: yellow,", "each"), "for_each: blue, triggers: [{trigger: event, event: HIT}]", False),
        (("", "Y1"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", False),
        (
            ("for_each: robots,", "each"),
            "for_each: robots, conditions: [{condition: held, entity: each}], triggers: [{trigger: event, event: HIT}]",
            False,
        ),
    ],
)
def test_an_event_of_one_that_each_hears(hit, hears, warned):
    rules = f"{HIT % hit}, all: {{{hears}, actions: [{{action: emit, event: E}}, {{action: hold, entity: robots, for_s: 1}}], says: A.}}}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    assert ("event_heard_by_each" in {one.kind for one in lint(loaded)}) is warned
