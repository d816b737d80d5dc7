"""Slips in keys and names: another unit, another thing's key, a name without its blanks, a word in the wrong place."""

from __future__ import annotations

import pytest

from tests.scenario.linting import codes
from tests.scenario.writing import complaints, loaded, rule

CONDITION = "    conditions: [%s]\n"


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ("zones: {a: {shape: circle, centre_m: [0, 0], radius_cm: 10}}\n", "'radius_m' here, in m: 0.1"),
        ("zones: {a: {shape: circle, centre_m: [0, 0], radius_mm: 150}}\n", "'radius_m' here, in m: 0.15"),
        ("zones: {a: {shape: circle, centre_m: [0, 0], radius_mm: 0.04}}\n", "'radius_m' here, in m: 0.00004"),
        ("zones: {a: {shape: circle, centre_m: [0, 0], radius_mm: 1234567}}\n", "'radius_m' here, in m: 1234.567"),
        ("match: {half_min: 5}\n", "'half_s' here, in s: 300"),
        ("match: {half_ms: 5000}\n", "'half_s' here, in s: 5"),
        ("robots: {Y1: {start: {x_m: 0, y_m: 0, yaw_deg: 90}}}\n", "'yaw_rad' here, in rad: 1.5708"),
        ("obstacles: {a: {shape: cylinder, centre_m: [0, 0], radius_m: 0.1, mass_g: 20}}\n", "'mass_kg' here, in kg: 0.02"),
    ],
)  # fmt: skip
def test_another_unit(body, told):
    assert any(text.endswith(f"; it is called {told}") for text in complaints(body + rule()))


@pytest.mark.parametrize(
    ("body", "key"),
    [
        ("zones: {a: {shape: circle, centre_cm: [10, 0], radius_m: 0.1}}\n", "centre_m"),
        ("zones: {a: {shape: circle, centre_m: [10, 0], radius_cm: {param: far}}}\nparams: {far: 10}\n", "radius_m"),
    ],
)
def test_of_what_is_no_single_number_only_the_unit_is_told(body, key):
    found = complaints(body + rule())
    assert any(text.endswith(f"; it is called '{key}' here, in m") for text in found)


@pytest.mark.parametrize(
    ("condition", "key"),
    [
        ("{condition: last_touch, robot: Y3}", "by"),
        ("{condition: last_touch, who: Y3}", "by"),
        ("{condition: last_touch, ball: ball}", "entity"),
        ("{condition: in_zone, robot: Y3, zone: pitch}", "entity"),
    ],
)
def test_who_is_meant(condition, key):
    found = complaints(rule(rest=CONDITION % condition))
    assert [text for text in found if text.endswith(f"; it is called '{key}' here")]


@pytest.mark.parametrize(
    ("action", "key"),
    [
        ("{action: score, entrant: yellow, amount: 3}", "points"),
        ("{action: score, entrant: yellow, value: 3}", "points"),
        ("{action: count, counter: c, amount: 3}", "by"),
        ("{action: count, counter: c, value: 3}", "to"),
        ("{action: set_flag, flag: f, value: false}", "to"),
    ],
)
def test_how_much(action, key):
    body = "counters: {c: {}}\nflags: {f: {}}\n" + rule(action=action)
    assert any(text.endswith(f"; it is called '{key}' here") for text in complaints(body))


@pytest.mark.parametrize(
    ("body", "key"),
    [
        ("balls: {ball: {at: [0, 0]}}\n", "start_m"),
        ("balls: {ball: {centre_m: [0, 0]}}\n", "start_m"),
        ("obstacles: {a: {shape: cylinder, start_m: [0, 0], radius_m: 0.1}}\n", "centre_m"),
        ("obstacles: {a: {shape: cylinder, at: [0, 0], radius_m: 0.1}}\n", "centre_m"),
        ("robots: {Y1: {at: [0, 0]}}\n", "start"),
        ("robots: {Y1: {position: [0, 0]}}\n", "start"),
        ("counters: {c: {start: 3}}\n", "initial"),
        ("flags: {f: {value: true}}\n", "initial"),
    ],
)
def test_where_it_is_and_what_it_is_at_first(body, key):
    assert any(text.endswith(f"; it is called '{key}' here") for text in complaints(body + rule()))


@pytest.mark.parametrize("word", ["timer_runs_out", "timer_over", "timer_finished", "runs_out", "Timer_Elapsed"])
def test_a_time_that_is_over(word):
    assert complaints(rule(f"{{trigger: {word}, timer: t}}"))[0].endswith("; write timer_expired")


@pytest.mark.parametrize("without", ["GPS", "Gps"])
def test_a_device_in_other_letters(without):
    (text,) = complaints(f"robots: {{Y1: {{without: [{without}]}}}}\n" + rule())
    assert text.endswith("; did you mean 'gps'?")


def test_a_device_with_a_stroke_for_its_blank():
    (text,) = complaints("robots: {Y1: {without: [ball_receiver]}}\n" + rule())
    assert text.endswith("; did you mean 'ball receiver'?")


@pytest.mark.parametrize(
    ("body", "device"),
    [
        ("robots: {Y1: {devices: {distancesensor_front: {range_m: 0.5}}}}\n", "distancesensor front"),
        ("robots: {Y1: {devices: {GPS: {noise_m: 0.01}}}}\n", "gps"),
        ("kits: {v2: {devices: {GPS: {noise_m: 0.01}}}}\n", "gps"),
    ],
)
def test_a_device_of_the_kit_is_changed_under_its_own_name(body, device):
    (text,) = complaints(body + rule())
    assert text.endswith(f"; one that the kit has is changed under its own name, '{device}'")


def test_a_device_that_is_new_is_called_as_one_likes():
    (text,) = complaints("robots: {Y1: {devices: {nose: {range_m: 0.5}}}}\n" + rule())
    assert "own name" not in text


@pytest.mark.parametrize("key", ["spot", "relative_to", "point", "entity"])
def test_where_a_name_stands_no_place_stands(key):
    action = f"{{action: place, entity: Y1, at: start, facing: {{towards: {{{key}: centre}}}}}}"
    (text,) = complaints(rule(action=action))
    assert text.endswith("; its name stands alone: centre")


def test_a_zone_is_nothing_to_look_at():
    action = "{action: place, entity: Y1, at: start, facing: {towards: {zone: pitch}}}"
    (text,) = complaints(rule(action=action))
    assert text.endswith("found a mapping with zone")


@pytest.mark.parametrize("section", ["counters", "flags"])
def test_what_needs_nothing_more_is_an_empty_mapping(section):
    (text,) = complaints(f"{section}:\n  it:\n" + rule())
    assert text == f"{section}.it: an empty value; write {{}}, which suffices, or leave the line out"


def test_what_needs_more_is_no_empty_mapping():
    (text,) = complaints("timers:\n  it:\n" + rule())
    assert text == "timers.it: an empty value; write one, or leave the line out"


@pytest.mark.parametrize(
    "body",
    [
        "timers: {t: {lasts_s: {long_s}}}\n" + rule(),
        "phases: {p: {lasts_s: {long_s}}}\n" + rule(),
        rule(action="{action: hold, entity: Y1, for_s: {long_s}}"),
        rule(rest="    cooldown_s: {long_s}\n"),
    ],
)
def test_a_param_as_sentences_write_it(body):
    wrong, empty = complaints("params: {long_s: 5}\n" + body)
    assert empty.endswith("an empty value; where a param is meant, write {param: long_s}")
    assert wrong.endswith("found a mapping with long_s; the value of that param is written {param: long_s}")
    assert "draws.long_s" not in wrong


@pytest.mark.parametrize("key", ["type", "name", "event", "kind"])
def test_a_trigger_under_another_key(key):
    text = complaints(rule(f"{{{key}: enters, entity: ball, zone: pitch}}"))[0]
    assert text.endswith("; write {trigger: enters, …}")


@pytest.mark.parametrize("trigger", ["half_started", "half_ended"])
def test_in_which_half(trigger):
    text = complaints(rule(f"{{trigger: {trigger}, half: 2}}"))[0]
    assert text.endswith("; in which half it counts stands in the rule's conditions: {condition: half, equals: …}")


def test_a_condition_in_a_not():
    text = complaints(rule(rest=CONDITION % "{not: {condition: in_zone, entity: ball, zone: pitch}}"))[0]
    assert text.endswith("; its opposite is the condition itself, with negate: true")


def test_a_counter_in_the_ranking():
    text = complaints("counters: {strokes: {per: robots}}\nresult: {rank: [{strokes: ascending}]}\n" + rule())[0]
    assert text.endswith("; a counter is written {counter: strokes, order: ascending}")


def test_any_phase_is_no_list():
    (text,) = complaints(rule(rest="    phases: [any]\n"))
    assert text.endswith("any phase is written phases: any, without brackets")


def test_one_device_is_a_list_too():
    (text,) = complaints("robots: {Y1: {without: gps}}\n" + rule())
    assert text.endswith("; a list of one is written [gps]")


def test_one_touch_is_a_list_of_pairs():
    test = "expect: {t: {lasts_s: 1, keyframes: [{at_s: 0, touch: [Y1, ball]}]}}\n"
    assert complaints(rule() + test)[0].endswith("'Y1'; each touch is a pair, also one alone: [[Y1, ball]]")
    assert loaded(rule() + test.replace("[Y1, ball]", "[[Y1, ball]]"))


def test_a_distance_is_between_two():
    action = "{action: count, counter: c, to: {distance: {from: Y1, to: ball}}}"
    text = complaints("counters: {c: {}}\n" + rule(action=action))[0]
    assert text.endswith("; the two are written [Y1, ball]")


def test_three_whole_numbers_for_a_point():
    text = complaints("spots: {a: {x_m: 0, y_m: 0}}\nballs: {ball: {start_m: [0,3, 1]}}\n" + rule())[0]
    assert text.endswith(
        "found a list of 3; if decimal numbers are meant, they are written with a point, as in [0.3, -0.2]"
    )


@pytest.mark.parametrize(
    ("reckoned", "told"),
    [
        ("{param: long_s, minus: 0.1}", "; what is taken off is a plus below 0: plus: -0.1"),
        ("{param: long_s, subtract: 3}", "; what is taken off is a plus below 0: plus: -3"),
        ("{param: long_s, minus: 1234567.5}", "; what is taken off is a plus below 0: plus: -1234567.5"),
        ("{param: long_s, divided_by: 4}", "; it is divided by times: 0.25"),
        ("{param: long_s, add: 3}", "; did you mean 'plus'?"),
    ],
)
def test_a_param_is_never_reckoned_the_other_way_round(reckoned, told):
    (text,) = complaints(f"params: {{long_s: 5}}\ntimers: {{t: {{lasts_s: {reckoned}}}}}\n" + rule())
    assert text.endswith(told)


def test_a_part_that_is_taken_off():
    action = "{action: count, counter: c, to: [3, {counter: c, minus: true}]}"
    assert complaints("counters: {c: {}}\n" + rule(action=action))[0].endswith("; what is taken off has weight: -1")


@pytest.mark.parametrize("word", ["all", "any", "none"])
def test_how_many_as_a_key(word):
    condition = f"{{condition: in_zone, entity: yellow, zone: pitch, {word}: true}}"
    assert complaints(rule(rest=CONDITION % condition))[0].endswith(f"; how many of them is written of: {word}")


def test_the_second_of_a_group_without_brackets():
    found = complaints("groups: {followers: Y2, Y3}\n" + rule())
    assert any("several values stand in brackets, followers: [Y2, Y3]" in text for text in found)
    (text,) = complaints("groups: {followers: [Y2], leaders: }\n" + rule())
    assert text == "groups.leaders: an empty value; write one, or leave the line out"


def test_all_that_is_meant_is_taken():
    body = (
        "params: {long_s: 5}\ntimers: {t: {lasts_s: {param: long_s}}}\ncounters: {c: {per: robots}}\n"
        "robots: {Y1: {without: [gps], devices: {distancesensor front: {range_m: 0.5}}}}\n"
        "result: {rank: [{counter: c, order: ascending}]}\n"
    )
    assert loaded(body + rule(action="{action: count, counter: c, entity: Y1, by: 3}", rest="    phases: any\n"))
    assert codes() == []
