#: about = "memory and files"
#: tries = "to fill the disk from a thread during a step that lasts longer than the match, so that the match never waits for it"
#: holds = "programs in long steps are checked too"
#: tick = 10
#: ends = "output_flood at 64"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "wrote more than 2 MB"

import threading

import arena

arena.drive(10)
arena.robot.step(32)
written = threading.Event()


def fill():
    with open("rcj-hostile", "wb") as file:
        file.write(bytes(1_500_000))
    with open("rcj-hostile-2", "wb") as file:
        file.write(bytes(1_500_000))
    written.set()


threading.Thread(target=fill).start()
written.wait()
arena.robot.step(1e15)
