"""The match for programs of 2021: who is where comes in a packet, and each robot has an entry point of its own."""

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


def test_programs_of_2021_play_a_match(play, team_folder):
    run = play("match.half_s=2", scenario="match_2021", blue=team_folder(PROGRAM), yellow=team_folder(PROGRAM))
    assert run.result["faults"] == []
    start, end = (run.trajectory.halves[0].start.substeps[0], list(run.trajectory.snapshots(1))[-1].substeps[-1])
    assert end[0][1] < start[0][1] - 0.15  # B1 looks at the yellow goal, and negative velocities drive forward
    along_the_field, size = run.log("B1").split()[-2:]
    assert abs(float(along_the_field) - end[0][1]) < 0.03  # the packet's X is our y
    assert size == "161"
