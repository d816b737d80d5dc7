"""What was played and submitted, as the site and the results read it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum
from functools import cached_property
from pathlib import Path
from typing import Any

from rcj_challenges.core.grouping import grouped
from rcj_challenges.records.folder import RESULT
from rcj_challenges.records.lines import parsed
from rcj_challenges.tournament.store.store import Store
from rcj_challenges.tournament.store.tables import RulingRow


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


@dataclass(frozen=True)
class PlayedMatch:
    """A fixture that was played or ruled on, in addition to its outcome.

    Attributes:
        record: folder of the record, as ``run`` writes one; None if nothing of it is kept or it was never played.
        summary: of its result, as the store has it; empty if it was never played (a forfeit before the match).
        submissions: by team id, SHA-256 (hexadecimal) of the submission that played.
        played_at: its end; None if it was never played.
        doubtful: whether a wall-time limit decided something in it, also when it was played once more.
    """

    fixture: str
    record: Path | None
    summary: Mapping[str, Any]
    submissions: Mapping[str, str] = field(default_factory=dict)
    played_at: datetime | None = None
    doubtful: bool = False
    rulings: tuple[RulingRow, ...] = ()

    @cached_property
    def result(self) -> Mapping[str, Any]:
        """The content of the record's ``result.json``; of a damaged one, or without one, the summary."""
        with suppress(OSError, ValueError):
            content = parsed((self.record / RESULT).read_bytes()) if self.record is not None else None
            if isinstance(content, dict):
                return content
        return self.summary


@dataclass(frozen=True, slots=True)
class Submission:
    """A submission that was handed in.

    Attributes:
        sha256: of the archive, hexadecimal.
        path: of the archive (ZIP) or folder.
        received_at: when the tournament first saw it.
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
    withdrawals: Mapping[str, Sequence[RulingRow]] = field(default_factory=dict)


def read_played(store: Store) -> Played:
    """Return all that was played, decided and submitted."""
    decided = store.rulings()
    rulings = grouped((row.fixture, row) for row in decided if row.fixture)
    withdrawals = grouped((row.team, row) for row in decided if not row.fixture)
    matches: dict[str, PlayedMatch] = {}
    for played, job in store.played_rows():
        folder = store.place.record_of(job.id)
        matches[played.fixture] = PlayedMatch(
            fixture=played.fixture,
            record=folder if folder.is_dir() else None,
            summary=job.summary,
            submissions=played.submissions,
            played_at=played.played_at,
            doubtful=job.doubtful,
            rulings=tuple(rulings.get(played.fixture, ())),
        )
    for fixture, own in rulings.items():
        matches.setdefault(fixture, PlayedMatch(fixture, None, {}, rulings=tuple(own)))
    return Played(matches, tuple(_submissions(store)), withdrawals)


def _submissions(store: Store) -> Iterator[Submission]:
    for row in store.submissions():
        report = store.place.report_folder(row.team, row.archive)
        path = store.place.submissions / row.file
        yield Submission(row.team, row.archive, path, row.received_at, row.purpose, report if report.is_dir() else None)
