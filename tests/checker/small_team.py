"""A submission as small as can be: one program for all robots, and a name."""

import zipfile

PLAYER = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


def write_team(path, program=PLAYER):
    """Write it as a ZIP; returns its path."""
    path.parent.mkdir(exist_ok=True)
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("robot.py", program)
        archive.writestr("team_name.txt", "Hanse")
    return path
