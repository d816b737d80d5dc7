from controller import Robot

robot = Robot()
receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
count = 0
while True:
    try:
        if robot.step(32) == -1:
            break
        receiver.getData()
    except:
        count += 1
print("caught", count)
