"""A short match as commands are given it."""

from pathlib import Path

import pytest

STAND = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"
ONE_ROBOT = [f"--set=entrants.{seat}.robots.{seat[0].upper()}{n}=null" for seat in ("blue", "yellow") for n in (2, 3)]


@pytest.fixture
def duel(tmp_path: Path) -> list[str]:
    """The scenario and teams of a half of one robot against another, for ``run`` and ``simulate``."""
    team = tmp_path / "team.py"
    team.write_text(STAND, encoding="utf-8")
    return ["match", "--blue", str(team), "--yellow", str(team), "--halves=1", *ONE_ROBOT]
