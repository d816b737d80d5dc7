"""Ball Chaser: the simplest team that plays.

Every robot does the same: look for the ball, turn to it, drive. Two small rules make it a football player:

* push the ball towards the other goal only: drive past it first, if it lies elsewhere from here,
* do not stand around when the ball is out of sight: go home, where it will be seen again.

Read this file from top to bottom; it is the whole program. One copy of it runs in each of the three robots.
"""

import json
import math
import struct

from controller import Robot

TIME_STEP = 32  # ms: the referee and all sensors work in steps of 32 ms
MAX_SPEED = 10  # rad/s: the motors do not turn faster
GOAL_Y = 0.75  # m: so far are the goals from the middle of the field

# Where each robot waits when it does not see the ball: metres to the right of the own goal, and in front of the
# middle line, seen by somebody who stands in the own goal. A ball is heard from 0.6 m away.
HOMES = {1: (0.0, -0.45), 2: (0.25, -0.1), 3: (-0.25, -0.1)}


def wrap(angle):
    """Bring an angle (rad) into the range from -pi to pi, so that we always turn the short way."""
    return math.atan2(math.sin(angle), math.cos(angle))


def wheel_speeds(angle):
    """Speeds of (left wheel motor, right wheel motor) that drive us to something at this angle.

    The angle is 0 straight ahead and positive on our left. Take care: the motor called "left wheel motor" sits on
    the RIGHT side of the robot. So when the left motor is faster, the robot turns to its LEFT.
    """
    turn = max(-MAX_SPEED, min(MAX_SPEED, 8 * angle))
    forward = MAX_SPEED - abs(turn)  # the more we have to turn, the slower we drive
    return forward + turn, forward - turn


def angle_past_the_ball(ball_angle, ball_distance, ball_heading, goal_heading):
    """Where to drive so that the ball goes to the other goal. All angles in rad.

    ball_heading is the direction to the ball on the field, goal_heading the direction to the other goal.
    If the two are alike, we stand behind the ball: go straight at it. If not, we would push it elsewhere: then we
    drive past the ball, near enough to stay close and far enough not to touch it.
    """
    error = wrap(ball_heading - goal_heading)
    if abs(error) < math.radians(45):
        return ball_angle
    room = 0.15  # metres between the ball's middle and our way
    detour = math.asin(min(1.0, room / max(ball_distance, 0.01)))
    return wrap(ball_angle + (detour if error > 0 else -detour))


def main():
    robot = Robot()
    name = robot.getName()  # B1, B2, B3, Y1, Y2 or Y3
    number = int(name[1])
    # The yellow team attacks the goal at +y, the blue team the goal at -y: this far from the middle of the field.
    goal_y = GOAL_Y if name[0] == "Y" else -GOAL_Y

    left_motor = robot.getDevice("left wheel motor")
    right_motor = robot.getDevice("right wheel motor")
    for motor in (left_motor, right_motor):
        motor.setPosition(float("inf"))  # turn for ever: we set the speed, not the angle
        motor.setVelocity(0.0)

    compass = robot.getDevice("compass")
    gps = robot.getDevice("gps")
    ball_receiver = robot.getDevice("ball receiver")
    referee = robot.getDevice("supervisor receiver")
    for sensor in (compass, gps, ball_receiver, referee):
        sensor.enable(TIME_STEP)

    waiting_for_kickoff = False
    while robot.step(TIME_STEP) != -1:  # -1: the match is over
        # The referee tells us once a step whether the game waits for a kick-off.
        while referee.getQueueLength() > 0:
            packet = referee.getBytes()
            referee.nextPacket()
            if len(packet) == 1:  # messages v2.1: one byte, true or false
                (waiting_for_kickoff,) = struct.unpack("?", packet)
            elif b"waiting_for_kickoff" in packet:  # messages v2.2: JSON text
                waiting_for_kickoff = json.loads(packet)["waiting_for_kickoff"]

        # The compass gives [sin, cos, 0] of our heading.
        sine, cosine, _ = compass.getValues()
        heading = math.atan2(sine, cosine)

        # The ball sends one packet a step. We keep the newest.
        ball = None
        while ball_receiver.getQueueLength() > 0:
            x, y, _ = ball_receiver.getEmitterDirection()  # x is ahead of us, y on our left
            strength = ball_receiver.getSignalStrength()  # 1 / (distance * distance)
            ball = (math.atan2(y, x), 1 / math.sqrt(strength))
            ball_receiver.nextPacket()

        x, y, _ = gps.getValues()  # where we are, in metres from the middle of the field

        if waiting_for_kickoff:
            left, right = 0.0, 0.0
        elif ball is not None:
            angle, distance = ball
            goal_heading = math.atan2(goal_y - y, 0 - x)
            left, right = wheel_speeds(angle_past_the_ball(angle, distance, heading + angle, goal_heading))
        else:
            home_x, home_y = HOMES[number]
            if name[0] == "B":  # the same places, seen from the other goal
                home_x, home_y = -home_x, -home_y
            if math.hypot(home_x - x, home_y - y) > 0.05:
                left, right = wheel_speeds(wrap(math.atan2(home_y - y, home_x - x) - heading))
            else:
                left, right = 3.0, -3.0  # at home: turn on the spot

        left_motor.setVelocity(left)
        right_motor.setVelocity(right)


if __name__ == "__main__":
    main()
