"""Lint of what is measured and must equal a number."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD


def found(condition):
    body = (
        "timers: {t: {lasts_s: 20}}\n"
        "rules:\n"
        "  begin: {triggers: [{trigger: half_started}], actions: [{action: timer, timer: t, do: start}]}\n"
        f"  r: {{triggers: [{{trigger: holds, condition: {condition}}}], actions: [{{action: end}}]}}\n"
    )
    return [str(one) for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind == "exactly_measured"]


def test_a_time_between_two_ticks_and_what_to_write_instead():
    (text,) = found("{condition: timer, timer: t, equals: 5}")
    assert text.partition("warning: ")[2] == (
        "rules.r.triggers[0] (holds): no timer ever stands at 5 s: after 4.992 s, on the next tick, come "
        "5.024 s; write at_least: 5, or equals: 5.024 [exactly_measured]"
    )
    assert found("{condition: timer, timer: t, equals: 5.024}") == []


def test_a_ball_that_must_stand_still():
    (text,) = found("{condition: speed, entity: ball, equals: 0}")
    assert "; write at_most: 0.01 [" in text


@pytest.mark.parametrize(
    ("condition", "count"),
    [
        ("{condition: speed, entity: ball, equals: 0.1}", 1),
        ("{condition: speed, entity: ball, equals: 0, negate: true}", 1),
        ("{condition: distance, entity: ball, to: Y1, equals: 0.2}", 1),
        ("{condition: distance, entity: ball, to: [0, 0], equals: 0}", 0),  # it lies where it was put
        ("{condition: way, entity: Y1, equals: 1}", 1),
        ("{condition: way, entity: Y1, equals: 0}", 0),  # it has not moved
        ("{condition: timer, timer: t, equals: 0}", 0),
        ("{condition: timer, timer: t, at_least: 5}", 0),
        ("{condition: counter, counter: yellow, equals: 5}", 0),
        ("{condition: speed, entity: ball, equals: {counter: yellow}}", 0),
    ],
)
def test_what_is_counted_or_at_rest_may_be_asked_for_exactly(condition, count):
    assert len(found(condition)) == count
