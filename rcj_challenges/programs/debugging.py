"""Differences for a program under a debugger: where it runs, and which side waits for the other."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from rcj_challenges.submissions.team import Team

PORT = 5678
"""The one that editors suggest."""


def program_place(team: Team, entry: str, unpacked: Path, *, is_debugged: bool) -> tuple[Path, Path]:
    """Return the folder of the team's files, which are unpacked in ``unpacked``, and the path of the program.

    A debugged program of a team that is a folder runs in that folder, where an editor has its breakpoints.
    """
    own = team.place_on_disk(entry) if is_debugged else None
    return own or (unpacked, unpacked.joinpath(*entry.split("/")))


def debugger_settings() -> dict[str, Any] | None:
    """Return the settings with which a debugged program waits for an editor; None: ``breakpoint()`` has the terminal.

    None without debugpy, or if the user sets ``PYTHONBREAKPOINT``.
    """
    spec = find_spec("debugpy")
    if spec is None or spec.origin is None or os.environ.get("PYTHONBREAKPOINT"):
        return None
    return {"folder": str(Path(spec.origin).parents[1]), "port": PORT}
