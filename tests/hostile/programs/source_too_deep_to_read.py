#: about = "endings"
#: tries = "to break the compiler with a hundred thousand brackets"
#: holds = "a program is compiled in its own process"
#: tick = 0
#: ends = "crash at 0"

eval("(" * 100_000 + ")" * 100_000)
