#: about = "time"
#: tries = "to continue after the match, computing, stepping, printing and writing files without end"
#: holds = "it has a second to clean up, then it is ended; its output stays limited"
#: tick = 10
#: ends = "plays on"
#: limits = {output_mb = 0.2}
#: said = ["plays on"]

import arena

arena.drive(10)
arena.play_on()
number = 0
while True:
    number += 1
    try:
        arena.robot.step(32)
        print("one more " * 100)
        with open(f"rcj-hostile-{number % 50}", "ab") as file:
            file.write(bytes(10_000))
    except BaseException:
        pass
