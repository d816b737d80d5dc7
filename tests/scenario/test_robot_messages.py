"""Messages to the referee in the file: what is refused, what lint says, what a file without them is written as."""

import pytest

from rcj_challenges.scenario.kits import referee_listens, robots_with_emitter
from rcj_challenges.scenario.load import load, load_text
from tests.scenario.writing import complaints

HEAD = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
RULE = "rules: {r: {triggers: [{trigger: tells, %s}], actions: [{action: emit, event: E}], says: Told.}}\n"


@pytest.mark.parametrize(
    ("trigger", "expected"),
    [
        ("entity: ball", "wrong-kind rules.r.triggers[0] (tells)"),
        ("text: {draw: no}", "unknown-name rules.r.triggers[0] (tells)"),
        ("is_a: text", "wrong-value rules.r.triggers[0] (tells).is_a"),
        ("text: 'a '", "wrong-value rules.r.triggers[0] (tells).text"),
        ("text: []", "wrong-value rules.r.triggers[0] (tells).text"),
    ],
)
def test_what_cannot_be_listened_for_is_refused(trigger, expected):
    assert complaints(RULE % trigger) == [expected]


def test_the_referee_listens_only_where_a_rule_or_the_broadcast_asks():
    assert not referee_listens(load("match").scenario)
    assert referee_listens(load_text(HEAD + RULE % "entity: Y1").scenario)
    assert referee_listens(load_text(HEAD + "broadcast: {fields: {said: {told: Y1}}}\n").scenario)


def test_robots_of_2021_have_no_emitter_unless_they_are_given_one():
    old = HEAD.replace("soccersim_v2", "soccersim_2021")
    given = "robots: {Y3: {devices: {radio: {device: team_emitter}}}}\n"
    assert robots_with_emitter(load_text(old).scenario) == []
    assert robots_with_emitter(load_text(old + given).scenario) == ["Y3"]
