"""Starts the site: the database, the pages and a dispatcher, in one command."""

from __future__ import annotations

import fcntl
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from rcj_challenges.core.codes import BAD_OPTION
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.codes import SITE_DATABASE, SITE_ISOLATION
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.errors import SiteError

_LEFT_OPEN_S = 3
_PARENT = "RCJ_SITE_PROCESS"
"""Holds the process of the pages, with which its dispatcher ends."""


@contextmanager
def _alone(config: SiteConfig) -> Iterator[None]:
    """Let one process at a time change the schema: two at once fail."""
    with (config.folder / "migrate.lock").open("ab") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def migrate(config: SiteConfig) -> list[str]:
    """Bring the database up to date; return the names of the changes made.

    Raises:
        SiteError: the database cannot be opened or changed.
    """
    from django.core.management import call_command  # noqa: PLC0415 - once Django is set up
    from django.db import DatabaseError, connection  # noqa: PLC0415
    from django.db.migrations.executor import MigrationExecutor  # noqa: PLC0415

    try:
        with _alone(config):
            executor = MigrationExecutor(connection)
            plan = executor.migration_plan(executor.loader.graph.leaf_nodes())
            if plan:
                call_command("migrate", interactive=False, verbosity=0)
            return [f"{migration.app_label}.{migration.name}" for migration, _ in plan]
    except DatabaseError as error:
        first = str(error).strip().splitlines()[0]
        raise SiteError(
            f"the database cannot be used: {first}", "check database in site.yaml", code=SITE_DATABASE
        ) from error


def ensure_isolation(config: SiteConfig) -> None:
    """Refuse to run programs of strangers where they cannot be isolated.

    Raises:
        SiteError: they cannot.
    """
    from rcj_challenges.core.errors import RcjError  # noqa: PLC0415
    from rcj_challenges.programs.isolation import active_layers  # noqa: PLC0415 - only a dispatcher needs it

    if config.trust_all_teams:
        return
    try:
        active_layers("strict")
    except RcjError as error:
        message = f"programs cannot be isolated here: {error}"
        raise SiteError(message, "run it on Linux, or give --trust-all-teams", code=SITE_ISOLATION) from error


def first_link(address: str) -> str | None:
    """Return a link for the first organizer, if there is no organizer yet; and make the first season."""
    from rcj_challenges.web import jobs  # noqa: PLC0415 - once Django is set up
    from rcj_challenges.web.models import Account, Role, Season  # noqa: PLC0415

    with jobs.writing():
        if not Season.objects.exists():
            Season.objects.create(title="First season")
        if Account.objects.filter(role=Role.ORGANIZER).exists():
            return None
    return organizer_link(address)


def organizer_link(address: str) -> str:
    """Return a link with which an organizer makes an account, once."""
    from django.utils import timezone  # noqa: PLC0415 - once Django is set up

    from rcj_challenges.web import jobs  # noqa: PLC0415
    from rcj_challenges.web.accounts import invite  # noqa: PLC0415
    from rcj_challenges.web.models import Role  # noqa: PLC0415

    with jobs.writing():
        return f"{address}/invite/{invite(Role.ORGANIZER, None, timezone.now())}"


def work(config: SiteConfig) -> None:
    """Run a dispatcher until it is interrupted or terminated."""
    from rcj_challenges.web.dispatcher import Dispatcher  # noqa: PLC0415 - once Django is set up

    ensure_isolation(config)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    parent = os.environ.get(_PARENT)
    Dispatcher(config).run(int(parent) if parent else None)


def serve(config: SiteConfig, host: str, port: int, *, dispatch: bool, on_start: Any) -> None:
    """Serve the pages, and run a dispatcher beside them that is started again if it dies.

    Args:
        config: the settings.
        host: the address to listen at.
        port: the port; 0: a free one.
        dispatch: whether a dispatcher runs here.
        on_start: called with the address once it listens.

    Raises:
        SiteError: the port is taken.
    """
    import uvicorn  # noqa: PLC0415 - for this command only

    from rcj_challenges.web.front import asgi_app  # noqa: PLC0415

    Blobs(config.folder).sweep()
    listening = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET)
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind((host, port))
        listening.listen()  # from here on a browser that follows the printed link waits instead of being refused
    except OSError as error:
        message = f"cannot listen at {host}:{port}: {error.strerror}"
        raise SiteError(message, "give another --port", code=BAD_OPTION) from error
    address = f"http://{'localhost' if host in {'127.0.0.1', '0.0.0.0'} else host}:{listening.getsockname()[1]}"  # noqa: S104
    server = uvicorn.Server(
        uvicorn.Config(
            asgi_app(config), lifespan="off", access_log=False, log_level="warning", server_header=False,
            timeout_graceful_shutdown=_LEFT_OPEN_S,
        )
    )  # fmt: skip
    stopped = threading.Event()
    keeper = threading.Thread(target=_keep_dispatcher, args=(config, stopped)) if dispatch else None
    if keeper is not None:
        keeper.start()
    try:
        on_start(address)
        server.run(sockets=[listening])
    finally:
        stopped.set()
        if keeper is not None:
            keeper.join()


def _keep_dispatcher(config: SiteConfig, stopped: threading.Event) -> None:
    """Run a dispatcher in a process of its own; if it dies, start another a moment later."""
    command = [sys.executable, "-P", "-m", "rcj_challenges", "site", "worker", str(config.folder)]
    if config.trust_all_teams:
        command.append("--trust-all-teams")
    package = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))  # noqa: PTH100, PTH120
    environment = {**os.environ, "PYTHONPATH": package, _PARENT: str(os.getpid())}
    while not stopped.is_set():
        with subprocess.Popen(command, env=environment, start_new_session=True) as process:
            while process.poll() is None and not stopped.wait(0.2):
                pass
            process.terminate()
        stopped.wait(1.0)
