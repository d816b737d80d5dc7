from controller import Robot


def drive(number):
    return 1 / number


robot = Robot()
count = 3
while robot.step(32) != -1:
    count -= 1
    drive(count)
