"""Reading and writing the store: each change is one transaction, so a kill at any moment leaves what was before it."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from sqlalchemy import Engine, create_engine, delete, event, inspect, select, update
from sqlalchemy.exc import DatabaseError
from sqlalchemy.orm import Session
from sqlalchemy.pool import StaticPool

from rcj_challenges.facts.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.facts.errors import format_error
from rcj_challenges.records.folder import utc_now
from rcj_challenges.tournament.jobs import MatchJob, Workplace
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.store.lock import WriterLock
from rcj_challenges.tournament.store.tables import (
    STORE_VERSION,
    Base,
    CheckRow,
    JobRow,
    MetaRow,
    PlayedRow,
    RulingRow,
    SubmissionRow,
)

STORE_FILE = "store.sqlite"
_VERSION_KEY = "store_version"
_BUSY_S = 30.0
_DAMAGED = ("malformed", "not a database", "file is encrypted", "no such table", "no such column")
_FULL = ("full", "disk i/o", "readonly", "unable to open")


@dataclass(frozen=True)
class PlayedFixture:
    """Which job counts for a fixture.

    Attributes:
        job_id: of the job.
        sides: team ids of each side.
        outcome: of the match.
    """

    job_id: str
    sides: tuple[tuple[str, ...], ...]
    outcome: Outcome


class Store:
    """What was played, submitted and decided; a context manager.

    Attributes:
        place: the folder of the tournament's data.
    """

    def __init__(self, folder: Path, *, writing: bool, now: Callable[[], datetime] = utc_now) -> None:
        """Open the store, and make it if it is to be written and is not there.

        Args:
            folder: of the tournament's data.
            writing: whether something will be changed; only one command at a time may.
            now: the wall clock.

        Raises:
            DiagnosticError: another command writes to it, or it is damaged, of another version, or cannot be written.
        """
        self.place = Workplace(folder)
        self._now = now
        self._path = folder / STORE_FILE
        self._stack = ExitStack()
        with ExitStack() as stack:
            if writing:
                self._make_folders()
                stack.enter_context(WriterLock(folder))
            self._engine = self._made_engine(writing=writing)
            stack.callback(lambda: self._engine.dispose())  # noqa: PLW0108 - a reader may replace it
            with self._errors():
                self._prepare(writing=writing)
            self._stack = stack.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    # --- submissions --------------------------------------------------------------------------------------------------

    def add_submission(self, **columns: str) -> None:
        """Note that a team has handed in something else than before; the columns are those of `SubmissionRow`."""
        with self._session() as session:
            session.add(SubmissionRow(**columns, received_at=self._now()))

    def submissions(self) -> list[SubmissionRow]:
        """Return all submissions, oldest first."""
        with self._session() as session:
            return list(session.scalars(select(SubmissionRow).order_by(SubmissionRow.id)))

    def current_submissions(self) -> dict[tuple[str, str], SubmissionRow]:
        """Return the newest submissions by team and purpose."""
        return {(row.team, row.purpose): row for row in self.submissions()}

    def add_check(self, archive: str, scenario: str, level: str, findings: list[Any]) -> None:
        """Note the verdict of a check."""
        with self._session() as session:
            session.merge(CheckRow(archive=archive, scenario=scenario, level=level, findings=findings))

    def checks(self) -> dict[tuple[str, str], CheckRow]:
        """Return the verdicts of checks by submission and scenario."""
        with self._session() as session:
            return {(row.archive, row.scenario): row for row in session.scalars(select(CheckRow))}

    # --- matches ------------------------------------------------------------------------------------------------------

    def played(self) -> dict[str, PlayedFixture]:
        """Return the job that counts, by fixture."""
        columns = select(PlayedRow.fixture, PlayedRow.job_id, PlayedRow.sides, PlayedRow.outcome)
        with self._session() as session:
            return {
                fixture: PlayedFixture(
                    job_id,
                    tuple(tuple(side.split("+")) for side in sides.split(" ")),
                    Outcome(scores=tuple(scores), values=tuple(values)),
                )
                for fixture, job_id, sides, (scores, values) in session.execute(columns)
            }

    def played_rows(self) -> list[tuple[PlayedRow, JobRow]]:
        """Return what was played, with its job, by fixture."""
        query = select(PlayedRow, JobRow).join(JobRow, PlayedRow.job_id == JobRow.id).order_by(PlayedRow.fixture)
        with self._session() as session:
            return [(played, job) for played, job in session.execute(query)]

    def jobs(self) -> dict[str, JobRow]:
        """Return all jobs that were played or tried, by id."""
        with self._session() as session:
            return {row.id: row for row in session.scalars(select(JobRow))}

    def remarkable_jobs(self) -> list[JobRow]:
        """Return the jobs that are doubtful, or could not be played."""
        query = select(JobRow).where(JobRow.doubtful | (JobRow.state == "failed")).order_by(JobRow.ended_at)
        with self._session() as session:
            return list(session.scalars(query))

    def fixtures_of(self, jobs: Iterable[str]) -> list[str]:
        """Return the fixtures for which some jobs count."""
        with self._session() as session:
            return list(session.scalars(select(PlayedRow.fixture).where(PlayedRow.job_id.in_(list(jobs)))))

    def digests(self) -> dict[str, str]:
        """Return the digest of each match that was played, by fixture."""
        query = select(PlayedRow.fixture, JobRow.summary).join(JobRow, PlayedRow.job_id == JobRow.id)
        with self._session() as session:
            return {fixture: summary["digest"] for fixture, summary in session.execute(query)}

    def keep_job(
        self,
        job: MatchJob,
        state: str,
        *,
        summary: Mapping[str, Any] | None = None,
        files: Mapping[str, int] | None = None,
        doubtful: bool = False,
        complaint: str = "",
        counts_for: Iterable[tuple[Fixture, Outcome]] = (),
    ) -> None:
        """Note in one transaction what came of a job, and for which fixtures it counts."""
        at = self._now()
        with self._session() as session:
            session.merge(
                JobRow(
                    id=job.id,
                    state=state,
                    job=job.to_json(),
                    summary=dict(summary or {}),
                    files=dict(files or {}),
                    doubtful=doubtful,
                    complaint=complaint,
                    ended_at=at,
                )
            )
            for fixture, outcome in counts_for:
                session.merge(_played_row(fixture, job, outcome, at))

    def note_files(self, job_id: str, files: Mapping[str, int]) -> None:
        """Note what the record of a job holds now."""
        with self._session() as session:
            session.execute(update(JobRow).where(JobRow.id == job_id).values(files=dict(files)))

    def count_job(self, row: JobRow, counts_for: Iterable[tuple[Fixture, Outcome]]) -> None:
        """Let a job that was played before count for fixtures too."""
        job = MatchJob.from_json(row.job)
        with self._session() as session:
            for fixture, outcome in counts_for:
                session.merge(_played_row(fixture, job, outcome, row.ended_at))

    def forget(self, fixtures: Iterable[str]) -> None:
        """Let no job count for these fixtures any more; the jobs themselves and their records stay."""
        with self._session() as session:
            _forget(session, fixtures)

    # --- rulings ------------------------------------------------------------------------------------------------------

    def add_ruling(self, columns: Mapping[str, Any], *, forget: Iterable[str] = ()) -> None:
        """Note a decision, and in the same transaction that no job counts for some fixtures any more.

        Args:
            columns: those of `RulingRow` but ``at``.
            forget: the fixtures.
        """
        with self._session() as session:
            session.add(RulingRow(**columns, at=self._now()))
            _forget(session, forget)

    def rulings(self) -> list[RulingRow]:
        """Return all decisions, oldest first."""
        with self._session() as session:
            return list(session.scalars(select(RulingRow).order_by(RulingRow.id)))

    # --- parts --------------------------------------------------------------------------------------------------------

    def _make_folders(self) -> None:
        try:
            for folder in (self.place.submissions, self.place.records):
                folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise _unwritable(self.place.folder, format_error(error)) from error

    def _made_engine(self, *, writing: bool) -> Engine:
        if not writing and not self._path.exists():  # nothing was played yet
            return _empty_engine()
        engine = create_engine(f"sqlite:///{self._path}", connect_args={"timeout": _BUSY_S})

        @event.listens_for(engine, "connect")
        def _set_up(connection: sqlite3.Connection, _record: object) -> None:
            cursor = connection.cursor()
            if writing:
                cursor.execute("PRAGMA journal_mode=WAL")
            cursor.execute("PRAGMA foreign_keys=ON")
            cursor.close()

        return engine

    def _prepare(self, *, writing: bool) -> None:
        """Make the tables of a new store; look whether an old one can be used.

        Raises:
            DiagnosticError: it is damaged, or of another version.
        """
        if writing and self._path.exists() and self._path.stat().st_size:
            with self._engine.connect() as connection:
                verdict = connection.exec_driver_sql("PRAGMA quick_check(1)").scalar()
            if verdict != "ok":
                raise _damaged(self._path, str(verdict))
        if self._is_new():
            if not writing:
                self._engine.dispose()
                self._engine = _empty_engine()
            Base.metadata.create_all(self._engine)
            with Session(self._engine) as session, session.begin():
                session.merge(MetaRow(key=_VERSION_KEY, value=str(STORE_VERSION)))
            return
        with Session(self._engine) as session:
            row = session.get(MetaRow, _VERSION_KEY)
        if row is None or row.value != str(STORE_VERSION):
            raise _other_version(self._path, "none" if row is None else row.value)

    def _is_new(self) -> bool:
        """Return whether there is nothing in it: no table yet, or empty ones because its making was interrupted."""
        found = set(inspect(self._engine).get_table_names())
        with self._engine.connect() as connection:
            return found <= Base.metadata.tables.keys() and all(
                connection.execute(select(table).limit(1)).first() is None
                for name, table in Base.metadata.tables.items()
                if name in found
            )

    @contextmanager
    def _session(self) -> Iterator[Session]:
        with self._errors(), Session(self._engine, expire_on_commit=False) as session, session.begin():
            yield session

    @contextmanager
    def _errors(self) -> Iterator[None]:
        """Turn what the database says into an error with a code.

        Raises:
            DiagnosticError: the store is damaged, or cannot be written.
        """
        try:
            yield
        except (DatabaseError, sqlite3.DatabaseError) as error:
            said = str(getattr(error, "orig", None) or error)
            if any(word in said.lower() for word in _DAMAGED):
                raise _damaged(self._path, said) from error
            if any(word in said.lower() for word in _FULL):
                raise _unwritable(self._path, said) from error
            raise


def _empty_engine() -> Engine:
    return create_engine("sqlite://", poolclass=StaticPool)


def _forget(session: Session, fixtures: Iterable[str]) -> None:
    for fixture in fixtures:
        session.execute(delete(PlayedRow).where(PlayedRow.fixture == fixture))


def _played_row(fixture: Fixture, job: MatchJob, outcome: Outcome, at: datetime) -> PlayedRow:
    archives = {
        team: program.archive
        for side in fixture.sides
        for team, program in zip(side.teams, job.seats[side.seat], strict=True)
    }
    return PlayedRow(
        fixture=fixture.id,
        job_id=job.id,
        sides=" ".join("+".join(side.teams) for side in fixture.sides),
        outcome=[list(outcome.scores), list(outcome.values)],
        submissions=archives,
        played_at=at,
    )


def _damaged(path: Path, said: str) -> DiagnosticError:
    message = f"the store {path} is damaged: {said}"
    help_ = "put a copy of it back; or move it away: 'run' then plays all matches again, with the same results"
    return DiagnosticError(Diagnostic("store-damaged", message, help_))


def _unwritable(path: Path, said: str) -> DiagnosticError:
    message = f"the tournament's data cannot be written: {path}: {said}"
    help_ = "make room there, or allow writing; then run the command again: it goes on where it was"
    return DiagnosticError(Diagnostic("store-unwritable", message, help_))


def _other_version(path: Path, found: str) -> DiagnosticError:
    message = f"the store {path} has version {found}; this rcj-challenges reads version {STORE_VERSION}"
    help_ = "use the rcj-challenges that made it, or give another folder with --data"
    return DiagnosticError(Diagnostic("store-version", message, help_))
