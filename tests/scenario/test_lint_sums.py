"""Lint of what each of several has, read as that of all of them in a rule for each."""

from __future__ import annotations

import pytest

from tests.scenario.linting import found_in

KEPT = (
    "counters: {n: {per: robots}, alone: {}, of_one: {per: Y1}, doors: {per: penalty_areas}}",
    "flags: {f: {per: yellow}}",
    "timers: {t: {per: robots, lasts_s: 5, starts: true}}",
)


def told(part: str, rule: str = "for_each: yellow,", entity: str = "each") -> list[str]:
    """Return what is said of a part of the points."""
    rules = (
        f"  a: {{{rule} triggers: [{{trigger: touches, entity: {entity}, other: walls}}], "
        f"actions: [{{action: score, entrant: yellow, points: [1, {part}]}}], says: So.}}\n"
    )
    return [str(one) for one in found_in(*KEPT, rules=rules) if one.kind == "each_has_its_own"]


def test_the_sum_of_all_in_a_rule_of_each():
    (one,) = told("{counter: n, weight: -2}")
    assert one.endswith(
        "rules.a.actions[0] (score): the rule is for each of 'yellow', and counter 'n' is read here as the sum of those of "
        "all of 'robots'; write entity: each, or a part for each of those who are meant; all of them are counted in a "
        "rule without for_each [each_has_its_own]"
    )


def test_of_flags_and_timers_it_is_any_or_the_longest():
    assert "flag 'f' is read here as 1 if that of any of 'yellow' is set" in told("{flag: f}")[0]
    assert "timer 't' is read here as the longest of those of all of 'robots'" in told("{timer: t}")[0]


@pytest.mark.parametrize(
    "part",
    [
        "{counter: n, entity: each}",
        "{counter: n, entity: Y1}",
        "{counter: alone}",
        "{counter: of_one}",
        "{counter: doors}",
        "{counter: blue}",
        "{word: time_s}",
    ],
)
def test_whose_it_is_is_said_or_it_is_nobodys_in_particular(part):
    assert told(part) == []


def test_in_a_rule_without_for_each_the_sum_is_meant():
    assert told("{counter: n}", "", "yellow") == []


def added(points: str, action: str = "score, entrant: yellow, points") -> list[str]:
    """Return what is said of a list of numbers that is added up."""
    rules = f"  a: {{triggers: [{{trigger: half_started}}], actions: [{{action: {action}: {points}}}], says: So.}}\n"
    more = ("params: {base: 5, more: 2}", *KEPT)
    return [str(one) for one in found_in(*more, rules=rules) if one.kind == "numbers_added_up"]


def test_points_for_the_first_the_second_and_the_third_are_no_list():
    (one,) = added("[5, 3, 1]")
    assert one.endswith(
        "rules.a.actions[0] (score): a list of points is added up, and all its parts are numbers: it is always 9; write 9; where "
        "it depends on something, a part such as {counter: NAME, weight: -2}, or a rule for each case [numbers_added_up]"
    )


@pytest.mark.parametrize(("points", "total"), [("[1.5, 1.5]", "3"), ("[1.0e+2, 3]", "103"), ("[0.1, 0.2]", "0.3")])
def test_the_sum_is_written_as_on_paper(points, total):
    (one,) = added(points)
    assert f"it is always {total}; write {total};" in one


@pytest.mark.parametrize("key", ["by", "to"])
def test_what_is_counted_likewise(key):
    assert len(added("[1.5, -2]", f"count, counter: alone, {key}")) == 1


@pytest.mark.parametrize(
    "points", ["[5]", "5", "[5, {counter: alone}]", "[{param: base}, {param: more}]", "[{param: base}, 1]"]
)
def test_a_single_number_what_is_read_and_params_may_be_meant(points):
    assert added(points) == []
