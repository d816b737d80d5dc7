"""A draw's name where a zone, a gate or what a distance is measured to stands: its values are checked, and lint knows them."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.registry import lint
from tests.scenario.writing import complaints, errors, in_short, loaded, rule, scenario

HOT = "draws: {hot: {values: [blue_goal, yellow_goal]}}\n"
ENTERS = "{trigger: enters, entity: ball, zone: hot}"


def kinds(body: str) -> list[str]:
    return [one.code for one in lint(loaded(body))]


def conditioned(trigger: str, condition: str) -> str:
    return HOT + rule(trigger, "{action: end}", f"    conditions: [{{{condition}}}]\n    says: So.\n")


class TestReferences:
    @pytest.mark.parametrize(
        ("values", "trigger", "expected"),
        [
            ("[blue_goal, centre]", ENTERS, ["wrong-kind draws.hot.values[1]"]),
            ("[blue_goal, penalty_areas]", ENTERS, ["wrong-kind draws.hot.values[1]"]),
            ("[blue_gaol, pitch]", ENTERS, ["unknown-name draws.hot.values[0] -> blue_goal"]),
            ("[blue_goal, 3]", ENTERS, ["wrong-value draws.hot.values[1]"]),
            (
                "[blue_goal, pitch]",
                "{trigger: crosses, entity: ball, gate: hot}",
                ["wrong-kind draws.hot.values[0]", "wrong-kind draws.hot.values[1]"],
            ),
        ],
    )
    def test_all_values_must_be_of_the_kind_that_is_needed_there(self, values, trigger, expected):
        found = errors(f"draws: {{hot: {{values: {values}}}}}\n" + rule(trigger))
        assert [in_short(problem) for problem in found] == expected
        assert all("(needed by rules.r.triggers[0]" in problem.message for problem in found)

    def test_draws_of_such_places_are_among_what_is_allowed_there(self):
        draws = "draws: {hot: {values: [blue_goal, pitch]}, cold: {values: [centre]}, how: {values: [1, 2]}}\n"
        (problem,) = errors(draws + rule("{trigger: enters, entity: ball, zone: nowhere}"))
        assert problem.help.endswith("in_play, penalty_areas, hot")

    def test_between_two_drawn_zones_no_distance_is_measured(self):
        body = HOT + rule(action="{action: score, entrant: blue, points: {distance: [hot, pitch]}}")
        assert complaints(body) == ["wrong-kind rules.r.actions[0] (score)"]

    def test_what_is_called_like_something_on_the_field_is_that(self):
        body = "draws: {pitch: {values: [blue_goal, yellow_goal]}}\n"
        assert scenario(body + rule("{trigger: leaves, entity: ball, zone: pitch}")).rules
        assert "pitch" not in loaded(body).roster.drawn

    def test_params_and_extends_reach_it(self):
        body = "params: {which: hot}\n" + HOT + rule("{trigger: enters, entity: ball, zone: {param: which}}")
        assert scenario(body).rules["r"].triggers[0].zone == "hot"


class TestLint:
    def test_zones_and_draws_that_are_named_so_are_used(self):
        body = (
            "zones: {a: {shape: circle, centre_m: [0, 0.3], radius_m: 0.1}, b: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}\n"
            "draws: {hot: {values: [a, b]}}\n" + rule(ENTERS, "{action: score, entrant: yellow}", "    says: So.\n")
        )
        assert kinds(body) == []
        assert kinds(body.replace("zone: hot", "zone: pitch")) == [
            "never-used",
            "never-used",
            "never-read",
        ]

    def test_distance_larger_than_the_field_is_reported_for_drawn_zones(self):
        far = "distance: [ball, hot], at_least: %s"
        assert "never-reached" in kinds(conditioned("{trigger: half_started}", far % 9))
        assert "never-reached" not in kinds(conditioned("{trigger: half_started}", far % 1))
