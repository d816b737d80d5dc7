"""The match for programs of 2021: positions come in a packet, and each robot has an entry point of its own."""

from pathlib import Path

import pytest

SAMPLE = Path(__file__).parents[2] / "examples" / "teams" / "match_2021"
STANDS = "from controller import Robot\nrobot = Robot()\nwhile robot.step(64) != -1:\n    pass\n"
PROGRAM = """
import struct
from controller import Robot

class Player:
    def __init__(self):
        self.robot = Robot()
        self.receiver = self.robot.getReceiver("receiver")
        self.receiver.enable(64)
        self.motors = [self.robot.getMotor(side + " wheel motor") for side in ("left", "right")]
        for motor in self.motors:
            motor.setPosition(float("+inf"))
            motor.setVelocity(0.0)

    def run(self):
        while self.robot.step(64) != -1:
            while self.receiver.getQueueLength() > 0:
                packet = self.receiver.getData()
                self.numbers = struct.unpack("ddd" * 6 + "dd?", packet)
                self.receiver.nextPacket()
            for motor in self.motors:
                motor.setVelocity(-5)
        print("%.2f" % self.numbers[0], len(packet))

Player().run()
"""

READS_WITHIN_A_STEP = """
from controller import Robot
robot = Robot()
receiver = robot.getDevice("receiver")
receiver.enable(64)
while True:
    robot.stepBegin(64)
    receiver.getData()
    robot.stepEnd()
"""
READS_AT_ONCE = """
import struct
from controller import Robot
robot = Robot()
receiver = robot.getDevice("receiver")
receiver.enable(64)
while robot.step(64) != -1:
    packet = receiver.getData()
    receiver.nextPacket()
    print(robot.getTime(), receiver.getQueueLength(), len(packet))
"""
ASKS_AND_READS_TOO_OFTEN = """
from controller import Robot
robot = Robot()
receiver = robot.getReceiver("receiver")
receiver.enable(64)
robot.step(64)
print("first", receiver.getQueueLength())
robot.step(64)
receiver.getData()
receiver.nextPacket()
receiver.getData()
"""


def test_programs_of_2021_play_a_match(play, team_folder):
    run = play("match.half_s=2", scenario="match_2021", blue=team_folder(PROGRAM), yellow=team_folder(PROGRAM))
    assert run.result["faults"] == []
    start, end = (
        run.trajectory.halves[0].start.substeps[0],
        list(run.trajectory.halves[0].snapshots())[-1].substeps[-1],
    )
    assert end[0][1] < start[0][1] - 0.15  # B1 looks at the yellow goal, and negative velocities drive forward
    along_the_field, size = run.log("B1").split()[-2:]
    assert abs(float(along_the_field) - end[0][1]) < 0.03  # the packet's X is our y
    assert size == "161"


@pytest.mark.parametrize("colour", ["blue", "yellow"])
def test_the_sample_team_of_2021_pushes_the_ball_towards_the_other_goal(play, team_folder, colour):
    teams = {"blue": team_folder(STANDS), "yellow": team_folder(STANDS)} | {colour: SAMPLE}
    # Later the ball may have come back from a robot that stands in its way.
    run = play("match.half_s=8", "match.halves=1", scenario="match_2021", **teams)
    assert run.result["faults"] == []
    goals = {entrant: score for entrant, score in run.result["score"].items() if score}
    ball = run.trajectory.halves[0].substeps[:, -1, 6, 1]
    # Blue attacks the yellow goal, at negative y.
    assert list(goals) in ([], [colour])
    assert max(ball * (-1 if colour == "blue" else 1)) > 0.25
    assert max(ball * (1 if colour == "blue" else -1)) < 0.3


def test_a_program_of_2021_that_reads_without_asking_waits_for_the_first_packet(play, team_folder):
    run = play(
        "match.half_s=1", "match.halves=1", scenario="match_2021", blue=team_folder(READS_AT_ONCE),
        yellow=team_folder(ASKS_AND_READS_TOO_OFTEN, READS_WITHIN_A_STEP),
    )  # fmt: skip
    warning, *read = [line for line in run.log("B1").splitlines() if not line.startswith("--- half")]
    assert warning.startswith("Warning: 'receiver': getData was called before the first packet was there")
    assert read[:3] == ["0.128 0 161", "0.192 0 161", "0.256 0 161"]
    assert {fault["robot"] for fault in run.result["faults"]} == {"Y1", "Y2", "Y3"}
    assert "first 0" in run.log("Y1")
    assert "getData was called with an empty queue" in run.log("Y1")
    # Between stepBegin and stepEnd no time can pass until the first packet.
    assert "getData was called with an empty queue" in run.log("Y2")
    assert "waits for it" not in run.log("Y2")
    assert "step was called between" not in run.log("Y2")
