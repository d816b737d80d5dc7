#: about = "processes and system"
#: tries = "to start a process with system call numbers, including those of another architecture"
#: holds = "the filter checks numbers and the architecture, not names"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: clone ", "refused: clone3", "refused: (fork|other kind)"]

import os
import signal

import arena

SIGCHLD = 17


def clone(what, number, *arguments):
    before = os.getpid()
    child = arena.syscall(what, number, *arguments, fine=("EINVAL",) if "clone3" in what else ())
    if os.getpid() != before:
        os._exit(0)
    if child > 0:
        os.kill(child, signal.SIGKILL)


arena.drive(10)
clone("clone ", arena.number_of("clone"), SIGCHLD, 0, 0, 0, 0)
clone("clone3", arena.number_of("clone3"), None, 0)
if arena.number_of("fork") > 0:
    clone("fork", arena.number_of("fork"))
    clone("other kind of program", 0x40000000 | arena.number_of("fork"))
else:
    print("refused: fork: there is none")
arena.play_on()
