from controller import Robot

robot = Robot()
while True:
    pass
