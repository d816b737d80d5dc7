import json
import math

from controller import Robot

TIME_STEP = 32


class Player:
    """R2023a: properties instead of get and set."""

    def __init__(self):
        self.robot = Robot()
        self.name = self.robot.name
        self.step_ms = int(self.robot.basic_time_step)

        self.supervisor = self.robot.getDevice("supervisor receiver")
        self.supervisor.enable(self.step_ms)
        self.team_in = self.robot.getDevice("team receiver")
        self.team_in.enable(self.step_ms)
        self.team_out = self.robot.getDevice("team emitter")
        self.ball_receiver = self.robot.getDevice("ball receiver")
        self.ball_receiver.enable(self.step_ms)
        self.gps = self.robot.getDevice("gps")
        self.gps.enable(self.step_ms)
        self.compass = self.robot.getDevice("compass")
        self.compass.enable(self.step_ms)
        self.sonars = []
        for side in ("front", "left", "back", "right"):
            sonar = self.robot.getDevice(f"distancesensor {side}")
            sonar.enable(self.step_ms)
            self.sonars.append(sonar)
        self.wheel = self.robot.getDevice("left wheel sensor")
        self.wheel.enable(self.step_ms)

        self.left = self.robot.getDevice("left wheel motor")
        self.right = self.robot.getDevice("right wheel motor")
        self.left.target_position = float("inf")
        self.right.target_position = float("inf")
        self.left.velocity = 0.0
        self.right.velocity = 0.0
        self.waiting = False

    def supervisor_says(self):
        while self.supervisor.queue_length > 0:
            text = self.supervisor.getString()
            try:
                self.waiting = json.loads(text)["waiting_for_kickoff"]
            except ValueError:
                self.waiting = text == "\x01"
            self.supervisor.nextPacket()

    def ball(self):
        found = None
        while self.ball_receiver.queue_length > 0:
            direction = self.ball_receiver.emitter_direction
            strength = self.ball_receiver.signal_strength
            found = math.atan2(direction[1], direction[0]), 1 / math.sqrt(strength)
            self.ball_receiver.nextPacket()
        return found

    def talk(self, ball):
        x, y, _ = self.gps.values
        self.team_out.send(json.dumps({"robot": self.name, "x": x, "y": y, "ball": ball}))
        mates = []
        while self.team_in.queue_length > 0:
            mates.append(json.loads(self.team_in.getString()))
            self.team_in.nextPacket()
        return mates

    def run(self):
        while self.robot.step(self.step_ms) != -1:
            self.supervisor_says()
            ball = self.ball()
            mates = self.talk(ball)
            heading = math.atan2(self.compass.values[0], self.compass.values[1])
            room = min(sonar.value for sonar in self.sonars)
            if ball is None:
                seen = any(mate["ball"] for mate in mates)
                self.left.velocity, self.right.velocity = (6.0, 2.0) if seen else (5.0, -5.0)
            elif abs(ball[0]) > 0.3:
                turn = math.copysign(min(self.left.max_velocity, 8 * abs(ball[0])), ball[0])
                self.left.velocity, self.right.velocity = turn, -turn
            else:
                self.left.velocity, self.right.velocity = 10.0, 10.0
            if self.name.endswith("1"):
                print(f"{self.robot.time:.3f} {heading:.2f} {room:.0f} {self.wheel.value:.1f}")


if __name__ == "__main__":
    Player().run()
