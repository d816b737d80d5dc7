"""Findings in stages, and the level that follows from them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal

from rcj_challenges.core.code import Level
from rcj_challenges.core.diagnostics import Diagnostic

RANKS: tuple[Level, ...] = ("passed", "warning", "error", "unchecked")
"""All levels; of many, the last one is that of all."""

StageName = Literal["archive", "layout", "identity", "design", "sources", "start", "play"]

STAGES: dict[StageName, str] = {
    "archive": "the file is a sound ZIP archive",
    "layout": "folders and programs are where the scenario requires them",
    "identity": "the team's name and logo",
    "design": "robots that the team has designed are within the guidelines",
    "sources": "the programs are valid Python and can run here",
    "start": "every robot starts and answers its first step, on every side",
    "play": "a short match, on every side that the team can take",
}
"""All stages in their order, and what each is about."""


@dataclass
class Stage:
    """One stage of a check.

    Attributes:
        name: which.
        findings: in the order in which they were found.
        skipped: why it was not carried out; empty if it was.
    """

    name: StageName
    findings: list[Diagnostic] = field(default_factory=list)
    skipped: str = ""

    @property
    def level(self) -> Level:
        """The most serious of its findings."""
        return most_serious(finding.level for finding in self.findings)

    @property
    def failed(self) -> bool:
        """Whether later stages that need this one make no sense."""
        return self.level in ("error", "unchecked")


def most_serious(levels: Iterable[Level]) -> Level:
    """Return the most serious of levels; passed, if there are none."""
    return max(levels, key=RANKS.index, default="passed")
