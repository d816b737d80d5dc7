"""Lint of distances that nothing on the floor reaches, or that all on it keep."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.trials import run_expectation
from rcj_challenges.scenario.lint.table import Finding, lint
from tests.scenario.writing import loaded

# The floor reaches to x = ±0.65 and, in the goals, to y = ±0.85.
PLACES = """
zones:
  house: {shape: circle, centre_m: [0, 0.5], radius_m: 0.1}
  east: {shape: rect, x_min_m: 0.4}
  all_of_it: {shape: rect, x_min_m: -2, x_max_m: 2, y_min_m: -2, y_max_m: 2}
  around: {shape: circle, centre_m: [0, 0], radius_m: 0.2, inverted: true}
  edges: {shape: rect, x_min_m: -0.5, x_max_m: 0.5, inverted: true}
  south: {shape: half_plane, through_m: [0, 0], normal: [0, 1], inverted: true}
  bay: {shape: polygon, points_m: [[-0.3, 0], [0.3, 0], [0.3, 0.3], [0.2, 0.1]]}
  not_bay: {shape: polygon, points_m: [[-0.3, 0], [0.3, 0], [0.3, 0.3], [0.2, 0.1]], inverted: true}
gates:
  line: {from_m: [-0.3, 0.2], to_m: [0.3, 0.2]}
  nose: {from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: Y1}
groups: {goals: [house, east]}
spots: {hill: {x_m: 0, y_m: 0}}
counters: {far: {}}
"""


def found(to: str, limits: str, rule: str = "") -> list[Finding]:
    asked = f"{{condition: distance, entity: ball, to: {to}, {limits}}}"
    body = f"rules: {{r: {{{rule}triggers: [{{trigger: half_started}}], conditions: [{asked}], actions: [{{action: end}}]}}}}"
    return [one for one in lint(loaded(PLACES + body)) if one.kind == "distance_never_reached"]


@pytest.mark.parametrize(
    ("to", "far_m"),
    [
        ("house", 1.28),  # from the corner of the yellow goal to its middle, (0.2, -0.85) to (0, 0.5), less the radius
        ("east", 1.05),
        ("all_of_it", 0.0),
        ("around", 0.2),
        ("edges", 1.15),
        ("south", 0.85),
        ("line", 1.05),
        ("hill", 0.95),  # the corners are cut by 0.06: (0.65, 0.69)
        ("[0.65, 0]", 1.47),
        ("goals", 1.28),
        ("Y1", 1.90),
        ("nose", 2.00),
    ],
)
def test_a_limit_beyond_the_floor_is_said_and_one_within_it_is_not(to, far_m):
    for key in ("at_least", "at_most", "equals"):
        assert found(to, f"{key}: {max(0.0, far_m - 0.02)}") == []
    (never,) = found(to, f"at_least: {far_m + 0.08}")
    assert never.problem.message.startswith("it is never reached: nothing on the floor is further than ")
    (always,) = found(to, f"at_most: {far_m + 0.08}")
    assert always.problem.message.startswith("every distance keeps to it: nothing on the floor is further than ")


def test_the_message_names_the_measure_and_the_remedy_the_unit():
    (one,) = found("line", "at_least: 30")
    assert one.problem.path == "rules.r.conditions[0] (distance)"
    assert one.problem.message == "it is never reached: nothing on the floor is further than 1.05 m from 'line'"
    assert one.remedy == "correct it; distances are in m"


def test_a_negative_distance_does_not_mean_inside():
    (one,) = found("house", "at_most: -0.05")
    assert (one.problem.message, one.remedy) == (
        "no distance is less than 0; inside a zone it is 0",
        "ask for a smaller zone",
    )
    (one,) = found("line", "equals: -1")
    assert (one.problem.message, one.remedy) == ("no distance is less than 0", "correct it")
    for place in ("line", "house"):
        (one,) = found(place, "at_least: -0.1")
        assert one.problem.message == "every distance keeps to it: none is less than 0"
        assert found(place, "at_least: 0") == []  # off the field no comparison holds: that may be what is asked


def test_each_is_the_one_that_is_furthest_off():
    assert found("each", "at_least: 1.25", "for_each: goals, ") == []
    assert len(found("each", "at_least: 1.4", "for_each: goals, ")) == 1


def test_what_is_not_known_is_not_said():
    assert found("not_bay", "at_least: 0.5") == []
    assert found("line", "at_least: {counter: far}") == []
    assert len(found("bay", "at_least: 3")) == 1


@pytest.mark.parametrize(
    ("entity", "to", "count"),
    [("ball", "ball", 1), ("each", "each", 1), ("each", "robots", 0), ("robots", "robots", 0), ("ball", "Y1", 0)],
)
@pytest.mark.parametrize(
    ("limit", "holds"),
    [
        ("at_most: 0.1", False),
        ("at_least: 0", False),
        ("at_most: 0.1, negate: true", True),
        ("at_most: 0.1, of: none", True),
        ("at_most: 0.1, of: none, negate: true", False),
        ("at_most: 0.1, of: all", False),
        ("at_most: 0.1, of: {at_least: 1}", False),
    ],
)
def test_from_a_thing_to_itself_nothing_is_measured(entity, to, count, limit, holds):
    asked = f"{{condition: distance, entity: {entity}, to: {to}, {limit}}}"
    rule = f"for_each: robots, max_executions: 1, triggers: [{{trigger: time_reached, at_s: 1}}], conditions: [{asked}]"
    body = (
        f"rules: {{r: {{{rule}, actions: [{{action: emit, event: IT}}]}}}}\n"
        "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 2, events: []}}\n"
    )
    this = loaded(PLACES + body)
    found = [str(one) for one in lint(this) if one.kind == "distance_never_reached"]
    assert len(found) == count
    said = f"nothing is measured from '{entity}' to itself, so that it {'always' if holds else 'never'} holds; name the"
    assert all(said in text for text in found)
    if count:
        assert bool(run_expectation(this, "it")) is holds


# --- distances in other places ------------------------------------------------------------------------------------------


def of_rule(trigger: str = "{trigger: half_started}", action: str = "{action: end}") -> list[str]:
    body = f"rules: {{r: {{triggers: [{trigger}], actions: [{action}]}}}}"
    kinds = ("distance_never_reached", "noise_wider_than_the_floor")
    return [str(one) for one in lint(loaded(PLACES + body)) if one.kind in kinds]


@pytest.mark.parametrize(
    ("written", "count"), [("distance_m: 50", 1), ("distance_m: 0.5", 0), ("from: [0, 0], distance_m: 1.2", 1)]
)
def test_nothing_is_displaced_by_more_than_the_floor_is_wide(written, count):
    assert len(of_rule(f"{{trigger: displaced, entity: ball, {written}}}")) == count


def test_what_a_trigger_asks_is_told_with_its_unit():
    (text,) = of_rule("{trigger: displaced, entity: ball, distance_m: 50}")
    assert text.partition("warning: ")[2] == (
        "rules.r.triggers[0] (displaced): it is never reached: nothing on the floor is further than 1.91 m from "
        "where it was put; correct it; distances are in m [distance_never_reached]"
    )


@pytest.mark.parametrize(
    ("placed", "count"),
    [
        ("at: {uniform_in: house}, min_clearance_m: 3", 1),
        ("at: {uniform_in: house}, min_clearance_m: 0.3", 0),
        ("at: {nearest_free: [hill], clearance_m: 8}", 1),
        ("at: {furthest_free: [hill], clearance_m: 8}", 1),
        ("at: {nearest_free: [hill]}", 0),
    ],
)
def test_no_gap_is_wider_than_the_floor(placed, count):
    found = of_rule(action=f"{{action: place, entity: ball, {placed}}}")
    assert len(found) == count
    assert all("no gap on this floor is wider than 1.91 m: there is never room" in text for text in found)


def test_a_spot_that_is_never_free():
    body = "rules: {r: {triggers: [{trigger: half_started}], conditions: [{condition: spot_free, spot: hill, clearance_m: 8}], actions: [{action: end}]}}"
    assert [one.kind for one in lint(loaded(PLACES + body))].count("distance_never_reached") == 1


@pytest.mark.parametrize(("noise", "count"), [("[5, 5]", 1), ("[0, 2]", 1), ("[0.6, 0.7]", 0)])
def test_noise_that_is_wider_than_the_floor_is_hardly_meant_in_metres(noise, count):
    found = of_rule(action=f"{{action: place, entity: ball, at: {{spot: hill}}, noise_m: {noise}}}")
    assert len(found) == count
    assert all("noise_wider_than_the_floor" in text and "which is 1.3 m wide and 1.5 m long" in text for text in found)


def test_so_it_is_with_the_noise_of_a_start():
    text = "robots: {Y1: {start: {noise_m: [5, 5]}}}\n"
    assert "noise_wider_than_the_floor" in [one.kind for one in lint(loaded(text))]
