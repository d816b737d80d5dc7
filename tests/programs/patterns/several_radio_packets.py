import struct

from controller import Robot

robot = Robot()
emitter = robot.getDevice("team emitter")
receiver = robot.getDevice("team receiver")
receiver.enable(robot.getBasicTimeStep())
number = int(robot.getName()[1])
seen = {}
while robot.step(32) != -1:
    emitter.send(struct.pack("ii", number, 1))
    emitter.send(bytearray(struct.pack("ii", number, 2)))
    emitter.send("Grüße")
    emitter.send([0.5, 2])
    while receiver.getQueueLength():
        sender, what = struct.unpack("ii", receiver.getBytes())
        seen.setdefault(sender, []).append(what)
        receiver.nextPacket()
print(seen, emitter.getChannel(), emitter.getRange(), receiver.getChannel())
