"""A test that misses an event says of a rule that was triggered and did not fire which condition did not hold."""

import pytest
import yaml

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
GOAL = "triggers: [{trigger: enters, entity: ball, zone: blue_goal}]"


def notes(
    more: str, wanted: str, keyframes: str = "{at_s: 1, place: {ball: [0, 0.8]}}", score: str = "{}"
) -> list[str]:
    expect = (
        f"expect:\n  it:\n    keyframes: [{keyframes}]\n    lasts_s: 4\n    events: [{wanted}]\n    score: {score}\n"
    )
    found = list(run_test(load_text(HEAD + more + expect, file="it.yaml"), "it").differences)
    return [line for line in found if line.startswith("note: ")]


COUNTED = (
    "counters: {goals: {}}\nrules:\n"
    f"  goal: {{{GOAL}, actions: [{{action: count, counter: goals}}]}}\n"
    f"  first: {{{GOAL}, conditions: [{{condition: half, equals: 1}}, {{condition: counter, counter: goals, at_least: 1}}], "
    "actions: [{action: emit, event: FIRST}]}\n"
)


def test_it_is_told_which_condition_did_not_hold():
    assert notes(COUNTED.replace("at_least: 1", "at_least: 2"), "{event: FIRST}") == [
        "note: first was triggered at 1.024 s, and {condition: counter, counter: goals, at_least: 2} did not hold"
    ]


def test_what_a_rule_of_the_same_tick_makes_true_is_told_as_such():
    assert notes(COUNTED, "{event: FIRST}") == [
        (
            "note: first was triggered at 1.024 s, and {condition: counter, counter: goals, at_least: 1} did not hold yet: "
            "a rule of that very tick made it true, which others see one tick later, as they hear an event that it emits"
        )
    ]


def test_of_several_times_that_is_told_which_is_nearest_to_when_the_event_was_expected():
    twice = "{at_s: 1, place: {ball: [0, 0.8]}}, {at_s: 2, place: {ball: [0, 0]}}, {at_s: 3, place: {ball: [0, 0.8]}}"
    more = COUNTED.replace("at_least: 1", "at_least: 9")
    assert "triggered at 3.008 s" in notes(more, "{event: FIRST, at_s: 3}", twice)[0]
    assert "triggered at 1.024 s" in notes(more, "{event: FIRST, at_s: 1}", twice)[0]
    assert "triggered at 3.008 s" in notes(more, "{event: FIRST}", twice)[0]


def test_rules_that_fired_and_those_that_emit_nothing_that_is_missing_are_not_told():
    other = COUNTED + f"  second: {{{GOAL}, actions: [{{action: emit, event: SECOND}}]}}\n"
    assert notes(other, "{event: SECOND}, {event: SECOND}") == []
    twice = "{at_s: 1, place: {ball: [0, 0.8]}}, {at_s: 2, place: {ball: [0, 0]}}, {at_s: 3, place: {ball: [0, 0.8]}}"
    assert notes(COUNTED, "{event: FIRST}, {event: FIRST}", twice) == []  # kept from it at first, and fired then


def test_of_many_rules_that_did_not_fire_the_first_three_are_told():
    more = "rules:\n" + "".join(
        f"  r{number}: {{{GOAL}, conditions: [{{condition: half, equals: 2}}], actions: [{{action: emit, event: E}}]}}\n"
        for number in range(5)
    )
    assert [note.split()[1] for note in notes(more, "{event: E}")] == ["r0", "r1", "r2"]


def test_rules_that_would_have_changed_a_score_are_told():
    more = (
        "rules:\n"
        f"  for_yellow: {{{GOAL}, conditions: [{{condition: half, equals: 2}}], actions: [{{action: score, entrant: yellow}}]}}\n"
        f"  for_blue: {{{GOAL}, conditions: [{{condition: half, equals: 2}}], actions: [{{action: score, entrant: blue}}]}}\n"
    )
    assert notes(more, "", score="{yellow: 1, blue: 0}") == [
        "note: for_yellow was triggered at 1.024 s, and {condition: half, equals: 2} did not hold"
    ]


@pytest.mark.parametrize("entrant", ["each", "{last_touch: ball}"])
def test_a_rule_that_scores_for_whom_it_concerns_may_have_changed_any_score(entrant):
    more = (
        f"rules:\n  own:\n    for_each: yellow\n    {GOAL}\n    conditions: [{{condition: half, equals: 2}}, "
        "{condition: in_zone, entity: each, zone: pitch}]\n"
        f"    actions: [{{action: score, entrant: {entrant}}}]\n"
    )
    assert len(notes(more, "", score="{yellow: 1}")) == 1
    assert notes(more, "{event: KICKOFF}", score="{yellow: 0}") == []


def test_a_rule_without_the_phase_is_not_triggered():
    assert notes(COUNTED.replace("first: {", "first: {phases: [pause], ").replace("rules:", "phases: {pause: {}}\nrules:"),
                 "{event: FIRST}") == []  # fmt: skip


def test_of_several_that_a_rule_is_for_that_is_told_which_kept_the_first_of_them():
    more = (
        "zones: {lane: {shape: rect, x_min_m: -0.1, x_max_m: 0.1}}\n"  # in which Y3 starts alone
        "rules:\n  near:\n    for_each: yellow\n    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]\n"
        "    conditions: [{condition: in_zone, entity: each, zone: lane}, {condition: half, equals: 2}]\n"
        "    actions: [{action: emit, event: NEAR}]\n"
    )
    assert notes(more, "{event: NEAR}") == [
        "note: near was triggered at 1.024 s, and {condition: in_zone, entity: each, zone: lane} did not hold"
    ]


@pytest.mark.parametrize("half", [1, 2])
def test_a_rule_of_another_phase_is_not_told_whether_its_conditions_hold_or_not(half):
    more = (
        "phases: {pause: {}}\nrules:\n  later: {phases: [pause], triggers: [{trigger: time_reached, at_s: 2}], "
        f"conditions: [{{condition: half, equals: {half}}}], actions: [{{action: emit, event: LATER}}]}}\n"
    )
    assert notes(more, "{event: LATER}") == []


@pytest.mark.parametrize(
    "condition",
    [
        '{condition: told, entity: Y1, text: ["a, b", "3", 3.25, "no", home]}',
        "{condition: distance, entity: ball, to: [0.25, 123.45678], at_most: 0.001}",
    ],
)
def test_texts_and_numbers_are_told_as_an_author_writes_them(condition):
    more = f"rules:\n  late: {{{GOAL}, conditions: [{condition}], actions: [{{action: emit, event: LATE}}]}}\n"
    said = notes(more, "{event: LATE}")[0].partition(", and ")[2].removesuffix(" did not hold")
    assert yaml.safe_load(said) == yaml.safe_load(condition)


def test_a_condition_of_several_is_told_as_it_is_written():
    several = (
        "rules:\n  near:\n    for_each: blue\n    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]\n"
        "    conditions: [{condition: any_of, conditions: [{condition: distance, entity: each, to: ball, at_most: 0.01},"
        " {condition: in_zone, entity: [Y1, Y2], zone: blue_goal, of: {at_least: 2}, negate: true}], negate: true}]\n"
        "    actions: [{action: emit, event: NEAR}]\n"
    )
    assert notes(several, "{event: NEAR}")[0].startswith(
        "note: near was triggered at 1.024 s, and {condition: any_of, conditions: [{condition: distance, entity: each, "
        "to: ball, at_most: 0.01}, {condition: in_zone, entity: [Y1, Y2], zone: blue_goal, of: {at_least: 2}, negate: true}], "
        "negate: true} did not hold"
    )


DENIED = f"{GOAL}, conditions: [{{condition: half, equals: 2}}]"


def notes_of(rules: str, expected: str, sections: str = "") -> list[str]:
    """Return the notes on a test that lasts 4 s, in which the ball is put into the goal after 1 s."""
    expect = f"expect: {{it: {{keyframes: [{{at_s: 1, place: {{ball: [0, 0.8]}}}}], lasts_s: 4, {expected}}}}}\n"
    found = list(run_test(load_text(f"{HEAD}{sections}rules:\n{rules}{expect}", file="it.yaml"), "it").differences)
    assert found
    return [line for line in found if line.startswith("note: ")]


@pytest.mark.parametrize(
    ("action", "expected"),
    [
        ("{action: count, counter: c}", "counters: {c: 1}"),
        ("{action: count, counter: each_s, entity: Y1}", "counters: {each_s: {Y1: 1}}"),
        ("{action: set_flag, flag: f}", "flags: {f: true}"),
        ("{action: toggle_flag, flag: f}", "flags: {f: true}"),
        ("{action: set_phase, phase: pause}", "phase: pause"),
        ("{action: end}", "ended: half"),
        ("{action: end, what: match}", "ended: match"),
        ("{action: hold, entity: Y1}", "held: {Y1: true}"),
    ],
)
def test_whatever_is_otherwise_than_expected_the_rule_that_would_have_done_it_is_told(action, expected):
    sections = "counters: {c: {}, each_s: {per: robots}, d: {}}\nflags: {f: {}}\nphases: {pause: {}}\n"
    rules = (
        f"  would: {{{DENIED}, actions: [{action}]}}\n  other: {{{DENIED}, actions: [{{action: count, counter: d}}]}}\n"
    )
    assert notes_of(rules, expected, sections) == [
        "note: would was triggered at 1.024 s, and {condition: half, equals: 2} did not hold"
    ]


def test_what_is_not_to_be_over_was_ended_by_no_rule_that_did_not_fire():
    rules = f"  ends: {{{GOAL}, actions: [{{action: end}}]}}\n  would: {{{DENIED}, actions: [{{action: end}}]}}\n"
    assert notes_of(rules, "ended: none") == ["note: ends ended the half at 1.024 s, and so the test; it lasts 4 s"]


@pytest.mark.parametrize("what", ["half", "match"])
def test_which_rule_ended_the_test_is_told_where_something_is_missing(what):
    rules = (
        f"  ends: {{{GOAL}, actions: [{{action: end, what: {what}}}]}}\n"
        "  later: {triggers: [{trigger: time_reached, at_s: 3}], actions: [{action: emit, event: LATER}]}\n"
    )
    assert notes_of(rules, "events: [{event: LATER}]") == [
        f"note: ends ended the {what} at 1.024 s, and so the test; it lasts 4 s"
    ]


def test_that_a_test_was_over_is_not_told_where_nothing_was_to_come():
    rules = f"  ends: {{{GOAL}, actions: [{{action: end}}]}}\n"
    assert notes_of(rules, "score: {yellow: 1}") == []
