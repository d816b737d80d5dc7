"""What `validate` says of timers and phases that last as long as a counter says."""

import pytest

from rcj_challenges.scenario.lint.registry import lint
from tests.scenario.writing import complaints, loaded, scenario

COUNTERS = "counters: {n: {initial: 3}, own: {per: robots, initial: 3}}\n"


def kinds(body):
    return {suspect.code for suspect in lint(loaded(COUNTERS + body))}


@pytest.mark.parametrize("section", ["timers", "phases"])
def test_a_counter_or_a_score_may_stand_there(section):
    for counter in ("n", "yellow"):
        model = getattr(scenario(f"{COUNTERS}{section}: {{a: {{lasts_s: {{counter: {counter}}}}}}}\n"), section)["a"]
        assert model.lasts_s.counter == counter


@pytest.mark.parametrize("section", ["timers", "phases"])
def test_unknown_counter_as_a_duration_is_refused(section):
    body = f"{COUNTERS}{section}: {{a: {{lasts_s: {{counter: m}}}}}}\n"
    assert complaints(body) == [f"unknown-name {section}.a.lasts_s.counter"]


def test_timer_for_each_needs_the_owner_of_its_counter():
    timers = "timers: {{a: {{per: robots, lasts_s: {{counter: own{}}}}}}}\n"
    assert scenario(COUNTERS + timers.format(", entity: each")).timers["a"].lasts_s.entity == "each"
    assert scenario(COUNTERS + timers.format(", entity: Y1")).timers["a"].lasts_s.entity == "Y1"
    assert complaints(COUNTERS + timers.format("")) == ["missing-entity timers.a.lasts_s.counter"]


def test_each_is_unknown_in_a_timer_without_per():
    body = f"{COUNTERS}timers: {{a: {{lasts_s: {{counter: own, entity: each}}}}}}\n"
    assert complaints(body) == ["unbound-name timers.a.lasts_s.entity"]


def test_each_must_have_such_a_counter():
    body = f"{COUNTERS}timers: {{a: {{per: balls, lasts_s: {{counter: own, entity: each}}}}}}\n"
    assert complaints(body) == ["wrong-kind timers.a.lasts_s.entity"]


@pytest.mark.parametrize(
    "body",
    [
        # It may last any time: nothing of it is longer than the half, never over, or certainly not at its end.
        ("timers: {a: {lasts_s: {counter: n}, starts: true}}\nrules: {r: {triggers: [{trigger: timer_expired, timer: a}], "
        "conditions: [{condition: timer, timer: a, at_least: 5}], actions: [{action: end}]}}\n"),
        ("phases: {a: {lasts_s: {counter: n}, robots: held}}\nfirst_phase: a\nrules: {r: {phases: [a], triggers: "
        "[{trigger: time_reached, at_s: 30}], actions: [{action: end}]}}\n"),
        ("phases: {a: {lasts_s: {counter: n}, robots: held}}\nfirst_phase: a\nrules: {r: {phases: any, for_each: robots, "
        "triggers: [{trigger: no_progress, entity: each, distance_m: 0.1, within_s: 5}], actions: [{action: end}]}}\n"),
    ],
)  # fmt: skip
def test_nothing_is_suspected_that_the_counter_may_make_true(body):
    suspicions = {"limit-too-long", "rule-never-fires", "held_robot_makes_no_progress", "robots_never_free"}
    assert not kinds(body) & suspicions


def test_the_counter_is_read_there():
    counted = "rules: {r: {triggers: [{trigger: half_started}], actions: [{action: count, counter: n}]}}\n"
    assert "never-read" in kinds(counted)
    used = "timers: {a: {lasts_s: {counter: n}, starts: true}}\n"
    assert not any(
        suspect.code == "never-read" and "'n'" in str(suspect) for suspect in lint(loaded(COUNTERS + used + counted))
    )
