#: about = "time"
#: tries = "to loop for ever before its first step"
#: holds = "the time limit for the start"
#: tick = 0
#: ends = "start_timeout at 0"
#: limits = {start_s = 3}
#: cause = "more than 3 s until its first step"
#: said = ["robot1.py|robot2.py|robot3.py"]
#: variant = true

while True:
    pass
