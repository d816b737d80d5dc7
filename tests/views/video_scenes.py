"""A recorded run, shown as if another scenario had been played."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.video.camera import FOV_RAD, View, axes

HEAD = "schema_version: 2\nid: lines\ntitle: Lines\nextends: soccersim_v2\n"
NO_GOALS = (
    "field: {goals: {blue_goal: null, yellow_goal: null}}\ngroups: {in_play: null, penalty_areas: null}\n"
    "zones: {blue_goal: null, yellow_goal: null, blue_penalty_area: null, yellow_penalty_area: null%s}\n"
)
JUDGED_GATE = (
    "gates: {door: %s}\n"
    "rules: {through: {triggers: [{trigger: crosses, entity: Y3, gate: door}],"
    " actions: [{action: score, entrant: yellow, points: 1}], says: A gate.}}\n"
)


def playing(footage, text):
    """Return the footage with the scenario of a YAML text."""
    scenario = load_text(HEAD + text).scenario
    return replace(footage, scenario=scenario, roster=Roster.of(scenario), things=visible_things(scenario))


def pixel_at(point_m: Sequence[float], view: View, size: tuple[int, int]) -> tuple[float, float]:
    """Return where a point is in a picture of a view."""
    forward, right, up = axes(view)
    ray = np.array(point_m) - np.array(view.look_at_m) + view.distance_m * forward
    px_per_m = size[1] / 2 / math.tan(FOV_RAD / 2) / float(ray @ forward)
    return size[0] / 2 + float(ray @ right) * px_per_m, size[1] / 2 - float(ray @ up) * px_per_m
