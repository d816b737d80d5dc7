"""Errors of the physics."""

from __future__ import annotations

from typing import ClassVar

from rcj_challenges.core.errors import RcjError


class PhysicsFault(RcjError):  # noqa: N818 - a fault of the match, as a program's Fault is
    """The simulation became unstable or ran out of room: the match cannot go on. A fault of ours, not of the input."""

    exit_code: ClassVar[int] = 3
