"""Lint of `repeat_for`: a value beside the names that nothing uses, and a rule that does the same each time."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load, load_text
from tests.scenario.writing import HEAD

KINDS = ("repeated_in_vain", "repeated_value_never_used")


def found(body: str) -> list[str]:
    return [str(one) for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind in KINDS]


def rule(repeat_for: str, points: str, says: str = "So.", entrant: str = "yellow") -> str:
    return (
        f"rules:\n  r:\n    repeat_for: {repeat_for}\n    triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}]\n"
        f"    actions: [{{action: score, entrant: {entrant}, points: {points}}}]\n    says: '{says}'\n"
    )


class TestAValueThatNothingUses:
    def test_it_is_told_once_under_the_rule_as_it_is_written(self):
        (warning,) = found(rule("{yellow: {a: 1, b: 2}, blue: {a: 3, b: 4}}", "{param: a}"))
        assert warning == (
            "a.yaml:6:3: warning: rules.r: 'b' stands beside the names in repeat_for, and nothing in the rule uses it; "
            "write {param: b} where the value belongs, or remove it from repeat_for [repeated_value_never_used]"
        )

    def test_of_several_all_are_named(self):
        (warning,) = found(rule("{yellow: {a: 1, b: 2, c: 3}}", "{param: a}"))
        assert "b, c stand beside the names in repeat_for, and nothing in the rule uses them" in warning

    @pytest.mark.parametrize(
        ("points", "says"),
        [("{param: a, times: 2}", "So."), ("[1, {param: a}]", "So."), ("1", "It is {a}, for {this}.")],
    )
    def test_wherever_it_stands_it_is_used(self, points, says):
        assert found(rule("{yellow: {a: 1}, blue: {a: 3}}", points, says)) == []

    def test_the_name_alone_need_not_be_used(self):
        assert found(rule("{first: {a: 1}, second: {a: 3}}", "{param: a}")) == []

    def test_a_blank_that_is_filled_in_when_the_rule_fires_is_no_use_of_it(self):
        (warning,) = found(rule("{yellow: {entity: 1}}", "1", "{entity} for {this}."))
        assert "'entity' stands" in warning


class TestARuleThatIsRepeatedInVain:
    @pytest.mark.parametrize("repeat_for", ["[yellow, blue]", "{yellow: {a: 1}, blue: {a: 2}}"])
    def test_where_nothing_differs_it_does_the_same_each_time(self, repeat_for):
        (warning,) = found(rule(repeat_for, "1"))
        assert warning == (
            "a.yaml:6:3: warning: rules.r: it is repeated, and nothing in it differs from one time to the next: all do "
            "the same; write {param: this} where the name belongs, or leave repeat_for out [repeated_in_vain]"
        )

    def test_the_name_is_enough(self):
        assert found(rule("[yellow, blue]", "1", entrant="{param: this}")) == []
        assert found(rule("[yellow, blue]", "1", says="Points for {this}.")) == []


@pytest.mark.parametrize(
    ("first_phase", "told"), [("show_1", " (tell_second, tell_third)"), ("play", "")], ids=["some", "all"]
)
def test_what_is_wrong_with_some_of_the_rules_names_them(first_phase, told):
    phases = "phases: {show_1: {lasts_s: 1, next: show_2}, show_2: {lasts_s: 1, next: show_3}, show_3: {lasts_s: 1}}\n"
    rules = (
        "rules:\n  tell:\n    repeat_for: {first: {phase: show_1}, second: {phase: show_2}, third: {phase: show_3}}\n"
        "    phases: [{param: phase}]\n"
        "    triggers: [{trigger: half_started}, {trigger: phase_entered, phase: {param: phase}}]\n"
        "    actions: [{action: emit, event: TOLD, payload: {which: {param: this}}}]\n    says: 'Told: {this}.'\n"
        "  start: {triggers: [{trigger: time_reached, at_s: 5}], actions: [{action: set_phase, phase: show_1}]}\n"
    )
    text = f"{HEAD}first_phase: {first_phase}\n{phases}{rules}"
    (warning,) = [str(one) for one in lint(load_text(text, file="a.yaml")) if one.kind == "rule_never_fires"]
    assert f"a half starts in phase '{first_phase}', in which this rule does not live{told}; " in warning


def test_what_a_base_brought_is_not_the_authors_to_tidy_up(tmp_path):
    (tmp_path / "base.yaml").write_text(HEAD + rule("{yellow: {a: 1}}", "1", "For {this}."), encoding="utf-8")
    (tmp_path / "own.yaml").write_text(HEAD.replace("soccersim_v2", "base.yaml"), encoding="utf-8")
    assert not [one for one in lint(load(tmp_path / "own.yaml")) if one.kind in KINDS]
    assert [one.kind for one in lint(load(tmp_path / "base.yaml")) if one.kind in KINDS] == [KINDS[1]]
