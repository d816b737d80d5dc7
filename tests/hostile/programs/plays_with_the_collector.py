#: about = "module"
#: tries = "to upset the garbage collector: cycles, weak references, resurrection, callbacks that raise errors, objects from the match's code"
#: holds = "it has its own process"
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import gc
import weakref

import arena


class Phoenix:
    ashes = []

    def __del__(self):
        self.ashes.append(self)
        raise RuntimeError("not yet")


def complain(*_):
    raise RuntimeError("never")


arena.drive(10)
gc.callbacks.append(complain)
gc.set_threshold(1, 1, 1)
for _ in range(100):
    bird = Phoenix()
    bird.self = bird
    weakref.finalize(bird, complain)
del bird
for thing in gc.get_objects():
    if type(thing).__name__ in ("Boot", "Output"):
        thing.__dict__.pop("_on_flood", None)
arena.robot.step(32)
gc.set_threshold(1000, 10, 10)
arena.play_on()
