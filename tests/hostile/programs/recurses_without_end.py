#: about = "endings"
#: tries = "to recurse without end"
#: holds = "the interpreter's recursion limit: a crash, with a short report"
#: tick = 10
#: ends = "crash at 10"
#: cause = "RecursionError"
#: said = ["repeated \\d+ more times"]
#: variant = true

import arena


def deeper():
    deeper()


arena.drive(10)
deeper()
