from controller import Robot

robot = Robot()
ticks = 0
history = []


def play():
    global ticks
    ticks += 1
    history.append(robot.getTime())


while robot.step(32) != -1:
    play()
print(ticks, len(history), __name__)
