"""Roles and Radio: three robots that talk, and share the work.

* The goalie (robot 1) stays before the own goal, between goal and ball.
* The striker is the one of the two others that gets to the ball sooner. It goes behind the ball and shoots.
* The support stays close behind, ready for a ball that gets loose.

Each robot sees the ball only when it is nearer than 0.6 m. By team radio every robot tells the others where it is
and where it sees the ball, so all three know what one knows.

The files: `senses.py` reads the devices, `team_radio.py` talks to the others, `roles.py` decides who does what and
where to go, `driving.py` turns a place to go into wheel speeds. This file puts them together.
"""

from controller import Robot
from driving import wheels_to_point
from roles import choose_role, place_for
from senses import TIME_STEP, Senses
from team_radio import TeamRadio


def main():
    robot = Robot()
    number = int(robot.getName()[1])
    senses = Senses(robot)
    radio = TeamRadio(robot, number)

    left_motor = robot.getDevice("left wheel motor")
    right_motor = robot.getDevice("right wheel motor")
    for motor in (left_motor, right_motor):
        motor.setPosition(float("inf"))
        motor.setVelocity(0.0)

    role = "support"
    while robot.step(TIME_STEP) != -1:
        senses.read()
        radio.listen()
        radio.tell(senses.x, senses.y, senses.ball)

        ball = radio.best_ball((senses.x, senses.y), senses.ball)
        role = choose_role(number, (senses.x, senses.y), radio.mates(), ball, role)
        if senses.waiting_for_kickoff:
            left, right = 0.0, 0.0
        else:
            x, y = place_for(role, number, (senses.x, senses.y), ball, robot.getTime())
            left, right = wheels_to_point(senses.x, senses.y, senses.heading, x, y)

        left_motor.setVelocity(left)
        right_motor.setVelocity(right)


if __name__ == "__main__":
    main()
