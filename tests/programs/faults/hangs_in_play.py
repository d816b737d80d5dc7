from controller import Robot

robot = Robot()
robot.step(32)
robot.step(32)
print("now it hangs")
try:
    while True:
        try:
            pass
        except:
            pass
finally:
    pass
