"""Lint of limits that are not over before the phase is in which the rule lives: what it follows begins anew then."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.trials import try_expectation
from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = (
    "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
    "phases: {red: {lasts_s: 2.5}, green: {lasts_s: {draw: d}}, open: {}}\ndraws: {d: {values: [1, 4]}}\nfirst_phase: red\n"
)
# It is red for 2.5 s, then play for half a second, then red again, and so on.
AGAIN = (
    "  again: {triggers: [{trigger: holds, condition: {condition: in_zone, entity: ball, zone: pitch}, for_s: 0.5}], "
    "actions: [{action: set_phase, phase: %s}]}\n"
)
HOLDS = "{trigger: holds, condition: {condition: in_zone, entity: ball, zone: pitch}, for_s: %s}"
STAYS = "{trigger: stays_in, entity: ball, zone: pitch, limit_s: %s}"
RESTS = "{trigger: no_progress, entity: ball, distance_m: 1, within_s: %s}"
TEST = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 20, events: [{event: TOLD}], ignore: []}}\n"


def text(trigger: str, phases: str = "[red]", next_phase: str = "red") -> str:
    told = f"  told: {{phases: {phases}, max_executions: 1, triggers: [{trigger}], actions: [{{action: emit, event: TOLD}}], says: T.}}\n"
    return f"{HEAD}rules:\n{told}{AGAIN % next_phase}{TEST}"


def found(*asked: str) -> list[str]:
    findings = lint(load_text(text(*asked), file="it.yaml"))
    return [str(one) for one in findings if one.kind == "limit_longer_than_the_phase"]


@pytest.mark.parametrize("trigger", [HOLDS, STAYS, RESTS])
def test_what_lasts_longer_than_the_only_phase_of_the_rule_never_fires(trigger):
    (one,) = found(trigger % 5)
    assert "5 s is not over before phase red is, after 2.5 s, and begins anew with the next one: it never fires" in one
    assert try_expectation(load_text(text(trigger % 5)), "it").differences


@pytest.mark.parametrize("trigger", [HOLDS, STAYS, RESTS])
def test_what_lasts_as_long_as_the_phase_never_fires_either(trigger):
    (one,) = found(trigger % 2.5)
    assert (
        "2.5 s is not over before phase red is, after 2.5 s, and begins anew with the next one: it never fires" in one
    )
    assert try_expectation(load_text(text(trigger % 2.5)), "it").differences


@pytest.mark.parametrize("trigger", [HOLDS, STAYS, RESTS])
def test_what_is_over_sooner_may_fire(trigger):
    assert found(trigger % 2) == []
    assert try_expectation(load_text(text(trigger % 2)), "it").differences == ()


def test_of_a_phase_whose_length_chance_decides_the_longest_counts():
    assert found(HOLDS % 3.9, "[green]", "green") == []
    assert len(found(HOLDS % 4.1, "[green]", "green")) == 1


@pytest.mark.parametrize("phases", ["[red, play]", "any", "[open]"])
def test_phases_that_follow_each_other_or_end_by_a_rule_are_as_long_as_they_like(phases):
    assert found(HOLDS % 5, phases, "open" if phases == "[open]" else "red") == []


def test_of_several_phases_that_do_not_follow_each_other_the_longest_counts():
    assert len(found(HOLDS % 4.1, "[red, green]", "green")) == 1
    assert found(HOLDS % 3, "[red, green]", "green") == []


def test_what_a_rule_follows_goes_on_from_one_phase_of_its_own_into_the_next():
    # First it is red for 2.5 s, then blue for 3 s: 4 s are full in blue.
    phases = "red: {lasts_s: 2.5, next: blue_light}, blue_light: {lasts_s: 3}"
    in_both = text(HOLDS % 4, "[red, blue_light]").replace("red: {lasts_s: 2.5}", phases)
    assert "limit_longer_than_the_phase" not in [one.kind for one in lint(load_text(in_both))]
    assert try_expectation(load_text(in_both), "it").differences == ()


@pytest.mark.parametrize("trigger", [HOLDS, STAYS, RESTS])
def test_what_lasts_as_long_as_the_half_is_told_of_that_alone(trigger):
    kinds = [one.kind for one in lint(load_text(text(trigger % 60)))]
    assert kinds.count("limit_longer_than_the_half") == 1
    assert "limit_longer_than_the_phase" not in kinds


# --- a clock that stops makes a half longer -----------------------------------------------------------------------------

STOPPED = """
match: {half_s: 20}
phases: {rest: {lasts_s: %s, clock: stops}}
timers: {long: {lasts_s: 25, starts: true}}
first_phase: rest
rules:
  lasts: {phases: [rest], triggers: [{trigger: holds, condition: {condition: in_zone, entity: ball, zone: pitch}, for_s: 25}],
          actions: [{action: emit, event: LASTS}], says: L.}
  runs: {phases: [rest], triggers: [{trigger: timer_expired, timer: long}], actions: [{action: emit, event: RUNS}], says: R.}
  after: {triggers: [{trigger: time_reached, at_s: 5%s}], actions: [{action: emit, event: AFTER}], says: A.}
expect:
  it: {keyframes: [{at_s: 0}], lasts_s: 40, ignore: [], events: [{event: LASTS}, {event: RUNS}, {event: AFTER, at_s: 35.04}]}
"""


def of_half(text: str) -> list[str]:
    loaded = load_text(f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2{text}", file="it.yaml")
    return [str(one) for one in lint(loaded) if one.kind == "limit_longer_than_the_half"]


def test_where_the_clock_stops_the_half_goes_on_for_longer_than_its_length():
    assert of_half(STOPPED % (30, "")) == []
    text = f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2{STOPPED % (30, '')}"
    assert try_expectation(load_text(text), "it").differences == ()


def test_but_not_for_ever_and_not_by_its_clock():
    (phase,) = of_half(STOPPED % (201, ""))
    assert (
        "phases.rest.lasts_s: 201 s is not over before the half is, after 200 s at most, the time included for which"
        in phase
    )
    (again,) = of_half(STOPPED % (30, ", every_s: 16"))
    assert (
        "rules.after.triggers[0] (time_reached): 21 s is not over before the half is, after 20 s: it fires once"
        in again
    )
