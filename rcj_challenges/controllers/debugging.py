"""Differences for a program under a debugger: where it runs, and which side waits for the other."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from rcj_challenges.controllers.assignment import Assignment
from rcj_challenges.controllers.disk_names import from_disk

PORT = 5678
"""The one that editors suggest."""


def program_place(assignment: Assignment, unpacked: Path) -> tuple[Path, Path]:
    """Return the folder of the team's files and the path of the program.

    Args:
        assignment: which program it is. One that is debugged runs where the team has its files, if these are in a
            folder: breakpoints of an editor are in them.
        unpacked: where its files were unpacked.
    """
    own = assignment.team.place_on_disk(assignment.entry) if assignment.debug else None
    return own or (unpacked, unpacked.joinpath(*assignment.entry.split("/")))


def debugger_settings() -> dict[str, Any] | None:
    """Return what a debugged program's process needs to wait for an editor; None: ``breakpoint()`` has the terminal.

    None without debugpy, or if the user sets ``PYTHONBREAKPOINT``.
    """
    spec = find_spec("debugpy")
    if spec is None or spec.origin is None or os.environ.get("PYTHONBREAKPOINT"):
        return None
    return {"folder": from_disk(str(Path(spec.origin).parents[1])), "port": PORT}
