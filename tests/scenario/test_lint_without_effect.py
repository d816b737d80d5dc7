"""Lint of what is written and has no effect: exclusive groups that never meet, criteria that rank nobody, empty words."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load, load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: %s\nmatch: {half_s: 60}\n"


def found(text: str, kind: str, extends: str = "soccersim_v2") -> list[Finding]:
    """Return what lint finds of a kind."""
    return [finding for finding in lint(load_text(HEAD % extends + text, file="it.yaml")) if finding.kind == kind]


class TestWordsOfABroadcast:
    KIND = "word_never_filled"

    @pytest.mark.parametrize(
        "word", ["robot_name", "entity_name", "each_name", "team_name", "entrant", "score", "measured", "limit"]
    )
    def test_a_broadcast_is_about_no_entity_and_no_rule(self, word):
        (finding,) = found(f"broadcast: {{fields: {{a: {{word: {word}}}}}}}\n", self.KIND)
        assert finding.problem.path == "broadcast.fields.a.word"
        assert finding.problem.message.startswith(f"'{word}' ")
        assert "a broadcast is about no" in finding.problem.message

    @pytest.mark.parametrize("word", ["team_name", "score"])
    def test_with_a_named_entrant_it_is_known(self, word):
        assert found(f"broadcast: {{fields: {{a: {{word: {word}, of: yellow}}}}}}\n", self.KIND) == []

    @pytest.mark.parametrize(
        "word", ["halftime", "match_id", "total_match_time_s", "time_s", "time_left_s", "phase", "seed_id"]
    )
    def test_words_of_the_match_are_known(self, word):
        assert found(f"broadcast: {{fields: {{a: {{word: {word}}}}}}}\n", self.KIND) == []

    def test_the_remedy_for_a_measure_is_a_counter(self):
        (finding,) = found("broadcast: {fields: {a: {word: measured}}}\n", self.KIND)
        assert "counter" in finding.remedy


RULE = (
    "  %s: {%striggers: [{trigger: touches, entity: %s, other: ball}], actions: [{action: emit, event: E}], says: E.}\n"
)


def rules(*each: str) -> str:
    """Return a section of rules of one exclusive group, each with its for_each or none."""
    return "rules:\n" + "".join(
        RULE % (f"r{n}", f"exclusive: one, {f'for_each: {group}, ' if group else ''}", "each" if group else "Y1")
        for n, group in enumerate(each)
    )


class TestExclusiveGroups:
    KIND = "exclusive_never_meets"

    def test_a_rule_for_each_and_a_plain_one_never_exclude_each_other(self):
        (finding,) = found(rules("yellow", ""), self.KIND)
        assert finding.problem.path == "rules.r1.exclusive"
        assert "r0" in finding.problem.message
        assert "for_each" in finding.problem.message + finding.remedy

    def test_a_group_that_mixes_them_is_told_once_whichever_comes_first(self):
        assert len(found(rules("", "", "yellow", "yellow"), self.KIND)) == 1

    def test_rules_for_different_things_never_meet(self):
        (finding,) = found(rules("blue", "yellow"), self.KIND)
        assert finding.problem.path == "rules.r1.exclusive"

    def test_of_one_rule_that_is_repeated_over_members_it_is_told_how_only_one_counts(self):
        rule = RULE % ("r", "exclusive: one, repeat_for: [blue, yellow], for_each: {param: this}, ", "each")
        (finding,) = found(f"rules:\n{rule}", self.KIND)
        assert finding.problem.path == "rules.r_yellow.exclusive"
        assert finding.remedy.startswith("leave it out; for only one of several to count in a tick each makes itself")

    @pytest.mark.parametrize("groups", [("", ""), ("robots", "robots"), ("robots", "Y1"), ("blue", "yellow", "robots")])
    def test_rules_that_meet_are_fine(self, groups):
        assert found(rules(*groups), self.KIND) == []

    def test_of_three_the_one_that_meets_no_other_is_told(self):
        (finding,) = found(rules("blue", "blue", "yellow"), self.KIND)
        assert finding.problem.path == "rules.r2.exclusive"

    def test_a_rule_for_each_of_several_that_is_alone_in_its_group_stops_nobody(self):
        (finding,) = found(rules("yellow"), self.KIND)
        assert finding.problem.path == "rules.r0.exclusive"
        assert "no other rule is in the group 'one', and of one rule for each of 'yellow' it stops none" in str(finding)
        assert "leave for_each out" in finding.remedy

    def test_a_group_that_is_called_nearly_like_another_is_named(self):
        text = rules("yellow", "yellow", "yellow").replace("exclusive: one", "exclusive: ones", 1)
        (finding,) = found(text, self.KIND)
        assert "did you mean 'one'?" in str(finding)

    @pytest.mark.parametrize("group", ["", "Y1"])
    def test_so_is_that_of_a_rule_for_nobody_or_one(self, group):
        text = rules(group, group, group).replace("exclusive: one", "exclusive: ones", 1)
        (finding,) = found(text, self.KIND)
        assert finding.problem.path == "rules.r0.exclusive"
        assert "did you mean 'one'?" in str(finding)
        assert found(text.replace("exclusive: ones", "exclusive: another"), self.KIND) == []

    @pytest.mark.parametrize("group", ["", "Y1"])
    def test_a_rule_alone_that_is_for_nobody_or_one_is_no_matter(self, group):
        assert found(rules(group), self.KIND) == []

    def test_of_two_that_one_robot_touches_at_once_a_rule_alone_stops_the_second(self):
        caught = (
            "rules:\n  caught:\n    for_each: robots\n    exclusive: one\n"
            "    triggers: [{trigger: touches, entity: each, other: %s}]\n"
            "    actions: [{action: emit, event: E, payload: {who: {word: other_name}}}]\n    says: E.\n"
        )
        assert found(caught % "robots", self.KIND) == []
        assert len(found(caught % "ball", self.KIND)) == 1

    def test_what_a_base_has_written_is_not_the_authors_to_mend(self, tmp_path):
        (tmp_path / "base.yaml").write_text(HEAD % "soccersim_v2" + rules("yellow", "yellow"), encoding="utf-8")
        mine = tmp_path / "mine.yaml"
        mine.write_text("schema_version: 1\nid: m\ntitle: M\nextends: base.yaml\nrules: {r0: null}\n", encoding="utf-8")
        assert [one for one in lint(load(mine)) if one.kind == self.KIND] == []


COUNTING = """counters: {c: {%s}}
rules:
  a:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: count, counter: c}]
"""
ALONE = "entrants: {blue: null}\nrobots: {B1: null, B2: null, B3: null}\n"


class TestRanking:
    KIND = "criterion_always_equal"
    BY_COUNTER = "result: {rank: [{score: descending}, {counter: c}]}\n"
    BY_TIME = "result: {rank: [{time: ascending, plus: [{counter: c, weight: 2}]}]}\n"

    @pytest.mark.parametrize(
        ("rank", "path"), [(BY_COUNTER, "result.rank[1].counter"), (BY_TIME, "result.rank[0].plus[0].counter")]
    )
    @pytest.mark.parametrize("seats", ["", ALONE])
    def test_a_counter_kept_per_ball_counts_for_nobody(self, rank, path, seats):
        (finding,) = found(COUNTING % "per: balls" + seats + rank, self.KIND)
        assert finding.problem.path == path
        assert finding.problem.message == (
            "counter 'c' is kept per balls, which nobody drives: it is 0 for every entrant"
        )

    @pytest.mark.parametrize("rank", [BY_COUNTER, BY_TIME])
    def test_one_counter_for_all_tells_no_two_teams_apart(self, rank):
        (finding,) = found(COUNTING % "" + rank, self.KIND)
        assert finding.problem.message == "counter 'c' is one for all: it is the same number for every entrant"
        assert "per: robots" in finding.remedy

    @pytest.mark.parametrize("rank", [BY_COUNTER, BY_TIME])
    def test_one_counter_ranks_runs_of_a_single_entrant(self, rank):
        assert found(COUNTING % "" + ALONE + rank, self.KIND) == []

    @pytest.mark.parametrize("per", ["robots", "yellow", "Y1"])
    def test_a_counter_kept_per_robot_ranks_teams(self, per):
        assert found(COUNTING % f"per: {per}" + self.BY_COUNTER, self.KIND) == []


FEWER = "robots: {B3: null, Y3: null}\nentrants: {blue: {robots: {B3: null}}, yellow: {robots: {Y3: null}}}\n"
LAYOUTS = (
    "placements:\n  blue_kicks_off: [{entity: ball, at: {spot: centre}}, {entity: robots, at: start}]\n"
    "  yellow_kicks_off: [{entity: ball, at: {spot: centre}}, {entity: robots, at: start}]\nexpect: {inherited: null}\n"
)


class TestTextsOfTheBase:
    KIND = "text_names_what_is_gone"

    def test_what_events_tell_of_a_robot_that_is_gone(self):
        finding, other = found(FEWER + LAYOUTS, self.KIND, "match")
        assert "'Y3'" in other.problem.message
        assert (finding.problem.file, finding.problem.line) == ("it.yaml", 6)
        assert finding.problem.path == "robots"
        assert "'B3'" in finding.problem.message
        assert "first_kickoff_blue (match.yaml:57)" in finding.problem.message
        assert "kickoff_blue (match.yaml:72)" in finding.problem.message
        assert "actions" in finding.remedy

    def test_actions_that_are_written_anew_are_the_authors_own(self):
        own = (
            "rules:\n"
            "  first_kickoff_blue: {actions: [{action: place, layout: blue_kicks_off}]}\n"
            "  kickoff_blue: {actions: [{action: place, layout: blue_kicks_off}]}\n"
            "  first_kickoff_yellow: {actions: [{action: emit, event: KICKOFF, payload: {robot_name: Y2}}]}\n"
            "  kickoff_yellow: {actions: [{action: emit, event: KICKOFF, payload: {robot_name: Y3}}]}\n"
        )
        assert found(FEWER + LAYOUTS + own, self.KIND, "match") == []

    def test_with_all_robots_there_nothing_is_said(self):
        assert found("", self.KIND, "match") == []

    @pytest.mark.parametrize("source", ["match", "match_2021", "pass_the_ball", "fast_shooter", "precision_lidar"])
    def test_what_is_shipped_names_nothing_that_is_gone(self, source):
        assert [finding for finding in lint(load(source)) if finding.kind == self.KIND] == []
