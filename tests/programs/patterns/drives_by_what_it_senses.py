from controller import Robot

robot = Robot()
left = robot.getDevice("left wheel motor")
right = robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(0)
gps = robot.getDevice("gps")
gps.enable(32)
compass = robot.getDevice("compass")
compass.enable(32)
sonar = robot.getDevice("distancesensor front")
sonar.enable(32)
wheel = robot.getDevice("left wheel sensor")
wheel.enable(32)
print("first", gps.getValues(), sonar.getValue(), robot.getName(), robot.getBasicTimeStep())
while robot.step(32) != -1:
    print(robot.getTime(), gps.getValues(), compass.getValues(), sonar.getValue(), round(wheel.getValue(), 3))
    left.setVelocity(5)
    right.setVelocity(-robot.getTime())
print("over")
