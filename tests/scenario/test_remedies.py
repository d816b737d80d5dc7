"""Messages say what to write instead, where there is one usual way out."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD, complaints, rule

PILLAR = "obstacles: {pillar: {shape: cylinder, centre_m: [0.4, 0], radius_m: 0.05}}\n"


def test_whoever_puts_something_beside_a_fixed_obstacle_learns_of_movable_and_of_spots():
    (text,) = complaints(
        PILLAR + rule(action="{action: place, entity: Y1, at: {relative_to: pillar, offset_m: [0.2, 0]}}")
    )
    assert text == (
        "rules.r.actions[0] (place): 'pillar' is a fixed obstacle; expected an entity or spot: with movable: true it "
        "is an entity, and a spot of the same place can stand for it"
    )


def test_of_what_can_be_touched_each_is_named_once():
    (text,) = complaints(rule("{trigger: touches, entity: ball, other: fence}"))
    assert text == (
        "rules.r.triggers[0] (touches): unknown entity or obstacle 'fence'; there are B1, B2, B3, Y1, Y2, Y3, ball, "
        "walls, robots, balls, blue, yellow"
    )


def test_whoever_takes_a_fixed_obstacle_for_an_entity_learns_of_movable():
    (text,) = complaints(PILLAR + rule(action="{action: remove, entity: pillar}"))
    assert text == (
        "rules.r.actions[0] (remove): 'pillar' is a fixed obstacle; expected an entity, which can move: with movable: "
        "true it is one"
    )


def test_a_group_with_a_fixed_obstacle_says_the_same():
    (text,) = complaints(
        PILLAR + "groups: {things: [ball, pillar]}\n" + rule(action="{action: remove, entity: things}")
    )
    assert text.endswith(
        "contains 'pillar', a fixed obstacle; expected an entity, which can move: with movable: true it is one"
    )


def test_what_comes_near_a_fixed_obstacle_is_named_first():
    (text,) = complaints(
        PILLAR + rule(rest="    conditions: [{condition: distance, entity: pillar, to: Y1, at_most: 0.2}]\n")
    )
    assert text.endswith("expected an entity; name the obstacle in 'to', and in 'entity' who comes near it")


@pytest.mark.parametrize(("entity", "other"), [("pillar", "walls"), ("pillar", "pillar"), ("obstacles", "walls")])
def test_of_two_that_touch_one_must_be_able_to_move(entity, other):
    (text,) = complaints(PILLAR + rule(f"{{trigger: touches, entity: {entity}, other: {other}}}"))
    assert text.startswith(
        f"rules.r.triggers[0] (touches): 'pillar' and '{other}' never move, so that they never touch"
    )


@pytest.mark.parametrize(
    ("trigger", "name"),
    [
        ("{trigger: touches, entity: B3, other: B3}", "B3"),
        ("{trigger: touches, entity: [B3], other: B3}", "B3"),
        ("{trigger: touches, entity: each, other: each}", "each"),
    ],
)
def test_nothing_touches_itself(trigger, name):
    (text,) = complaints(f"rules: {{r: {{for_each: robots, triggers: [{trigger}], actions: [{{action: end}}]}}}}\n")
    assert text.endswith(
        f"(touches): '{name}' never touches itself; name in other what it touches, such as robots or walls"
    )


@pytest.mark.parametrize("entity", ["each", "robots"])
def test_each_of_a_group_touches_the_others_of_it(entity):
    trigger = f"{{trigger: touches, entity: {entity}, other: robots}}"
    rules = f"rules: {{r: {{for_each: robots, triggers: [{trigger}], actions: [{{action: end}}]}}}}\n"
    assert load_text(HEAD + rules).scenario.rules["r"].triggers


def test_what_is_no_obstacle_gets_no_such_advice():
    (text,) = complaints(rule(action="{action: remove, entity: centre}"))
    assert text.endswith("'centre' is a spot; expected an entity")


def test_two_entrants_on_one_channel_are_told_which_key_to_write():
    (text,) = complaints(
        "robots: {P1: {colour: pink, number: 1, kit: v2, start: {x_m: 0.5, y_m: 0, yaw_rad: 0}}}\n"
        "entrants: {pink: {radio_channel: 2, robots: {P1: robot.py}}}\n"
    )
    assert text.endswith("they would hear each other: write another radio_channel, such as 4")


def test_of_two_channels_that_one_is_told_which_stands_in_the_own_file():
    # The preset has 2 for blue and 3 for yellow.
    with pytest.raises(ScenarioError) as error:
        load_text(HEAD + "entrants: {blue: {radio_channel: 3}}\n", file="a.yaml")
    assert str(error.value) == (
        "a.yaml:5:34: entrants.blue.radio_channel: channel 3 is that of 'blue' and of 'yellow'; they would hear each other: "
        "write another radio_channel, such as 2"
    )


@pytest.mark.parametrize("key", ["position", "pos"])
def test_where_a_ball_or_an_obstacle_begins(key):
    (text,) = complaints(f"balls: {{ball: {{{key}: [0, 0]}}}}\n")
    assert text.endswith("; it is called 'start_m' here")
    texts = complaints(f"obstacles: {{post: {{shape: cylinder, radius_m: 0.1, {key}: [0, 0]}}}}\n")
    assert any(text.endswith("; it is called 'centre_m' here") for text in texts)


@pytest.mark.parametrize("place", ["{x: 0, y: 0.5}", "{x_m: 0, y_m: 0.5}", "{point: [0, 0.5]}"])
def test_a_place_of_a_keyframe_is_a_list_of_numbers(place):
    (text,) = complaints(rule() + f"expect: {{t: {{keyframes: [{{at_s: 1, move: {{ball: {place}}}}}], lasts_s: 2}}}}\n")
    assert text.endswith("; a place is written [x, y] or [x, y, yaw], in m and rad")
    assert "in brackets, also of one" not in text


def test_the_values_of_a_draw_are_no_list_of_mappings():
    (text,) = complaints(rule() + "draws: {side: {values: {west: 1, east: 2}}}\n")
    assert text == "draws.side.values: expected a list, found a mapping with west, east"


@pytest.mark.parametrize(
    ("body", "hint"),
    [
        (
            rule("{trigger: speed, entity: Y1, at_least: 1}"),
            "'speed' is a condition: {trigger: holds, condition: {condition: speed, …}} waits for it",
        ),
        (
            rule(rest="    conditions: [{condition: touches, entity: Y1, other: ball}]\n"),
            "'touches' is a trigger: it stands in 'triggers'",
        ),
        (rule(action="{action: touches, entity: Y1, other: ball}"), "'touches' is a trigger: it stands in 'triggers'"),
        (rule("{trigger: score, entrant: yellow}"), "'score' is an action: it stands in 'actions'"),
        (rule(action="{action: in_zone}"), "'in_zone' is a condition: it stands in 'conditions'"),
    ],
)
def test_a_word_of_another_list_is_told_where_it_belongs(body, hint):
    (text,) = complaints(body)
    assert text.endswith(f"; {hint}")


def test_a_word_of_no_list_gets_no_such_hint():
    with pytest.raises(ScenarioError, match=r"unknown trigger 'nonsense'; there are [a-z_, ]+$"):
        load_text(HEAD + rule("{trigger: nonsense}"), file="a.yaml")


@pytest.mark.parametrize(
    ("written", "hint"),
    [
        ("halftime", "; write half"),
        ("and", "; write all_of"),
        ("or", "; write any_of"),
        ("not", "; write the condition itself, with negate: true"),
        ("none_of", "; write any_of, with negate: true"),
        ("score", "; write counter, with the entrant as the counter: a score is read like one"),
        ("phase", "; write phases: […] beside 'conditions': a rule lives in the phases of that list"),
        ("time_s", "; write timer, of a timer with starts: true"),
        ("inzone", "; did you mean 'in_zone'?"),
        ("all", "; did you mean 'all_of'?"),
        ("nonsense", ""),
        ("position", ""),
    ],
)
def test_a_wrong_condition_is_told_all_there_are_and_never_the_contrary(written, hint):
    (text,) = complaints(rule(rest=f"    conditions: [{{condition: {written}}}]\n"))
    known, _, rest = text.partition("; there are ")[2].partition(";")
    assert {"in_zone", "any_of", "all_of", "half", "timer"} <= set(known.split(", "))
    assert f";{rest}" == (hint or ";")


@pytest.mark.parametrize(("written", "meant"), [("at_min", ""), ("at_max", "at_most"), ("at_lest", "at_least")])
def test_a_wrong_key_is_never_told_the_contrary(written, meant):
    asked = f"{{condition: speed, entity: ball, {written}: 1}}"
    (text,) = complaints(rule(rest=f"    conditions: [{asked}]\n"))
    assert text.endswith(f"; did you mean '{meant}'?" if meant else "entity, of")


POSTS = "obstacles: {%s}\n" % ", ".join(  # noqa: UP031 - braces of YAML
    f"post_{name}: {{shape: cylinder, centre_m: [{x_m}, 0.6], radius_m: 0.03}}"
    for name, x_m in zip("abc", (-0.3, 0, 0.3), strict=True)
)


def test_a_group_of_fixed_obstacles_is_refused_once_in_a_rule_and_says_how_many_they_are():
    near = "{condition: speed, entity: obstacles, at_most: 0.1}"
    (text,) = complaints(POSTS + rule(rest=f"    conditions: [{near}, {near}, {near}]\n"))
    assert text.startswith(
        "rules.r.conditions[0] (speed): group 'obstacles' contains 'post_a', a fixed obstacle, and 2 more of them; "
    )
    two = rule(rest=f"    conditions: [{near}]\n") + rule(rest=f"    conditions: [{near}]\n").replace(
        "rules:\n  r:", "  other:"
    )
    assert len(complaints(POSTS + two)) == 2


def test_a_value_of_a_draw_that_does_not_fit_is_told_once_whoever_needs_it():
    place = "{action: place, entity: ball, at: {spot: d}}"
    (text,) = complaints("draws: {d: {values: [pitch, centre]}}\n" + rule(action=f"{place}, {place}"))
    assert text == "draws.d.values[0]: 'pitch' is a zone; expected a spot (needed by rules.r.actions[0] (place))"
    points = "{action: score, entrant: yellow, points: {draw: d}}"
    (text,) = complaints("draws: {d: {values: [many, 2]}}\n" + rule(action=f"{points}, {points}"))
    assert text.startswith("draws.d.values[0]: expected a number, found 'many' (needed by rules.r.actions[0] (score)")


@pytest.mark.parametrize(
    ("body", "remedy"),
    [
        ("match: {half_s: 10 min}\n", "its unit is the one that the key's name ends with"),
        ("match: {half_s: '1:30'}\n", "its unit is the one that the key's name ends with"),
        ("match:\n  half_s: 7,5\n", "a decimal number is written with a point: 7.5"),
        ("spots: {s: {x_m: '0.5', y_m: 0}}\n", "leave the quotes out"),
        ("spots: {s: {x_m: \u22120.5, y_m: 0}}\n", "found '\u22120.5'; its minus is another sign: write -0.5"),
        ("groups: {g: [„Y1“]}\n", "at most 64; quotes of a text processor are part of it: write Y1"),
        (
            "zones:\n  - name: a\n",
            "expected a mapping by name, found a list of 1; each entry begins with its name and ':', not with '-'",
        ),
        (
            "rules: {r: {triggers: [{trigger: half_started}], actions: [{action: end}], text: So}}\n",
            "; it is called 'says' here",
        ),
        (
            "params: {far_m: 0.3}\nspots: {s: {x_m: far_m, y_m: 0}}\n",
            "the value of that param is written {param: far_m}",
        ),
        (
            "params: {far_m: 0.3}\nspots: {s: {x_m: $far_m, y_m: 0}}\n",
            "the value of that param is written {param: far_m}",
        ),
        ("gates: {g: {from_m: [0,5, 0,2], to_m: [0, 0]}}\n", "a decimal number is written with a point: [0.5, 0.2]"),
        (
            rule(action="{action: score, entrant: yellow, points: 2 * goals}"),
            "no formula is read: {param: NAME, times: 2, plus: 1} reckons with a param, a list of parts is added up",
        ),
        ("kits: {v2: {messages: 2021}}\n", "expected v2.1, v2.2 or 2021, found 2021; write it in quotes: '2021'"),
        ("counters: {c: 0}\n", "expected a mapping that may have initial, per, keep, such as {}, found 0"),
        (rule().replace("[{trigger: half_started}]", "{trigger: half_started}"), "also of one: [{…}]"),
        (rule(rest="    phases: play\n"), "a list of one is written [play]"),
    ],
)
def test_a_value_that_is_written_otherwise_elsewhere(body, remedy):
    assert any(line.endswith(remedy) for line in complaints(body)), complaints(body)


@pytest.mark.parametrize(
    ("key", "remedy"),
    [
        ("when", "it is called 'triggers' here"),
        ("if", "it is called 'conditions' here"),
        ("then", "it is called 'actions' here"),
        ("else", "what else is to happen is a rule of its own, whose conditions have negate: true"),
    ],
)
def test_a_rule_in_the_words_of_other_languages(key, remedy):
    (text,) = complaints(rule(rest=f"    {key}: []\n"))
    assert text.startswith(f"rules.r: unknown key '{key}'; ")
    assert text.endswith(f"; {remedy}")


@pytest.mark.parametrize(
    ("body", "remedy"),
    [
        (rule(action="{action: remove, robot: B3}"), "it is called 'entity' here"),
        (rule(rest="    conditions: [{condition: last_touch, ball: ball, by: B1}]\n"), "it is called 'entity' here"),
        (
            rule(action="{action: score, entrant: yellow, points: [{word: time_s, times: 0.5}]}"),
            "it is called 'weight' here",
        ),
        ("draws: {d: {values: [a, b]}}\n" + rule(action="{action: draw, draw: d, to: a}"), "it is called 'as' here"),
        (
            rule().replace("half_started", "stays_in, entity: Y1, zone: pitch, for_s: 3"),
            "it is called 'limit_s' here",
        ),
    ],
)
def test_a_key_that_another_word_has_is_told_as_it_is_called_here(body, remedy):
    assert any("unknown key" in text and text.endswith(f"; {remedy}") for text in complaints(body)), complaints(body)


@pytest.mark.parametrize(
    ("trigger", "remedies"),
    [
        ("touches, robot: Y1, ball: ball", ["it is called 'entity' here", "it is called 'other' here"]),
        ("touches, entity: ball, robot: Y1", ["it is called 'other' here"]),
        ("touches, other: ball, robot: Y1", ["it is called 'entity' here"]),
        (
            "enters, zone: blue_goal, robot: Y1, ball: ball",
            ["it is called 'entity' here", "allowed are trigger, entity, zone"],
        ),
    ],
)
def test_of_two_things_each_is_told_its_own_key(trigger, remedies):
    texts = [text for text in complaints(rule(f"{{trigger: {trigger}}}")) if "unknown key" in text]
    assert len(texts) == len(remedies)
    for text, remedy in zip(texts, remedies, strict=True):
        assert text.endswith(f"; {remedy}"), text


def test_what_has_a_key_of_another_name_is_not_said_to_be_reckoned_elsewhere():
    points = "[{counter: yellow, times: 2}]"
    (text,) = complaints(rule(action=f"{{action: score, entrant: yellow, points: {points}}}"))
    assert text.endswith("; it is called 'weight' here")


def test_a_section_that_is_not_indented():
    texts = complaints("rules:\nr:\n  triggers: [{trigger: half_started}]\n  actions: [{action: end}]\n")
    assert texts[1].startswith("unknown key 'r'; ")
    assert texts[1].endswith("; what belongs to 'rules' above it is indented: put two blanks before it")


def test_a_key_that_is_unknown_anywhere_else_is_no_matter_of_indentation():
    (text,) = complaints("regeln: {}\n")
    assert "indented" not in text


def test_without_a_preset_it_is_told_what_brings_robots():
    texts = complaints("", head="schema_version: 1\nid: a\ntitle: A\n")
    assert [text.partition("; ")[2] for text in texts] == ["a preset brings them: extends: soccersim_v2"] * 2


@pytest.mark.parametrize(
    ("trigger", "said"),
    [
        ("{trigger:enters, entity: ball}", "an empty value; a blank comes after the ':', trigger: enters"),
        (
            "{trigger: enters, entity: ball, zone: blue_goal, yellow_goal}",
            "several values stand in brackets, zone: [blue_goal, yellow_goal], and a text with a ',' in quotes",
        ),
        ("{trigger: enters, entity: ball, zone: }", "an empty value; write one, or leave the line out"),
    ],
)
def test_a_key_without_a_value(trigger, said):
    assert any(text.endswith(said) for text in complaints(rule(trigger))), complaints(rule(trigger))


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (
            "match: {half_s: 7,5}",
            "a decimal number is written with a point, 7.5, and several numbers stand in brackets, [7, 5]",
        ),
        (
            "spots: {s: {x_m: 0.3, 0}}",
            "0 stands where a key is expected: several numbers stand in brackets, [0.3, 0]",
        ),
        ("spots: {a: {x_m: 0, y_m: 0}, 1: {x_m: 0, y_m: 0}}", "key 1 is not text; write it in quotes"),
        ("rules: {r: {says: {entity} scores}}", "or begins with {, [ or # is not in quotes)"),
        ("rules:\n  r:\n    says: {entity} scores", "or a text that begins with { or [ is not in quotes)"),
        ("balls: {b: {colour: #ff0000}}", "what begins with # is a comment, unless it is in quotes: '#ff8800')"),
        (
            "rules: {r: {says: A goal: one point}}",
            "or a text that has ': ' in it or begins with {, [ or # is not in quotes)",
        ),
    ],
)
def test_what_yaml_takes_for_something_else(body, said):
    assert any(text.endswith(said) for text in complaints(body + "\n")), complaints(body + "\n")


@pytest.mark.parametrize(
    ("body", "usual"),
    [
        ("balls: {ball: {friction: 0.1}}\n", "slows_mps2"),
        ("balls: {ball: {rolling_friction: 0.1}}\n", "slows_mps2"),
        ("counters: {n: {}}\n" + rule(action="{action: count, counter: n, max: 3}"), "keeps_at_most"),
        (rule(action="{action: score, entrant: yellow, points: -1, min: 0}"), "keeps_at_least"),
        (rule("{trigger: holds, condition: {condition: way, entity: Y1, min: 2}}"), "at_least"),
    ],
)
def test_a_key_in_the_words_of_other_languages(body, usual):
    (text,) = complaints(body)
    assert text.endswith(f"; it is called '{usual}' here")


@pytest.mark.parametrize(
    ("body", "way_out"),
    [
        (rule("half_started"), "found 'half_started'; write {trigger: half_started}"),
        (rule("enters"), "found 'enters'; write {trigger: enters, …}"),
        (rule("goal"), "found 'goal'; a goal is {trigger: enters, entity: ball, zone: …}: the goal is the zone"),
        (rule("kickof"), "expected a mapping with 'trigger', found 'kickof'"),
        (rule("{enters: {entity: ball, zone: blue_goal}}"), "tells, holds; write {trigger: enters, …}"),
        (rule(action="end"), "found 'end'; write {action: end, …}"),
        (rule(action="place"), "found 'place'; write {action: place, …}"),
        (rule(action="{score: yellow}"), "emit, end; write {action: score, …}"),
        (rule(action="{count: n, by: 2}"), "emit, end; write {action: count, …}"),
        (rule(rest="    conditions: [half]\n"), "found 'half'; write {condition: half, …}"),
        (
            rule(rest="    conditions: [{counter: blue, at_least: 1}]\n"),
            "any_of, all_of; write {condition: counter, …}",
        ),
        ("zones: {a: circle}\n", "found 'circle'; write {shape: circle, …}"),
        ("zones: {a: {circle: {radius_m: 0.1}}}\n", "half_plane; write {shape: circle, …}"),
        ("robots: {Y1: {devices: {eye: lidar}}}\n", "found 'lidar'; write {device: lidar, …}"),
        ("robots: {Y1: {start: [0, 0.5]}}\n", "found a list of 2; write {x_m: 0, y_m: 0.5}"),
        ("robots: {Y1: {start: [0, 0.5, 1.57]}}\n", "found a list of 3; write {x_m: 0, y_m: 0.5, yaw_rad: 1.57}"),
        ("spots: {a: [0.1, 0]}\n", "found a list of 2; write {x_m: 0.1, y_m: 0}"),
        (
            rule() + "expect: {t: {keyframes: [{at_s: 1, place: {ball: centre}}], lasts_s: 2}}\n",
            "expected a list, found 'centre'; a place is written [x, y] or [x, y, yaw], in m and rad",
        ),
        ("match: {duration: 60}\n", "it is called 'half_s' here"),
        ("timers: {t: {duration: 60}}\n", "it is called 'lasts_s' here"),
        (rule(action="{action: hold, entity: robots, duration: 3}"), "it is called 'for_s' here"),
        (rule(action="{action: remove, entity: ball, seconds: 3}"), "it is called 'for_s' here"),
        (rule("{trigger: stays_in, entity: ball, zone: blue_goal, duration: 3}"), "it is called 'limit_s' here"),
        ("spots: {a: [true, 0]}\n", "expected a mapping, found a list of 2"),
    ],
)
def test_words_without_their_key_and_lists_in_place_of_mappings(body, way_out):
    assert any(line.endswith(way_out) for line in complaints(body)), complaints(body)


@pytest.mark.parametrize(
    ("word", "way_out"),
    [
        ("more_than", "'at_least' holds from that value on, and 'more than it' is at_most with negate: true"),
        ("greater_than", "'at_least' holds from that value on, and 'more than it' is at_most with negate: true"),
        ("less_than", "'at_most' holds up to that value, and 'less than it' is at_least with negate: true"),
        ("below", "'at_most' holds up to that value, and 'less than it' is at_least with negate: true"),
    ],
)
def test_more_and_less_than_a_value(word, way_out):
    (text,) = complaints(rule(rest=f"    conditions: [{{condition: counter, counter: blue, {word}: 2}}]\n"))
    assert text.endswith(way_out)


def test_coordinates_beside_an_action_are_a_point():
    texts = complaints(rule(action="{action: place, entity: Y1, x_m: 0.1, y_m: 0.2}"))
    assert all(text.endswith("; a place is written at: {point: [x, y]}") for text in texts[:2])


def test_a_condition_in_the_place_of_a_trigger_is_what_holds_waits_for():
    (text,) = complaints(rule("{condition: in_zone, entity: ball, zone: blue_goal}"))
    assert text.endswith(
        "holds; to wait until a condition comes true: {trigger: holds, condition: {condition: in_zone, …}}"
    )


@pytest.mark.parametrize("body", ["robots: {B1: }\n", "zones: {pitch: }\n", "entrants: {blue: {robots: {B1: }}}\n"])
def test_a_name_of_the_base_left_empty_may_be_meant_to_go(body):
    text = complaints(body)[0]
    name = "pitch" if "pitch" in body else "B1"
    assert text.endswith(
        f"an empty value; write one, leave the line out, or take away what the base has by '{name}: null'"
    )
