"""Which ends a seat attacks, where points go to whoever drives a robot or touched the ball last."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.stats.ground import attacked_ends

GOALS = """schema_version: 1
id: goals
title: Goals
extends: soccersim_v2
rules:
  goal:
    {each}triggers: [{{trigger: enters, entity: ball, zone: yellow_goal}}]
    conditions: [{{condition: last_touch, by: {by}}}]
    actions: [{{action: score, entrant: {who}}}]
"""


@pytest.mark.parametrize(
    ("each", "by", "who", "ends"),
    [
        # Against the way they start: only the rule can tell.
        ("for_each: yellow\n    ", "each", "each", {"yellow": {-1}, "blue": set()}),
        ("", "yellow", "yellow", {"yellow": {-1}, "blue": set()}),
        # Of the last to touch it nothing is known beforehand: each attacks the end at which the others start.
        ("", "robots", "{last_touch: ball}", {"yellow": {1}, "blue": {-1}}),
    ],
)
def test_an_end_is_attacked_by_those_who_may_get_points_there(each, by, who, ends):
    loaded = load_text(GOALS.format(each=each, by=by, who=who))
    assert attacked_ends(loaded.scenario, loaded.roster) == ends
