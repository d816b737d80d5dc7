from controller import Robot

robot = Robot()
robot.step(32)
heap = []
while True:
    heap.append(bytearray(1 << 20))
