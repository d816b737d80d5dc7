#: about = "memory and files"
#: tries = "to leave behind pipes, sockets, devices and files with impossible names"
#: holds = "they are in its own folder, which is deleted without being read"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import os

import arena


def attempt(deed, *arguments):
    try:
        deed(*arguments)
    except OSError as error:
        print("refused:", error.errno)


arena.drive(10)
attempt(os.mkfifo, "rcj-hostile-pipe")
for name in (b"\xff\xfe", b"new\nline", b"-rf", b"x" * 255, b"\x1b[2J", b" ", "\u202e.txt".encode()):
    attempt(os.close, os.open(name, os.O_CREAT | os.O_WRONLY, 0))
    attempt(os.mkdir, name + b"d" if len(name) < 255 else b"d")
arena.play_on()
