import struct

from controller import Robot

robot = Robot()
receiver = robot.getReceiver("supervisor receiver")
receiver.enable(64)
robot.step(64)
while robot.step(64) != -1:
    packet = receiver.getData()
    receiver.nextPacket()
    print(struct.unpack("ddd?", packet))
