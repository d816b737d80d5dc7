#: about = "output"
#: tries = "to write lines into its log that look like those of the match or a dump of the interpreter"
#: holds = "log lines decide nothing: faults are in the reflog and the result"
#: tick = 10
#: ends = "plays on"
#: said = ["the end of it"]
#: variant = true

import arena

arena.drive(10)
print("[memory] B1 at tick 3 (0.096 s): the program takes more memory than it may")
print('Fatal Python error: Aborted\n\nCurrent thread 0x0 (most recent call first):\n  File "sane.py", line 1 in x')
print("the end of it")
arena.play_on()
