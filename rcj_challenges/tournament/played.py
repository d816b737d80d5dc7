"""What was played and submitted, as plain data: the store fills it, the site reads it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum
from pathlib import Path
from typing import Any


class RulingKind(StrEnum):
    """What a human referee can decide about a match, or the organizer about a team."""

    FORFEIT = "forfeit"
    DOUBLE_FORFEIT = "double_forfeit"
    """Both teams lose."""
    REPLAY = "replay"
    CORRECTED = "corrected"
    WITHDRAWN = "withdrawn"
    UNDONE = "undone"
    """The decision before is taken back."""


@dataclass(frozen=True, slots=True)
class Ruling:
    """One decision of a human referee; it is kept and shown for ever, also when a later one replaces it.

    Attributes:
        kind: what was decided.
        reason: in the referee's words; shown to the public.
        at: when, with a time zone.
        scores: by side, in the order of the fixture's sides; empty for a replay and what is undone.
    """

    kind: RulingKind
    reason: str
    at: datetime
    scores: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class PlayedMatch:
    """What is known of one fixture in addition to its outcome.

    Attributes:
        fixture: its id.
        record: folder of the record, as ``run`` writes one; None if nothing of it is kept or it was never played.
        result: the content of ``result.json``; empty if it was never played (a forfeit before the match).
        submissions: by team id, SHA-256 (hexadecimal) of the submission that played.
        played_at: when it ended, with a time zone; None if it was never played.
        doubtful: whether a wall-time limit decided something in it, also when it was played once more.
        rulings: oldest first.
    """

    fixture: str
    record: Path | None
    result: Mapping[str, Any]
    submissions: Mapping[str, str] = field(default_factory=dict)
    played_at: datetime | None = None
    doubtful: bool = False
    rulings: tuple[Ruling, ...] = ()


@dataclass(frozen=True, slots=True)
class Submission:
    """What a team handed in.

    Attributes:
        team: id.
        sha256: of the archive, hexadecimal.
        path: of the archive (ZIP) or folder.
        received_at: when the tournament first saw it, with a time zone.
        purpose: ``stage/challenge`` if it is for this challenge alone; else empty.
        report: folder with the check's report, or None if there is none. For the team only.
    """

    team: str
    sha256: str
    path: Path
    received_at: datetime
    purpose: str = ""
    report: Path | None = None


@dataclass(frozen=True, slots=True)
class Played:
    """All that was played and submitted so far.

    Attributes:
        matches: by fixture id; of fixtures that were played or ruled on.
        submissions: oldest first; the last one of a team for a purpose is the one that plays now.
        withdrawals: by team id, oldest first, also those that were taken back.
    """

    matches: Mapping[str, PlayedMatch] = field(default_factory=dict)
    submissions: tuple[Submission, ...] = ()
    withdrawals: Mapping[str, tuple[Ruling, ...]] = field(default_factory=dict)
