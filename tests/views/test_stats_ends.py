"""Which ends a seat attacks, where points go to whoever drives a robot or touched the ball last."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.stats.ends import attacked_ends

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


@pytest.mark.parametrize(
    ("zone", "end"),
    [
        ("shape: rect, y_min_m: 0.65", 1),
        ("shape: rect, y_max_m: -0.65", -1),
        ("shape: circle, centre_m: [0, 0.7], radius_m: 0.1", 1),
        ("shape: circle, centre_m: [0, -0.7], radius_m: 0.1", -1),
        ("shape: polygon, points_m: [[0, 0.6], [0.2, 0.74], [-0.2, 0.74]]", 1),
        ("shape: polygon, points_m: [[0, -0.6], [0.2, -0.74], [-0.2, -0.74]]", -1),
        ("shape: half_plane, through_m: [0, 0.7], normal: [0, 1]", 1),
        ("shape: half_plane, through_m: [0, -0.7], normal: [0, -1]", -1),
    ],
)
def test_a_zone_in_which_a_team_gets_points_lies_at_the_end_that_it_attacks(zone, end):
    team = "blue" if end == 1 else "yellow"  # against the way they start
    rules = GOALS.format(each="", by=team, who=team).replace("yellow_goal", "there")
    loaded = load_text(f"{rules}zones: {{there: {{{zone}}}}}\n")
    assert attacked_ends(loaded.scenario, loaded.roster)[team] == {end}
