from controller import Robot

robot = Robot()
left = robot.getMotor("left wheel motor")
right = robot.getMotor("right wheel motor")
receiver = robot.getReceiver("supervisor receiver")
sonar = robot.getDistanceSensor("distancesensor left")
print(left is robot.getDevice("left wheel motor"), robot.getDevice("kicker"), receiver.getName(), sonar.getMaxValue())
while robot.step(32) != -1:
    pass
