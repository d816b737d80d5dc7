"""The sample teams of the match understand the packets of every tournament since 2022, and play the same with each."""

from __future__ import annotations

from pathlib import Path

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team

SAMPLES = Path(__file__).resolve().parents[2] / "examples" / "teams"


def played(out: Path, blue: str, yellow: str, *overrides: str) -> tuple[list[object], bytes]:
    """Play 3 s; return the faults, and every pose of the match."""
    loaded = load("match", ["match.half_s=3", "match.halves=1", *overrides])
    seats = tuple(loaded.scenario.entrants.values())
    teams = {"blue": open_team(SAMPLES / blue, *seats), "yellow": open_team(SAMPLES / yellow, *seats)}
    match = play_match(MatchPlan(loaded, teams, {}, seed=3, out=out))
    return match.result["faults"], (match.folder / "trajectory.chunks").read_bytes()


@pytest.mark.parametrize(
    ("blue", "yellow"),
    [pytest.param("ball_chaser", "all_sensors", marks=pytest.mark.nightly), ("roles_and_radio", "ball_chaser")],
)
def test_sample_teams_do_the_same_whether_packets_are_bytes_or_text(tmp_path, blue, yellow):
    bytes_faults, bytes_poses = played(tmp_path / "v21", blue, yellow)
    text_faults, text_poses = played(tmp_path / "v22", blue, yellow, "kits.v2.messages=v2.2")
    assert (bytes_faults, text_faults) == ([], [])
    assert bytes_poses == text_poses


def test_a_sample_team_passes_over_what_a_scenario_broadcasts(tmp_path):
    faults, _ = played(tmp_path, "ball_chaser", "all_sensors", "broadcast={fields: {bonus: 3}}")
    assert faults == []
