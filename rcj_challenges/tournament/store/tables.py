"""The tables of the store."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

from sqlalchemy import JSON, DateTime, Dialect, ForeignKey
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column
from sqlalchemy.types import TypeDecorator

STORE_VERSION = 1
"""Version of the tables; a store of another version is refused."""


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


class Base(DeclarativeBase):
    """What all tables have."""

    type_annotation_map = {  # noqa: RUF012 - read once by SQLAlchemy
        datetime: UtcDateTime,
        dict[str, Any]: JSON,
        list[Any]: JSON,
    }


class MetaRow(Base):
    """What the store itself is: its version."""

    __tablename__ = "meta"
    key: Mapped[str] = mapped_column(primary_key=True)
    value: Mapped[str]


class SubmissionRow(Base):
    """One submission of one team, when it came. The newest of a team for a purpose is the one that plays."""

    __tablename__ = "submission"
    id: Mapped[int] = mapped_column(primary_key=True)
    team: Mapped[str]
    purpose: Mapped[str]
    """``stage/challenge`` if it is for this challenge alone; else empty."""
    archive: Mapped[str]
    """SHA-256 of its file."""
    file: Mapped[str]
    """Its path in the folder of submissions."""
    name: Mapped[str]
    """What the team calls itself."""
    received_at: Mapped[datetime]


class CheckRow(Base):
    """The verdict of the check of a submission for a scenario."""

    __tablename__ = "checked"
    archive: Mapped[str] = mapped_column(primary_key=True)
    scenario: Mapped[str] = mapped_column(primary_key=True)
    level: Mapped[str]
    findings: Mapped[list[Any]]
    """Code and message of what failed."""


class JobRow(Base):
    """A job that was played, or tried."""

    __tablename__ = "job"
    id: Mapped[str] = mapped_column(primary_key=True)
    """Its content address."""
    state: Mapped[str]
    """``played``; ``suspect``: a time limit decided something, to be played once more; ``failed``."""
    job: Mapped[dict[str, Any]]
    """As in `MatchJob.to_json`."""
    summary: Mapped[dict[str, Any]] = mapped_column(default=dict)
    """Of the result: score, ranking, digest, kinds of faults, times."""
    files: Mapped[dict[str, Any]] = mapped_column(default=dict)
    """Size of each file of the record that is kept."""
    doubtful: Mapped[bool] = mapped_column(default=False)
    complaint: Mapped[str] = mapped_column(default="")
    """Why it could not be played."""
    ended_at: Mapped[datetime]


class PlayedRow(Base):
    """Which job counts for a fixture, and with which scores."""

    __tablename__ = "played"
    fixture: Mapped[str] = mapped_column(primary_key=True)
    job_id: Mapped[str] = mapped_column(ForeignKey("job.id"))
    sides: Mapped[str]
    """Team ids: members of a side joined with ``+``, sides with a space."""
    outcome: Mapped[list[Any]]
    """Scores by side, and of what is played alone the values that the scenario ranks by."""
    submissions: Mapped[dict[str, Any]]
    """Hash of the submission by team."""
    played_at: Mapped[datetime]


class RulingRow(Base):
    """A decision of a human referee. Rows are added, never changed or removed."""

    __tablename__ = "ruling"
    id: Mapped[int] = mapped_column(primary_key=True)
    kind: Mapped[str]
    """``forfeit``, ``replay``, ``corrected`` of a fixture; ``withdrawn`` of a team."""
    fixture: Mapped[str] = mapped_column(default="")
    team: Mapped[str] = mapped_column(default="")
    """Who forfeits or withdraws."""
    sides: Mapped[list[Any]] = mapped_column(default=list)
    """Team ids of each side: the ruling holds for a fixture of these."""
    scores: Mapped[list[Any]] = mapped_column(default=list)
    last_rounds: Mapped[dict[str, Any]] = mapped_column(default=dict)
    """Of a withdrawn team: by stage the last round for which it was drawn."""
    reason: Mapped[str]
    at: Mapped[datetime]
