#: about = "module"
#: tries = "to hide where it hangs, by switching the fault handler off and redirecting it"
#: holds = "the fault and its tick are reported in any case"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "step_timeout at 10"
#: variant = true

import faulthandler
import signal

import arena

arena.drive(10)
elsewhere = open("rcj-hostile-dump", "w")
faulthandler.disable()
faulthandler.enable(elsewhere)
faulthandler.register(signal.SIGTERM, elsewhere, chain=False)
signal.signal(signal.SIGABRT, signal.SIG_DFL)
while True:
    pass
