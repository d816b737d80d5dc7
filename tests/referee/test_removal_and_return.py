"""How things come back that were taken off the field for a time."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from tests.referee.building import event_ticks, hears, on_fault, once, place

AWAY = "{action: remove, entity: Y1, for_s: %s, back_at: {point: [-0.5, 0]}}"
WHERE_B1_IS = "{action: place, entity: Y1, at: {point: [0.4, 0.5]}, on_failure: stay}"


@pytest.mark.parametrize(
    ("sections", "where"),
    [
        pytest.param([once(50, AWAY % 3.2), once(80, WHERE_B1_IS, name="earlier")], (-0.5, 0.0),
                     id="a place that found no room and gave up does not keep it away"),
        pytest.param([once(50, AWAY % 0.64), once(50, WHERE_B1_IS, name="elsewhere")], (-0.4, -0.5),
                     id="what was placed in the tick of its removal was never off and does not come back"),
        pytest.param([once(50, AWAY % 3.2), once(80, "{action: set_phase, phase: second}", name="later"),
                      "phases: {second: {}}"], (-0.5, 0.0), id="it comes back whatever phase the match is in"),
    ],
)  # fmt: skip
def test_where_it_is_in_the_end(stage, sections, where):
    play = stage(*sections)
    play.play(160)
    assert play.pose("Y1")[:2] == pytest.approx(where)


def test_what_one_of_several_holds_goes_on_while_another_is_put_elsewhere(stage):
    west = "{entity: yellow, in: left, of: {at_least: 1}}"
    elsewhere = once(80, "{action: place, entity: Y2, at: {point: [0.5, 0.1]}}")
    play = stage(hears(f"holds, conditions: [{west}], for_s: 3.2"), elsewhere)
    place(play, "Y1", 0.4, -0.3, ticks=20)
    place(play, "Y1", -0.4, -0.5, ticks=150)
    assert event_ticks(play) == [121]


STOPPED_CLOCK = """
schema_version: 2
id: it
title: It
extends: soccersim_v2
match: {half_s: 6.4}
phases: {warm_up: {lasts_s: 3.2, next: play, clock: stops}}
first_phase: warm_up
rules:
  over: {triggers: [{trigger: half_ended}], phases: any, actions: [{action: emit, event: OVER}]}
expect:
  it: {keyframes: [{at_s: 0.5}], lasts_s: 9.6, ignore: [], events: [{event: OVER, at_s: 9.6}]}
"""


def test_a_half_whose_clock_stood_still_can_be_tested_to_its_end():
    assert run_test(load_text(STOPPED_CLOCK), "it").differences == ()


@pytest.mark.parametrize(("value", "back"), [("0.64", 20), ("0", 1), ("-3", 1)])
def test_a_counter_sets_the_time_of_return(stage, value, back):
    remove = "{action: remove, entity: Y1, for_s: {counter: away_s}}"
    play = stage(f"counters: {{away_s: {{initial: {value}}}}}", on_fault("Y1", remove))
    play.fail("Y1")
    play.play(100)
    assert [(tick, placed.parked) for tick, placed in play.placements if tick] == [(1, True), (1 + back, False)]
