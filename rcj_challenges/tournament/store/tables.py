"""The tables of the store, and their rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from typing import Any, NamedTuple, get_type_hints

# SQLAlchemy's core: importing its ORM would take as long as all else that `status` does.
from sqlalchemy import JSON, Boolean, Column, DateTime, Dialect, ForeignKeyConstraint, Integer, MetaData, String, Table
from sqlalchemy.types import TypeDecorator

STORE_VERSION = 2
"""Version of the tables; a store of another version is refused."""

METADATA = MetaData()


class UtcDateTime(TypeDecorator[datetime]):
    """A moment with its time zone; SQLite itself keeps none."""

    impl = DateTime
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        """Return a moment as it is stored."""
        return None if value is None else value.astimezone(UTC).replace(tzinfo=None)

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        """Return a moment as it was given."""
        return None if value is None else value.replace(tzinfo=UTC)


class MetaRow(NamedTuple):
    """The version of the store, or the draws."""

    key: str
    value: str


class SubmissionRow(NamedTuple):
    """One submission of one team, when it came. The newest of a team for a purpose is the one that plays."""

    team: str
    purpose: str
    """``stage/challenge`` if it is for this challenge alone; else empty."""
    archive: str
    """SHA-256 of its file."""
    file: str
    """Its path in the folder of submissions."""
    name: str
    """What the team calls itself; safe to show."""
    received_at: datetime


class CheckRow(NamedTuple):
    """The verdict of the check of a submission for a scenario."""

    archive: str
    scenario: str
    level: str
    findings: list[tuple[str, str]]
    """Code and message of what failed."""


class JobRow(NamedTuple):
    """A job that was played, or tried."""

    id: str
    """Its content address."""
    state: str
    """``played``; ``suspect``: a time limit decided something, to be played once more; ``failed``."""
    job: dict[str, Any]
    """As in `MatchJob.to_json`."""
    summary: dict[str, Any]
    """Of the result: score, ranking, digest, kinds of faults, times."""
    files: dict[str, int]
    """Size of each file of the record that is kept."""
    doubtful: bool
    complaint: str
    """Why it could not be played."""
    ended_at: datetime


class PlayedRow(NamedTuple):
    """The job that counts for a fixture, and its scores."""

    fixture: str
    job_id: str
    sides: str
    """Team ids: members of a side joined with ``+``, sides with a space."""
    outcome: list[Any]
    """Scores by side, and of what is played alone the values that the scenario ranks by."""
    submissions: dict[str, str]
    """Hash of the submission by team."""
    played_at: datetime


class RulingRow(NamedTuple):
    """A decision of a human referee. Rows are added, never changed or removed."""

    kind: str
    """As `RulingKind`; ``undone`` takes back the one before of this fixture, or of this team."""
    reason: str
    at: datetime
    fixture: str = ""
    """Empty if a team withdraws."""
    team: str = ""
    """The one that forfeits or withdraws; both that forfeit, joined with ``+``."""
    sides: Sequence[Sequence[str]] = ()
    """Team ids of each side: the ruling holds for a fixture of these."""
    scores: Sequence[float] = ()
    last_rounds: Mapping[str, int] = {}
    """Of a withdrawn team: by stage the last round for which it was drawn."""


_KINDS = {str: String, bool: Boolean, datetime: UtcDateTime}
"""Kinds of columns; all else is JSON."""


def _table(name: str, row: type[Any], *key: str) -> Table:
    """Return the table of these rows; without a key it numbers them."""
    columns: list[Column[Any]] = [Column(one, _KINDS.get(kind, JSON), primary_key=one in key, nullable=False)
               for one, kind in get_type_hints(row).items()]  # fmt: skip
    return Table(name, METADATA, *([] if key else [Column("id", Integer, primary_key=True)]), *columns)


META = _table("meta", MetaRow, "key")
SUBMISSION = _table("submission", SubmissionRow)
CHECKED = _table("checked", CheckRow, "archive", "scenario")
JOB = _table("job", JobRow, "id")
PLAYED = _table("played", PlayedRow, "fixture")
PLAYED.append_constraint(ForeignKeyConstraint([PLAYED.c.job_id], [JOB.c.id]))
RULING = _table("ruling", RulingRow)
