"""Lint of names that are told as texts."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD, rule

KEPT = "counters: {laps: {}}\nflags: {armed: {}}\ntimers: {attempt: {lasts_s: 5}}\ndraws: {side: {values: [left, right]}}\n"


def found(body):
    findings = lint(load_text(HEAD + KEPT + body, file="a.yaml"))
    return [str(one) for one in findings if one.kind == "text_instead_of_value"]


def test_a_word_that_programs_are_told_as_a_text():
    (text,) = found("broadcast: {fields: {left: time_left_s}}\n" + rule())
    assert text.partition("warning: ")[2] == (
        "broadcast.fields.left: it is told as the text 'time_left_s', the same each time; write {word: time_left_s} for the "
        "value [text_instead_of_value]"
    )


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("laps", "{counter: laps}"),
        ("armed", "{flag: armed}"),
        ("attempt", "{timer: attempt}"),
        ("side", "{draw: side}"),
    ],
)
def test_what_rules_remember_likewise(name, value):
    (text,) = found(f"broadcast: {{fields: {{it: {name}}}}}\n" + rule())
    assert f"write {value} for the value" in text


def test_of_several_of_that_name_each_is_named():
    both = KEPT.replace("side:", "attempt:") + "broadcast: {fields: {it: attempt}}\n" + rule()
    findings = lint(load_text(HEAD + both, file="a.yaml"))
    (text,) = [str(one) for one in findings if one.kind == "text_instead_of_value"]
    assert "write {timer: attempt} or {draw: attempt} for the value" in text


def test_what_only_some_robots_are_told_likewise():
    (text,) = found("broadcast: {fields: {}, only: {Y1: {it: laps}}}\n" + rule())
    assert "broadcast.only.Y1.it: it is told as the text 'laps'" in text


@pytest.mark.parametrize(
    ("payload", "count"), [("time_s", 1), ("score", 1), ("{word: time_s}", 0), ("robot", 0), ("7", 0), ("side", 0)]
)
def test_in_a_payload_a_name_may_be_meant_but_no_word(payload, count):
    assert len(found(rule(action=f"{{action: emit, event: GO, payload: {{it: {payload}}}}}"))) == count


def test_a_text_that_a_test_expects_is_meant():
    emits = rule(action="{action: emit, event: GO, payload: {why: limit}}")
    test = "expect: {it_goes: {keyframes: [{at_s: 1}], lasts_s: 2, events: [{event: GO, payload: {why: %s}}]}}\n"
    (text,) = found(emits)
    assert "write {word: limit} for the value; that the text is meant, says a test that expects it" in text
    assert found(emits + test % "limit") == []
    assert len(found(emits + test % "other")) == 1


def test_so_is_one_that_another_rule_tells_as_another_text():
    other = "  s: {triggers: [{trigger: half_ended}], actions: [{action: emit, event: %s, payload: {why: %s}}]}\n"
    emits = rule(action="{action: emit, event: GO, payload: {why: limit}}")
    assert found(emits + other % ("GO", "slow")) == []
    assert len(found(emits + other % ("GO", "limit"))) == 2
    assert len(found(emits + other % ("STOP", "slow"))) == 1


@pytest.mark.parametrize(
    "waits",
    [
        rule("{trigger: tells, entity: Y1, text: side}"),
        rule(
            "{trigger: tells, entity: Y1}",
            rest="    conditions: [{condition: told, entity: Y1, text: side, negate: true}]\n",
        ),
    ],
)
def test_a_draw_whose_name_a_robot_would_have_to_tell(waits):
    (text,) = found(waits)
    assert text.endswith(
        ": it is the text 'side' itself that must be told; write {draw: side} for what is drawn [text_instead_of_value]"
    )


def test_among_other_texts_no_draw_can_stand():
    (text,) = found(rule("{trigger: tells, entity: Y1, text: [nothing, side]}"))
    assert text.endswith(
        ": it is the text 'side' itself that must be told; write text: {draw: side} for what is drawn, without other texts beside "
        "it [text_instead_of_value]"
    )


@pytest.mark.parametrize("said", ["text: left", "text: laps", "text: {draw: side}", "is_a: number"])
def test_a_robot_may_tell_any_other_text(said):
    assert found(rule(f"{{trigger: tells, entity: Y1, {said}}}")) == []
