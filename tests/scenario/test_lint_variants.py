"""Lint of variants: what a scenario changes of its base, and what of the base no longer fits it."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load, load_text

HEAD = "schema_version: 1\nid: mine\ntitle: Mine\nextends: %s\n"
KINDS = {
    "zones_of_another_field",
    "goal_and_zone_differ",
    "sentence_of_the_base",
    "kit_never_used",
    "idle_robot_makes_no_progress",
    "event_never_emitted",
}


def found(text: str, kind: str, extends: str = "match", overrides: tuple[str, ...] = ()) -> list[Finding]:
    """Return what lint finds of a kind in a variant."""
    loaded = load_text(HEAD % extends + text, overrides, file="it.yaml")
    return [finding for finding in lint(loaded) if finding.kind == kind]


def shown(finding: Finding) -> tuple[str, str, int]:
    """Return where a finding is: file, path, line."""
    return finding.problem.file, finding.problem.path, finding.problem.line


@pytest.mark.parametrize("base", ["match", "match_2021", "fast_shooter", "precision_lidar", "pass_the_ball"])
def test_a_variant_that_changes_nothing_has_none_of_these_findings(base):
    loaded = load_text(HEAD % base, file="it.yaml")
    assert [str(finding) for finding in lint(loaded) if finding.kind in KINDS] == []


class TestFieldOfAnotherSize:
    KIND = "zones_of_another_field"
    NEW_PITCH = "zones: {pitch: {x_min_m: -1, x_max_m: 1}}\n"

    def test_what_is_named_and_inherited_stays_where_it_was(self):
        (finding,) = found("field: {width_m: 2}\n", self.KIND)
        assert shown(finding) == ("it.yaml", "field.width_m", 5)
        assert finding.problem.message == (
            "width_m changed, and what is inherited stays where it was: pitch, blue_penalty_area, yellow_penalty_area, "
            "corner_blue_right, corner_blue_left, corner_yellow_right, corner_yellow_left"
        )
        assert finding.remedy.startswith("give them new numbers in zones and spots too")

    def test_with_both_sizes_changed_it_is_told_once(self):
        (finding,) = found("field: {length_m: 2, width_m: 2}\n", self.KIND)
        assert finding.problem.message.startswith("width_m and length_m changed")
        assert "middle_blue" in finding.problem.message

    def test_what_got_new_numbers_is_not_named(self):
        (finding,) = found(f"field: {{width_m: 2}}\n{self.NEW_PITCH}", self.KIND)
        assert "pitch" not in finding.problem.message

    def test_new_numbers_along_the_other_axis_do_not_help(self):
        (finding,) = found(f"field: {{length_m: 2}}\n{self.NEW_PITCH}", self.KIND)
        assert "it was: pitch in y, " in finding.problem.message

    def test_of_what_was_moved_along_one_axis_the_other_one_is_told(self):
        moved = "field: {length_m: 2, width_m: 2}\nzones: {blue_penalty_area: {y_min_m: 0.84}}\n"
        (finding,) = found(moved, self.KIND)
        assert "pitch, blue_penalty_area in x, yellow_penalty_area, " in finding.problem.message

    def test_nothing_is_said_of_what_nobody_names(self):
        rules = "rules:\n  r: {triggers: [{trigger: enters, entity: ball, zone: %s}], actions: [{action: end}]}\n"
        text = "field: {width_m: 2}\n"
        assert found(text, self.KIND, "soccersim_v2") == []
        (finding,) = found(text + rules % "pitch", self.KIND, "soccersim_v2")
        assert finding.problem.message.endswith("it was: pitch")
        (finding,) = found(text + rules % "penalty_areas", self.KIND, "soccersim_v2")
        assert finding.problem.message.endswith("it was: blue_penalty_area, yellow_penalty_area")

    def test_a_spot_that_only_a_draw_names_is_used(self):
        drawn = (
            "field: {length_m: 2}\ndraws: {where: {values: [centre, middle_blue]}}\nrules:\n  r:\n"
            "    triggers: [{trigger: half_started}]\n"
            "    actions: [{action: place, entity: ball, at: {spot: where}}]\n"
        )
        (finding,) = found(drawn, self.KIND, "soccersim_v2")
        assert finding.problem.message.endswith("it was: middle_blue")  # the centre stays the centre

    def test_another_size_than_width_and_length_moves_nothing(self):
        assert found("field: {wall_height_m: 0.2, corner_cut_m: 0}\n", self.KIND) == []

    def test_a_size_from_the_command_line_is_not_the_authors(self):
        assert found("", self.KIND, overrides=("field.width_m=2",)) == []

    @pytest.mark.parametrize(
        ("section", "place", "used", "stays"),
        [
            ("gates", "{from_m: [-0.6, 0], to_m: [0.6, 0]}", "crosses, entity: ball, gate: it", True),
            ("gates", "{from_m: [0, -0.2], to_m: [0, 0.2]}", "crosses, entity: ball, gate: it", False),
            ("gates", "{from_m: [-0.6, 0], to_m: [0.6, 0], anchor: Y1}", "crosses, entity: ball, gate: it", False),
            ("zones", "{shape: circle, centre_m: [0.3, 0], radius_m: 0.1}", "enters, entity: ball, zone: it", True),
            ("zones", "{shape: circle, centre_m: [0, 0.3], radius_m: 0.1}", "enters, entity: ball, zone: it", False),
            ("zones", "{shape: polygon, points_m: [[0, 0], [0.5, 0], [0, 0.5]]}", "leaves, entity: ball, zone: it", True),
            ("zones", "{shape: half_plane, through_m: [0.5, 0], normal: [1, 0]}", "enters, entity: ball, zone: it", True),
            ("zones", "{shape: half_plane, through_m: [0.5, 0], normal: [0, 1]}", "enters, entity: ball, zone: it", False),
            ("zones", "{shape: rect, y_min_m: 0.5}", "enters, entity: ball, zone: it", False),
        ],
    )  # fmt: skip
    def test_each_kind_of_place_along_the_axis_that_changed(self, tmp_path, section, place, used, stays):
        base = (
            f"{section}: {{it: {place}}}\n"
            f"rules:\n  r: {{triggers: [{{trigger: {used}}}], actions: [{{action: score, entrant: yellow}}], says: So.}}\n"
        )
        (tmp_path / "base.yaml").write_text(HEAD % "soccersim_v2" + base, encoding="utf-8")
        mine = tmp_path / "mine.yaml"
        mine.write_text(HEAD % "base.yaml" + "field: {width_m: 2}\n", encoding="utf-8")
        found = [finding for finding in lint(load(str(mine))) if finding.kind == self.KIND]
        assert len(found) == stays
        (tmp_path / "base.yaml").write_text(HEAD % "soccersim_v2" + base + "field: {width_m: 2}\n", encoding="utf-8")
        assert [one for one in lint(load(str(tmp_path / "base.yaml"))) if one.kind == self.KIND] == []

    def test_a_param_that_the_own_file_sets_counts(self, tmp_path):
        base = (
            "params: {wide_m: 1.3, out_m: 0.6}\nfield: {width_m: {param: wide_m}}\n"
            "zones: {out: {shape: rect, x_min_m: {param: out_m}}}\n"
            "rules:\n  r: {triggers: [{trigger: enters, entity: ball, zone: out}], actions: [{action: end}]}\n"
        )
        (tmp_path / "base.yaml").write_text(HEAD % "soccersim_v2" + base, encoding="utf-8")
        mine = tmp_path / "mine.yaml"
        mine.write_text(HEAD % "base.yaml" + "params: {wide_m: 2}\n", encoding="utf-8")
        (finding,) = [one for one in lint(load(str(mine))) if one.kind == self.KIND]
        assert (finding.problem.file, finding.problem.path) == (str(mine), "params.wide_m")
        mine.write_text(HEAD % "base.yaml" + "params: {wide_m: 2, out_m: 0.9}\n", encoding="utf-8")
        assert [one for one in lint(load(str(mine))) if one.kind == self.KIND] == []

    def test_of_many_a_dozen_are_named(self, tmp_path):
        spots = "".join(f"  s{number}: {{x_m: 0.{number + 10}, y_m: 0}}\n" for number in range(20))
        names = ", ".join(f"s{number}" for number in range(20))
        rule = f"{{triggers: [{{trigger: half_started}}], actions: [{{action: place, entity: ball, at: {{choice: [{names}]}}}}]}}"
        (tmp_path / "base.yaml").write_text(
            HEAD % "soccersim_v2" + f"spots:\n{spots}rules:\n  r: {rule}\n", encoding="utf-8"
        )
        (tmp_path / "mine.yaml").write_text(HEAD % "base.yaml" + "field: {width_m: 2}\n", encoding="utf-8")
        (finding,) = [one for one in lint(load(str(tmp_path / "mine.yaml"))) if one.kind == self.KIND]
        assert finding.problem.message.endswith("s10, s11 and 8 more")


class TestGoalAndZone:
    KIND = "goal_and_zone_differ"
    MINE = (
        "field: {goals: {blue_goal: null, mine: {end: positive_y, colour: blue}}}\n"
        "rules: {r: {triggers: [{trigger: enters, entity: ball, zone: mine}], actions: [{action: end}]}}\n"
    )

    def test_a_wider_goal_with_the_zone_of_the_base(self):
        (finding,) = found("field: {goals: {blue_goal: {width_m: 0.6}}}\n", self.KIND)
        assert shown(finding) == ("it.yaml", "field.goals.blue_goal", 5)
        assert "the zone goes from x -0.2, the hole from -0.3" in finding.problem.message
        assert "the zone goes to x 0.2, the hole to 0.3" in finding.problem.message
        assert "zones.blue_goal" in finding.remedy

    def test_a_narrower_zone_with_the_goal_of_the_base(self):
        (finding,) = found("zones: {yellow_goal: {x_min_m: -0.1}}\n", self.KIND)
        assert shown(finding)[1] == "zones.yellow_goal"

    def test_a_longer_field_takes_the_goals_along_and_leaves_the_zones(self):
        findings = found("field: {length_m: 2}\n", self.KIND)
        assert [shown(finding) for finding in findings] == [("it.yaml", "field.length_m", 5)] * 2
        assert "the zone begins at y 0.745, the field ends at 1" in findings[0].problem.message
        assert "the zone begins at y -0.745, the field ends at -1" in findings[1].problem.message

    def test_goals_that_change_ends_leave_their_zones(self):
        ends = "field: {goals: {blue_goal: {end: negative_y}, yellow_goal: {end: positive_y}}}\n"
        assert [shown(one)[1] for one in found(ends, self.KIND)] == ["field.goals.blue_goal", "field.goals.yellow_goal"]

    def test_a_zone_that_is_open_towards_the_field_begins_nowhere(self):
        zone = "zones: {mine: {shape: rect, x_min_m: -0.2, x_max_m: 0.2, y_max_m: 0.85}}\n"
        (finding,) = found(zone + self.MINE, self.KIND, "soccersim_v2")
        assert "no side towards the field" in finding.problem.message

    @pytest.mark.parametrize(
        "text",
        [
            "field: {goals: {blue_goal: {width_m: 0.6}}}\nzones: {blue_goal: {x_min_m: -0.3, x_max_m: 0.3}}\n",
            "field: {goals: {blue_goal: {width_m: 0.42}}}\n",
            "field: {goals: {blue_goal: {colour: red, depth_m: 0.2}}}\n",
            "field: {width_m: 2}\n",
            "field: {length_m: 1.55}\n",
            "field: {length_m: 2}\nzones:\n  blue_goal: {y_min_m: 0.995, y_max_m: 1.1}\n  yellow_goal: {y_min_m: -1.1, y_max_m: -0.995}\n",
            "zones: {blue_goal: {shape: circle, centre_m: [0, 0.8], radius_m: 0.5}}\n",
            "zones: {mine: {shape: rect, y_min_m: 0.1}}\n",
        ],
    )
    def test_where_both_are_at_one_place_or_only_one_exists_nothing_is_said(self, text):
        assert found(text, self.KIND) == []

    def test_a_side_that_is_left_out_is_closed_by_the_wall(self):
        assert found("zones: {mine: {shape: rect, y_min_m: 0.745}}\n" + self.MINE, self.KIND, "soccersim_v2") == []

    def test_where_no_rule_looks_at_the_zone_nothing_is_said(self):
        text = "field: {length_m: 2, goals: {blue_goal: {width_m: 0.6}}}\n"
        assert found(text, self.KIND, "soccersim_v2") == []
        rule = "rules: {r: {triggers: [{trigger: leaves, entity: ball, zone: in_play}], actions: [{action: end}]}}\n"
        assert len(found(text + rule, self.KIND, "soccersim_v2")) == 2

    def test_what_a_base_got_wrong_is_told_there(self, tmp_path):
        (tmp_path / "base.yaml").write_text(
            HEAD % "match" + "field: {goals: {blue_goal: {width_m: 0.6}}}\n", encoding="utf-8"
        )
        (tmp_path / "mine.yaml").write_text(HEAD % "base.yaml", encoding="utf-8")
        of_base, of_mine = (lint(load(str(tmp_path / name))) for name in ("base.yaml", "mine.yaml"))
        assert [one.kind for one in of_base if one.kind == self.KIND] == [self.KIND]
        assert [one for one in of_mine if one.kind == self.KIND] == []

    def test_a_width_from_a_param_of_the_own_file_is_told_at_the_param(self, tmp_path):
        base = "params: {goal_m: 0.4}\nfield: {goals: {blue_goal: {width_m: {param: goal_m}}}}\n"
        (tmp_path / "base.yaml").write_text(HEAD % "match" + base, encoding="utf-8")
        (tmp_path / "mine.yaml").write_text(HEAD % "base.yaml" + "params: {goal_m: 0.6}\n", encoding="utf-8")
        (finding,) = [one for one in lint(load(str(tmp_path / "mine.yaml"))) if one.kind == self.KIND]
        assert shown(finding)[1:] == ("params.goal_m", 5)


class TestSentenceOfTheBase:
    KIND = "sentence_of_the_base"
    ACTIONS = "actions: [{action: score, entrant: yellow, points: 3}, {action: set_phase, phase: goal_pause}]"

    @pytest.mark.parametrize(
        ("part", "told"),
        [
            (ACTIONS, "its actions are"),
            ("triggers: [{trigger: enters, entity: ball, zone: pitch}]", "its triggers are"),
            (f"conditions: [{{condition: flag, flag: blue_conceded}}], {ACTIONS}", "its conditions and actions are"),
        ],
    )
    def test_a_rule_that_does_something_else_and_says_the_same(self, part, told):
        (finding,) = found(f"rules:\n  goal_in_blue: {{{part}}}\n", self.KIND)
        assert shown(finding) == ("it.yaml", "rules.goal_in_blue", 6)
        assert finding.problem.message.startswith(told)
        assert "match.yaml:" in finding.problem.message

    @pytest.mark.parametrize(
        "rule",
        [
            f"goal_in_blue: {{{ACTIONS}, says: Three points.}}",
            "goal_in_blue: {phases: any, priority: 2, exclusive: one, cooldown_s: 1, max_executions: 3}",
            "goal_in_blue: {says: Three points.}",
            "goal_in_blue: null",
            "robot_moved_on: {actions: [{action: count, counter: put_backs, entity: each, to: 1}]}",  # says nothing
            f"mine: {{triggers: [{{trigger: half_started}}], {ACTIONS}, says: So.}}",
        ],
    )
    def test_its_own_sentence_no_sentence_or_other_keys_only(self, rule):
        assert found(f"rules:\n  {rule}\n", self.KIND) == []

    def test_params_do_not_count(self):
        assert found("params: {robot_progress_s: 30}\n", self.KIND) == []

    def test_what_the_command_line_says_is_no_sentence_of_the_base(self):
        text = f"rules:\n  goal_in_blue: {{{self.ACTIONS}}}\n"
        assert found(text, self.KIND, overrides=("rules.goal_in_blue.says=Three points.",)) == []


class TestKits:
    KIND = "kit_never_used"

    def test_a_kit_that_no_robot_has(self):
        (finding,) = found("kits:\n  v2: {messages: v2.1}\n", self.KIND, "match_2021")
        assert shown(finding) == ("it.yaml", "kits.v2", 6)
        assert "legacy_2021" in finding.remedy

    def test_a_kit_that_a_robot_has_and_one_that_is_only_inherited(self):
        assert found("kits: {v2: {devices: {gps: null}}}\n", self.KIND) == []
        assert found("robots: {Y1: {kit: v2}}\nkits: {v2: {devices: {gps: null}}}\n", self.KIND, "match_2021") == []
        assert found("match: {half_s: 300}\n", self.KIND, "match_2021") == []


class TestIdleRobots:
    KIND = "idle_robot_makes_no_progress"
    IDLE = "entrants: {yellow: {robots: {Y3: null}}, blue: {robots: {B3: null}}}\nrobots: {Y3: {idle: true}, B3: {idle: true}}\n"
    RULE = "rules:\n  r: {%s triggers: [{trigger: %s}], actions: [{action: emit, event: STANDS}], says: It stands.%s}\n"
    STANDS = "no_progress, entity: %s, distance_m: 0.1, within_s: 3"
    STAYS = "stays_in, entity: %s, zone: pitch, limit_s: 3"

    @pytest.mark.parametrize("trigger", [STANDS, STAYS])
    @pytest.mark.parametrize(("entity", "count"), [("Y3", 1), ("yellow", 1), ("robots", 2), ("[Y1, B3]", 1)])
    def test_a_rule_that_expects_that_an_idle_robot_moves(self, trigger, entity, count):
        text = self.IDLE + self.RULE % ("", trigger % entity, "")
        (finding,) = found(text, self.KIND, "soccersim_v2")
        assert shown(finding) == ("it.yaml", f"rules.r.triggers[0] ({trigger.partition(',')[0]})", 8)
        assert ("are idle" in finding.problem.message) == (count == 2)

    def test_of_each_the_group_is_meant(self):
        text = self.IDLE + self.RULE % ("for_each: yellow,", self.STANDS % "each", "")
        (finding,) = found(text, self.KIND, "soccersim_v2")
        assert finding.problem.path == "rules.r.for_each"
        assert "'Y3' is idle" in finding.problem.message

    @pytest.mark.parametrize(
        "rule",
        [
            RULE % ("", STANDS % "[Y1, Y2]", ""),
            RULE % ("for_each: moving,", STANDS % "each", ""),
            RULE % ("", STANDS % "ball", ""),
            RULE % ("", "enters, entity: yellow, zone: pitch", ""),
            RULE % ("", STANDS % "Y3", ", phases: [dead]") + "phases: {dead: {}}\n",
        ],
    )
    def test_a_group_without_it_another_trigger_and_a_rule_that_never_lives(self, rule):
        groups = "groups: {moving: [Y1, Y2, B1, B2]}\n"
        assert found(self.IDLE + groups + rule, self.KIND, "soccersim_v2") == []

    def test_where_nobody_is_idle_nothing_is_said(self):
        assert found(self.RULE % ("", self.STANDS % "robots", ""), self.KIND, "soccersim_v2") == []

    def test_of_inherited_rules_it_is_told_once_at_the_robot(self):
        findings = found(self.IDLE, self.KIND)
        assert {shown(finding)[1] for finding in findings} == {"robots.Y3.idle", "robots.B3.idle"}
        rules = "robot_damaged, robot_lack_of_progress, inside_penalty_area_too_long"
        assert all(finding.problem.message.endswith(f"rules {rules}") for finding in findings)

    def test_rules_that_go_over_a_group_without_it_are_mended(self):
        rules = "".join(
            f"  {name}: {{for_each: moving}}\n"
            for name in ("robot_damaged", "robot_lack_of_progress", "inside_penalty_area_too_long")
        )
        assert found(f"{self.IDLE}groups: {{moving: [Y1, Y2, B1, B2]}}\nrules:\n{rules}", self.KIND) == []


class TestEventsOfTests:
    KIND = "event_never_emitted"
    TEST = "expect:\n  mine:\n    keyframes: [{at_s: 1}]\n    lasts_s: 2\n"

    def test_an_event_that_is_expected_and_never_emitted(self):
        (finding,) = found(f"{self.TEST}    events: [{{event: KICKOFF}}, {{event: GOALS}}]\n", self.KIND)
        assert shown(finding) == ("it.yaml", "expect.mine.events[1].event", 9)
        assert finding.problem.message == "event 'GOALS' is expected and never emitted; did you mean 'GOAL'?"

    def test_an_event_that_is_ignored_and_never_emitted(self):
        (finding,) = found(f"{self.TEST}    ignore: [GOAL, GAOL]\n", self.KIND)
        assert shown(finding) == ("it.yaml", "expect.mine.ignore[1]", 9)
        assert finding.remedy == "correct its name, or leave it out"

    def test_an_event_of_a_rule_that_cannot_fire_is_not_emitted(self):
        dead = "phases: {dead: {}}\nrules: {goal_in_blue: {phases: [dead]}, goal_in_yellow: {phases: [dead]}}\n"
        (finding,) = found(f"{dead}{self.TEST}    events: [{{event: GOAL}}]\n", self.KIND)
        assert finding.problem.path == "expect.mine.events[0].event"

    def test_what_is_emitted_inherited_or_ignored_by_default_is_sound(self):
        assert found(f"{self.TEST}    events: [{{event: GOAL}}]\n    ignore: [LACK_OF_PROGRESS]\n", self.KIND) == []
        assert found("rules: {goal_in_blue: null, goal_in_yellow: null}\n", self.KIND) == []
        none = "rules: {r: {triggers: [{trigger: half_started}], actions: [{action: emit, event: TOLD}], says: So.}}\n"
        default = "    ignore: [MATCH_START, KICKOFF, MATCH_FINISH, TOLD]\n"
        assert found(f"{none}{self.TEST}{default}", self.KIND, "soccersim_v2") == []
        assert found(f"{none}{self.TEST}", self.KIND, "soccersim_v2") == []


class TestQuestions:
    RULES = (
        "rules:\n  r: {triggers: [{trigger: event, event: %s}], actions: [{action: emit, event: TOLD}], says: So.}\n"
    )

    def test_the_remedy_follows_a_question_without_a_semicolon(self):
        (finding,) = found(self.RULES % "OWN_GOAL", "event_never_emitted")
        assert str(finding).endswith(
            "event 'OWN_GOAL' is waited for and never emitted; did you mean 'GOAL'? emit it in a rule that can fire, "
            "or correct its name [event_never_emitted]"
        )

    def test_without_a_question_there_is_one(self):
        (finding,) = found(self.RULES % "XYZ", "event_never_emitted")
        assert "never emitted; emit it in a rule" in str(finding)
