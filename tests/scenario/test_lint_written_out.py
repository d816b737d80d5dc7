"""Lint of numbers in sentences that are those of a param, and of blanks in description and title."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

HEAD = 'schema_version: 1\nid: it\ntitle: "%s"\ndescription: >-\n  %s\nextends: %s\nmatch: {half_s: 60}\n'
RULES = (
    "rules:\n  home:\n    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]\n"
    "    actions: [{action: score, entrant: yellow, points: %s}]\n    says: %s\n"
)


def of_kind(kind: str, text: str) -> list[Finding]:
    return [one for one in lint(load_text(text, file="it.yaml")) if one.kind == kind]


def head(description: str = "About it.", title: str = "It", extends: str = "soccersim_v2") -> str:
    return HEAD % (title, description, extends)


def in_says(says: str, points: str = "{param: home_points}", params: str = "home_points: 5") -> list[str]:
    text = f"{head()}params: {{{params}}}\n{RULES % (points, says)}"
    return [one.problem.message for one in of_kind("number_instead_of_param", text)]


class TestNumbersInSentences:
    def test_the_number_of_a_param_that_the_rule_uses(self):
        text = f"{head()}params: {{home_points: 5}}\n{RULES % ('{param: home_points}', 'The ball is home; 5 points.')}"
        (one,) = of_kind("number_instead_of_param", text)
        assert str(one) == (
            "it.yaml:13:11: warning: rules.home.says: 5 is the param 'home_points' here, and with --set home_points=… it "
            "would be untrue; write {home_points}, which fills in its value [number_instead_of_param]"
        )

    def test_numbers_in_words_are_numbers(self):
        assert len(in_says("Five points.")) == 1

    @pytest.mark.parametrize("says", ["'{home_points} points.'", "50 points in 0.5 s.", "Points."])
    def test_a_placeholder_and_other_numbers_are_none(self, says):
        assert in_says(says) == []

    @pytest.mark.parametrize("says", ["Y5 is home.", "B5 comes through gate_5.", "It is in t5 and leaves."])
    def test_the_number_in_a_name_is_none(self, says):
        assert in_says(says) == []

    @pytest.mark.parametrize("number", [0, 1, 2])
    def test_every_other_sentence_has_a_one_or_a_two_in_it(self, number):
        assert in_says(f"{number} points.", params=f"home_points: {number}") == []

    @pytest.mark.parametrize(
        ("points", "params"),
        [
            # Another param of the same number, a plain number beside it, one that is reckoned, one that the rule never uses.
            ("[{param: home_points}, {param: bonus}]", "home_points: 5, bonus: 5"),
            ("[{param: home_points}, 5]", "home_points: 5"),
            ("{param: half, times: 2}", "half: 2.5"),
            ("5", "home_points: 5"),
        ],
    )
    def test_where_it_is_not_clear_which_one_is_meant_nothing_is_said(self, points, params):
        assert in_says("5 points.", points, params) == []

    def test_another_unit_is_another_number(self):
        draws = "timers: {patience: {lasts_s: {param: wait_s}}}\n"
        text = head() + "params: {wait_s: 5}\n" + draws + RULES.replace(
            "{trigger: enters, entity: ball, zone: blue_goal}", "{trigger: timer_expired, timer: patience}"
        )  # fmt: skip
        assert of_kind("number_instead_of_param", text % ("-4", "Too late; 5 points less.")) == []
        assert len(of_kind("number_instead_of_param", text % ("-4", "Nobody came for 5 s."))) == 1

    def test_of_seconds_and_points_of_one_number_the_unit_says_which(self):
        text = head() + "params: {home_points: 5, wait_s: 5}\ntimers: {patience: {lasts_s: {param: wait_s}}}\n" + RULES.replace(
            "{trigger: enters, entity: ball, zone: blue_goal}", "{trigger: timer_expired, timer: patience}"
        )  # fmt: skip
        (one,) = of_kind("number_instead_of_param", text % ("-4", "Nobody came for 5 s."))
        assert "5 is the param 'wait_s' here" in str(one)

    @pytest.mark.parametrize(("says", "found"), [("{par} points.", 0), ("5 points.", 1), ("{this}: 5 points.", 1)])
    def test_a_value_beside_a_name_that_is_a_param_follows_it(self, says: str, found: int):
        # --set par_long=6 changes what {par} fills in.
        text = (
            f"{head()}params: {{par_long: 5}}\n"
            "rules:\n  home:\n    repeat_for: {blue_goal: {par: {param: par_long}}, yellow_goal: {par: 3}}\n"
            "    triggers: [{trigger: enters, entity: ball, zone: {param: this}}]\n"
            f"    actions: [{{action: score, entrant: yellow, points: {{param: par}}}}]\n    says: '{says}'\n"
        )
        assert len(of_kind("number_instead_of_param", text)) == found

    def test_what_is_said_by_the_base_is_not_the_author_s(self):
        text = head(extends="match") + "params: {damaged_for_s: 90}\n"
        assert of_kind("number_instead_of_param", text) == []


class TestDescriptions:
    def said(self, description: str, params: str = "shot_s: 15, goals: 7") -> list[str]:
        text = f"{head(description)}params: {{{params}}}\n{RULES % ('1', 'A goal.')}"
        return [one.problem.message.split(" here")[0] for one in of_kind("number_instead_of_param", text)]

    def test_a_number_of_what_a_param_is_called_after(self):
        assert self.said("Fifteen seconds for each shot. Seven robots play.") == ["15 is the param 'shot_s'"]

    @pytest.mark.parametrize("text", ["15 robots play.", "{shot_s} s for each shot.", "About it."])
    def test_other_numbers_are_not_meant(self, text):
        assert self.said(text) == []

    @pytest.mark.parametrize(
        "text", ["Three jewels stand in the vault.", "Three red jewels, {jewel_points} points each."]
    )
    def test_so_many_things_are_not_so_many_points_for_each(self, text):
        assert self.said(text, "jewel_points: 3") == []
        assert self.said("Three shots for each robot.", "shot_s: 3") == []

    @pytest.mark.parametrize(
        "text", ["Three points for each.", "A jewel gives three more points.", "3 a jewel.", "3 per jewel."]
    )
    def test_points_are_called_by_their_unit_or_by_what_they_are_for(self, text):
        assert self.said(text, "jewel_points: 3") == ["3 is the param 'jewel_points'"]

    def test_a_param_without_a_unit_is_the_number_of_what_it_is_called_after(self):
        assert self.said("Three jewels stand in the vault.", "jewels: 3") == ["3 is the param 'jewels'"]

    @pytest.mark.parametrize(
        ("description", "points", "said"),
        [
            ("{home_points} points for a goal, 5 points at the end.", 5, False),
            ("{home_points} points for a goal, 5 points at the end.", 7, True),
            ("5 points for a goal, 5 points at the end.", 5, True),
        ],
    )
    def test_a_number_that_rules_have_of_their_own_is_not_that_of_a_param_told_by_name(self, description, points, said):
        own = f"  late:\n    triggers: [{{trigger: half_ended}}]\n    actions: [{{action: score, entrant: blue, points: {points}}}]\n"
        rules = RULES % ("{param: home_points}", "A goal.") + own
        found = of_kind("number_instead_of_param", f"{head(description)}params: {{home_points: 5}}\n{rules}")
        assert len(found) == said

    def test_of_two_params_with_one_number_nobody_knows_which(self):
        assert self.said("15 s for a shot.", "shot_s: 15, pause_s: 15") == []


class TestBlanksInDescriptionAndTitle:
    def said(self, description: str, title: str = "It", params: str = "params: {shots: 7}\n") -> list[str]:
        return [str(one) for one in of_kind("placeholder_unknown", head(description, title) + params)]

    def test_a_param_is_filled_in(self):
        assert self.said("There are {shots} shots.") == []

    def test_what_is_no_param_stays_as_written(self):
        assert self.said("There are {shot} shots.") == [
            (
                "it.yaml:4:14: warning: description: '{shot}' is not filled in, it stays as written; did you mean "
                "'shots'? what is filled in is {shots} [placeholder_unknown]"
            )
        ]
        (one,) = self.said("There are {shots_} shots.", params="")
        assert one.endswith("; params are filled in by their names [placeholder_unknown]")

    def test_what_is_known_when_a_rule_fires_is_not_known_there(self):
        (one,) = self.said("{entity} shoots.")
        assert "that is known only when a rule fires; what is filled in is {shots}" in one

    def test_other_braces_are_text(self):
        assert self.said('Programs are told {"light": "red"} or {}.') == []

    def test_a_title_is_the_same_for_every_value(self):
        (one,) = self.said("About it.", "{shots} shots")
        assert one == (
            "it.yaml:3:8: warning: title: '{shots}' is not filled in: a title is the same for every value of its params; "
            "leave it out, or tell it in the description [placeholder_unknown]"
        )
