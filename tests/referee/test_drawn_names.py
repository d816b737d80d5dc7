"""A draw that decides among robots or balls: rules ask whether `each` or `other` is the one, and make it so."""

import pytest

from tests.referee.building import touch

CATCHER = """
draws: {catcher: {values: [B1, B2, Y1, Y2]}}
broadcast: {fields: {catcher: {draw: catcher}}}
rules:
  begins:
    for_each: robots
    triggers: [{trigger: half_started}]
    conditions: [{draw: catcher, equals: each}]
    actions: [{action: emit, event: CATCHER, payload: {who: {word: robot_name}}}]
    says: "{entity} is the catcher."
  caught:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: robots}]
    conditions: [{draw: catcher, equals: each}]
    actions:
      - {action: draw, draw: catcher, as: other}
      - {action: score, entrant: other, points: -1}
      - {action: emit, event: CAUGHT, payload: {by: {word: robot_name}, who: {draw: catcher}}}
"""


@pytest.mark.parametrize("catcher", ["B1", "B2", "Y1", "Y2"])
def test_the_rule_of_the_drawn_one_fires_and_no_other(stage, catcher):
    play = stage(CATCHER, draws={"catcher": catcher})
    assert [event.payload for event in play.events] == [{"who": catcher}]
    assert [firing.says for firing in play.firings] == [f"{catcher} is the catcher."]
    assert play.output.broadcast == {"catcher": catcher}


def test_the_robot_that_the_catcher_touches_is_the_one_from_then_on(stage):
    play = stage(CATCHER, draws={"catcher": "Y1"})
    for pair in (("B1", "B2"), ("Y1", "B1"), ("Y1", "Y2"), ("B1", "Y2")):
        touch(play, *pair, ticks=2)
    caught = [(event.payload["by"], event.payload["who"]) for event in play.events_named("CAUGHT")]
    assert caught == [("Y1", "B1"), ("B1", "Y2")]
    assert play.referee.scores == {"blue": -1, "yellow": -1}
    assert play.output.broadcast == {"catcher": "Y2"}


POISONED = """
balls: {ball: {start_m: [0, 0]}, red: {start_m: [0.2, 0.2]}}
draws: {poisoned: {values: [ball, red], not_last: true}}
rules:
  hit:
    triggers: [{trigger: touches, entity: robots, other: balls}]
    conditions: [{draw: poisoned, equals: other%s}]
    actions: [{action: emit, event: HIT, payload: {ball: {word: other_name}}}]
"""


@pytest.mark.parametrize(("negate", "hit"), [("", ["red"]), (", negate: true", ["ball"])])
def test_one_touches_two_balls_and_it_counts_for_the_one_that_is_drawn(stage, negate, hit):
    play = stage(POISONED % negate, draws={"poisoned": "red"})
    play.touch("Y1", "ball")
    touch(play, "Y1", "red")
    assert [event.payload["ball"] for event in play.events] == hit


def test_a_value_called_other_stays_a_value_where_the_rule_has_no_such_name(stage):
    play = stage(
        "draws: {which: {values: [one, other]}}",
        "rules: {r: {triggers: [{trigger: half_started}], conditions: [{draw: which, equals: other}], "
        "actions: [{action: emit, event: OTHER}]}}",
        draws={"which": "other"},
    )
    assert play.names() == ["OTHER"]
