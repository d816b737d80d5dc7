#: about = "module"
#: tries = "to run code in its team-mates' processes by sending a pickle over the radio"
#: holds = "only its own team receives it, and a program that loads it does so in its own process"
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import os
import pickle

import arena


class Poison:
    def __reduce__(self):
        return os.system, ("touch /tmp/rcj-hostile-poison",)


arena.drive(10)
for _ in range(10):
    arena.robot.getDevice("team emitter").send(pickle.dumps(Poison()))
    arena.robot.step(32)
arena.play_on()
