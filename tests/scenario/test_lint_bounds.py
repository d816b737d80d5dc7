"""Lint of floors and ceilings that change nothing, and what contradicts itself in them."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.blanks import points_of
from rcj_challenges.scenario.lint.table import lint
from tests.scenario.writing import complaints, loaded, rule, scenario

COUNTERS = "counters: {n: {}}\n"


def found(action: str, kind: str = "bound_without_effect") -> list[str]:
    body = COUNTERS + rule(action=action)
    return [f"{one.problem.message}; {one.remedy}" for one in lint(loaded(body)) if one.kind == kind]


def score(text: str) -> str:
    return f"{{action: score, entrant: blue, {text}}}"


class TestBoundsWithoutEffect:
    def test_who_means_the_score_and_bounds_the_points_is_told_the_other_word(self):
        (text,) = found(score("points: -5, at_least: 0"))
        assert text == (
            "points is the number -5, of which at_least: 0 always makes 0; leave it out; what keeps the score in "
            "bounds is keeps_at_least: 0"
        )

    @pytest.mark.parametrize(
        ("action", "told"),
        [
            (score("points: 5, at_most: 7"), "of which at_most: 7 changes nothing"),
            (score("at_least: 3"), "points is the number 1, of which at_least: 3 always makes 3"),
            ("{action: count, counter: n, at_most: 3}", "what keeps the counter in bounds is keeps_at_most: 3"),
            (
                "{action: count, counter: n, to: 8, at_most: 3}",
                "to is the number 8, of which at_most: 3 always makes 3",
            ),
            (score("points: 5, keeps_at_least: 0"), "points is the number 5, by which the score never falls"),
            ("{action: count, counter: n, by: -1, keeps_at_most: 9}", "by which the counter never rises"),
        ],
    )
    def test_a_plain_number_needs_none(self, action, told):
        (text,) = found(action)
        assert told in text

    @pytest.mark.parametrize(
        "action",
        [
            score("points: [20, {word: time_s, weight: -1}], at_least: 5, keeps_at_least: 0, keeps_at_most: 9"),
            score("points: -5, keeps_at_least: 0"),
            score("points: 5, keeps_at_most: 9"),
            "{action: count, counter: n, keeps_at_most: 9}",
            "{action: count, counter: n, to: {word: time_s}, at_least: 5}",
        ],
    )
    def test_what_may_be_met_or_not_is_no_matter(self, action):
        assert found(action) == []


@pytest.mark.parametrize(
    ("action", "told"),
    [
        (score("points: {counter: n}, at_least: 5, at_most: 3"), "nothing is at least 5 and at most 3"),
        (score("points: -1, keeps_at_least: 5, keeps_at_most: 3"), "nothing is at least 5 and at most 3"),
        (
            "{action: count, counter: n, to: {word: time_s}, keeps_at_least: 5}",
            "what is set 'to' a number neither falls nor rises to it; write at_least here",
        ),
    ],
)
def test_what_contradicts_itself_is_a_mistake(action, told):
    assert any(told in one for one in complaints(COUNTERS + rule(action=action)))


@pytest.mark.parametrize(
    ("text", "known"),
    [
        ("points: 3", 3),
        ("points: 3, at_most: 2", 2),
        ("points: -3, at_least: -1", -1),
        ("points: -3, keeps_at_least: 0", None),
        ("points: 3, keeps_at_most: 9", None),
    ],
)
def test_points_that_depend_on_the_score_are_known_only_when_the_rule_fires(text, known):
    assert points_of(scenario(rule(action=score(text))).rules["r"]) == {known}


def test_bounds_can_be_params_and_are_inherited_with_their_rule():
    body = "params: {least: 2}\n" + rule(action=score("points: {word: time_s}, at_least: {param: least}"))
    (action,) = scenario(body, ["params.least=4"]).rules["r"].actions
    assert action.at_least == 4
