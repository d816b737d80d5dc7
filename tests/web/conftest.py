"""Sites for the tests: in this process with a database of their own, or served by a real process."""

from __future__ import annotations

import json
import os
import pwd
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import quote

import django
import pytest
from django.conf import settings
from django.db import connections

from rcj_challenges.web.config import SiteConfig, load_site, make_site
from rcj_challenges.web.settings import settings_for

# The driver of a browser that another test of this process uses keeps a loop of events, which Django takes for its caller.
os.environ["DJANGO_ALLOW_ASYNC_UNSAFE"] = "1"

# Django is set up once in a process; `use_site` then gives it the folder and the database of a test's own site.
if not settings.configured:
    _NO_SITE = SiteConfig(folder=Path("no-site"))
    settings.configure(**settings_for(_NO_SITE, "x" * 50), RCJ=_NO_SITE)
    django.setup()

NOW = datetime(2026, 3, 14, 12, 0, tzinfo=UTC)
_START_S = 60.0


@contextmanager
def use_site(config: SiteConfig) -> Iterator[None]:
    """Let this process work on a site."""
    from django.test import override_settings

    made = {**settings_for(config, (config.folder / "secret_key").read_text(encoding="utf-8")), "RCJ": config}
    databases = made.pop("DATABASES")
    if config.is_sqlite:  # nothing here outlives a power cut, and waiting for the disk takes most of the time
        databases["default"]["OPTIONS"]["init_command"] = "PRAGMA journal_mode=WAL; PRAGMA synchronous=OFF;"
    other = {name: value for name, value in made.items() if getattr(settings, name) != value}
    _close_all()
    before = connections.settings
    connections.settings = connections.configure_settings(databases)
    with override_settings(**other):
        yield
    _close_all()
    connections.settings = before


def _close_all() -> None:
    connections.close_all()
    for alias in list(connections.settings):
        if hasattr(connections, "_connections") and hasattr(connections._connections, alias):
            close_pool = getattr(connections[alias], "close_pool", None)
            if close_pool is not None:
                close_pool()
            del connections[alias]


def make_folder(folder: Path, database: str = "sqlite", **options: Any) -> SiteConfig:
    """Make the folder of a site with other settings than the usual ones; its database is empty."""
    make_site(folder, "Test club")
    with (folder / "site.yaml").open("a", encoding="utf-8") as file:
        for key, value in options.items():
            file.write(f"{key}: {json.dumps(value)}\n")
    text = (folder / "site.yaml").read_text(encoding="utf-8").replace("database: sqlite", f"database: {database}")
    lines = text.splitlines()
    for key in options:  # a later line of the same name wins, and only that one is left
        first = next(index for index, line in enumerate(lines) if line.startswith(f"{key}:"))
        if sum(line.startswith(f"{key}:") for line in lines) > 1:
            del lines[first]
    (folder / "site.yaml").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return load_site(folder)


@pytest.fixture(scope="session")
def migrated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return an SQLite file with all tables, to be copied: making them takes a second."""
    from rcj_challenges.web.serving import migrate

    config = make_folder(tmp_path_factory.mktemp("migrated") / "club")
    with use_site(config):
        migrate(config)
    return config.folder / "site.sqlite3"


@pytest.fixture
def folder(tmp_path: Path, migrated: Path) -> Callable[..., SiteConfig]:
    """Return a function that makes the folder of a site with SQLite, its tables made and empty."""

    def make(**options: Any) -> SiteConfig:
        config = make_folder(tmp_path / "club", **options)
        shutil.copy(migrated, config.folder / "site.sqlite3")
        return config

    return make


@pytest.fixture
def site(folder: Callable[..., SiteConfig]) -> Iterator[SiteConfig]:
    """Return a new site with SQLite, on which this process works."""
    config = folder()
    with use_site(config):
        yield config


@pytest.fixture(params=["sqlite", "postgresql"])
def any_site(request: pytest.FixtureRequest, tmp_path: Path, folder: Callable[..., SiteConfig]) -> Iterator[SiteConfig]:
    """Return a new site on which this process works, once with each database."""
    if request.param == "sqlite":
        config = folder()
    else:
        config = make_folder(tmp_path / "club", request.getfixturevalue("postgres").new_database())
    with use_site(config):
        yield config


class Served:
    """A site that a process of its own serves.

    Args:
        config: its settings.
        options: further options of ``site serve``.
    """

    def __init__(self, config: SiteConfig, *options: str) -> None:
        self.config = config
        self._options = options
        self.log = config.folder / "serve.log"
        self.address = ""
        self.first_link = ""
        self.start()

    def start(self, port: int = 0) -> None:
        """Start it, and wait until it listens."""
        with self.log.open("ab") as log:
            self.process = subprocess.Popen(
                [*COMMAND, "site", "serve", str(self.config.folder), "--port", str(port), *self._options],
                stdout=subprocess.PIPE, stderr=log, text=True, start_new_session=True,
            )  # fmt: skip
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        assert line, self.log.read_text(encoding="utf-8")
        self.address = line.rsplit(": ", 1)[1].strip()
        until = time.monotonic() + _START_S
        while time.monotonic() < until:
            try:
                self.get("/healthz")
                break
            except OSError:
                time.sleep(0.05)

    def stop(self) -> None:
        """Stop it as Ctrl-C does, and wait."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(30)
            except subprocess.TimeoutExpired:
                os.killpg(self.process.pid, signal.SIGKILL)
                self.process.wait()
        assert self.process.stdout is not None
        self.process.stdout.close()

    def get(self, path: str, headers: dict[str, str] | None = None) -> tuple[int, bytes]:
        """Return the status and the body of an answer."""
        return self.send(path, None, headers)

    def send(self, path: str, body: bytes | None, headers: dict[str, str] | None = None) -> tuple[int, bytes]:
        """Send a body by POST; return the status and the body of the answer."""
        request = urllib.request.Request(self.address + path, body, headers or {})  # noqa: S310 - our own server
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:  # noqa: S310
                return answer.status, answer.read()
        except urllib.error.HTTPError as error:
            with error:
                return error.code, error.read()

    def submit(self, code: str, archive: bytes) -> tuple[int, dict[str, Any]]:
        """Hand an archive in as a program does; return the status and the receipt or problem."""
        headers = {"Authorization": f"Bearer {code}", "Content-Type": "application/zip"}
        status, body = self.send("/api/v1/submissions", archive, headers)
        try:
            return status, json.loads(body)
        except ValueError:
            return status, {"message": body.decode("utf-8", "replace")}

    def state(self, code: str, pk: int) -> dict[str, Any]:
        """Return where a submission stands."""
        status, body = self.get(f"/api/v1/submissions/{pk}", {"Authorization": f"Bearer {code}"})
        assert status == 200, body
        return dict(json.loads(body))


COMMAND = [sys.executable, "-P", "-m", "rcj_challenges"]


@pytest.fixture
def serve() -> Iterator[Callable[..., Served]]:
    """Return a function that serves a site by a real process on a free port, with options of ``site serve``."""
    running: list[Served] = []

    def start(config: SiteConfig, *options: str) -> Served:
        running.append(Served(config, *options))
        return running[-1]

    yield start
    for served in running:
        served.stop()


@pytest.fixture(scope="module")
def quiet(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Served]:
    """A site for the tests of a module, which takes small archives and checks nothing."""
    options = {"upload_bytes": 100_000, "uploads_per_hour": 1000, "uploads_per_day": 1000}
    config = make_folder(tmp_path_factory.mktemp("quiet") / "club", **options)
    shutil.copy(migrated, config.folder / "site.sqlite3")
    served = Served(config, "--no-dispatch")
    yield served
    served.stop()


def make_team(name: str = "Blue Foxes", group: str = "School 1") -> tuple[Any, str]:
    """Make a team of the site that this process works on, and a season if there is none; return its code, too."""
    from rcj_challenges.web.accounts import give_card
    from rcj_challenges.web.models import Group, Season, Team

    if not Season.objects.exists():
        Season.objects.create(title="Season", overrides=["match.half_s=2"])
    team = Team.objects.create(group=Group.objects.get_or_create(label=group)[0], name=name)
    return team, give_card(team)


# PostgreSQL: Debian's own server, started in a folder by a user without rights, as it demands.


@cache
def postgres_programs() -> Path | None:
    """Return the folder with the newest server's programs; None: it is not installed."""
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda path: int(path.parts[-3]))
    return found[-1].parent if found else None


class Postgres:
    """A server of PostgreSQL in a folder, reached by a socket there.

    Args:
        folder: in which its data and its socket are.
        programs: the folder of its programs.
    """

    def __init__(self, folder: Path, programs: Path) -> None:
        self.folder = folder
        self._programs = programs
        self._data = folder / "data"
        self._user: dict[str, Any] = {}
        if os.getuid() == 0:
            entry = pwd.getpwnam("postgres")
            os.chown(folder, entry.pw_uid, entry.pw_gid)
            self._user = {"user": entry.pw_uid, "group": entry.pw_gid, "extra_groups": []}
        self._run("initdb", "-D", str(self._data), "-U", "rcj", "-A", "trust", "--no-sync", "-E", "UTF8", "--locale=C")
        self._databases = 0
        self.start()

    def _run(self, name: str, *options: str) -> None:
        subprocess.run(
            [self._programs / name, *options],
            check=True,
            capture_output=True,
            cwd=self.folder,
            timeout=60,
            **self._user,
        )

    def start(self) -> None:
        """Start the server, and wait until it answers."""
        server = f"-c listen_addresses='' -c unix_socket_directories={self.folder} -c shared_buffers=16MB -c fsync=off"
        log = str(self.folder / "log")
        # No shell: the pipes of `_run` would stay open as long as the server lives.
        started = subprocess.run(
            [self._programs / "pg_ctl", "-D", self._data, "-l", log, "-w", "-o", server, "start"],
            check=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            cwd=self.folder, timeout=60, **self._user,
        )  # fmt: skip
        assert started.returncode == 0, Path(log).read_text(encoding="utf-8")[-3000:]

    def stop(self, mode: str = "fast", *, wait: bool = True) -> None:
        """Stop the server: fast, or immediate, without a last checkpoint."""
        self._run("pg_ctl", "-D", str(self._data), "-w" if wait else "-W", "-m", mode, "stop")

    def kill(self) -> None:
        """End the server with all its processes, as if the power had gone."""
        pid = int((self._data / "postmaster.pid").read_text(encoding="utf-8").splitlines()[0])
        os.kill(pid, signal.SIGSTOP)  # it starts no more
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="utf-8").split()
        for one in (pid, *map(int, children)):
            os.kill(one, signal.SIGKILL)
        until = time.monotonic() + _START_S
        while any(Path(f"/proc/{one}").exists() for one in (pid, *children)):
            assert time.monotonic() < until
            time.sleep(0.01)

    def url(self, name: str) -> str:
        """Return the address of a database, as ``site.yaml`` has it."""
        return f"postgresql://rcj@{quote(str(self.folder), safe='')}/{name}"

    def sql(self, text: str, database: str = "postgres") -> list[Any]:
        """Run a statement; return its rows."""
        import psycopg

        with psycopg.connect(host=str(self.folder), user="rcj", dbname=database, autocommit=True) as connection:
            cursor = connection.execute(text)
            return cursor.fetchall() if cursor.description else []

    def new_database(self) -> str:
        """Make a database with all tables; return its address."""
        if not self._databases:
            from rcj_challenges.web.serving import migrate

            self.sql("CREATE DATABASE migrated")
            with tempfile.TemporaryDirectory() as made:
                config = make_folder(Path(made) / "club", self.url("migrated"))
                with use_site(config):
                    migrate(config)
        self._databases += 1
        name = f"site{self._databases}"
        self.sql(f"CREATE DATABASE {name} TEMPLATE migrated")
        return self.url(name)


@pytest.fixture(scope="session")
def postgres() -> Iterator[Postgres]:
    """Start a server of PostgreSQL for this process's tests."""
    programs = postgres_programs()
    if programs is None:
        pytest.skip("PostgreSQL's server is not installed (apt-get install postgresql)")
    folder = Path(tempfile.mkdtemp(prefix="rcj-pg-"))
    try:
        server = Postgres(folder, programs)
        yield server
        server.stop("immediate", wait=False)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if sys.platform == "win32":
    collect_ignore_glob = ["*"]
