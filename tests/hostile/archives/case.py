"""What a case of the archives is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Case:
    """One archive.

    Attributes:
        build: makes it.
        code: of the finding that must be there.
        level: of that finding.
        says: what its message must contain.
        repair: whether a repair puts it right.
        scenario: the scenario it is meant for.
    """

    build: Callable[[], bytes]
    code: str
    level: Literal["passed", "warning", "error"] = "error"
    says: str = ""
    repair: bool = False
    scenario: str = "match"
