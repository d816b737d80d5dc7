"""Circles that sit at a spot or move with an entity: what is in them, what enters them, and how far they are."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import at_start, zone_words
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.replay.things import visible_things
from tests.referee.building import fail, on_fault
from tests.scenario.writing import complaints, loaded, rule, scenario

GUARD = """
zones:
  guard: {shape: circle, anchor: Y1, radius_m: 0.2}
  ahead: {shape: circle, anchor: Y1, centre_m: [0.3, 0], radius_m: 0.1}
  home: {shape: circle, anchor: centre, radius_m: 0.2}
counters: {came: {}, went: {}, homes: {}, stays: {}, laps: {}}
sequences: {path: {entity: ball, steps: [ahead, guard]}}
rules:
  comes: {triggers: [{trigger: enters, entity: ball, zone: [guard, home]}], actions: [{action: count, counter: came}]}
  goes: {triggers: [{trigger: leaves, entity: ball, zone: guard}], actions: [{action: count, counter: went}]}
  stays: {triggers: [{trigger: stays_in, entity: ball, zone: guard, limit_s: 0.2}], actions: [{action: count, counter: stays}]}
  laps: {triggers: [{trigger: sequence_completed, sequence: path}], actions: [{action: count, counter: laps}]}
"""


@pytest.fixture
def play(stage):
    """Y1 stands at (-0.5, -0.5) and looks along +x; the ball lies at (0.5, 0)."""
    begun = stage(GUARD)
    begun.place("Y1", -0.5, -0.5, 0.0)
    begun.place("ball", 0.5, 0.0)
    begun.play()
    return begun


def counted(play, *names):
    return [play.referee.counters[name] for name in names]


def test_ball_at_rest_enters_and_leaves_the_circle_of_a_robot_that_drives_past(play):
    play.place("Y1", 0.4, 0.0)
    play.play(8)
    assert counted(play, "came", "went", "stays") == [1, 0, 1]
    play.place("Y1", -0.5, -0.5)
    play.play()
    assert counted(play, "came", "went", "stays") == [1, 1, 1]


def test_passing_within_one_tick_counts_both_ways(play):
    play.place("Y1", 0.5, -0.3)
    play.play()
    play.glide("Y1", (0.5, 0.3), 1)
    play.play()
    assert counted(play, "came", "went") == [1, 1]


def test_circle_beside_its_entity_turns_with_it(play):
    play.place("Y1", 0.5, -0.3, 1.57)  # ahead of it is now +y
    play.play()
    play.place("Y1", 0.5, -0.1)
    play.play()
    assert counted(play, "laps") == [1]


def test_circle_moves_to_where_a_rule_sets_its_spot(stage):
    play = stage(GUARD, on_fault("Y1", "{action: set_spot, spot: centre, to: [0.5, 0.1]}"))
    play.place("ball", 0.5, 0.0)
    fail(play, "Y1")
    play.play()
    assert counted(play, "came") == [1]


def test_placement_of_the_entity_is_no_entry_and_off_the_field_it_contains_nothing(stage):
    there = on_fault("Y1", "{action: place, entity: Y1, at: {point: [0.4, 0]}}", "{action: hold, entity: Y2, for_s: 9}")
    gone = "rules: {gone: {triggers: [{trigger: tips_over, entity: Y2, after_s: 0}], actions: [{action: remove, entity: Y1}]}}"
    inside = "broadcast: {fields: {inside: {entity: ball, in: guard}, away_m: {distance: [ball, guard]}}}"
    play = stage(GUARD, there, gone.replace(", after_s: 0", ""), inside)
    play.place("ball", 0.5, 0.0)
    play.play()
    assert play.output.broadcast["away_m"] == pytest.approx(((0.5 + 0.4) ** 2 + 0.5**2) ** 0.5 - 0.2, abs=1e-3)
    fail(play, "Y1")
    play.play()
    assert counted(play, "came") == [0]
    assert play.output.broadcast == {"inside": True, "away_m": 0}
    play.tip("Y2")
    play.play(40)
    assert play.output.broadcast == {"inside": False, "away_m": None}


def test_words_name_what_it_moves_with(stage):
    zones = stage(GUARD).referee._state.scenario.zones
    assert [zone_words(zones[name]) for name in ("guard", "ahead")] == [
        "within 0.2 of Y1",
        "within 0.1 of (0.3, 0) from Y1",
    ]


def test_views_show_it_where_it_is(small):
    scenario = small(GUARD)
    shown = {zone["name"]: zone for zone in visible_things(scenario)["zones"]}
    assert (shown["ahead"]["anchor"], shown["ahead"]["centre_m"]) == (Roster.of(scenario).index["Y1"], [0.3, 0.0])
    assert (shown["home"]["anchor"], shown["home"]["centre_m"]) == (None, [0.0, 0.0])
    # Y1 starts at (-0.4, -0.5) and looks along +y.
    assert at_start(scenario.zones["ahead"], scenario).centre_m == pytest.approx((-0.4, -0.2), abs=1e-3)


BY_CHANCE = """
spots: {near: {x_m: 0.5, y_m: 0}, far: {x_m: -0.5, y_m: 0}}
%s
zones: {ring: {shape: circle, anchor: corner, radius_m: 0.2}}
counters: {came: {}, went: {}}
rules:
  comes: {triggers: [{trigger: enters, entity: ball, zone: ring}], actions: [{action: count, counter: came}]}
  goes: {triggers: [{trigger: leaves, entity: ball, zone: ring}], actions: [{action: count, counter: went}]}
  again: {triggers: [{trigger: tips_over, entity: Y1}], actions: [%s]}
  is_there: {triggers: [{trigger: time_reached, at_s: 4}], conditions: [{entity: ball, in: ring}], actions: [{action: emit, event: IN}]}
expect:
  the_circle_is_where_chance_says:
    draws: {corner: [far, near]}
    keyframes:
      - {at_s: 0.5, place: {ball: [0.1, 0.3]}}
      - {at_s: 1, move: {ball: [0.5, 0]}}
      - {at_s: 1.5, tips: [Y1]}
      - {at_s: 4.5, move: {ball: [0.5, 0]}}
      - {at_s: 5, move: {ball: [0.1, 0.3]}}
    lasts_s: 6
    events: [{event: IN}]
    counters: {came: 0, went: 1}
  or_elsewhere:
    draws: {corner: near}
    keyframes: [{at_s: 0.5, place: {ball: [0.1, 0.3]}}, {at_s: 1, move: {ball: [0.5, 0]}}]
    lasts_s: 6
    events: [{event: IN}]
    counters: {came: 1, went: 0}
"""
DRAW = BY_CHANCE % ("draws: {corner: {values: [near, far]}}", "{action: draw, draw: corner}")
ROLE = BY_CHANCE % ("roles: {corner: {of: [near, far]}}", "{action: assign, role: corner}")


@pytest.mark.parametrize("body", [DRAW, ROLE])
@pytest.mark.parametrize("test", ["the_circle_is_where_chance_says", "or_elsewhere"])
def test_circle_sits_at_the_spot_that_is_drawn_and_another_draw_is_no_entry(body, test):
    assert run_test(loaded(body), test).differences == ()


@pytest.mark.parametrize("body", [DRAW, ROLE])
def test_views_of_a_circle_at_a_drawn_spot(body):
    drawn = loaded(body)
    assert zone_words(drawn.scenario.zones["ring"]) == "within 0.2 of corner"
    assert "ring" not in [zone["name"] for zone in visible_things(drawn.scenario)["zones"]]
    assert "within 0.2 of corner" in draw_scenario(drawn.scenario, drawn.roster)
    assert not [one for one in lint(drawn) if "corner" in one.message]


def test_role_as_anchor_moves_with_its_holder_and_without_one_contains_nothing():
    body = """
roles: {it: {of: [Y1, B1], initial: none}}
zones: {ring: {shape: circle, anchor: it, radius_m: 0.2}}
broadcast: {fields: {inside: {entity: ball, in: ring}}}
counters: {came: {}}
rules:
  given: {triggers: [{trigger: tips_over, entity: Y2}], actions: [{action: assign, role: it, to: B1}]}
  comes: {triggers: [{trigger: enters, entity: ball, zone: ring}], actions: [{action: count, counter: came}]}
expect:
  it_moves:
    keyframes:
      - {at_s: 0.5, place: {B1: [0.5, 0.3], ball: [0.5, 0], Y1: [-0.5, 0]}}
      - {at_s: 1, move: {Y1: [0.5, -0.15]}, tips: [Y2]}
      - {at_s: 3.5, move: {B1: [0.5, 0.3]}}
      - {at_s: 4, move: {B1: [0.5, 0.15]}}
    lasts_s: 5
    counters: {came: 1}
"""
    assert run_test(loaded(body), "it_moves").differences == ()


def test_replay_leaves_out_circles_around_spots_that_rules_set(small):
    moves = (
        "rules: {moves: {triggers: [{trigger: half_started}], actions: [{action: set_spot, spot: centre, to: ball}]}}"
    )
    names = [zone["name"] for zone in visible_things(small(GUARD, moves))["zones"]]
    assert "home" not in names
    assert "guard" in names


ZONE = "zones: {z: {shape: circle, anchor: %s, radius_m: 0.1%s}}\n"
SET_SPOT = "spots: {mark: {x_m: 0, y_m: 0}}\n" + rule(action="{action: set_spot, spot: mark, to: ball}")


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (ZONE % ("Y1", ", drawn: true"), "conflicting-keys zones.z.drawn"),
        (SET_SPOT + ZONE % ("mark", ", drawn: true"), "conflicting-keys zones.z.drawn"),
        (SET_SPOT.replace("0}", "0, drawn: true}"), "conflicting-keys spots.mark.drawn"),
        (ZONE % ("yellow", ""), "wrong-kind zones.z.anchor"),
        ("draws: {d: {values: [centre]}}\n" + ZONE % ("d", ", drawn: true"), "conflicting-keys zones.z.drawn"),
        ("draws: {d: {values: [centre, pitch]}}\n" + ZONE % ("d", ""), "wrong-kind draws.d.values[1]"),
        ("roles: {d: {of: [pitch]}}\n" + ZONE % ("d", ""), "wrong-kind zones.z.anchor"),
        (ZONE % ("Y1", "") + rule(action="{action: place, entity: ball, at: {uniform_in: z}}"),
         "unbounded-zone rules.r.actions[0] (place)"),
    ],
)  # fmt: skip
def test_mistake_in_an_anchored_circle(body, expected):
    assert complaints(body) == [expected]


def test_circle_at_a_spot_that_no_rule_sets_may_be_drawn_on_the_field():
    spots = "spots: {mark: {x_m: 0, y_m: 0, drawn: true, colour: red}}\n"
    assert scenario(spots + ZONE % ("mark", ", drawn: true")).spots["mark"].drawn
