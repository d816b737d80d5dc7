#: about = "module"
#: tries = "to hang inside step, with a trace function that never returns"
#: holds = "the time limit for a step"
#: tick = 10
#: ends = "step_timeout at 10"
#: variant = true

import sys

import arena


def trace(frame, event, argument):
    if frame.f_code.co_name == "exchange":
        while True:
            pass
    return trace


arena.drive(10)
sys.settrace(trace)
arena.play_on()
