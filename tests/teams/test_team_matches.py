"""The sample teams and the programs in other styles, in real matches."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "examples" / "teams"
STYLES = ROOT / "tests" / "programs" / "styles"
DEFAULT_BLUE, DEFAULT_YELLOW = "roles_and_radio", "all_sensors"
STAND = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


@dataclass(frozen=True)
class Played:
    """A match that was played."""

    folder: Path
    result: dict[str, Any]

    def log(self, robot: str) -> str:
        return (self.folder / "logs" / f"{robot}.log").read_text(encoding="utf-8")


Play = Callable[..., Played]


@pytest.fixture
def play_teams(tmp_path) -> Play:
    """Return a function that plays two folders against each other: seconds a half, halves, seed."""

    def run(blue: Path, yellow: Path, half_s: float, halves: int = 2, seed: int = 1, *overrides: str) -> Played:
        loaded = load("match", [f"match.half_s={half_s}", f"match.halves={halves}", *overrides])
        seats = tuple(loaded.scenario.entrants.values())
        teams = {"blue": open_team(blue, *seats), "yellow": open_team(yellow, *seats)}
        played = play_match(MatchPlan(loaded, teams, {}, seed=seed, out=tmp_path / "runs"))
        return Played(played.folder, played.result)

    return run


@pytest.fixture
def idle_team(tmp_path) -> Path:
    folder = tmp_path / "idle"
    folder.mkdir()
    (folder / "robot.py").write_text(STAND, encoding="utf-8")
    return folder


@pytest.mark.parametrize(
    ("blue", "yellow"), [("ball_chaser", "all_sensors"), ("roles_and_radio", "ball_chaser")], ids=lambda name: name
)
def test_sample_teams_play_both_colours_without_a_fault(play_teams, blue, yellow):
    played = play_teams(SAMPLES / blue, SAMPLES / yellow, half_s=4)
    assert played.result["complete"]
    assert played.result["faults"] == []
    # Sample teams print nothing: what stands in a log would be a warning.
    assert all("rror" not in played.log(robot) for robot in ("B1", "B2", "B3", "Y1", "Y2", "Y3"))


def test_programs_of_2022_and_2023_play_together(play_teams):
    played = play_teams(STYLES / "style_2022", STYLES / "style_2023", half_s=5)
    assert played.result["faults"] == []
    log = played.log("B2")
    assert "Größenwahn" in played.result["entrants"]["blue"]["name"]
    assert "Ende für B2" in log
    assert "Höhe" in log or "kein Ball…" in log
    # It prints time, heading, free room and the wheel's angle: the wheel turned, so its properties reach the motor.
    # In the second half the other team drives Y1.
    _, first_half, _ = played.log("Y1").split("--- half")
    wheel_angles = {line.split()[3] for line in first_half.splitlines()[1:]}
    assert len(wheel_angles) > 10


def test_a_program_of_2023_plays_with_text_messages_too(play_teams):
    played = play_teams(STYLES / "style_2023", STYLES / "style_2023", 3, 1, 1, "kits.v2.messages=v2.2")
    assert played.result["faults"] == []


def test_the_program_of_2022_is_as_it_would_be_handed_in():
    program = STYLES / "style_2022" / "rcj_soccer_team_blue" / "rcj_soccer_team_blue.py"
    data = program.read_bytes()
    assert data.count(b"\r\n") == data.count(b"\n") > 50
    assert not data.isascii()
    assert (STYLES / "style_2022" / "team_name.txt").read_bytes().startswith(b"\xef\xbb\xbf")


def programs_in(document: Path) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```$", document.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_the_programs_in_the_documents_play(play_teams, tmp_path):
    programs = [*programs_in(ROOT / "docs" / "programs.md"), *programs_in(ROOT / "docs" / "first-ten-minutes.md")]
    assert len(programs) >= 6
    said = ""
    for first in range(0, len(programs), 2):
        teams = []
        # Two copies of one program are a team: what one of them says by radio is for its like.
        for program in [*programs[first:], *programs][:2]:
            teams.append(tmp_path / f"team{first + len(teams)}")
            entry = teams[-1] / "rcj_soccer_team_blue" / "rcj_soccer_team_blue.py"
            entry.parent.mkdir(parents=True)
            entry.write_text(program, encoding="utf-8")
        two = ("entrants.blue.robots.B3=null", "entrants.yellow.robots.Y3=null")
        played = play_teams(*teams, 4, 1, 1, *two)
        assert played.result["faults"] == []
        said += "".join(played.log(robot) for robot in ("B1", "B2", "Y1", "Y2"))
    assert "I am at (" in said
    assert "to the left" in said or "I do not see the ball" in said


@pytest.mark.nightly
@pytest.mark.parametrize(("blue", "yellow"), [("style_2022", "style_2023"), ("style_2023", "style_2022")])
def test_programs_of_2022_and_2023_play_a_whole_half(play_teams, blue, yellow):
    played = play_teams(STYLES / blue, STYLES / yellow, half_s=600, halves=1)
    assert played.result["complete"]
    assert played.result["faults"] == []


@pytest.mark.nightly
@pytest.mark.parametrize("seed", range(1, 6))
def test_the_default_match_is_a_game(play_teams, seed):
    played = play_teams(SAMPLES / DEFAULT_BLUE, SAMPLES / DEFAULT_YELLOW, half_s=600, seed=seed)
    goals = played.result["score"]
    assert min(goals.values()) >= 1
    assert 2 <= sum(goals.values()) <= 60
    assert played.result["faults"] == []


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["ball_chaser", "roles_and_radio", "all_sensors"])
def test_a_sample_team_without_opponents_scores_for_itself_only(play_teams, idle_team, name):
    played = play_teams(SAMPLES / name, idle_team, half_s=120)
    assert played.result["score"]["blue"] >= 2
    assert played.result["score"]["yellow"] == 0
