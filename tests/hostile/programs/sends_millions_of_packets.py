#: about = "module"
#: tries = "to slow the match down with tens of thousands of radio packets in every step"
#: holds = "the number of packets per step is limited; those beyond the limit are dropped with a warning"
#: tick = 10
#: ends = "plays on"
#: said = ["the packet is dropped", "plays on"]
#: variant = true

import arena

arena.drive(10)
emitter = arena.robot.getDevice("team emitter")
for _ in range(3):
    for _ in range(20_000):
        emitter.send(b"x")
    arena.robot.step(32)
arena.play_on()
