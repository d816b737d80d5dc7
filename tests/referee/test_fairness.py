"""Neither the order of rules in the file nor the order of teams decides what a tick brings."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

SECTIONS = """
phases: {pause: {lasts_s: 0.16, next: play}}
counters: {touches: {}, by: {per: robots}, ticks: {}, rests: {}}
timers: {rest: {lasts_s: 0.16}}
"""
RULES = (
    "touched: {triggers: [{trigger: touches, entity: robots, other: ball, apart_s: 0}], actions: [{action: count, counter: touches}]}",
    (
        "by_each: {for_each: robots, phases: any, triggers: [{trigger: touches, entity: each, other: ball, apart_s: 0}], "
        "actions: [{action: count, counter: by, entity: each}]}"
    ),
    "stops: {triggers: [{trigger: touches, entity: Y1, other: ball, apart_s: 0}], actions: [{action: set_phase, phase: pause}]}",
    "goal: {triggers: [{trigger: enters, entity: ball, zone: middle}], actions: [{action: score, entrant: yellow}]}",
    "beat: {triggers: [{trigger: time_reached, at_s: 0.096, every_s: 0.096}], actions: [{action: count, counter: ticks}]}",
    "again: {triggers: [{trigger: enters, entity: ball, zone: right}], actions: [{action: timer, timer: rest}]}",
    "rested: {phases: any, triggers: [{trigger: timer_expired, timer: rest}], actions: [{action: count, counter: rests}]}",
    "back: {phases: any, triggers: [{trigger: phase_entered, phase: play, from: pause}], actions: [{action: emit, event: BACK}]}",
)
ROBOTS = ("B1", "B2", "Y1", "Y2")
PLACES = ((0.0, 0.0), (0.3, 0.0), (-0.3, 0.0))
SCRIPT = st.lists(
    st.tuples(st.sets(st.sampled_from(ROBOTS), max_size=2), st.none() | st.sampled_from(PLACES)), max_size=25
)


def played(stage, script, *sections):
    play = stage(*sections)
    for robots, place in script:
        for robot in robots:
            play.touch(robot, "ball")
        if place is not None:
            play.place("ball", *place)
        play.play()
    play.finish()
    return play


@given(script=SCRIPT, order=st.permutations(RULES))
def test_rules_that_share_no_written_state_may_stand_in_any_order(stage, script, order):
    def log(rules):
        play = played(stage, script, SECTIONS, f"rules: {{{', '.join(rules)}}}")
        return sorted((one.tick, one.rule, one.entity or "", one.suppressed or "") for one in play.firings)

    assert log(order) == log(RULES)


DUEL = """
phases: {pause: {lasts_s: 0.16, next: play}}
rules:
  blue_touches:
    triggers: [{trigger: touches, entity: blue, other: ball, apart_s: 0}]
    actions: [{action: score, entrant: blue}, {action: set_phase, phase: pause}]
  yellow_touches:
    triggers: [{trigger: touches, entity: yellow, other: ball, apart_s: 0}]
    actions: [{action: score, entrant: yellow}, {action: set_phase, phase: pause}]
  wins_the_middle:
    triggers: [{trigger: enters, entity: ball, zone: middle}]
    actions: [{action: score, entrant: blue, points: 2}, {action: score, entrant: yellow, points: 2}]
"""
EXCHANGED = {"B1": "Y1", "B2": "Y2", "Y1": "B1", "Y2": "B2"}


@given(script=SCRIPT)
@pytest.mark.parametrize("sections", [DUEL], ids=["duel"])
def test_exchanging_the_teams_and_mirroring_what_happens_exchanges_the_score(stage, script, sections):
    mirrored = [
        ({EXCHANGED[robot] for robot in robots}, None if place is None else (-place[0], -place[1]))
        for robots, place in script
    ]
    scores, exchanged = (played(stage, one, sections).referee.scores for one in (script, mirrored))
    assert (scores["blue"], scores["yellow"]) == (exchanged["yellow"], exchanged["blue"])
