import json

from controller import Robot

robot = Robot()
receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
while robot.step(32) != -1:
    while receiver.getQueueLength() > 0:
        print(type(receiver.getData()).__name__, json.loads(receiver.getString()), receiver.getBytes())
        receiver.nextPacket()
