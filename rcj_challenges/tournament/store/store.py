"""Reading and writing the store: each change is one transaction, so a kill at any moment leaves what was before it."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from shutil import copyfile
from tempfile import TemporaryDirectory
from typing import Any, Self, TypeVar

import sqlalchemy as sa
from sqlalchemy.dialects.sqlite import insert
from sqlalchemy.exc import DatabaseError
from sqlalchemy.pool import StaticPool

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import format_error
from rcj_challenges.records.folder import utc_now
from rcj_challenges.tournament import codes
from rcj_challenges.tournament.codes import STORE_DAMAGED, STORE_UNWRITABLE
from rcj_challenges.tournament.jobs import MatchJob, Workplace
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.store.lock import WriterLock
from rcj_challenges.tournament.store.tables import (
    CHECKED,
    JOB,
    META,
    METADATA,
    PLAYED,
    RULING,
    STORE_VERSION,
    SUBMISSION,
    CheckRow,
    JobRow,
    PlayedRow,
    RulingRow,
    SubmissionRow,
)

STORE_FILE = "store.sqlite"
_Row = TypeVar("_Row", SubmissionRow, CheckRow, JobRow, PlayedRow, RulingRow)
_VERSION_KEY, _DRAWN_KEY = "store_version", "drawn"
_BUSY_S = 30.0
_DAMAGED = ("malformed", "could not decode", "not a database", "file is encrypted", "no such table", "no such column")
_FULL = ("full", "disk i/o", "readonly", "unable to open")


@dataclass(frozen=True)
class PlayedFixture:
    """The job that counts for a fixture, with the team ids of each side."""

    job_id: str
    sides: tuple[tuple[str, ...], ...]
    outcome: Outcome


class Store:
    """What was played, submitted and decided; a context manager."""

    def __init__(self, folder: Path, *, writing: bool) -> None:
        """Open the store, and make it if it is to be written and is not there; only one command at a time may write.

        Raises:
            DiagnosticError: another command writes to it, or it is damaged, of another version, or cannot be written.
        """
        self.place = Workplace(folder)
        self._path = folder / STORE_FILE
        self._stack = ExitStack()
        with ExitStack() as stack:
            if writing:
                self._make_folders()
                stack.callback(WriterLock(folder).close)
            self._engine = self._made_engine(self._path, writing=writing)
            stack.callback(lambda: self._engine.dispose())  # noqa: PLW0108 - a reader may replace it
            try:
                with self._errors():
                    self._prepare(writing=writing)
            except DiagnosticError as error:
                if writing or error.code != "store-unwritable":
                    raise
                self._read_copy(stack)
            self._stack = stack.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    # --- submissions --------------------------------------------------------------------------------------------------

    def add_submission(self, row: SubmissionRow) -> None:
        """Note that a team has handed in something else than before."""
        with self.transaction() as connection:
            connection.execute(sa.insert(SUBMISSION).values(row._asdict()))

    def submissions(self) -> list[SubmissionRow]:
        """Return all submissions, oldest first."""
        return self._rows(SUBMISSION, SubmissionRow, SUBMISSION.c.id)

    def current_submissions(self) -> dict[tuple[str, str], SubmissionRow]:
        """Return the newest submissions by team and purpose."""
        return {(row.team, row.purpose): row for row in self.submissions()}

    def add_check(self, archive: str, scenario: str, level: str, findings: list[tuple[str, str]]) -> None:
        """Note the verdict of a check."""
        with self.transaction() as connection:
            _put(connection, CHECKED, archive=archive, scenario=scenario, level=level, findings=findings)

    def checks(self) -> dict[tuple[str, str], CheckRow]:
        """Return the verdicts of checks by submission and scenario."""
        return {(row.archive, row.scenario): row for row in self._rows(CHECKED, CheckRow)}

    # --- matches ------------------------------------------------------------------------------------------------------

    def played(self) -> dict[str, PlayedFixture]:
        """Return the job that counts, by fixture."""
        columns = sa.select(PLAYED.c.fixture, PLAYED.c.job_id, PLAYED.c.sides, sa.cast(PLAYED.c.outcome, sa.String))
        with self.transaction() as connection:
            rows = connection.execute(columns).all()
            outcomes = json.loads(f"[{','.join(outcome for *_, outcome in rows)}]")  # ten times as fast as one by one
            return {
                fixture: PlayedFixture(
                    job_id,
                    tuple([tuple(side.split("+")) for side in sides.split(" ")]),
                    Outcome(scores=tuple(scores), values=tuple(values)),
                )
                for (fixture, job_id, sides, _), (scores, values) in zip(rows, outcomes, strict=True)
            }

    def played_rows(self) -> list[tuple[PlayedRow, JobRow]]:
        """Return the played fixtures with their jobs, by fixture."""
        rows = self._rows(PLAYED, PlayedRow, PLAYED.c.fixture)
        jobs = self.jobs()  # after the rows: a run may add more of both meanwhile
        return [(row, jobs[row.job_id]) for row in rows]

    def jobs(self) -> dict[str, JobRow]:
        """Return all jobs that were played or tried, by id."""
        return {row.id: row for row in self._rows(JOB, JobRow)}

    def latest_fixtures(self, count: int) -> list[str]:
        """Return the fixtures that were played last, the newest first."""
        return self._texts(
            sa.select(PLAYED.c.fixture).order_by(PLAYED.c.played_at.desc(), PLAYED.c.fixture).limit(count)
        )

    def failed_submissions(self) -> dict[str, str]:
        """Return the failures in the check of submissions that would play now, by team."""
        failed = [row for row in self.checks().values() if row.level == "error"]
        return {
            team: "; ".join(message for _, message in row.findings)
            for (team, _), handed in self.current_submissions().items()
            for row in failed
            if row.archive == handed.archive
        }

    def doubtful_fixtures(self) -> list[str]:
        """Return the fixtures for which doubtful jobs count."""
        return self._texts(
            sa.select(PLAYED.c.fixture).join_from(PLAYED, JOB).where(JOB.c.doubtful).order_by(PLAYED.c.fixture)
        )

    def complaints(self) -> list[str]:
        """Return the complaints of jobs that could not be played, oldest first."""
        return self._texts(sa.select(JOB.c.complaint).where(JOB.c.state == "failed").order_by(JOB.c.ended_at))

    def summaries(self) -> dict[str, dict[str, Any]]:
        """Return the summary of each match that was played, by fixture."""
        query = sa.select(PLAYED.c.fixture, JOB.c.summary).join_from(PLAYED, JOB)
        with self.transaction() as connection:
            return {row.fixture: row.summary for row in connection.execute(query)}

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
        """Note in one transaction the outcome of a job, and the fixtures for which it counts."""
        at = utc_now()
        row = JobRow(job.id, state, job.to_json(), dict(summary or {}), dict(files or {}), doubtful, complaint, at)
        with self.transaction() as connection:
            _put(connection, JOB, **row._asdict())
            _count(connection, job, counts_for, at)

    def rename(self, archive: str, old: str, new: str) -> list[str]:
        """Give the team of a submission another name in all that is kept; return the ids of its jobs."""
        with self.transaction() as connection:
            connection.exec_driver_sql("PRAGMA secure_delete = ON")
            connection.execute(sa.update(SUBMISSION).where(SUBMISSION.c.archive == archive).values(name=new))
            found = [
                row for row in connection.execute(sa.select(JOB.c.id, JOB.c.job)) if archive in json.dumps(row.job)
            ]
            for row in found:
                job = {**row.job, "names": {seat: new if one == old else one for seat, one in row.job["names"].items()}}
                job["seats"] = {
                    seat: [{**one, "name": new if one["name"] == old else one["name"]} for one in programs]
                    for seat, programs in job["seats"].items()
                }
                connection.execute(sa.update(JOB).where(JOB.c.id == row.id).values(job=job))
            return [row.id for row in found]

    def note_files(self, job_id: str, files: Mapping[str, int]) -> None:
        """Note the files in the record of a job."""
        with self.transaction() as connection:
            connection.execute(sa.update(JOB).where(JOB.c.id == job_id).values(files=dict(files)))

    def count_job(self, row: JobRow, counts_for: Iterable[tuple[Fixture, Outcome]]) -> None:
        """Let a job that was played before count for fixtures too."""
        with self.transaction() as connection:
            _count(connection, MatchJob.from_json(row.job), counts_for, row.ended_at)

    def forget(self, fixtures: Iterable[str]) -> None:
        """Let no job count for these fixtures any more; the jobs themselves and their records stay."""
        with self.transaction() as connection:
            _forget(connection, fixtures)

    # --- what was drawn -----------------------------------------------------------------------------------------------

    def has_begun(self) -> bool:
        """Return whether anything was played or decided."""
        with self.transaction() as connection:
            rows = [connection.execute(sa.select(table).limit(1)).first() for table in (PLAYED, RULING)]
        return any(row is not None for row in rows)

    def drawn(self) -> dict[str, Any] | None:
        """Return the draws, a `Drawn` as a dict; None if nothing is kept."""
        with self.transaction() as connection:
            kept = connection.scalar(sa.select(META.c.value).where(META.c.key == _DRAWN_KEY))
        return None if kept is None else json.loads(kept)

    def keep_drawn(self, drawn: Mapping[str, Any], moved: Mapping[str, str] | None = None) -> None:
        """Keep a `Drawn`, as a dict, and in the same transaction let results count for fixtures with other ids.

        ``moved``: by fixture, the id that it had before; rulings are repeated, since rows of them never change.
        """
        with self.transaction() as connection:
            _put(connection, META, key=_DRAWN_KEY, value=json.dumps(drawn))
            _forget(connection, moved or ())
            for fixture, before in (moved or {}).items():
                connection.execute(sa.update(PLAYED).where(PLAYED.c.fixture == before).values(fixture=fixture))
                columns = {name: RULING.c[name] for name in RulingRow._fields} | {"fixture": sa.literal(fixture)}
                rows = sa.select(*columns.values()).where(RULING.c.fixture == before).order_by(RULING.c.id)
                connection.execute(sa.insert(RULING).from_select(list(columns), rows))

    # --- rulings ------------------------------------------------------------------------------------------------------

    def add_ruling(self, ruling: RulingRow, *, forget: Iterable[str] = ()) -> None:
        """Note a decision, and in the same transaction that no job counts for some fixtures any more."""
        with self.transaction() as connection:
            connection.execute(sa.insert(RULING).values(ruling._asdict()))
            _forget(connection, forget)

    def rulings(self) -> list[RulingRow]:
        """Return all decisions, oldest first."""
        return self._rows(RULING, RulingRow, RULING.c.id)

    # --- parts --------------------------------------------------------------------------------------------------------

    def _texts(self, query: sa.Select[tuple[str]]) -> list[str]:
        with self.transaction() as connection:
            return list(connection.scalars(query))

    def _rows(self, table: sa.Table, kind: type[_Row], *order: sa.Column[Any]) -> list[_Row]:
        columns = [table.c[name] for name in kind._fields]
        with self.transaction() as connection:
            return [kind(*row) for row in connection.execute(sa.select(*columns).order_by(*order))]

    def _make_folders(self) -> None:
        try:
            for folder in (self.place.submissions, self.place.records):
                folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise _unwritable(self.place.folder, format_error(error)) from error

    def _made_engine(self, path: Path, *, writing: bool) -> sa.Engine:
        if not writing and not path.exists():  # nothing was played yet
            return _empty_engine()
        engine = sa.create_engine(f"sqlite:///{path}", connect_args={"timeout": _BUSY_S})

        @sa.event.listens_for(engine, "connect")
        def _set_up(connection: sqlite3.Connection, _record: object) -> None:
            cursor = connection.cursor()
            if writing:
                cursor.execute("PRAGMA journal_mode=WAL")
            cursor.execute("PRAGMA foreign_keys=ON")
            cursor.close()

        return engine

    def _read_copy(self, stack: ExitStack) -> None:
        """Read a copy of the store: SQLite makes files beside a store even to read it, and the folder forbids this.

        Raises:
            DiagnosticError: it cannot be copied, is damaged, or of another version.
        """
        self._engine.dispose()
        folder = Path(stack.enter_context(TemporaryDirectory(prefix="rcj-store-")))
        stack.callback(lambda: self._engine.dispose())  # noqa: PLW0108 - before the folder goes
        try:
            for ending in ("", "-wal"):  # the second has what a killed command wrote last
                with suppress(FileNotFoundError):
                    copyfile(f"{self._path}{ending}", folder / f"{STORE_FILE}{ending}")
        except OSError as error:
            raise _unwritable(folder, format_error(error)) from error
        self._engine = self._made_engine(folder / STORE_FILE, writing=False)
        with self._errors():
            self._prepare(writing=False)

    def _prepare(self, *, writing: bool) -> None:
        """Make the tables of a new store; check an old one.

        Raises:
            DiagnosticError: it is damaged, or of another version.
        """
        was_there = self._path.exists()  # to connect makes it
        if writing and was_there and self._path.stat().st_size:
            with self._engine.connect() as connection:
                verdict = connection.exec_driver_sql("PRAGMA quick_check(1)").scalar()
            if verdict != "ok":
                raise _damaged(self._path, str(verdict))
        if self._is_new():
            if was_there and any(self.place.records.glob("[!.]*")):
                raise _damaged(self._path, "it is empty, but there are records of matches")
            if not writing:
                self._engine.dispose()
                self._engine = _empty_engine()
            METADATA.create_all(self._engine)
            with self._engine.begin() as connection:
                _put(connection, META, key=_VERSION_KEY, value=str(STORE_VERSION))
            return
        with self._engine.connect() as connection:
            version = connection.scalar(sa.select(META.c.value).where(META.c.key == _VERSION_KEY))
        if version != str(STORE_VERSION):
            found = version or "none"
            message = f"the store {self._path} has version {found}; this rcj-challenges reads version {STORE_VERSION}"
            help_ = "use the rcj-challenges that made it, or give another folder with --data"
            raise DiagnosticError(Diagnostic(codes.STORE_VERSION, message, help_))

    def _is_new(self) -> bool:
        """Return whether there is nothing in it: no table yet, or empty ones because its making was interrupted."""
        found = set(sa.inspect(self._engine).get_table_names())
        with self._engine.connect() as connection:
            return found <= METADATA.tables.keys() and all(
                connection.execute(sa.select(table).limit(1)).first() is None
                for name, table in METADATA.tables.items()
                if name in found
            )

    @contextmanager
    def transaction(self) -> Iterator[sa.Connection]:
        """Return a connection whose changes are all kept, or none if the block fails.

        Raises:
            DiagnosticError: the store is damaged, or cannot be written.
        """
        with self._errors(), self._engine.begin() as connection:
            yield connection

    @contextmanager
    def _errors(self) -> Iterator[None]:
        """Turn errors of the database into one with a code."""
        try:
            yield
        except (DatabaseError, sqlite3.DatabaseError) as error:
            said = str(getattr(error, "orig", None) or error)
            if any(word in said.lower() for word in _DAMAGED):
                raise _damaged(self._path, said) from error
            if any(word in said.lower() for word in _FULL):
                raise _unwritable(self._path, said) from error
            raise
        except (ValueError, TypeError) as error:  # a cell is no JSON or date
            raise _damaged(self._path, str(error)) from error


def _empty_engine() -> sa.Engine:
    return sa.create_engine("sqlite://", poolclass=StaticPool)


def _put(connection: sa.Connection, table: sa.Table, **columns: Any) -> None:
    """Write a row in the place of one with the same key, if there is one."""
    row = insert(table).values(columns)
    connection.execute(row.on_conflict_do_update(index_elements=table.primary_key, set_=columns))


def _count(
    connection: sa.Connection, job: MatchJob, counts_for: Iterable[tuple[Fixture, Outcome]], at: datetime
) -> None:
    for fixture, outcome in counts_for:
        archives = {
            team: program.archive
            for side in fixture.sides
            for team, program in zip(side.teams, job.seats[side.seat], strict=True)
        }
        sides = " ".join("+".join(side.teams) for side in fixture.sides)
        row = PlayedRow(fixture.id, job.id, sides, [list(outcome.scores), list(outcome.values)], archives, at)
        _put(connection, PLAYED, **row._asdict())


def _forget(connection: sa.Connection, fixtures: Iterable[str]) -> None:
    if forgotten := [{"one": fixture} for fixture in fixtures]:
        connection.execute(sa.delete(PLAYED).where(PLAYED.c.fixture == sa.bindparam("one")), forgotten)


def _damaged(path: Path, said: str) -> DiagnosticError:
    message = f"the store {path} is damaged: {said}"
    help_ = "put a copy of it back; or move it away: 'run' then plays all matches again, with the same results"
    return DiagnosticError(Diagnostic(STORE_DAMAGED, message, help_))


def _unwritable(path: Path, said: str) -> DiagnosticError:
    message = f"the tournament's data cannot be written: {path}: {said}"
    help_ = "free some space there, or allow writing; then run the command again: it continues where it stopped"
    return DiagnosticError(Diagnostic(STORE_UNWRITABLE, message, help_))
