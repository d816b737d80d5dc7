"""Lint of rules and counters for each of a group of groups: they are for each member, and not for each group."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD

ZONES = (
    "zones:\n" + "".join(f"  {name}: {{shape: circle, centre_m: [{x}, 0], radius_m: 0.05}}\n"
                         for name, x in (("west", -0.3), ("middle", 0), ("east", 0.3)))
    + "groups:\n  left: [west, middle]\n  right: [middle, east]\n  outer: [east]\n  lines: [left, right]\n"
    "  cells: [left, outer]\n  few: [west, east]\n"
)  # fmt: skip
RULE = (
    "rules:\n  r:\n    for_each: %s\n    triggers: [{trigger: enters, entity: Y1, zone: each}]\n"
    "    actions: [{action: score, entrant: yellow}]\n    says: So.\n"
)


def found(body: str) -> list[str]:
    return [
        str(one)
        for one in lint(load_text(HEAD + ZONES + body, file="a.yaml"))
        if one.kind == "each_of_a_group_of_groups"
    ]


class TestEachOfAGroupOfGroups:
    def test_a_rule_over_groups_that_share_a_member_is_told(self):
        (warning,) = found(RULE % "lines")
        assert warning.endswith(
            "rules.r.for_each: 'lines' is made of groups, and the rule is there for each of their members, not for each "
            "of the groups ('middle' is in several); a rule for each group is repeat_for: [left, right], where "
            "{param: this} is the group; or name a group without repeats [each_of_a_group_of_groups]"
        )

    @pytest.mark.parametrize("section", ["counters", "flags", "timers"])
    def test_so_is_what_is_kept_for_each(self, section):
        lasts = ", lasts_s: 3" if section == "timers" else ""
        (warning,) = found(f"{section}: {{n: {{per: lines{lasts}}}}}\n")
        assert f"{section}.n.per: 'lines' is made of groups, and there is one for each of their members" in warning
        assert "; give each of left, right one of its own; or name" in warning

    @pytest.mark.parametrize("group", ["cells", "few", "left"])
    def test_groups_that_share_nobody_are_a_way_to_write_a_large_one(self, group):
        assert found(RULE % group) == []
