"""A sound archive, and what makes others of it: what the cases are built from."""

from __future__ import annotations

import io
import random
import tarfile

from tests.hostile.archives.building import STORED, Member, pack, with_folders

ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
PROGRAM = b"from controller import Robot\nfrom utils import speed\n\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"
UTILS = b"# -*- coding: utf-8 -*-\r\nspeed = 10  # rad/s\r\n"
NAME = {"team_name.txt": b"Phase Moon\n"}
SOUND = {ENTRY: PROGRAM, "rcj_soccer_team_blue/utils.py": UTILS} | NAME
OF_2021 = {
    "robot1/robot1.py": b"import sys\nsys.path.append('..')\nfrom team_7_libraries.robot1 import main\nmain()\n",
    "robot2/robot2.py": b"print(2)\n",
    "robot3/robot3.py": b"print(3)\n",
    "team_7_libraries/robot1.py": b"def main(): pass\n",
} | NAME


def plain(files: dict[str, bytes]) -> bytes:
    return pack(with_folders(files))


def sound_with(**more: bytes) -> bytes:
    return plain(SOUND | more)


def below(prefix: str, files: dict[str, bytes]) -> dict[str, bytes]:
    return {f"{prefix}/{name}": content for name, content in files.items()}


def without(files: dict[str, bytes], *names: str) -> dict[str, bytes]:
    return {name: content for name, content in files.items() if name not in names}


def member_with(**lies: object) -> bytes:
    """Return a sound archive and one more member that lies."""
    return pack([*with_folders(SOUND), Member(**({"name": "more.txt", "content": b"more and more " * 20} | lies))])


def damaged_table() -> bytes:
    """Return an archive whose table of contents has a second entry that begins as none does."""
    before, first, *others = plain(SOUND).split(b"PK\1\2")
    return b"PK\1\2".join([before, first + b"PK\1\3" + others[0], *others[1:]])


def named(content: bytes, name: str = "team_name.txt") -> bytes:
    return plain(without(SOUND, "team_name.txt") | {name: content})


def logo(content: bytes, name: str = "logo.png") -> bytes:
    return plain(SOUND | {name: content})


def importing(line: bytes, **more: bytes) -> bytes:
    """Return a sound archive whose program imports something else."""
    return sound_with(**{ENTRY: line + b"\n" + PROGRAM, **more})


def noise(size: int) -> bytes:
    return random.Random(size).randbytes(size)


def tar() -> bytes:
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as archive:
        for name, content in SOUND.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(content)
            archive.addfile(entry, io.BytesIO(content))
    return out.getvalue()


def overlapping() -> bytes:
    """Many names for the bytes of one member (a bomb after D. Fifield, 2019)."""
    first = Member("a0", bytes(100_000))
    return pack([first, *(Member(f"a{n}", bytes(100_000), offset=0) for n in range(1, 200))])


def quoted() -> bytes:
    """Each member's content reaches over all headers that follow it (the better bomb after D. Fifield)."""
    inner = pack([Member(f"b{n}", b"x" * 50, method=STORED) for n in range(20)])
    members = [Member(f"a{n}", inner, method=STORED, offset=n) for n in range(20)]
    return pack([Member("a", inner, method=STORED), *members])
