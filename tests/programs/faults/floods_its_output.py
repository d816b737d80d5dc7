from controller import Robot

robot = Robot()
line = "x" * 999
while robot.step(32) != -1:
    for _ in range(20):
        try:
            print(line)
        except BaseException:
            pass
