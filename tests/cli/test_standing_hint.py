"""``run`` says of robots that never set off what ``check`` says of them."""

import json

import pytest

from rcj_challenges.core.play import Placement, RefereeOutput, Snapshot
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.match.motionless import WATCHED_S, MotionlessObserver
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.roster import Roster
from tests.cli.conftest import ONE_ROBOT
from tests.cli.in_this_process import here

WITHOUT_POSITION = """\
from controller import Robot
robot = Robot()
motors = [robot.getDevice(name) for name in ("left wheel motor", "right wheel motor")]
while robot.step(32) != -1:
    for motor in motors:
        motor.setVelocity(5)
"""
MATCH = load("match").scenario
TICKS = ticks_from_s(WATCHED_S) + 1


def standing_after(move):
    """Return the robots standing still after a half in which ``move(tick)`` gives the pose of B1, and a placement of it or none."""
    observer, roster = MotionlessObserver(MATCH), Roster.of(MATCH)
    observer.half_started(half_of(MATCH))
    for tick in range(TICKS):
        pose, placed = move(tick)
        poses = [(0.1 * number, 0.0, 0.0) for number in range(len(roster.entities))]
        poses[roster.index["B1"]] = pose
        placements = (Placement(roster.index["B1"], *placed),) if placed else ()
        observer.after_tick(Snapshot(tick, [poses], [], [], ()), RefereeOutput(placements=placements))
    return observer.robots()


@pytest.mark.parametrize(
    ("move", "stands"),
    [
        (lambda _: ((0.0, 0.0, 0.0), None), True),
        (lambda tick: ((0.001 * tick, 0.0, 0.0), None), False),
        (lambda tick: ((0.0, 0.0, 0.01 * tick), None), False),
        (lambda tick: ((0.0, 0.0, 0.0) if tick < 9 else (0.5, 0.0, 1.0), (0.5, 0.0, 1.0) if tick == 8 else None), True),
    ],
    ids=["stands", "drives", "turns", "is put elsewhere"],
)
def test_robot_that_neither_drives_nor_turns_is_motionless(move, stands):
    assert ("B1" in standing_after(move)) == stands


def test_a_half_that_is_too_short_reports_nothing():
    observer = MotionlessObserver(MATCH)
    observer.half_started(half_of(MATCH))
    assert observer.robots() == []


def without(line, instead):
    return WITHOUT_POSITION.replace(line, instead)


@pytest.mark.parametrize(
    ("program", "named"),
    [
        (WITHOUT_POSITION, "setPosition"),
        (without("left wheel", "left_wheel").replace("in motors:", "in filter(None, motors):"), '"left wheel motor"'),
        (
            without("    for motor in motors:", "    try:").replace("motor.set", "gone.set") + "    except: pass\n",
            "line 7",
        ),
    ],
    ids=["no setPosition", "no such device", "hidden error"],
)
def test_hint_for_a_robot_that_never_moves_names_the_reason(tmp_path, monkeypatch, capsys, program, named):
    (tmp_path / "team.py").write_text(program, encoding="utf-8")
    teams = ("--blue", "team.py", "--yellow", "team.py")
    match = ["run", "match", *teams, "--duration", "11", "--halves", "1", *ONE_ROBOT]
    assert here(monkeypatch, tmp_path, *match, "--no-replay", "--json") == 0
    result = json.loads(capsys.readouterr().out)
    (hint,) = result["hints"]
    assert sorted(hint["robots"]) == ["B1", "Y1"]
    assert named in hint["help"]
    (log,) = tmp_path.glob("runs/*/logs/B1.log")
    assert f"hint: {hint['help']}\n" in log.read_text("utf-8")
