"""What programs print is scaled up from a short match to a half, and compared with what they may print."""

from __future__ import annotations

import zipfile

import pytest

from rcj_challenges.checker.check import CheckOptions, check_file
from tests.checker.alone import alone

pytestmark = pytest.mark.usefixtures("sources_read_here")

BEGIN = """\
from controller import Robot
robot = Robot()
for name in ("left wheel motor", "right wheel motor"):
    robot.getDevice(name).setPosition(float("inf"))
"""
LOOP = "while robot.step(32) != -1:\n"


@pytest.mark.parametrize(
    ("program", "overrides", "level"),
    [
        (BEGIN + LOOP + '    print("x" * 2500)\n', (), "warning"),
        (BEGIN + LOOP + '    print("x" * 4500)\n', (), "error"),
        (BEGIN + LOOP + '    print("x" * 500)\n', (), None),
        (BEGIN + LOOP + '    print("x" * 4500)\n', ("match.half_s=60",), None),
        (BEGIN + 'print("x" * 3_000_000)\n' + LOOP + '    print("ordinary", robot.getTime())\n', (), None),
    ],
    ids=["would be stopped late", "would be stopped early", "little", "a short half", "much at the start only"],
)
def test_program_that_would_print_too_much_in_a_half_is_reported(tmp_path, program, overrides, level):
    path = tmp_path / "team.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("rcj_soccer_team_blue/rcj_soccer_team_blue.py", program)
    report = check_file(path, alone(*overrides), CheckOptions(play_s=4.2))
    found = [finding for finding in report.stages[-1].findings if finding.code == "play.prints_much"]
    assert [(one.level, one.where) for one in found] == ([] if level is None else [(level, "B1")])
    assert (report.level == "error") == (level == "error")
