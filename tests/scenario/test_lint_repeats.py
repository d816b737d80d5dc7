"""Lint of what comes too seldom or tells nothing apart: a rest that is as long as a repeat, one time for all, names."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.trials import try_expectation
from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD

SCORE = "actions: [{action: score, entrant: %s, points: 1}], says: So."
TIMES = "{trigger: time_reached, at_s: 2, every_s: %s}"
TOUCHES = "{trigger: touches, entity: Y1, other: ball, every_s: %s}"
HOLDS = "{trigger: holds, condition: {condition: in_zone, entity: Y1, zone: blue_goal}, for_s: 1, every_s: %s}"


def found(body: str, kind: str):
    return [one for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind == kind]


def repeated(trigger: str, cooldown: str) -> str:
    return f"rules: {{r: {{cooldown_s: {cooldown}, triggers: [{trigger}], {SCORE % 'yellow'}}}}}\n"


class TestARestAsLongAsARepeat:
    KIND = "cooldown_as_long_as_every_s"

    @pytest.mark.parametrize("trigger", [TIMES, TOUCHES, HOLDS])
    @pytest.mark.parametrize(
        ("every", "cooldown", "lost"),
        [
            ("1", "1", True),
            ("0.2", "0.2", True),
            ("1", "0.995", True),  # 32 ticks, and some repeats come after 31
            ("0.96", "0.96", False),  # 30 ticks each: no repeat comes sooner
            ("1", "0.9", False),
            ("0.2", "2", False),  # meant: at most every 2 s as long as they touch
        ],
    )
    def test_it_is_reported_if_repeats_are_lost(self, trigger, every, cooldown, lost):
        findings = found(repeated(trigger % every, cooldown), self.KIND)
        assert len(findings) == lost
        assert all("rules.r" in str(one) and "leave cooldown_s out" in str(one) for one in findings)

    @pytest.mark.parametrize(("cooldown", "points"), [("1", 3), ("0.9", 5)])
    def test_it_is_so_in_play(self, cooldown, points):
        test = "{keyframes: [{at_s: 1, touch: [[Y1, ball]], touch_lasts_s: 4.5}], lasts_s: 8, score: {yellow: %d}}"
        body = repeated(TOUCHES % "1", cooldown) + f"expect: {{t: {test % points}}}\n"
        assert try_expectation(load_text(HEAD + body), "t").differences == ()

    def test_without_a_repeat_nothing_is_lost(self):
        assert not found(repeated("{trigger: touches, entity: Y1, other: ball}", "1"), self.KIND)


class TestOneTimeForAll:
    KIND = "criterion_always_equal"
    RULES = f"rules: {{r: {{triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}], {SCORE % 'yellow'}}}}}\n"
    COUNTED = (
        "counters: {n: {per: robots}}\n"
        "rules: {r: {for_each: robots, triggers: [{trigger: touches, entity: each, other: walls}], "
        "actions: [{action: count, counter: n, entity: each}], says: So.}}\n"
    )

    def test_two_who_play_at_the_same_time_have_one_time(self):
        findings = found("result: {rank: [{score: descending}, {time: ascending}]}\n" + self.RULES, self.KIND)
        assert ["result.rank[1]" in str(one) and "{word: measured}" in str(one) for one in findings] == [True]

    def test_one_alone_is_compared_with_others(self):
        alone = "robots: {B1: null, B2: null, B3: null}\nentrants: {blue: null}\n"
        assert not found(f"{alone}result: {{rank: [{{time: ascending}}]}}\n{self.RULES}", self.KIND)

    def test_penalties_of_their_own_tell_them_apart(self):
        rank = "result: {rank: [{time: ascending, plus: [{counter: n, weight: 2}]}]}\n"
        assert not found(rank + self.COUNTED, self.KIND)


class TestNamesWithoutUse:
    RULE = (
        "rules: {r: {triggers: [{trigger: half_started}], actions: [%s, {action: score, entrant: blue}], says: So.}}\n"
    )
    PLACE = "{action: place, entity: ball, at: {%s}}"

    @pytest.mark.parametrize(
        ("body", "action", "kinds"),
        [
            ("spots: {bull: {x_m: 0, y_m: 0.3}}", "spot: centre", ["spot_never_used"]),
            ("spots: {bull: {x_m: 0, y_m: 0.3}}", "spot: bull", []),
            ("spots: {bull: {x_m: 0, y_m: 0.3}}\ngroups: {marks: [bull]}", "choice: [marks]", []),
            ("spots: {bull: {x_m: 0, y_m: 0.3}}\ngroups: {marks: [bull]}", "spot: bull", ["group_never_used"]),
            ("spots: {bull: {x_m: 0, y_m: 0.3}}\ndraws: {d: {values: [bull, centre]}}", "spot: d", []),
            ("groups: {mine: [Y1, Y2]}", "spot: centre", ["group_never_used"]),
            ("groups: {mine: [Y1, Y2]}\ncounters: {n: {per: mine}}", "spot: centre", []),
        ],
    )
    def test_a_spot_or_group_of_ones_own_that_nothing_names(self, body, action, kinds):
        text = f"{body}\n{self.RULE % (self.PLACE % action)}"
        told = [one.kind for one in lint(load_text(HEAD + text, file="a.yaml"))]
        assert [kind for kind in told if kind in ("spot_never_used", "group_never_used")] == kinds

    def test_those_of_the_preset_are_not_the_authors_to_tidy_up(self):
        assert not found(self.RULE % (self.PLACE % "spot: centre"), "spot_never_used")
