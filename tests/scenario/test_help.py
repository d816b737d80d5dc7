"""The help of errors says what to write instead, and following it works."""

import pytest

from rcj_challenges.scenario.json_schema import scenario_schema
from rcj_challenges.scenario.messages.synonyms import OTHER_KEYS, OTHER_WORDS
from tests.scenario.writing import complaints, errors, in_short, loaded, rule


def place(text):
    return rule(action=f"{{action: place, entity: ball, at: {text}}}")


def condition(text):
    return rule(rest=f"    conditions: [{{{text}}}]\n")


HELP = [
    # A word of another list, of another language, or without its key.
    (rule("{trigger: speed, entity: Y1, at_least: 1}"), "{trigger: holds, conditions: [{speed: …}]}"),
    (condition("condition: touches, entity: Y1, other: ball"), "it stands in 'triggers'"),
    (rule(action="{action: speed}"), "it stands in 'conditions'"),
    (rule("{trigger: goal}"), "{trigger: enters, entity: ball, zone: NAME}"),
    (condition("inside: pitch"), "{entity: NAME, in: ZONE}"),
    (rule("enters"), "write {trigger: enters, …}"),
    (rule("{enters: {entity: ball, zone: blue_goal}}"), "write {trigger: enters, …}"),
    ("zones: {a: {type: circle, radius_m: 0.1}}\n", "write {shape: circle, …}"),
    # Keys.
    ("rules: {r: {when: [], actions: [{action: end}]}}\n", "did you mean 'triggers'?"),
    ("match: {duration: 60}\n", "did you mean 'half_s'?"),
    (rule("{trigger: touches, robot: Y1, ball: ball}"), "did you mean 'entity'?"),
    (condition("score: blue, more_than: 2"), "did you mean 'above'?"),
    (condition("score: blue, greater: 2"), "did you mean 'above'?"),
    (condition("score: blue, fewer_than: 2"), "did you mean 'below'?"),
    (condition("score: blue, min: 2"), "did you mean 'at_least'?"),
    (condition("score: blue, max: 2"), "did you mean 'at_most'?"),
    (rule(action="{action: score, entrant: blue, points: {counter: blue, weight: 2}}"), "did you mean 'times'?"),
    # Values as YAML reads them.
    ("match: {half_s: '60'}\n", "leave the quotes out"),
    ("match: {half_s: 10 min}\n", "write one number alone"),
    ("match:\n  half_s: 7,5\n", "a decimal number is written with a point: 7.5"),
    ("match: {swap_sides: on}\n", "did you mean true?"),
    ("kits: {v2: {messages: 2021}}\n", "write it in quotes: '2021'"),
    ("description: 007\n", "write it in quotes: '007'"),
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
    ("robots: {Y1: {devices: {gps: null}}}\n", "'without: [gps]'"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0}], poses: {Y1: null}}}\n", "off: [Y1]"),
    ("robots: {B3: }\n", "'B3: null' takes away what the base has"),
]


@pytest.mark.parametrize(("body", "said"), HELP)
def test_help_shows_what_to_write(body, said):
    assert any(said in problem.help for problem in errors(body)), [problem.help for problem in errors(body)]


MISLEADING = [
    # Of what is no list, or no list of mappings, nothing is said about lists.
    ("zones: {z: {shape: circle, radius_m: 0.1, centre_m: target}}\n", "a list"),
    (rule("{trigger: touches, entity: {draw: d}, other: ball}"), "brackets"),
    (condition("score: blue, greater: 2"), "negate'?"),
]


@pytest.mark.parametrize(("body", "said"), MISLEADING)
def test_help_that_would_mislead_is_not_given(body, said):
    assert not any(said in problem.help for problem in errors(body)), [problem.help for problem in errors(body)]


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

NO_B3 = "robots: {B3: null}\n"


def test_robot_that_is_removed_and_driven_is_reported_once_and_the_help_works():
    (problem,) = errors(NO_B3 + "entrants: {blue: {robots: {B3: x.py}}}\n")
    assert in_short(problem) == "unknown-name entrants.blue.robots.B3"
    assert problem.help.startswith("'B3' was removed in a.yaml:5")
    assert loaded(NO_B3)


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
