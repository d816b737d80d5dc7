"""A recorded run, shown as if another scenario had been played."""

from dataclasses import replace

from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.replay.things import visible_things

HEAD = "schema_version: 1\nid: lines\ntitle: Lines\nextends: soccersim_v2\n"
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
