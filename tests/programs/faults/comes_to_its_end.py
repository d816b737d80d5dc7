from controller import Robot

robot = Robot()
robot.step(32)
