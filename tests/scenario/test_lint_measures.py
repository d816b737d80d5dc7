"""Lint of what is measured and told in another unit, and of numbers that are those of the base."""

from __future__ import annotations

from pathlib import Path

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load, load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: %s\nmatch: {half_s: 60}\n"
FAR = "{trigger: holds, condition: {condition: distance, entity: ball, to: Y3, at_least: 0.3}, for_s: 0.5%s}"
DISPLACED = "{trigger: displaced, entity: ball, distance_m: 0.1}"
STAYS = "{trigger: stays_in, entity: ball, zone: pitch, limit_s: 2}"


def found(trigger: str, says: str = "So.", action: str = "{action: end}") -> list[Finding]:
    rule = f'rules:\n  r:\n    triggers: [{trigger}]\n    actions: [{action}]\n    says: "{says}"\n'
    findings = lint(load_text(HEAD % "soccersim_v2" + rule, file="it.yaml"))
    return [one for one in findings if one.kind == "measured_in_another_unit"]


class TestUnits:
    @pytest.mark.parametrize(
        ("trigger", "says", "wrong"),
        [
            (FAR % "", "{measured} m away", True),
            (FAR % "", "{measured} metres (allowed: {limit} s)", True),
            (FAR % "", "{measured} m/s", True),
            (FAR % "", "{measured} s long", False),
            (FAR % "", "too far for {measured} seconds", False),
            (FAR % "", "{measured} more than that", False),
            (FAR % "", "{measured}", False),
            (DISPLACED, "{measured} m", False),
            (DISPLACED, "{measured} cm", True),
            (DISPLACED, "{measured} s", True),
            (STAYS, "{measured} s of {limit}s", False),
            (STAYS, "{measured} m", True),
            (f"{STAYS}, {DISPLACED}", "{measured} m", False),
            ("{trigger: tips_over, entity: Y1}", "{measured} rad", False),
            ("{trigger: tips_over, entity: Y1}", "{measured}°", True),
        ],
    )
    def test_behind_the_blank_stands_the_unit_in_which_the_trigger_measures(self, trigger, says, wrong):
        assert len(found(trigger, says)) == wrong

    def test_of_holds_it_is_said_that_it_measures_seconds_of_a_distance_too(self):
        (one,) = found(FAR % "", "{measured} m away")
        assert one.problem.message == (
            "{measured} is told in m, and this rule measures in s: holds measures how long the condition has held, in s, "
            "whatever it compares"
        )
        assert one.remedy == "write {measured} s, or leave it out"

    @pytest.mark.parametrize(
        ("trigger", "key", "wrong"),
        [
            (FAR % "", "distance_m", True),
            (FAR % "", "how_near_m", True),
            (FAR % "", "measured", False),
            (FAR % "", "held_s", False),
            (DISPLACED, "distance_m", False),
            (STAYS, "distance_m", True),
        ],
    )
    def test_the_key_of_a_payload_promises_what_is_measured(self, trigger, key, wrong):
        told = f"{{action: emit, event: TOLD, payload: {{{key}: {{word: measured}}}}}}"
        assert len(found(trigger, action=told)) == wrong

    @pytest.mark.parametrize(
        ("trigger", "wrong"), [(FAR % "", True), (FAR % ", every_s: 1", False), (STAYS, False), (DISPLACED, False)]
    )
    def test_points_for_how_long_a_distance_was_kept_are_always_the_same(self, trigger, wrong):
        points = "{action: score, entrant: yellow, points: [{word: measured, weight: 2}]}"
        assert len(found(trigger, action=points)) == wrong
        one_number = "{action: score, entrant: yellow, points: {word: measured}}"
        assert len(found(trigger, action=one_number)) == wrong

    def test_the_condition_may_be_one_of_several(self):
        several = FAR.replace("{condition: distance", "{condition: all_of, conditions: [{condition: distance")
        several = several.replace("at_least: 0.3}", "at_least: 0.3}, {condition: speed, entity: ball, at_most: 1}]}")
        told = "{action: score, entrant: yellow, points: {word: measured}}"
        assert len(found(several % "", action=told)) == 1


BASE = """params: {shots: 5, shot_s: 15, goal_points: 1}
description: Five shots each, fifteen seconds a shot; three robots play, one of them is a keeper.
timers: {shot: {lasts_s: {param: shot_s}, starts: true}}
counters: {done: {}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow, points: {param: goal_points}}, {action: count, counter: done}]
    says: "%s"
  missed:
    triggers: [{trigger: timer_expired, timer: shot}]
    actions: [{action: emit, event: MISSED}]
    says: "%s"
  over:
    triggers: [{trigger: time_reached, at_s: 50}]
    conditions: [{condition: counter, counter: done, at_least: {param: shots}}]
    actions: [{action: end}]
    says: All have shot.
"""
DESCRIPTION = "description: Another one.\n"


class TestNumbersOfTheBase:
    @staticmethod
    def found(
        folder: Path, mine: str, goal: str = "A goal; one point.", missed: str = "15 s are over."
    ) -> list[Finding]:
        (folder / "base.yaml").write_text(HEAD % "soccersim_v2" + BASE % (goal, missed), encoding="utf-8")
        (folder / "mine.yaml").write_text(HEAD % "./base.yaml" + mine, encoding="utf-8")
        return [one for one in lint(load(str(folder / "mine.yaml"))) if one.kind == "number_of_the_base"]

    def test_a_sentence_that_tells_the_length_of_its_timer_as_it_was(self, tmp_path):
        (one,) = self.found(tmp_path, DESCRIPTION + "params: {shot_s: 8}\n")
        assert one.problem.path == "params.shot_s"
        assert one.problem.message.startswith("it was 15, and what is said by missed (")
        assert one.problem.message.endswith("base.yaml:18) tells the number of the base")
        assert one.remedy == "write its says: anew here, or let the base say {shot_s}, which fills it in"

    @pytest.mark.parametrize(
        ("says", "told"),
        [
            ("Fifteen seconds are over.", True),
            ("After 15 s it is over.", True),
            ("After 115 s, or 1.15, or 15.5 it is over.", False),
            ("The time is over.", False),
        ],
    )
    def test_numbers_are_found_as_digits_and_as_words(self, tmp_path, says, told):
        assert len(self.found(tmp_path, DESCRIPTION + "params: {shot_s: 8}\n", missed=says)) == told

    @pytest.mark.parametrize(
        ("says", "told"), [("A goal; one point.", True), ("One of them scored.", False), ("1 point", True)]
    )
    def test_one_is_a_number_where_it_counts_something(self, tmp_path, says, told):
        assert len(self.found(tmp_path, "params: {goal_points: 3}\n", goal=says)) == told

    @pytest.mark.parametrize(
        "mine",
        [
            "params: {shot_s: 15}\n",  # as it was
            'rules: {missed: {says: "8 s are over."}}\nparams: {shot_s: 8}\n' + DESCRIPTION,
            "params: {other: 3}\ntimers: {more: {lasts_s: {param: other}}}\n",
        ],
    )
    def test_where_nothing_changed_or_the_sentence_is_new_nothing_is_said(self, tmp_path, mine):
        assert self.found(tmp_path, mine) == []

    def test_a_rule_that_does_not_depend_on_the_param_may_tell_the_same_number(self, tmp_path):
        assert self.found(tmp_path, DESCRIPTION + "params: {shots: 7}\n", missed="5 s are over.") == []

    def test_the_description_tells_what_the_param_is_called_after(self, tmp_path):
        shots = self.found(tmp_path, "params: {shots: 7}\n")
        assert ["description" in one.problem.message for one in shots] == [True]
        both = self.found(tmp_path, "params: {shot_s: 8}\n", missed="The time is over.")
        assert [one.remedy for one in both] == ["write it anew here, or let the base say {shot_s}, which fills it in"]
        assert self.found(tmp_path, "params: {goal_points: 3}\n", goal="A goal.") == []

    def test_what_the_command_line_sets_is_no_matter_of_the_file(self, tmp_path):
        self.found(tmp_path, "")
        findings = lint(load(str(tmp_path / "mine.yaml"), ["shot_s=8"]))
        assert [one for one in findings if one.kind == "number_of_the_base"] == []
