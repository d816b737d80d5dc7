#: about = "memory and files"
#: tries = "to create a sparse file of a terabyte"
#: holds = "a limit on the size of files"
#: platforms = ["linux", "darwin"]
#: layers = ["resource_limits"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: truncate", "refused: write far behind"]

import arena


def far():
    with open("rcj-hostile", "wb") as file:
        file.seek(10**12)
        file.write(b"x")


arena.drive(10)
with open("rcj-hostile", "wb") as file:
    arena.refused("truncate", file.truncate, 10**12)
arena.refused("write far behind", far)
arena.play_on()
