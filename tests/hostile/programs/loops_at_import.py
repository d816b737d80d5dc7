#: about = "time"
#: tries = "to loop for ever before its first step"
#: holds = "the wall limit of the start"
#: tick = 0
#: ends = "start_timeout at 0"
#: limits = {start_s = 3}
#: cause = "did not call step within 3 s"
#: said = ["robot1.py|robot2.py|robot3.py"]
#: variant = true

while True:
    pass
