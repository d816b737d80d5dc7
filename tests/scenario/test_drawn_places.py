"""A draw's name where a zone, a gate or what a distance is measured to stands: its values are checked, and lint knows them."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.registry import lint
from tests.scenario.writing import complaints, loaded, rule, scenario

HOT = "draws: {hot: {values: [blue_goal, yellow_goal]}}\n"
ENTERS = "{trigger: enters, entity: ball, zone: hot}"


def kinds(body: str) -> list[str]:
    return [one.code for one in lint(loaded(body))]


def conditioned(trigger: str, condition: str) -> str:
    return HOT + rule(trigger, "{action: end}", f"    conditions: [{{condition: {condition}}}]\n    says: So.\n")


class TestReferences:
    @pytest.mark.parametrize(
        ("values", "trigger", "told"),
        [
            ("[blue_goal, centre]", ENTERS, "'centre' is a spot; expected a zone"),
            ("[blue_goal, penalty_areas]", ENTERS, "'penalty_areas' is a group; name one zone"),
            ("[blue_gaol, pitch]", ENTERS, "unknown zone 'blue_gaol'; did you mean 'blue_goal'?"),
            ("[blue_goal, 3]", ENTERS, "expected a zone, found 3"),
            (
                "[blue_goal, pitch]",
                "{trigger: crosses, entity: ball, gate: hot}",
                "'blue_goal' is a zone; expected a gate",
            ),
        ],
    )
    def test_all_values_must_be_what_stands_there(self, values, trigger, told):
        (first, *_) = complaints(f"draws: {{hot: {{values: {values}}}}}\n" + rule(trigger))
        assert first.startswith("draws.hot.values[")
        assert told in first
        assert "(needed by rules.r.triggers[0]" in first

    def test_a_mapping_is_told_how_a_draw_is_named(self):
        (one,) = complaints(HOT + rule("{trigger: enters, entity: ball, zone: {draw: hot}}"))
        assert one.endswith(
            "expected a name or a list of names, found a mapping with draw; where a draw may decide, its name stands alone: hot"
        )

    def test_among_what_could_stand_there_are_draws_of_such_places_only(self):
        draws = "draws: {hot: {values: [blue_goal, pitch]}, cold: {values: [centre]}, how: {values: [1, 2]}}\n"
        (one,) = complaints(draws + rule("{trigger: enters, entity: ball, zone: nowhere}"))
        assert one.endswith("in_play, penalty_areas, hot")

    def test_of_two_drawn_zones_no_distance_is_measured(self):
        body = HOT + rule(action="{action: score, entrant: blue, points: {distance: [hot, pitch]}}")
        assert "'blue_goal' is a zone and 'pitch' another" in complaints(body)[0]

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

    def test_a_distance_that_none_of_them_is_far_enough_for_is_told(self):
        far = "distance, entity: ball, to: hot, at_least: %s"
        assert "never-reached" in kinds(conditioned("{trigger: half_started}", far % 9))
        assert "never-reached" not in kinds(conditioned("{trigger: half_started}", far % 1))
