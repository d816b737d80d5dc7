"""The help of errors says what to write instead, and following it works."""

import pytest

from rcj_challenges.scenario.json_schema import scenario_schema
from rcj_challenges.scenario.messages.synonyms import OTHER_KEYS, OTHER_WORDS
from tests.scenario.writing import complaints, errors, in_short, loaded, rule


def place(text):
    return rule(action=f"{{action: place, entity: ball, at: {text}}}")


def condition(text):
    return rule(rest=f"    conditions: [{{condition: {text}}}]\n")


HELP = [
    # A word of another list, of another language, or without its key.
    (rule("{trigger: speed, entity: Y1, at_least: 1}"), "{trigger: holds, condition: {condition: speed, …}}"),
    (condition("touches, entity: Y1, other: ball"), "it stands in 'triggers'"),
    (rule(action="{action: in_zone}"), "it stands in 'conditions'"),
    (rule("{trigger: goal}"), "{trigger: enters, entity: ball, zone: NAME}"),
    (condition("inside, entity: ball, zone: pitch"), "did you mean 'in_zone'?"),
    (rule("enters"), "write {trigger: enters, …}"),
    (rule("{enters: {entity: ball, zone: blue_goal}}"), "write {trigger: enters, …}"),
    ("zones: {a: {type: circle, radius_m: 0.1}}\n", "write {shape: circle, …}"),
    # Keys.
    ("rules: {r: {when: [], actions: [{action: end}]}}\n", "did you mean 'triggers'?"),
    ("match: {duration: 60}\n", "did you mean 'half_s'?"),
    (rule("{trigger: touches, robot: Y1, ball: ball}"), "did you mean 'entity'?"),
    (condition("counter, counter: blue, more_than: 2"), "did you mean 'at_least'?"),
    ("match: {half_s: 60, half: 30}\n", "'half_s' is given already, in line 5"),
    # Values as YAML reads them.
    ("match: {half_s: '60'}\n", "leave the quotes out"),
    ("match: {half_s: 10 min}\n", "write one number alone"),
    ("match:\n  half_s: 7,5\n", "a decimal number is written with a point: 7.5"),
    ("match: {swap_sides: on}\n", "did you mean true?"),
    ("kits: {v2: {messages: 2021}}\n", "write it in quotes: '2021'"),
    ("groups: {g: B1}\n", "a list of one is written [B1]"),
    ("balls: {ball: {colour: #ff0000}}\n", "a comment, unless it is in quotes"),
    ("balls: {ball: {colour: }}\n", "a comment, unless it is in quotes"),
    # Places, params, names.
    (place("centre"), "write {spot: centre}"),
    (place("pitch"), "write {uniform_in: pitch}"),
    (place("{robot: Y1}"), "write {relative_to: Y1}"),
    (place("[0.1, 0.2]"), "a point is written {point: [x, y]}"),
    ("params: {far_m: 0.3}\nspots: {s: {x_m: far_m, y_m: 0}}\n", "{param: far_m}"),
    ("params: {winner: blue}\n" + rule(action="{action: score, entrant: winner}"), "{param: winner}"),
    ("params: {n: 2}\nmatch: {half_s: {param: n * 2}}\n", "{param: n, times: 2, plus: 1}"),
    (rule("{trigger: enters, entity: {name: ball}, zone: pitch}"), "the name stands alone: ball"),
    ("robots: {Y1: {devices: {gps: null}}}\n", "'without: [gps]'"),
    ("robots: {B3: }\n", "'B3: null' takes away what the base has"),
    ("entrants: {blue: {radio_channel: 3}}\n", "2 is free"),
]


@pytest.mark.parametrize(("body", "said"), HELP)
def test_help_says_what_to_write(body, said):
    assert any(said in problem.help for problem in errors(body)), [problem.help for problem in errors(body)]


def test_no_word_of_the_language_is_called_foreign():
    words = {
        (kind, value["const"])
        for definition in scenario_schema()["$defs"].values()
        for kind, value in definition.get("properties", {}).items()
        if "const" in value
    }
    assert words
    assert not words & set(OTHER_WORDS)


def test_keys_that_are_suggested_exist():
    schema = scenario_schema()
    keys = {key for definition in schema["$defs"].values() for key in definition.get("properties", ())}
    assert {key for keys_ in OTHER_KEYS.values() for key in keys_} <= keys | set(schema["properties"])


# --- what a base had and this scenario removed ------------------------------------------------------------------------

NO_B3 = "robots: {B3: null}\nentrants: {blue: {robots: {B3: null}}}\n"


def test_robot_removed_without_its_seat_is_reported_once_and_the_help_works():
    (problem,) = errors("robots: {B3: null}\n")
    assert in_short(problem) == "unknown-name entrants.blue.robots.B3"
    assert "write 'B3: null' under entrants.blue.robots too" in problem.help
    assert loaded(NO_B3)


@pytest.mark.parametrize("swaps", ["", "match: {halves: 2, swap_sides: true}\n"])
def test_robots_removed_without_their_entrant_are_reported_once_and_the_help_works(swaps):
    robots = "robots: {B1: null, B2: null, B3: null}\n"
    (problem,) = errors(swaps + robots)
    assert in_short(problem) == "entrant-without-robots entrants.blue"
    assert "write 'blue: null' under entrants" in problem.help
    assert ("'swap_sides: false'" in problem.help) is bool(swaps)
    assert loaded(swaps.replace("true", "false") + robots + "entrants: {blue: null}\n")


def test_own_test_of_a_removed_entrant_is_told_to_take_the_line_out():
    removed = "robots: {B1: null, B2: null, B3: null}\nentrants: {blue: null}\n"
    test = "expect: {t: {keyframes: [{at_s: 1}], lasts_s: 2, score: {%s}}}\n"
    (problem,) = errors(removed + test % "yellow: 0, blue: 0")
    assert in_short(problem) == "unknown-name expect.t.score.blue"
    assert problem.help.endswith("take this line out")
    assert loaded(removed + test % "yellow: 0")


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("placements: {l: [{entity: B3, at: start}]}\n", "take this line out"),
        (rule(action="{action: remove, entity: B3}"), "take this line out"),
        ("spots: {centre: null}\n", "write groups.neutral_spots without it, or 'neutral_spots: null' under groups"),
    ],
)
def test_help_names_what_to_change_where_something_removed_is_named(body, said):
    assert any(
        "it was removed in a.yaml:5; " in one.help and one.help.endswith(said) for one in errors(NO_B3 + body)
    ) or any(one.help.endswith(said) for one in errors(body))


def test_kind_of_a_misused_name_is_part_of_the_message():
    (problem,) = errors("timers: {nap: {lasts_s: 1}}\n" + rule(action="{action: set_phase, phase: nap}"))
    assert "'nap', which is a timer" in problem.message


def test_group_of_several_wrong_things_is_reported_once_in_a_rule():
    posts = ", ".join(f"p{x}: {{shape: cylinder, centre_m: [0.{x}, 0.6], radius_m: 0.01}}" for x in (1, 2))
    near = "{condition: speed, entity: obstacles, at_most: 0.1}"
    body = f"obstacles: {{{posts}}}\n" + rule(rest=f"    conditions: [{near}, {near}]\n")
    assert complaints(body) == ["wrong-kind rules.r.conditions[0] (speed)"]


@pytest.mark.parametrize(
    "trigger",
    [
        "{trigger: touches, entity: B3, other: [B3]}",
        "{trigger: touches, entity: each, other: each}",
        "{trigger: touches, entity: post, other: walls}",
    ],
)
def test_two_that_never_touch_are_refused(trigger):
    post = "obstacles: {post: {shape: cylinder, centre_m: [0.4, 0], radius_m: 0.05}}\n"
    entity = "obstacles" if "post" in trigger else "robots"
    rules = f"rules: {{r: {{for_each: {entity}, triggers: [{trigger}], actions: [{{action: end}}]}}}}\n"
    assert complaints(post + rules) == ["never-touches rules.r.triggers[0] (touches)"]
