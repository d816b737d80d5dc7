import pickle

from controller import Robot

robot = Robot()
emitter = robot.getDevice("team emitter")
receiver = robot.getDevice("team receiver")
receiver.enable(32)
message = {"robot_id": 1, "position": [0.25, -0.5], "role": "striker", "ball": {"x": 0.1, "y": 0.2}, "pad": "." * 150}
while robot.step(32) != -1:
    emitter.send(pickle.dumps(message))
    while receiver.getQueueLength() > 0:
        print(pickle.loads(receiver.getData()) == message)
        receiver.nextPacket()
