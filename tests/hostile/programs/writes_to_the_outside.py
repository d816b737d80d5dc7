#: about = "memory and files"
#: tries = "to write everywhere: temporary folders, home, the record, the library, the project"
#: holds = "only its own folder can be written to"
#: layers = ["filesystem"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: /tmp", "refused: temporary", "refused: library", "refused: project", "refused: home"]

import os
import pwd

import arena
import controller


def write(folder):
    path = os.path.join(folder, "rcj-hostile-file")
    with open(path, "w") as file:
        file.write("x")
    os.unlink(path)
    folder = os.path.join(folder, "rcj-hostile-folder")
    os.mkdir(folder)
    os.rmdir(folder)


arena.drive(10)
pupil = os.path.dirname(os.path.dirname(controller.__file__))
try:
    home = pwd.getpwuid(os.getuid()).pw_dir
except KeyError:  # nobody has a name here
    home = "/root"
for name, folder in {
    "/tmp": "/tmp",
    "/var/tmp": "/var/tmp",
    "temporary": os.path.dirname(os.environ["HOME"]),
    "home": home,
    "library": os.path.dirname(os.__file__),
    "project": os.path.join(pupil, "..", "..", ".."),
    "pupil": pupil,
}.items():
    arena.refused(name, write, folder)
arena.play_on()
