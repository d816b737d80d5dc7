"""Eye and Kick: robots on omni wheels that look for the orange ball with two cameras, and shoot it."""

import math

from controller import Robot

WHEELS_AT = (1.0472, 2.3562, 3.927, 5.236)  # rad: where the wheels are, as in robot.yaml
RING, RADIUS = 0.028, 0.016  # m: from the centre to a wheel, and a wheel's own radius
SPEED = 0.18  # m/s

robot = Robot()
blue = robot.getName()[0] == "B"
number = int(robot.getName()[1])
motors = [robot.getDevice(f"wheel {n}") for n in range(4)]
eyes = {0.0: robot.getDevice("eye"), math.pi: robot.getDevice("rear eye")}  # by their directions
compass, kicker = robot.getDevice("compass"), robot.getDevice("kicker")
ball_sensor, referee = robot.getDevice("ball sensor"), robot.getDevice("supervisor receiver")
for device in (*eyes.values(), compass, ball_sensor, referee):
    device.enable(32)
for motor in motors:
    motor.setPosition(float("inf"))


def wrap(angle):
    """Bring an angle into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def drive(direction, speed, turn):
    """Drive into a direction (rad, positive to the left) and turn (rad/s) at the same time."""
    ahead, left = speed * math.cos(direction), speed * math.sin(direction)
    for motor, at in zip(motors, WHEELS_AT):
        wheel = (left * math.cos(at) - ahead * math.sin(at) + turn * RING) / RADIUS
        motor.setVelocity(max(-12, min(12, wheel)))


def ball_in(camera):
    """The direction of the ball in a picture, and how many pixels show it; None if it is not in there."""
    image, width = camera.getImage() or b"", camera.getWidth()
    columns = [i // 4 % width for i in range(0, len(image), 4) if image[i + 2] > 1.5 * image[i + 1] > 3 * image[i]]
    if len(columns) < 2:
        return None
    middle = sum(columns) / len(columns)
    return math.atan((1 - 2 * (middle + 0.5) / width) * math.tan(camera.getFov() / 2)), len(columns)


waiting, lost_side, seen_at = False, 1, -9.0
ball, size = 0.0, 0
while robot.step(32) != -1:
    while referee.getQueueLength() > 0:
        waiting = referee.getBytes() == b"\x01"
        referee.nextPacket()
    sine, cosine, _ = compass.getValues()
    # The goal to shoot at is ahead of yellow and behind blue in the field's +y direction.
    goal = wrap((-math.pi / 2 if blue else math.pi / 2) - math.atan2(sine, cosine))
    for facing, camera in eyes.items():
        found = ball_in(camera)
        if found is not None:
            ball, size, seen_at = wrap(facing + found[0]), found[1], robot.getTime()
            lost_side = 1 if ball > 0 else -1
    kicker.setPosition(0)
    if waiting:
        drive(0, 0, 0)
    elif robot.getTime() - seen_at > 0.5:
        drive(0, 0, 2.5 * lost_side)  # look around
    elif abs(wrap(ball - goal)) < 0.6:  # the ball is between here and the goal: push it
        drive(ball, SPEED, 3 * goal)
        if ball_sensor.getValue() < 8 and abs(goal) < 0.3:  # mm
            kicker.setPosition(0.04)
    else:  # drive around it, further away if it is near
        side = 1 if wrap(ball - goal) > 0 else -1
        drive(ball + side * (1.5 if size > 40 else 0.6), SPEED, 3 * goal)
