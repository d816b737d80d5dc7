#: about = "processes and system"
#: tries = "to start other programs: subprocess, os.system, spawn, multiprocessing, exec"
#: holds = "starting a process is refused"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: subprocess", "refused: popen", "refused: posix_spawn", "refused: multiprocessing"]

import multiprocessing
import os
import subprocess
import sys

import arena


def system():
    status = os.system("true")
    if status:
        raise OSError(status)


def process():
    worker = multiprocessing.get_context("fork").Process(target=os.getpid)
    worker.start()
    worker.join()


arena.drive(10)
arena.refused("subprocess", subprocess.check_output, [sys.executable, "-c", "1"])
arena.refused("popen", lambda: os.popen("true").close())
arena.refused("system", system)
arena.refused("posix_spawn", lambda: os.waitpid(os.posix_spawn("/bin/true", ["true"], {}), 0))
arena.refused("multiprocessing", process)
arena.play_on()
