"""What the programs of a half share."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rcj_challenges.controllers.timed_channel import WaitBudget

if TYPE_CHECKING:
    from rcj_challenges.controllers.program import Program


@dataclass(frozen=True)
class Sharing:
    """How the programs of a half share the temporary folder, and the time of the match.

    Attributes:
        place: in the temporary folder, where each has its private folder.
        share_bytes: when it is full, programs that have written more than this have filled it.
        programs: all of them.
        wait_budget: of the match for all of them together.
    """

    place: Path
    share_bytes: float
    programs: tuple[Program, ...]
    wait_budget: WaitBudget
