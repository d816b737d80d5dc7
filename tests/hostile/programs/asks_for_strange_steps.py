#: about = "time"
#: tries = "to request steps whose length is 0, -1, NaN or infinity, among others, or not a number at all"
#: holds = "a step lasts at least one tick, and a length that is not a number raises a TypeError"
#: tick = 10
#: ends = "plays on"
#: said = ["refused: step soon TypeError", "refused: step None", "passed: 10"]

import sys

import arena

arena.drive(10)
step = arena.robot.step
before = arena.robot.getTime()
for strange in (0, -1, -(10**30), float("nan"), -float("inf"), -0.0, True, 0.001, 1e-300, False):
    step(strange)
print("passed:", round((arena.robot.getTime() - before) / 0.032))
for strange in ("soon", [], object(), 1j):
    try:
        step(strange)
    except (TypeError, ValueError) as error:
        print("refused: step", strange if isinstance(strange, str) else "None", type(error).__name__)
if "huge" not in sys.argv:
    step(1e300)
print("over:", step(10**300), step(float("inf")))
