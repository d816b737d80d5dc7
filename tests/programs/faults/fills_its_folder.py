from controller import Robot

robot = Robot()
robot.step(32)
number = 0
while True:
    number += 1
    with open(f"file{number % 50}", "wb") as file:
        file.write(bytes(500_000))
