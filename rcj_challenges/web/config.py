"""The settings of a site: ``site.yaml`` in its folder, and Django's settings made from it."""

from __future__ import annotations

import os
import secrets
from pathlib import Path
from typing import Annotated
from urllib.parse import urlsplit

import yaml
from pydantic import BaseModel, ConfigDict, Field, ValidationError, field_validator

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web.codes import BAD_SITE_FILE, NOT_A_SITE, SITE_EXISTS
from rcj_challenges.web.errors import SiteError
from rcj_challenges.web.settings import settings_for

SITE_FILE = "site.yaml"
SECRET_FILE = "secret_key"  # noqa: S105 - the name of a file

_TEMPLATE = """\
# The settings of this site; see docs/site.md.
title: {title}
# Names under which browsers reach it. Add the name or address of this computer.
hosts: [localhost, 127.0.0.1]
# true behind HTTPS: cookies are then never sent over plain HTTP.
https: false
time_zone: UTC
# sqlite, or postgresql://user:password@host/name (needs the extra [postgres])
database: sqlite
# How many checks and matches run at a time on this computer.
lanes: 2
"""


class SiteConfig(BaseModel):
    """The settings of a site.

    Attributes:
        folder: where the site keeps everything; not in the file.
        upload_bytes: the largest archive that is taken.
        lane_s_per_day: how long the jobs of one team may run in 24 hours, in s.
        team_quota: how many teams a mentor may make.
        trust_all_teams: whether programs may run without strict isolation.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    folder: Path = Field(exclude=True)
    title: Annotated[str, Field(min_length=1, max_length=100)] = "Soccer club"
    hosts: tuple[str, ...] = ("localhost", "127.0.0.1")
    https: bool = False
    time_zone: str = "UTC"
    database: str = "sqlite"
    lanes: Annotated[int, Field(ge=1, le=64)] = 2
    upload_bytes: Annotated[int, Field(ge=1000, le=100_000_000)] = 10_000_000
    uploads_per_hour: Annotated[int, Field(ge=1)] = 12
    uploads_per_day: Annotated[int, Field(ge=1)] = 60
    upload_bytes_per_day: Annotated[int, Field(ge=1000)] = 300_000_000
    lane_s_per_day: Annotated[int, Field(ge=60)] = 3600
    team_quota: Annotated[int, Field(ge=1)] = 40
    trust_all_teams: bool = Field(False, exclude=True)

    @field_validator("time_zone")
    @classmethod
    def _is_a_zone(cls, name: str) -> str:
        from zoneinfo import ZoneInfo  # noqa: PLC0415 - only when a file is read

        try:
            ZoneInfo(name)
        except Exception as error:
            raise ValueError("not a time zone; write one such as Europe/Berlin") from error
        return name

    @field_validator("database")
    @classmethod
    def _is_a_database(cls, url: str) -> str:
        if url != "sqlite" and urlsplit(url).scheme not in {"postgresql", "postgres"}:
            raise ValueError("write sqlite, or postgresql://user:password@host/name")
        return url

    @property
    def is_sqlite(self) -> bool:
        """Whether the database is the file in the folder."""
        return self.database == "sqlite"

    @property
    def write_lock(self) -> Path:
        """A file that is locked around each write to SQLite, whose own lock is unfair."""
        return self.folder / "write.lock"


def make_site(folder: Path, title: str) -> SiteConfig:
    """Make the folder of a new site, with its settings and its secret key.

    Raises:
        SiteError: there is a site already, or the folder cannot be written.
    """
    if (folder / SITE_FILE).exists():
        message = f"{sanitize(folder)}: there is a site in this folder"
        raise SiteError(message, f"start it with: rcj-challenge site serve {sanitize(folder)}", code=SITE_EXISTS)
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    for name in ("blobs", "incoming", "reports"):
        (folder / name).mkdir(exist_ok=True)
    descriptor = os.open(folder / SECRET_FILE, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(descriptor, "w", encoding="ascii") as file:
        file.write(secrets.token_urlsafe(50))
    (folder / SITE_FILE).write_text(_TEMPLATE.format(title=yaml.safe_dump(title).split("\n")[0]), encoding="utf-8")
    return load_site(folder)


def load_site(folder: Path, *, trust_all_teams: bool = False) -> SiteConfig:
    """Read the settings of a site.

    Raises:
        SiteError: the folder has no site, or a setting cannot be used.
    """
    folder = folder.resolve()
    try:
        text = (folder / SITE_FILE).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        message = f"{sanitize(folder)}: there is no site in this folder"
        raise SiteError(
            message, f"make one: rcj-challenge site init {sanitize(folder.name)}", code=NOT_A_SITE
        ) from error
    try:
        given = yaml.safe_load(text) or {}
        return SiteConfig(**{**given, "folder": folder, "trust_all_teams": trust_all_teams})
    except ValidationError as error:
        first = error.errors()[0]
        key = ".".join(map(str, first["loc"]))
        message = f"{SITE_FILE}: {key}: {sanitize(first['msg'].removeprefix('Value error, '), 200)}"
        raise SiteError(message, "docs/site.md lists the keys", code=BAD_SITE_FILE) from error
    except (yaml.YAMLError, TypeError) as error:
        message = f"{SITE_FILE}: {sanitize(error, 200)}"
        raise SiteError(message, "write one key: value to a line", code=BAD_SITE_FILE) from error


def set_up(config: SiteConfig) -> None:
    """Start Django with the settings of a site, once in a process."""
    import tempfile  # noqa: PLC0415 - only here

    import django  # noqa: PLC0415 - half a second, for the site only
    from django.conf import settings  # noqa: PLC0415

    if not settings.configured:
        tempfile.tempdir = str(config.folder / "incoming")  # bodies are spooled on the disk of the data
        settings.configure(**settings_for(config, _secret_key(config.folder)), RCJ=config)
        django.setup()


def current_site() -> SiteConfig:
    """Return the settings of the site that this process serves."""
    from django.conf import settings  # noqa: PLC0415 - once Django is set up

    config: SiteConfig = settings.RCJ  # type: ignore[misc]  # a setting of ours
    return config


def _secret_key(folder: Path) -> str:
    try:
        return (folder / SECRET_FILE).read_text(encoding="ascii")
    except OSError as error:
        message = f"{sanitize(folder)}: the file {SECRET_FILE} cannot be read"
        raise SiteError(
            message, "put it back from a backup; without it all cards and sessions end", code=NOT_A_SITE
        ) from error
