"""A counter that is compared with the lowest or highest of all others: the last one, the leader."""

import pytest

from tests.referee.building import EMIT, acted, once
from tests.scenario.writing import complaints

TOLD = """
counters: {visits: {per: robots}, limit: {initial: 2}}
rules:
  told:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 1}]
    conditions: [%s]
    actions: [{action: emit, event: TOLD, payload: {who: {word: robot_name}}}]
"""
COUNTED = """
rules:
  counted:
    triggers: [{trigger: half_started}]
    actions: [%s]
"""


def reported(stage, condition: str, visits: dict[str, float], off: str = "") -> list[str]:
    """Return the robots for which a condition holds when they have these counters and some are off the field."""
    counts = [f"{{action: count, counter: visits, entity: {robot}, to: {to}}}" for robot, to in visits.items()]
    removed = [f"{{action: remove, entity: {robot}}}" for robot in off.split()]
    play = stage(TOLD % condition, COUNTED % ", ".join([*counts, *removed]))
    play.play(40)
    return [event.payload["who"] for event in play.events_named("TOLD")]


LAST = "{counter: visits, entity: each, at_most: {lowest: {counter: visits, entity: others}}}"
ALONE_LAST = "{counter: visits, entity: each, at_least: {lowest: {counter: visits, entity: others}}, negate: true}"
FIRST = "{counter: visits, entity: each, at_least: {highest: {counter: visits, entity: others}}}"
AS_THE_FIRST = "{counter: visits, entity: each, equals: {highest: {counter: visits, entity: others}}}"
VISITS = {"B1": 3, "B2": 1.5, "Y1": 2, "Y2": 7}


class TestTheLowestAndTheHighestOfOthers:
    @pytest.mark.parametrize(("condition", "expected"), [(LAST, ["B2"]), (ALONE_LAST, ["B2"]), (FIRST, ["Y2"])])
    def test_one_is_last_and_one_is_first(self, stage, condition, expected):
        assert reported(stage, condition, VISITS) == expected

    @pytest.mark.parametrize(
        ("condition", "expected"),
        [(LAST, ["B2", "Y1"]), (ALONE_LAST, []), (FIRST, ["B1", "Y2"]), (AS_THE_FIRST, ["B1", "Y2"])],
    )
    def test_several_that_are_equal(self, stage, condition, expected):
        assert reported(stage, condition, {"B1": 4, "B2": 1, "Y1": 1, "Y2": 4}) == expected

    @pytest.mark.parametrize(("condition", "expected"), [(LAST, ["Y1"]), (FIRST, ["B1"])])
    def test_a_robot_off_the_field_neither_counts_nor_is_it(self, stage, condition, expected):
        assert reported(stage, condition, VISITS, off="B2 Y2") == expected

    def test_where_no_other_is_left_nothing_compares(self, stage):
        assert reported(stage, LAST, VISITS, off="B1 B2 Y2") == []
        assert reported(stage, FIRST, VISITS, off="B1 B2 Y2") == []

    def test_what_is_asked_for_by_negation_holds_then_too(self, stage):
        # docs/authoring.md says so, and what to ask beside it.
        on_the_field = "{entity: each, in: pitch}"
        assert reported(stage, ALONE_LAST, VISITS, off="B2") == ["B2", "Y1"]
        assert reported(stage, f"{ALONE_LAST}, {on_the_field}", VISITS, off="B2") == ["Y1"]

    def test_without_for_each_it_is_that_of_all(self, stage):
        low = once(10, EMIT, more="conditions: [{counter: level, at_most: {lowest: {counter: visits}}}],")
        for level, names in ((2, ["TOLD"]), (2.5, [])):
            counters = f"counters: {{visits: {{per: robots}}, level: {{initial: {level}}}}}"
            assert acted(stage(counters, low, COUNTED % "{action: count, counter: visits, to: 2}")).names() == names

    def test_places_are_never_off_the_field(self, stage):
        rule = """
        counters: {visits: {per: sides}}
        groups: {sides: [left, right, middle]}
        rules:
          counted: {triggers: [{trigger: half_started}], actions: [{action: count, counter: visits, entity: middle, to: -1}]}
          told:
            for_each: sides
            triggers: [{trigger: time_reached, at_s: 1}]
            conditions: [{counter: visits, entity: each, at_most: {lowest: {counter: visits, entity: others}}}]
            actions: [{action: emit, event: TOLD, payload: {where: {word: each_name}}}]
        """
        play = stage(rule)
        play.play(40)
        assert [event.payload["where"] for event in play.events_named("TOLD")] == ["middle"]

    def test_anything_that_is_compared_may_be_compared_with_it(self, stage):
        # Y1 stands 0.64 m from the ball, all others 0.64 m too: none is nearer than the limit of another.
        near = "{distance: [each, ball], at_least: {highest: {counter: visits, entity: others}}}"
        assert reported(stage, near, {"B1": 0.5, "B2": 0.5, "Y1": 0.9, "Y2": 0.5}) == ["Y1"]


def test_a_counter_that_is_kept_once_has_no_others():
    rule = (
        "counters: {laps: {}}\nrules: {it: {triggers: [{trigger: half_started}], conditions: "
        "[{counter: laps, at_most: {lowest: {counter: laps}}}], actions: [{action: end}]}}\n"
    )
    assert complaints(rule) == ["not-per-entity rules.it.conditions[0] (counter)"]
