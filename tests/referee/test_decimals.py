"""Decimal amounts behave as on paper: three times 0.1 is 0.3, in conditions, events, broadcasts and the ranking."""

import json

import pytest

from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.roster import Roster
from tests.referee.building import acted, at_tick_10, hears, payloads

TENTHS = """
counters: {third: {}, per_robot: {per: robots}}
rules:
  tenth:
    triggers: [{trigger: time_reached, at_s: 0.32}, {trigger: time_reached, at_s: 0.64}, {trigger: time_reached, at_s: 0.96}]
    actions:
      - {action: score, entrant: yellow, points: 0.1}
      - {action: count, counter: third, by: 0.7}
      - {action: count, counter: per_robot, entity: B1, by: 0.1}
      - {action: emit, event: TENTH, payload: {score: {score: yellow}, third: {counter: third}}}
  equal:
    triggers: [{trigger: holds, conditions: [{counter: third, equals: 2.1}]}]
    actions: [{action: emit, event: EQUAL}]
"""


def test_three_times_a_tenth_of_a_point_is_exactly_three_tenths(stage):
    play = stage(TENTHS)
    play.play(31)
    assert play.referee.scores["yellow"] == 0.3
    assert play.events_named("TENTH")[-1].payload == {"score": 0.3, "third": 2.1}


def test_the_sum_of_a_counter_kept_per_robot_is_that_on_paper(stage):
    tenths = ("{action: count, counter: own, by: 0.1}", "{action: count, counter: own, entity: B1, by: -0.1}")
    reported = "{action: emit, event: TOLD, payload: {sum: {counter: own}}}"
    play = acted(stage("counters: {own: {per: robots}}", at_tick_10(*tenths, reported)))
    assert payloads(play) == [{"sum": 0.3}]


def test_a_bound_with_more_decimals_than_are_kept_is_met_by_the_counter_that_was_set_to_it(stage):
    third = "0.3333333333333333"
    play = stage(
        "counters: {n: {}}",
        at_tick_10(f"{{action: count, counter: n, to: {third}}}"),
        hears(f"holds, conditions: [{{counter: n, equals: {third}}}]"),
    )
    play.play(12)
    assert play.names() == ["TOLD"]


GROWS = """
counters: {{c: {{initial: {first}}}}}
rules:
  grows:
    triggers: [{{trigger: holds, conditions: [{{word: halftime, at_least: 1}}], for_s: 0.032, every_s: 0.032}}]
    actions:
      - {{action: count, counter: c, to: {{sum: [{{counter: c, times: {weight}}}]}}}}
      - {{action: score, entrant: blue, points: {{counter: c}}}}
      - {{action: emit, event: TOLD, payload: {{c: {{counter: c}}}}}}
    says: "{{points}} points"
"""


@pytest.mark.parametrize(
    ("first", "weight", "ends_at"),
    [(1, 10.5, 10**15), (-1, 10.5, -(10**15)), (1.0e308, 1.0e308, 10**15), (-1.0e308, 1, -(10**15))],
)
def test_what_grows_by_a_factor_stays_at_a_bound_and_can_be_recorded(stage, first, weight, ends_at):
    play = stage(GROWS.format(first=f"{first:.1e}", weight=f"{weight:.2e}"))
    play.play(40)
    assert play.referee.counters["c"] == ends_at
    assert play.referee.scores["blue"] == ends_at
    json.dumps([[event.payload for event in play.events], [one.scored for one in play.firings]], allow_nan=False)


def test_more_than_all_less_more_than_all_is_nothing(stage):
    weights = "1.0e+308}, {counter: c, times: -1.0e+308"
    play = stage(GROWS.format(first=1000000, weight=weights))
    play.play(1)
    assert play.referee.counters["c"] == 0


def test_a_time_with_endless_penalties_is_still_a_number_to_rank_by(small):
    scenario = small(
        "counters: {faults: {initial: 1.0e+15}}\n"
        "result: {rank: [{word: time_s, plus: {counter: faults, times: 1.0e+308}, better: less, says: T}]}",
    )
    half = half_of(scenario)
    assert Referee(scenario, Roster.of(scenario), half).ranked(half) == {"blue": [10**15], "yellow": [10**15]}
