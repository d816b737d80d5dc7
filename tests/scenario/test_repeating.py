"""Entries that are written once and repeated for the rows of a table: ``repeat_for``."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.diagnostics import InFile
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load, load_resolved, load_text
from rcj_challenges.scenario.roster import Roster
from tests.scenario.writing import HEAD, HEAD_LINES, complaints, errors, in_short, loaded, problems_of, scenario

GOALS = """
tables:
  teams:
    yellow: {zone: blue_goal, rest: [blue], worth: 2}
    blue: {zone: yellow_goal, rest: [yellow, blue], worth: 3}
rules:
  before:
    triggers: [{trigger: half_started}]
    actions: [{action: emit, event: BEFORE}]
  goal:
    repeat_for: teams
    triggers: [{trigger: enters, entity: ball, zone: {param: zone}}]
    conditions: [{entity: {param: rest}, in: in_play}]
    actions: [{action: score, entrant: {param: this}, points: {param: worth, times: 2, plus: 1}}]
    says: "{points} points for {this}: the ball is in the {zone}, and {rest} {rest} see it from {entity}."
  after:
    triggers: [{trigger: half_ended}]
    actions: [{action: emit, event: AFTER}]
"""
BY_HAND = """
rules:
  before:
    triggers: [{trigger: half_started}]
    actions: [{action: emit, event: BEFORE}]
  goal_yellow:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{entity: [blue], in: in_play}]
    actions: [{action: score, entrant: yellow, points: 5}]
    says: "{points} points for yellow: the ball is in the blue goal, and blue blue see it from {entity}."
    sheet: "{points} points for a team: the ball is in its zone, and its rest its rest see it from {entity}."
  goal_blue:
    triggers: [{trigger: enters, entity: ball, zone: yellow_goal}]
    conditions: [{entity: [yellow, blue], in: in_play}]
    actions: [{action: score, entrant: blue, points: 7}]
    says: "{points} points for blue: the ball is in the yellow goal, and yellow and blue yellow and blue see it from {entity}."
    sheet: "{points} points for a team: the ball is in its zone, and its rest its rest see it from {entity}."
  after:
    triggers: [{trigger: half_ended}]
    actions: [{action: emit, event: AFTER}]
"""
PAY = """
tables: {teams: {yellow: {}, blue: {}}}
rules:
  pay:
    repeat_for: teams
    triggers: [{trigger: enters, entity: ball, zone: in_play}]
    actions: [{action: score, entrant: {param: this}}]
    says: "One point for {this}."
"""
values = (
    st.integers(-99, 99)
    | st.floats(-99, 99).map(lambda number: round(number, 3))
    | st.booleans()
    | st.sampled_from(["one", "a b"])
)
names = st.from_regex(r"[a-z_][a-z0-9_]{0,8}", fullmatch=True)


def written(rules, params=None, tables=None):
    """Return a scenario with some rules, written down."""
    return json.dumps(
        {
            "schema_version": 2,
            "id": "a",
            "title": "A",
            "extends": "soccersim_v2",
            "params": params or {},
            "tables": tables or {},
            "rules": rules,
        }
    )


class TestMeaning:
    def test_it_is_one_rule_for_each_name_in_its_place_in_the_order(self):
        assert list(scenario(GOALS).rules) == ["before", "goal_yellow", "goal_blue", "after"]
        assert loaded(GOALS).resolved == loaded(BY_HAND).resolved

    def test_a_row_need_not_have_values(self):
        rules = scenario(PAY).rules
        assert {name: (rule.actions[0].entrant, rule.says) for name, rule in rules.items()} == {
            "pay_yellow": ("yellow", "One point for yellow."),
            "pay_blue": ("blue", "One point for blue."),
        }

    def test_a_value_may_be_a_param_of_the_scenario_and_follows_it(self):
        text = GOALS.replace("worth: 3", "worth: {param: goal_points, plus: 1}") + "params: {goal_points: 4}\n"
        assert scenario(text).rules["goal_blue"].actions[0].points == 11
        assert scenario(text, ["goal_points=0"]).rules["goal_blue"].actions[0].points == 3

    def test_a_list_of_two_numbers_is_a_point(self):
        text = """
tables: {homes: {B1: {home: [0, 0.3]}, Y1: {home: [0, -0.3]}}}
rules:
  put:
    repeat_for: homes
    triggers: [{trigger: half_started}]
    actions: [{action: place, entity: {param: this}, at: {point: {param: home}}}]
"""
        assert scenario(text).rules["put_Y1"].actions[0].at.point == (0, -0.3)

    def test_a_sentence_that_begins_with_the_name_begins_with_a_capital(self):
        rules = scenario(PAY.replace("One point for {this}.", "{this} has scored, and that is for {this}.")).rules
        assert [rule.says for rule in rules.values()] == [
            "Yellow has scored, and that is for yellow.",
            "Blue has scored, and that is for blue.",
        ]

    def test_the_resolved_scenario_has_the_rules_and_no_repetition(self):
        resolved = loaded(GOALS).resolved
        assert not any("repeat_for" in rule for rule in resolved["rules"].values())
        assert load_resolved(resolved).resolved == resolved

    @given(
        rows=st.dictionaries(names, st.fixed_dictionaries({"one": values, "two": st.lists(values, max_size=3)}), min_size=1, max_size=4),
        params=st.dictionaries(st.sampled_from(["p", "q"]), values, min_size=2),
        before=st.booleans(),
    )  # fmt: skip
    def test_it_is_what_it_would_be_written_out_by_hand(self, rows, params, before):
        def rule(this, one, of_param):
            payload = {"this": this, "one": one, "of_param": of_param, "fixed": 7}
            return {
                "triggers": [{"trigger": "half_started"}],
                "actions": [{"action": "emit", "event": "SAID", "payload": payload}],
                "says": "Said.",
            }

        first = {"first": rule("x", 1, 2)} if before else {}
        repeated = {"repeat_for": "rows", **rule({"param": "this"}, {"param": "one"}, {"param": "p"})}
        by_hand = {f"r_{name}": rule(name, row["one"], params["p"]) for name, row in rows.items()}
        text = written({**first, "r": repeated, "last": rule("y", 1, {"param": "q"})}, params, {"rows": rows})
        expected = written({**first, **by_hand, "last": rule("y", 1, params["q"])}, params)
        found = load_text(text, file="a.yaml").resolved
        assert list(found["rules"]) == [*first, *by_hand, "last"]
        assert found == load_text(expected, file="a.yaml").resolved


RINGS = """
tables:
  sides: {west: {x: -0.4, ball: extra_west, home: home_west}, east: {x: 0.4, ball: extra_east, home: home_east}}
  rings: {outer: {radius: 0.3}, inner: {radius: 0.1}}
balls: {extra: {repeat_for: sides, start_m: [{param: x}, 0.2]}}
zones:
  ring: {repeat_for: rings, shape: circle, centre_m: [0, 0], radius_m: {param: radius}}
  target: {repeat_for: [sides, rings], shape: circle, centre_m: [{param: x}, 0], radius_m: {param: radius}}
spots: {home: {repeat_for: sides, x_m: {param: x}, y_m: 0}}
gates: {door: {repeat_for: sides, from_m: [{param: x}, 0], to_m: [{param: x, of: other, times: 0.5}, 0]}}
counters: {hits: {repeat_for: rings, initial: {param: radius}}}
placements:
  out: [{repeat_for: sides, entity: {param: ball}, at: {spot: {param: home, of: other}}}, {entity: ball, at: start}]
broadcast: {fields: {seen: {repeat_for: sides, position_of: {param: ball}}}}
rules:
  hit:
    repeat_for: [sides, rings]
    triggers: [{trigger: enters, entity: extra, zone: ring}]
    actions: [{action: emit, event: HIT, payload: {side: {param: sides}, ring: {param: rings}}}]
    says: "{sides}, {rings}"
expect:
  out:
    repeat_for: sides
    keyframes: [{at_s: 0, place: {ball: [{param: x}, 0]}}]
    lasts_s: 1
"""


class TestEverySection:
    @pytest.fixture
    def rings(self):
        return load_text(HEAD + RINGS).scenario

    def test_balls_zones_and_spots_have_the_values_of_their_rows(self, rings):
        assert [rings.balls[f"extra_{side}"].start_m for side in ("west", "east")] == [(-0.4, 0.2), (0.4, 0.2)]
        assert [rings.zones[f"ring_{ring}"].radius_m for ring in ("outer", "inner")] == [0.3, 0.1]
        assert [rings.spots[f"home_{side}"].x_m for side in ("west", "east")] == [-0.4, 0.4]

    def test_the_written_name_is_the_group_of_the_copies(self, rings):
        assert rings.groups["extra"] == ("extra_west", "extra_east")
        assert Roster.of(rings).expand(rings.rules["hit_west_outer"].triggers[0].zone) == ("ring_outer", "ring_inner")

    def test_tables_are_crossed_and_each_row_is_a_group(self, rings):
        targets = tuple(f"target_{side}_{ring}" for side in ("west", "east") for ring in ("outer", "inner"))
        assert rings.groups["target"] == tuple(one for one in rings.zones if one.startswith("target")) == targets
        assert rings.zones["target_east_inner"].centre_m == (0.4, 0)
        assert rings.groups["target_west"] == ("target_west_outer", "target_west_inner")
        assert rings.groups["target_inner"] == ("target_west_inner", "target_east_inner")
        assert rings.rules["hit_east_outer"].actions[0].payload == {"side": "east", "ring": "outer"}
        assert rings.rules["hit_east_outer"].says == "east, outer"

    def test_a_value_of_the_other_row_of_two_can_be_calculated_with(self, rings):
        assert (rings.gates["door_west"].from_m, rings.gates["door_west"].to_m) == ((-0.4, 0), (0.2, 0))

    def test_counters_tests_layouts_and_broadcasts_are_repeated(self, rings):
        assert [rings.counters[f"hits_{ring}"].initial for ring in ("outer", "inner")] == [0.3, 0.1]
        assert rings.expect["out_east"].keyframes[0].place == {"ball": (0.4, 0)}
        placed = [(one.entity, getattr(one.at, "spot", one.at)) for one in rings.placements["out"]]
        assert placed == [("extra_west", "home_east"), ("extra_east", "home_west"), ("ball", "start")]
        assert list(rings.broadcast.fields) == ["seen_west", "seen_east"]

    def test_a_repeated_counter_of_each_robot_has_two_dimensions(self):
        hits = """
tables:
  rings:
    outer: {radius: 0.3, zone: ring_outer, hits: hits_outer}
    inner: {radius: 0.1, zone: ring_inner, hits: hits_inner}
zones: {ring: {repeat_for: rings, shape: circle, centre_m: [0, 0], radius_m: {param: radius}}}
counters: {hits: {repeat_for: rings, per: robots}}
rules:
  hit:
    repeat_for: rings
    for_each: robots
    triggers: [{trigger: enters, entity: each, zone: {param: zone}}]
    actions: [{action: count, counter: {param: hits}}]
expect:
  counted:
    keyframes: [{at_s: 1, place: {B1: [0.2, 0]}}, {at_s: 2, place: {B1: [0, 0]}}, {at_s: 3, place: {B1: [0.2, 0]}},
                {at_s: 4, place: {B1: [0, 0]}}]
    lasts_s: 5
    counters: {hits_outer: {B1: 1, B2: 0}, hits_inner: {B1: 2, B2: 0}}
"""
        assert run_test(load_text(HEAD + hits), "counted").differences == ()

    def test_the_groups_of_copies_need_no_use(self):
        assert not [one for one in lint(load_text(HEAD + RINGS)) if one.where.path.startswith("groups")]

    def test_the_inline_form_is_an_error_in_version_2(self):
        inline = PAY.replace("for: teams", "for: {yellow: {}}")
        found = [in_short(one) for one in problems_of(load_text, HEAD + inline)]
        assert found == ["wrong-repeat rules.pay.repeat_for"]

    @pytest.mark.parametrize(
        ("old", "new", "problem"),
        [
            ("repeat_for: rings", "repeat_for: rigns", "wrong-repeat zones.ring.repeat_for -> rings"),
            ("{param: x, of: other", "{param: x, of: east", "wrong-param-use gates.door.to_m[0]"),
            ("{param: radius}", "{param: radius, of: another}", "wrong-param-use zones.ring.radius_m"),
            ("sides: {west", "sides: {mid: {x: 0, ball: ball, home: centre}, west", "wrong-param-use gates.door.to_m[0]"),
            ("inner: {radius", "inner: {radios", "wrong-repeat tables.rings.inner.radios -> radius"),
            ("{param: sides}", "{param: this}", "unknown-param rules.hit.actions[0] (emit).payload.side"),
        ],
    )  # fmt: skip
    def test_mistakes_are_reported_where_they_are_written(self, old, new, problem):
        assert old in RINGS
        found = [in_short(one) for one in problems_of(load_text, HEAD + RINGS.replace(old, new, 1))]
        assert problem in [one if "->" in problem else one.split(" ->")[0] for one in found]


class TestVariants:
    """A repeated rule, and its table, are merged as they are written."""

    @pytest.fixture
    def base(self, tmp_path):
        (tmp_path / "base.yaml").write_text(HEAD + GOALS, encoding="utf-8")

        def variant(rest, overrides=()):
            path = tmp_path / "variant.yaml"
            path.write_text("schema_version: 2\nid: b\ntitle: B\nextends: base.yaml\n" + rest, encoding="utf-8")
            return load(path, overrides).scenario.rules

        return variant

    def test_it_is_removed_by_its_name(self, base):
        assert list(base("rules: {goal: null}\n")) == ["before", "after"]

    def test_a_name_is_removed_from_it(self, base):
        assert list(base("tables: {teams: {yellow: null}}\n")) == ["before", "goal_blue", "after"]

    def test_a_name_is_added_to_it(self, base):
        rules = base(
            "tables: {teams: {B1: {zone: in_play, rest: [Y1], worth: 1}}}\nrules: {goal: {actions: [{action: end}]}}\n"
        )
        assert list(rules) == ["before", "goal_yellow", "goal_blue", "goal_B1", "after"]

    def test_a_value_is_changed(self, base):
        rules = base("tables: {teams: {yellow: {worth: 10}}}\n")
        assert [rules[f"goal_{name}"].actions[0].points for name in ("yellow", "blue")] == [21, 7]

    def test_values_are_set_from_the_command_line(self, base):
        rules = base("", ["tables.teams.yellow.worth=5", "rules.goal.says=Goal."])
        assert (rules["goal_yellow"].actions[0].points, rules["goal_blue"].says) == (11, "Goal.")

    def test_an_override_of_one_of_the_rules_leads_to_where_it_is_written(self):
        (problem,) = errors(GOALS, ["rules.goal_yellow.says=x"])
        assert problem.code == "wrong-override"
        assert "'goal'" in problem.help

    def test_a_key_of_a_name_is_added_for_all_or_none(self, base):
        with pytest.raises(ScenarioError, match="'new' is missing, which 'yellow' has"):
            base("tables: {teams: {yellow: {new: 1}}}\n")


class TestMistakes:
    def test_mistake_in_all_repeated_rules_is_reported_once_where_it_is_written(self):
        text = PAY.replace("in_play", "in_plai")
        (problem,) = errors(text)
        column = text.splitlines()[5].index("in_plai") + 1
        assert problem.where == InFile("a.yaml", HEAD_LINES + 6, column, "rules.pay.triggers[0] (enters)")

    def test_an_error_for_one_name_states_the_name(self):
        body = GOALS.replace("zone: yellow_goal", "zone: yellow_gaol")
        assert complaints(body) == ["unknown-name rules.goal_blue.triggers[0] (enters) -> yellow_goal"]

    def test_a_rule_of_the_same_name_is_refused(self):
        more = "  pay_blue: {triggers: [{trigger: half_started}], actions: [{action: end}]}\n"
        (problem,) = errors(PAY + more)
        assert in_short(problem) == "wrong-repeat rules.pay"
        assert f"(line {HEAD_LINES + 9})" in problem.message

    def test_a_list_that_stands_in_many_places_counts_in_each(self):
        triggers = ", ".join(["{trigger: enters, entity: {param: rest}, zone: in_play}"] * 100)
        body = f"triggers: [{triggers}]\n    actions: [{{action: end}}]\n"
        table = f"tables: {{t: {{a: {{rest: [{', '.join(['ball'] * 500)}]}}}}}}\n"
        rule = f"{table}rules:\n  r:\n    repeat_for: t\n    {body}"
        assert complaints(rule) == ["scenario-too-large rules.r"]

    def test_a_value_that_hides_a_param_is_refused(self):
        line = HEAD_LINES + GOALS.count("\n") + 1
        (problem,) = errors(GOALS + "params: {worth: 1}\n")
        assert in_short(problem) == "wrong-repeat tables.teams.yellow.worth"
        assert f"(line {line})" in problem.message


class TestLint:
    def test_warning_about_all_rules_of_a_repeated_one_is_reported_once(self):
        text = PAY.replace("One point for {this}.", "{oops}")
        findings = [finding for finding in lint(loaded(text)) if finding.where.path.startswith("rules")]
        assert findings
        assert len({(one.where.line, one.where.column, one.code) for one in findings}) == len(findings)
        assert all(one.where.path.startswith("rules.pay.") for one in findings)

    def test_misspelt_placeholder_gets_a_suggestion(self):
        (finding,) = [
            one
            for one in lint(loaded(GOALS.replace("in the {zone}", "in the {zoen}")))
            if one.code == "unknown-placeholder"
        ]
        assert finding.where.path == "rules.goal.says"
        assert finding.help.startswith("did you mean 'zone'?")
        assert finding.help.endswith("limit, points, this, teams, zone, rest, worth")

    def test_a_param_in_a_value_is_used(self):
        text = GOALS.replace("worth: 3", "worth: {param: goal_points}") + "params: {goal_points: 4}\n"
        assert not [one for one in lint(loaded(text)) if one.code == "never-used"]


def test_unknown_param_in_rows_with_other_keys_is_reported_once():
    rule = """
tables: {t: {a: {x: 1}, b: {y: 2}}}
rules:
  goal:
    repeat_for: t
    triggers: [{trigger: half_started}]
    actions: [{action: score, entrant: {param: ths}}]
"""
    assert complaints(rule) == [
        "wrong-repeat tables.t.b.y",
        "unknown-param rules.goal.actions[0] (score).entrant -> this",
    ]


def test_a_copy_of_each_row_is_named_in_a_column():
    text = """
tables: {t: {a: {}, b: {}}}
zones: {base: {repeat_for: t, shape: circle, centre_m: [0, 0], radius_m: 0.2}}
rules:
  goal:
    repeat_for: t
    triggers: [{trigger: enters, entity: ball, zone: {param: base}}]
    actions: [{action: end}]
"""
    assert complaints(text) == ["unknown-param rules.goal.triggers[0] (enters).zone"]
    with pytest.raises(ScenarioError) as caught:
        loaded(text)
    assert "base_ROW, in a column" in caught.value.diagnostics[0].help
