"""Ten mistakes of pupils; an editor marks each of these lines."""

from controller import Robot

robot = Robot()
gps = robot.getDevice("gps")
left = robot.getDevice("left wheel motor")
receiver = robot.getDevice("supervisor receiver")
emitter = robot.getDevice("team emitter")
compass = robot.getDevice("compass")
front = robot.getDevice("distancesensor front")

left.setVelocty(5)  # 1: a misspelt method
left.setPosition("inf")  # 2: a text for a number
x, y = gps.getValue()  # 3: the method of another sensor
front.getValues()  # 4: the method of another sensor
receiver.getQueueLenght()  # 5: a misspelt method
emitter.send({"ball": 1})  # 6: a dict is no message
robot.getdevice("gps")  # 7: upper and lower case
while robot.step("32") != -1:  # 8: a text for a number
    left.velocity = "fast"  # 9: a text for a number
    if compass.getValues() > 1:  # 10: a list is no number
        break
