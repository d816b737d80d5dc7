"""Lint of values that nothing looks at because of what stands, or does not stand, beside them."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.resources import scenarios_folder
from tests.scenario.linting import found_in, rule

KIND = "value_without_effect"
LAY = "placements: {lay: [{entity: ball, at: {spot: centre}}]}"


def ignored(*sections: str, rules: str = "") -> list[Finding]:
    return [finding for finding in found_in(*sections, rules=rules) if finding.kind == KIND]


@pytest.mark.parametrize(
    "given",
    [
        "facing: keep",
        "noise_m: [0.1, 0]",
        "min_clearance_m: 0.1",
        "max_attempts: 3",
        "on_failure: stay",
        "facing: start",
    ],
)
def test_beside_a_layout_nothing_else_says_how_things_are_put(given):
    (finding,) = ignored(LAY, rules=rule("it", "{trigger: half_started}", f"{{action: place, layout: lay, {given}}}"))
    key = given.partition(":")[0]
    assert finding.problem.path == "rules.it.actions[0] (place)"
    assert (
        finding.problem.message == f"beside a layout '{key}' changes nothing: each of its placements says it for itself"
    )
    assert finding.remedy == "write it in the placements of the layout"


def test_a_layout_can_be_mirrored_as_a_whole():
    mirrored = "{action: place, layout: lay, mirror: {axis: x}}"
    assert ignored(LAY, rules=rule("it", "{trigger: half_started}", mirrored)) == []
    one = "{action: place, entity: ball, at: {spot: centre}, facing: keep, noise_m: [0.1, 0], on_failure: stay}"
    assert ignored(rules=rule("it", "{trigger: half_started}", one)) == []


@pytest.mark.parametrize("given", ["back_at: {spot: centre}", "facing: keep"])
def test_what_comes_back_by_no_time_comes_back_where_a_rule_puts_it(given):
    gone = "{action: remove, entity: Y1%s, " + given + "}"
    (finding,) = ignored(rules=rule("it", "{trigger: half_started}", gone % ""))
    key = given.partition(":")[0]
    assert (
        finding.problem.message
        == f"without for_s '{key}' changes nothing: what is taken off stays off until a rule puts it"
    )
    assert finding.remedy == "write for_s beside it, or leave it out"
    assert ignored(rules=rule("it", "{trigger: half_started}", gone % ", for_s: 5")) == []


@pytest.mark.parametrize("shape", ["shape: box, size_m: [0.1, 0.1]", "shape: cylinder, radius_m: 0.05"])
def test_a_mass_is_for_what_can_be_pushed(shape):
    crate = "obstacles: {crate: {%s, centre_m: [0.5, 0], mass_kg: 2%s}}"
    (finding,) = ignored(crate % (shape, ""))
    assert finding.problem.path == "obstacles.crate.mass_kg"
    assert finding.problem.message == "the mass of what nobody can push changes nothing"
    assert finding.remedy == "write movable: true beside it, or leave it out"
    assert ignored(crate % (shape, ", movable: true")) == []
    assert ignored(crate % (shape, ", movable: false")) == []


@pytest.mark.parametrize("path", sorted(scenarios_folder().rglob("*.yaml")), ids=lambda path: path.stem)
def test_shipped_scenarios_say_nothing_in_vain(path):
    assert [finding for finding in lint(load(path)) if finding.kind == KIND] == []
