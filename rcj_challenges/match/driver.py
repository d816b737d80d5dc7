"""What drives one robot of a half."""

from __future__ import annotations

from typing import Protocol

from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import Observation, Request


class Driver(Protocol):
    """What drives one robot: a program in a process, or a stand-in in tests."""

    def collect(self) -> Request | Fault:
        """Wait for its next request, or for its fault."""

    def collect_soon(self) -> Request | Fault | None:
        """Return the request if it is here or comes at once; None: `collect` has to wait for it."""

    def release(self, observation: Observation) -> None:
        """Let its ``step`` return."""

    def limit_fault(self, tick: int) -> Fault | None:
        """Return a fault if its threads use more than they may during a long ``step``."""
