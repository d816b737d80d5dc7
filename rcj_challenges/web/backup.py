"""Backups of a site while it runs, and what is wrong with one."""

from __future__ import annotations

import errno
import hashlib
import os
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.tournament.store.store import STORE_FILE
from rcj_challenges.web.blobs import Blobs, match_folder
from rcj_challenges.web.codes import BACKUP_DATABASE, SITE_EXISTS
from rcj_challenges.web.config import SECRET_FILE, SITE_FILE, SiteConfig
from rcj_challenges.web.errors import SiteError

_DATABASE = "site.sqlite3"
_FOLDERS = ("blobs", "reports", "matches", "events")


def back_up(config: SiteConfig, target: Path) -> None:
    """Copy a site into a new folder, which is a site, too; files that never change are hard links, if they can be.

    The database comes first: what it names is on the disk before it does so.

    Raises:
        SiteError: the folder is not empty, or the database is none that this copies.
        OSError: the disk is full or broken.
    """
    if not config.is_sqlite:
        message = "the database is PostgreSQL's, which has its own backups"
        raise SiteError(message, "use pg_dump, and then copy the folder of the site", code=BACKUP_DATABASE)
    if target.exists() and any(target.iterdir()):
        raise SiteError(f"{sanitize(target)}: this folder is not empty", "name a new one", code=SITE_EXISTS)
    target.mkdir(mode=0o700, parents=True, exist_ok=True)
    (target / "incoming").mkdir()
    # In one step: each write of another process would begin a backup in steps anew.
    _copy_database(config.folder / _DATABASE, target / _DATABASE)
    with closing(sqlite3.connect(target / _DATABASE)) as copy:
        named = {sha256 for (sha256,) in copy.execute("SELECT sha256 FROM web_submission WHERE NOT is_deleted")}
    for name in (SITE_FILE, SECRET_FILE):
        shutil.copy2(config.folder / name, target / name)
    for name in _FOLDERS:
        (target / name).mkdir()
        for folder, _, files in os.walk(config.folder / name):
            for file in files:
                path = Path(folder, file)
                if path.name == STORE_FILE:
                    (target / path.relative_to(config.folder)).parent.mkdir(parents=True, exist_ok=True)
                    _copy_database(path, target / path.relative_to(config.folder))
                elif path.name.startswith(STORE_FILE):  # what SQLite keeps beside it
                    continue
                elif name != "blobs" or path.stem in named:  # others came since
                    _link(path, target / path.relative_to(config.folder))


def _copy_database(source: Path, target: Path) -> None:
    with closing(sqlite3.connect(source)) as own, closing(sqlite3.connect(target)) as copy:
        own.backup(copy)


def _link(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    with suppress(FileNotFoundError):  # records, and files of deleted teams, go at any time
        try:
            target.hardlink_to(source)
        except OSError as error:
            if error.errno not in {errno.EXDEV, errno.EPERM, errno.EMLINK}:
                raise
            shutil.copy2(source, target)


def problems(config: SiteConfig) -> Iterator[str]:
    """Yield what is wrong with the data of a site: archives and scenarios that are missing or damaged, and alarms."""
    from rcj_challenges.web.models import Basis, Job, JobState, Submission  # noqa: PLC0415 - once Django is set up

    blobs = Blobs(config.folder)
    kept = set(Submission.objects.filter(is_deleted=False).values_list("sha256", flat=True))
    for sha256 in sorted(kept):
        path = blobs.path(sha256)
        if not path.is_file():
            yield f"an archive is missing: {path}"
        elif hashlib.sha256(path.read_bytes()).hexdigest() != sha256:
            yield f"an archive is damaged: {path}"
    for path in sorted((config.folder / "blobs").glob("*/*.zip")):
        if path.stem not in kept:
            yield f"an archive belongs to no submission: {path}"
    for basis in Basis.objects.all():
        path = match_folder(config.folder) / "scenarios" / f"{basis.scenario}.json"
        if not path.is_file():
            yield f"the scenario of a season is missing: {path}"
    for job in Job.objects.filter(state=JobState.STUCK):
        yield f"a job is stuck: {job.key}: {sanitize(job.error)}"
