import os
import stat

from controller import Robot

robot = Robot()
robot.step(32)
for fd in range(3, 64):
    try:
        if stat.S_ISFIFO(os.fstat(fd).st_mode):
            os.write(fd, b"\x05\x00\x00\x00hello")
    except OSError:
        pass
while True:
    pass
