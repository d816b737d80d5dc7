from controller import Robot

robot = Robot()
team = robot.getDevice("team receiver")
team.enable(32)
emitter = robot.getDevice("team emitter")
while robot.step(32) != -1:
    newest = None
    while team.getQueueLength() > 0:
        newest = team.getString()
        print(newest, team.getSignalStrength(), team.getEmitterDirection(), team.getDataSize())
        team.nextPacket()
    print("newest", newest, team.getQueueLength(), team.getDataSize(), team.getSignalStrength())
