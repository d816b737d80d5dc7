"""Teams that keep their sides: who kicks off in the second half is what the file says, and it can say the other team."""

from pathlib import Path

import pytest

from rcj_challenges.controllers.team import open_team
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load_text

KEPT = """
schema_version: 1
id: kept
title: Sides are kept
extends: match
match: {swap_sides: false, half_s: 0.032}
robots: {B1: {idle: true}, B2: {idle: true}, Y1: {idle: true}, Y2: {idle: true}}
entrants: {blue: {robots: {B1: null, B2: null}}, yellow: {robots: {Y1: null, Y2: null}}}
"""
OTHER_NEXT = "draws: {first_kickoff: {keep: half, not_again: match}}\n"
STAND = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


def who_kicks_off(folder: Path, text: str, seed: int) -> list[str]:
    (folder / "team.py").write_text(STAND, encoding="utf-8")
    loaded = load_text(text)
    teams = {seat: open_team(folder / "team.py", entrant) for seat, entrant in loaded.scenario.entrants.items()}
    played = play_match(MatchPlan(loaded, teams, {}, seed=seed, out=folder))
    for team in teams.values():
        team.close()
    return [event["payload"]["team_name"] for event in played.result["events"] if event["event"] == "KICKOFF"]


@pytest.mark.parametrize("seed", [1, pytest.param(3, marks=pytest.mark.nightly)])
def test_the_other_team_begins_the_second_half_if_it_is_asked_for(tmp_path, seed):
    first, second = who_kicks_off(tmp_path, KEPT + OTHER_NEXT, seed)
    assert {first, second} == {"B", "Y"}


def test_what_is_drawn_for_the_match_stays_what_it_is(tmp_path):
    """`keep: match` means the seat; lint warns of it (tests/scenario/test_lint_sides.py)."""
    first, second = who_kicks_off(tmp_path, KEPT, 1)
    assert first == second
