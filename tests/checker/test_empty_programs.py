"""Files without a program in them that stand where one is looked for: what is said of those beside them."""

from __future__ import annotations

from pathlib import Path

from rcj_challenges.checker.archives import inspect
from rcj_challenges.scenario.load import load
from tests.hostile.archives.making import plain

MATCH = load("match").scenario
ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
PROGRAM = b"from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"
OF_2021 = {f"robot{number}/robot{number}.py": PROGRAM for number in (1, 2, 3)}
YELLOW = "rcj_soccer_team_yellow/rcj_soccer_team_yellow.py"


def layout(tmp_path: Path, files: dict[str, bytes]) -> dict[str, str]:
    """What is said of a submission's layout, by the codes of the findings, and what to do."""
    path = tmp_path / "team.zip"
    path.write_bytes(plain(files | {"team_name.txt": b"Cats"}))
    return {one.code: one.remedy for one in inspect(path, MATCH).stages[1].findings if one.level != "passed"}


def test_programs_that_robots_are_started_with_once_an_empty_one_is_deleted_are_not_to_be_deleted_too(
    tmp_path: Path,
) -> None:
    assert layout(tmp_path, {ENTRY: b"", **OF_2021}) == {"layout.empty_entry": "delete it"}


def test_where_the_empty_one_is_to_be_filled_those_beside_it_are_told(tmp_path: Path) -> None:
    said = layout(tmp_path, {ENTRY: b"", YELLOW: PROGRAM})
    assert said["layout.empty_entry"] == "put the program into it"
    assert "put what it does into the program that is started" in said["layout.never_started"]
