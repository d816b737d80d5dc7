"""Two Eyes: one keeper that slides before its goal, and two runners with a dribbler and a kicker."""

import math

from controller import Robot

robot = Robot()
blue, keeper = robot.getName()[0] == "B", robot.getName()[1] == "1"
WHEELS_AT = (1.0472, 3.1416, 5.236) if keeper else (1.0472, 2.3562, 3.927, 5.236)  # as in robot.yaml
motors = [robot.getDevice(f"wheel {n}") for n in range(len(WHEELS_AT))]
for motor in motors:
    motor.setPosition(float("inf"))
eyes = {0.0: robot.getDevice("eye")}  # by their directions
if keeper:
    eyes[math.pi] = robot.getDevice("rear eye")
    rear_sonar, left_sonar = robot.getDevice("rear sonar"), robot.getDevice("left sonar")
    others = [rear_sonar, left_sonar]
else:
    kicker, dribbler, ball_sensor = (robot.getDevice(name) for name in ("kicker", "dribbler", "ball sensor"))
    dribbler.setPosition(float("inf"))
    others = [ball_sensor]
compass, referee = robot.getDevice("compass"), robot.getDevice("supervisor receiver")
for device in (*eyes.values(), compass, referee, *others):
    device.enable(32)


def wrap(angle):
    """Bring an angle into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def drive(ahead, left, turn):
    """Drive ahead and to the left (m/s) and turn (rad/s) at the same time."""
    for motor, at in zip(motors, WHEELS_AT):
        wheel = (left * math.cos(at) - ahead * math.sin(at) + turn * 0.028) / 0.016
        motor.setVelocity(max(-12, min(12, wheel)))


def ball_in(camera):
    """The direction of the ball in a picture, None if it is not in there."""
    image, width = camera.getImage() or b"", camera.getWidth()
    columns = [i // 4 % width for i in range(0, len(image), 4) if image[i + 2] > 1.5 * image[i + 1] > 3 * image[i]]
    if len(columns) < 2:
        return None
    return math.atan((1 - (2 * sum(columns) / len(columns) + 1) / width) * math.tan(camera.getFov() / 2))


waiting, ball, seen_at = False, 0.0, -9.0
while robot.step(32) != -1:
    while referee.getQueueLength() > 0:
        waiting = referee.getBytes() == b"\x01"
        referee.nextPacket()
    sine, cosine, _ = compass.getValues()
    goal = wrap((-math.pi / 2 if blue else math.pi / 2) - math.atan2(sine, cosine))  # where we score
    for facing, camera in eyes.items():
        found = ball_in(camera)
        if found is not None:
            ball, seen_at = wrap(facing + found), robot.getTime()
    sees = robot.getTime() - seen_at < 0.5
    if waiting:
        drive(0, 0, 0)
    elif keeper:
        # Stay 15 cm ahead of the wall behind, and slide to where the ball is; without it to the middle.
        back = 0.8 * (0.15 - rear_sonar.getValue() / 1000)
        side = 1.5 * math.sin(ball) if sees else 1.0 * (left_sonar.getValue() / 1000 - 0.6)
        drive(max(-0.1, min(0.1, back)), max(-0.17, min(0.17, 0.2 * side)), 4 * goal)
    else:
        dribbler.setVelocity(50 if ball_sensor.getValue() < 19 else 0)  # mm
        kicker.setPosition(0.04 if ball_sensor.getValue() < 8 and abs(goal) < 0.2 else 0)
        if not sees:
            drive(0, 0, 2.5)  # look around
        elif abs(wrap(ball - goal)) < 0.7:  # push the ball
            drive(0.18 * math.cos(ball), 0.18 * math.sin(ball), 3 * goal)
        else:  # around it
            way = ball + math.copysign(1.1, wrap(ball - goal))
            drive(0.18 * math.cos(way), 0.18 * math.sin(way), 3 * goal)
