"""Rules for each entrant, what is kept per entrants, and the others of a rule's group."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from tests.referee.building import fail, place, touch
from tests.scenario.writing import in_short, problems_of

V2 = "schema_version: 2"
FOULS = """
counters: {fouls: {per: entrants, keep: match}, bumps: {per: robots}}
flags: {warned: {per: entrants}}
timers: {rest: {per: entrants, lasts_s: {counter: fouls}}}
rules:
  foul:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: walls}]
    actions: [{action: count, counter: fouls, entity: each}, {action: count, counter: bumps}]
"""
AFTER_TWO = """
rules:
  after_two:
    for_each: entrants
    triggers: [{trigger: holds, conditions: [{counter: fouls, at_least: 2}]}]
    actions: [%s]
    says: "%s"
"""


@pytest.fixture
def fouled(stage):
    """Return what plays two fouls of blue under the rules of a text."""

    def play(actions, *more, says="{each} has fouled, a foul of {team}."):
        rules = FOULS + AFTER_TWO.replace("rules:\n", "") % (actions, says)
        played = stage(V2, rules, *more)
        touch(played, "B1", "walls", ticks=10)
        touch(played, "B2", "walls", ticks=10)
        return played

    return play


class TestRulesForEachEntrant:
    def test_two_fouls_of_a_team_give_the_opponent_a_point(self, fouled):
        play = fouled("{action: score, entrant: others}")
        assert play.referee.counters == {
            "fouls": {"blue": 2, "yellow": 0},
            "bumps": {"B1": 1, "B2": 1, "Y1": 0, "Y2": 0},
        }
        assert play.referee.scores == {"blue": 0, "yellow": 1}

    def test_a_team_loses_its_own_points_and_the_log_names_it(self, fouled):
        play = fouled("{action: score, entrant: each, points: {score: others, minus: 1}}")
        assert play.referee.scores == {"blue": -1, "yellow": 0}
        assert play.firings[-1].says == "blue has fouled, a foul of Blue Moon."

    @pytest.mark.parametrize("others", ["others", "entrants"])
    def test_in_a_rule_for_robots_the_others_that_get_points_are_the_opponents(self, stage, others):
        triggers = "triggers: [{trigger: touches, entity: each, other: walls}]"
        score = f"actions: [{{action: score, entrant: {others}}}]"
        played = stage(V2, f"rules: {{foul: {{for_each: robots, {triggers}, {score}}}}}")
        touch(played, "B1", "walls", ticks=10)
        assert played.referee.scores == {"blue": int(others == "entrants"), "yellow": 1}

    def test_the_log_shows_counters_and_roles_as_the_rule_leaves_them_and_the_others(self, fouled):
        play = fouled(
            "{action: count, counter: fouls}, {action: assign, role: wanted}",
            "roles: {wanted: {of: [B1, B2], order: listed}}",
            says="{each} has {fouls} fouls of {bumps} bumps; {others} waits for {wanted}, {nothing}.",
        )
        assert play.firings[-1].says == "blue has 3 fouls of 2 bumps; yellow waits for B2, {nothing}."

    def test_the_log_shows_that_there_is_none_and_what_is_0(self, fouled):
        play = fouled(
            "{action: assign, role: wanted, to: none}",
            "roles: {wanted: {of: [B1, B2]}}\ndraws: {bonus: {values: [0]}}\ncounters: {best_m: {keeps: lowest}}",
            says="{wanted}, {bonus}, {best_m}",
        )
        assert play.firings[-1].says == "none, 0, none"

    def test_without_entity_flags_and_timers_are_those_of_the_team(self, fouled):
        play = fouled(
            "{action: set_flag, flag: warned}, {action: timer, timer: rest}",
            "rules: {over: {for_each: entrants, triggers: [{trigger: timer_expired, timer: rest}], "
            "conditions: [{flag: warned}], actions: [{action: score, entrant: each, points: 7}]}}",
        )
        assert play.referee.flags == {"warned": {"blue": True, "yellow": False}}
        play.play(70)
        assert play.referee.scores == {"blue": 7, "yellow": 0}

    def test_where_things_are_asked_for_a_team_stands_for_its_robots(self, fouled):
        asks = "rules: {asks: {triggers: [{trigger: program_fault, robot: Y1}], actions: [{action: emit, event: LEFT, payload: {n: {count: robots}}}]}}"
        out = "{action: remove, entity: each}, {action: emit, event: OUT, payload: {n: {sum: {counter: bumps, entity: each}}}}"
        play = fail(fouled(out, asks), "Y1")
        assert [(event.name, event.payload["n"]) for event in play.events] == [("OUT", 2), ("LEFT", 2)]

    def test_a_zone_is_entered_by_any_robot_of_the_other_team(self, stage):
        play = stage(
            V2, "rules: {entered: {for_each: entrants, triggers: [{trigger: enters, entity: others, zone: middle}], "
            "actions: [{action: score, entrant: each}]}}"
        )  # fmt: skip
        place(play, "Y2", 0, 0)
        assert play.referee.scores == {"blue": 1, "yellow": 0}

    def test_an_event_of_a_team_is_about_its_robots(self, fouled):
        hears = "rules: {hears: {triggers: [{trigger: event, event: OUT, entity: B2}], actions: [{action: score, entrant: yellow}]}}"
        play = fouled("{action: emit, event: OUT}", hears)
        assert play.referee.scores == {"blue": 0, "yellow": 1}

    def test_a_seat_and_a_colour_of_one_name_are_told_apart(self, stage):
        entrants = "entrants: {yellow: {robots: {B1: a.py, Y1: a.py}}, blue: {robots: {B2: a.py, Y2: a.py}}}"
        rule = "rules: {touched: {for_each: entrants, triggers: [{trigger: touches, entity: each, other: ball}], actions: [{action: score, entrant: each}]}}"
        play = stage(V2, entrants, rule)
        touch(play, "B1", "ball")
        assert play.referee.scores == {"blue": 0, "yellow": 1}


class TestValuesOfEntrants:
    @pytest.mark.parametrize(
        ("condition", "holds"),
        [
            ("{score: entrants, at_least: 5}", True),
            ("{score: entrants, of: all, at_least: 5}", False),
            ("{counter: fouls, entity: yellow, above: {lowest: {counter: fouls}}}", False),
            ("{counter: fouls, entity: B2, equals: {highest: {counter: fouls, entity: entrants}}}", True),
            ("{counter: fouls, entity: entrants, equals: 2, of: {equals: 1}}", True),
        ],
    )
    def test_scores_and_counters_of_teams_are_compared(self, fouled, condition, holds):
        asks = f"rules: {{asks: {{triggers: [{{trigger: program_fault, robot: Y1}}], conditions: [{condition}], actions: [{{action: emit, event: TRUE_NOW}}]}}}}"
        play = fail(fouled("{action: score, entrant: others, points: 5}", asks), "Y1")
        assert bool(play.events_named("TRUE_NOW")) is holds

    def test_what_is_kept_for_the_match_changes_seats_with_the_team(self, fouled, stage):
        swapped = {"teams": {"blue": "yellow", "yellow": "blue"}}
        left = fouled("{action: score, entrant: others}").referee.kept
        second = stage(V2, FOULS, half=2, kept=left, **swapped)
        assert second.referee.counters["fouls"] == {"blue": 0, "yellow": 2}
        assert second.referee.kept["counters"] == left["counters"]


OTHERS = """
schema_version: 2
id: t
title: T
extends: soccersim_v2
gates: {line: {from_m: [-0.5, 0], to_m: [0.5, 0]}}
rules:
  crossed:
    for_each: entrants
    triggers: [{trigger: crosses, entity: others, gate: line, direction: forward}]
    actions: [{action: score, entrant: each}]
  hit:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: others}]
    actions: [{action: emit, event: HIT, payload: {by: {word: robot_name}, whom: {word: other_name}}}]
expect:
  the_opponent_gets_the_point:
    keyframes:
      - {at_s: 0, place: {B1: [0, -0.1]}}
      - {at_s: 1, move: {B1: [0, 0.1]}, touch: [[B2, Y3]]}
    lasts_s: 2
    score: {yellow: 1, blue: 0}
    events: [{event: HIT, payload: {by: B2, whom: Y3}}, {event: HIT, payload: {by: Y3, whom: B2}}]
"""


def test_others_stand_in_triggers_and_in_the_notes_of_tests():
    loaded = load_text(OTHERS)
    assert run_test(loaded, "the_opponent_gets_the_point").differences == ()


RULE = """
schema_version: 2
id: t
title: T
extends: soccersim_v2
counters: {{fouls: {{per: entrants}}, bumps: {{per: robots}}}}
rules:
  r:
    for_each: {group}
    triggers: [{{trigger: half_started}}]
    actions: [{action}]
"""


@pytest.mark.parametrize(
    ("group", "action", "problem"),
    [
        ("robots", "{action: count, counter: fouls}", "missing-entity"),
        ("balls", "{action: count, counter: fouls, entity: each}", "wrong-kind"),
        ("entrants", "{action: score, entrant: each, points: {counter: bumps, entity: each}}", "wrong-kind"),
        ("entrants", "{action: score, entrant: each, points: {score: entrants}}", "missing-entity"),
        ("robots", "{action: score, entrant: each, points: {score: others}}", "missing-entity"),
        ("entrants", "{action: place, entity: ball, at: {relative_to: each, offset_m: [0, 0]}}", "wrong-kind"),
    ],
)
def test_what_is_not_one_where_one_is_needed_is_an_error(group, action, problem):
    found = problems_of(load_text, RULE.format(group=group, action=action))
    assert {in_short(one).split()[0] for one in found} == {problem}
