#: about = "module"
#: tries = "to send radio packets of 100 MB, empty ones, and objects that are not packets"
#: holds = "the size of a packet is limited; larger ones are dropped with a warning"
#: tick = 10
#: ends = "plays on"
#: said = ["the packet is dropped", "refused: None TypeError", "sent: 0"]

import arena

arena.drive(10)
emitter = arena.robot.getDevice("team emitter")
print("sent:", emitter.send(bytes(100_000_000)))
for strange in (None, 5, object(), ["x"], "\ud800", {None: 2}):
    arena.refused(str(strange)[:5].encode("ascii", "replace").decode(), emitter.send, strange)
for size in (0, 1, 100_000, 1_000_000):
    emitter.send(bytes(size))
    arena.robot.step(32)
arena.play_on()
