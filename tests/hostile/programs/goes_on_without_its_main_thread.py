#: about = "memory and files"
#: tries = "to hide deleted files: another thread holds them open after the main thread has ended with the exit system call"
#: holds = "a program that has lost its main thread is ended"
#: platforms = ["linux"]
#: tick = 10
#: ends = "exit at 10"
#: cause = "main thread ended"

import ctypes
import os
import platform
import threading

import arena

EXIT = {"x86_64": 60, "aarch64": 93}[platform.machine()]
held = []


def fill():
    for number in range(5):
        file = open("rcj-hostile", "wb", buffering=0)
        os.unlink("rcj-hostile")
        file.write(bytes(1_000_000))
        held.append(file)
    while True:
        pass


arena.drive(10)
threading.Thread(target=fill).start()
arena.libc().syscall(ctypes.c_long(EXIT), ctypes.c_long(0))
