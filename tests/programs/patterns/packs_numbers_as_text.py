import struct

from controller import Robot

robot = Robot()
emitter, receiver = robot.getDevice("team emitter"), robot.getDevice("team receiver")
receiver.enable(32)
number = int(robot.getName()[1])
while robot.step(32) != -1:
    while receiver.getQueueLength():
        for text in (receiver.getString(), receiver.string, receiver.getData(), receiver.data):
            print(type(text).__name__, *struct.unpack("<i", text if isinstance(text, bytes) else text.encode()))
        receiver.nextPacket()
    emitter.send(struct.pack("<i", number))
