#: about = "endings"
#: tries = "to keep the report busy with a circle of a thousand errors, each the cause of the next, with nested groups"
#: holds = "the report is limited in length; the time limit covers the rest"
#: tick = 10
#: ends = "crash at 10"
#: variant = true

import arena

arena.drive(10)
first = error = ValueError("first")
for number in range(1_000):
    error.__context__ = ValueError(number)
    error = error.__context__
error.__cause__ = first
group = ValueError("inner")
for _ in range(500):
    group = ExceptionGroup("group", [group])
first.__cause__ = group
raise first
