import struct

from controller import Robot

robot = Robot()
receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
while robot.step(32) != -1:
    if receiver.getQueueLength() > 0:
        waiting = struct.unpack("?", receiver.getData())[0]
print(receiver.getQueueLength(), waiting)
