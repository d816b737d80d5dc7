"""All Sensors: the strongest of the sample teams. It uses every device that the robot has.

What each device is good for:

* gps, compass      where we are and where we look                          (body.py)
* ball receiver     where the ball is, and from several steps how fast      (body.py, ball.py)
* team radio        what the others see, and who goes for the ball          (team.py)
* sonars            is there a robot in our way? where is room to get free? (body.py, escape.py)
* wheel sensors     do the wheels turn while we stand? then we are stuck    (body.py, escape.py)
* referee           does the game wait for a kick-off?                      (body.py)

Each step goes the same way: read, share, decide, get free if we are stuck, drive.
"""

from ball import BallTracker
from body import Body
from controller import Robot
from driving import wheels_to_point
from escape import Escape
from plan import Plan
from team import Team


def main():
    robot = Robot()
    body = Body(robot)
    team = Team(robot, body.number)
    tracker = BallTracker()
    plan = Plan(body.number)
    escape = Escape()

    while body.step():
        team.listen()
        tracker.update(body.time, team.best_ball(body.place, body.ball))
        team.tell(body.place, body.ball)

        if body.waiting_for_kickoff:
            tracker.forget()  # the ball will be put back to the centre
            escape.forget()
            body.drive(0.0, 0.0)
            continue

        escape.watch(body)
        if escape.active:
            body.drive(escape.left, escape.right)
            continue
        target, full_speed = plan.decide(body, team.mates(), tracker)
        body.drive(*wheels_to_point(*body.place, body.heading, *target, full_speed=full_speed))


if __name__ == "__main__":
    main()
