"""Lint: who is drawn for the whole match, where the teams keep their sides, is the same team in every half."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

VARIANT = "schema_version: 1\nid: kept\ntitle: Kept\nextends: match\n"


def found(*sections: str) -> list[Finding]:
    return lint(load_text(VARIANT + "".join(f"{section}\n" for section in sections), file="it.yaml"))


def test_a_match_without_changing_sides_lets_the_same_team_begin_twice():
    (finding,) = found("match: {swap_sides: false}")
    assert str(finding) == (
        "it.yaml:5:21: warning: match.swap_sides: draw 'first_kickoff' is drawn once for all 2 halves, and the teams keep "
        "their sides: the same team is drawn in each half; write 'first_kickoff: {keep: half, not_again: match}' under "
        "draws, so that the next half has the other one [same_entrant_in_every_half]"
    )


@pytest.mark.parametrize(
    "sections",
    [
        ["match: {swap_sides: true}"],
        ["match: {swap_sides: false, halves: 1}"],
        ["match: {swap_sides: false}", "draws: {first_kickoff: {keep: half, not_again: match}}"],
        ["match: {swap_sides: false}", "draws: {first_kickoff: {keep: half}}"],
    ],
    ids=["sides are changed", "one half", "the other one next", "drawn in each half"],
)
def test_what_gives_each_team_its_turn_is_in_order(sections):
    assert [finding.kind for finding in found(*sections)] == []


@pytest.mark.parametrize("values", ["[1, 2]", "[blue, yellow, nobody]"])
def test_a_draw_of_something_else_may_last_the_whole_match(values):
    sections = ("match: {swap_sides: false, halves: 2}", f"draws: {{another: {{values: {values}, keep: match}}}}")
    told = [str(one) for one in found(*sections) if one.kind == "same_entrant_in_every_half"]
    assert len(told) == 1
    assert "another" not in told[0]
