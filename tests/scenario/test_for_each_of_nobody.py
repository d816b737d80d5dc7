"""A rule for each of a group that has no members: it never fires, which is said, and its sheet can be read."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.views.sheet import sheet_markdown
from tests.scenario.writing import loaded

NOBODY = "'{group}' has no members here: the rule never fires"


def each_of(group: str, more: str = ""):
    rule = "triggers: [{trigger: half_started}], actions: [{action: score, entrant: yellow}]"
    says = "{each} and {entity} of {team}."
    return loaded(f'{more}rules:\n  r: {{for_each: {group}, {rule}, says: "{says}"}}\n')


@pytest.mark.parametrize(
    ("group", "more"),
    [("obstacles", ""), ("balls", "balls: {ball: null}\n"), ("crates", "groups: {crates: [obstacles]}\n")],
)
def test_lint_says_that_it_never_fires(group, more):
    found = [one for one in lint(each_of(group, more)) if one.kind == "each_of_nobody"]
    assert [one.problem.message for one in found] == [NOBODY.format(group=group)]
    assert [one.problem.path for one in found] == ["rules.r.for_each"]


@pytest.mark.parametrize(
    ("group", "more"),
    [("obstacles", ""), ("crates", "groups: {crates: [obstacles]}\n")],
)
def test_its_sheet_names_the_group(group, more):
    found = each_of(group, more)
    assert f"The {group} and the one concerned." in sheet_markdown(found.scenario, found.roster)


def test_of_a_group_with_members_nothing_is_said():
    crate = "obstacles: {crate: {shape: cylinder, radius_m: 0.05, centre_m: [0, 0.15], movable: true}}\n"
    assert "each_of_nobody" not in {one.kind for one in lint(each_of("obstacles", crate))}
