"""Whatever is killed, and whenever: no upload with a receipt is lost, none is checked twice, none waits for ever.

Nor is a match of the ladder twice in the table, or with another result than without a kill.
"""

from __future__ import annotations

import contextlib
import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

import pytest
from django.utils import timezone

from rcj_challenges.web import jobs, seasons, tables
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.ladder.ratings import Result, fit, standings
from rcj_challenges.web.models import Audit, Basis, Entry, Job, JobState, Match, Season, State, Submission
from tests.web.brisk_worker import LEASE_S, result_of
from tests.web.conftest import Postgres, Served, make_folder, make_team, use_site
from tests.web.handing_in import hand_in

ROOT = Path(__file__).parents[2]
MANY = {"uploads_per_hour": 100_000, "uploads_per_day": 100_000}
OPEN = (State.QUEUED, State.CHECKING)
_SETTLE_S = 60.0


class Workers:
    """Workers that are forked from one process, so that the next one is there in a moment."""

    def __init__(self, config: SiteConfig, count: int) -> None:
        command = [sys.executable, "-m", "tests.web.brisk_worker", str(config.folder)]
        with (config.folder / "workers.log").open("ab") as log:
            self._nursery = subprocess.Popen(
                command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, text=True
            )
        self.pids = [self._start() for _ in range(count)]

    def _start(self) -> int:
        assert self._nursery.stdin is not None
        assert self._nursery.stdout is not None
        self._nursery.stdin.write("start\n")
        self._nursery.stdin.flush()
        return int(self._nursery.stdout.readline())

    def kill(self, index: int) -> None:
        os.kill(self.pids[index], signal.SIGKILL)
        self.pids[index] = self._start()

    def end(self) -> None:
        self._nursery.kill()
        for pid in self.pids:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        self._nursery.communicate()


@contextmanager
def workers(config: SiteConfig, count: int) -> Iterator[Workers]:
    started = Workers(config, count)
    try:
        yield started
    finally:
        started.end()


class Load:
    """Hands in for some teams without a pause, over HTTP, until each upload has its receipt."""

    def __init__(self, served: Served, codes: list[str]) -> None:
        self.receipts: list[dict[str, Any]] = []
        self.cut_off, self.last = 0, {}
        self._served, self._codes, self._stopped = served, codes, threading.Event()
        self._thread = threading.Thread(target=self._run)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stopped.set()
        self._thread.join()

    def wait_for(self, count: int) -> None:
        """Wait for some receipts more."""
        count, until = len(self.receipts) + count, time.monotonic() + _SETTLE_S
        while len(self.receipts) < count:
            assert time.monotonic() < until, (self.last, self._served.log.read_text(encoding="utf-8")[-2000:])
            time.sleep(0.01)

    def _run(self) -> None:
        count = 0
        while not self._stopped.is_set():
            code = self._codes[count % len(self._codes)]
            try:
                status, receipt = self._served.submit(code, f"archive {count}".encode())
            except (OSError, ValueError):
                status, receipt = 0, {"message": "cut off"}
            if status != 201:
                self.cut_off, self.last = self.cut_off + 1, receipt
                time.sleep(0.05)
                continue
            self.receipts.append(receipt)
            count += 1
            time.sleep(0.02)


def settle(config: SiteConfig) -> None:
    """Wait until all is checked; what is stuck is tried again, as an organizer would."""
    until = time.monotonic() + _SETTLE_S
    while Submission.objects.filter(state__in=OPEN).exists() or Job.objects.filter(state=JobState.STUCK).exists():
        for job in Job.objects.filter(state=JobState.STUCK):
            jobs.try_again(job, timezone.now())
        assert time.monotonic() < until, (config.folder / "workers.log").read_text(encoding="utf-8")[-2000:]
        time.sleep(0.1)


def wait_for_matches(count: int) -> None:
    """Wait until some matches have been played."""
    until = time.monotonic() + _SETTLE_S
    while Match.objects.filter(played_at__isnull=False).count() < count:
        assert time.monotonic() < until
        time.sleep(0.1)


def assert_matches_are_as_without_kills() -> None:
    matches = list(Match.objects.select_related("blue", "yellow").order_by("number"))
    assert [one.number for one in matches] == sorted({one.number for one in matches})
    counted = list(Audit.objects.filter(act="result").values_list("about", flat=True))
    assert sorted(key.rpartition("/")[2] for key in counted) == sorted(str(one.pk) for one in matches)
    secret = Season.objects.get().secret
    expected = []
    for one in matches:
        assert one.seed == seasons.seed_of(secret, "rated", one.number)
        result = result_of(one.seed, one.blue.digest, one.yellow.digest)
        assert one.digest == result["digest"]
        expected.append(Result(one.blue.digest, one.yellow.digest, *result["score"].values()))
    basis = Basis.objects.get()
    undisturbed = fit(expected, seasons.programs_of(basis.season))
    table = tables.standings_of(basis)
    assert table.fitted.strengths.tobytes() == undisturbed.strengths.tobytes()
    shown = standings(undisturbed, set(seasons.playing_now(basis.season)))
    assert table.published.table == shown


def assert_nothing_is_lost(receipts: list[dict[str, Any]], team_count: int) -> None:
    stored = dict(Submission.objects.values_list("pk", "sha256"))
    assert {receipt["id"]: receipt["sha256"] for receipt in receipts}.items() <= stored.items()
    assert not Job.objects.exclude(state=JobState.DONE).exists()
    verdicts = list(Audit.objects.filter(act="verdict").values_list("about", flat=True))
    assert len(verdicts) == len(set(verdicts))
    # An upload whose receipt was lost is handed in again: if the check of the first had ended, it has its verdict.
    accepted = Submission.objects.filter(state=State.ACCEPTED).exclude(via="sample")
    assert {f"check/{one.pk}" for one in accepted if Job.objects.filter(submission=one).exists()} == set(verdicts)
    for one in accepted.filter(job=None):
        assert accepted.filter(team=one.team, sha256=one.sha256, pk__lt=one.pk).exists()
    assert not Submission.objects.exclude(state__in=(State.ACCEPTED, State.SUPERSEDED)).exists()
    # As without any death: of each team the last one plays, with the verdict of its own bytes.
    assert Entry.objects.count() == team_count
    for entry in Entry.objects.select_related("active", "team"):
        last = Submission.objects.filter(team=entry.team).order_by("-number").first()
        assert last is not None
        assert entry.active == last
        assert last.digest == last.sha256


def kill_at_random(
    config: SiteConfig, served: Served, kills: int, postgres: Postgres | None, seed: int
) -> tuple[Load, dict[str, int]]:
    """Kill processes at random moments while teams hand in and workers check."""
    with use_site(config):
        codes = [make_team(f"Team {index}")[1] for index in range(6)]
        seasons.begin(Season.objects.get(), timezone.now())
    chance = random.Random(seed)  # noqa: S311 - no secret
    port = int(served.address.rsplit(":", 1)[1])
    counts = {"web": 0, "worker": 0, "database": 0}
    with workers(config, 3) as working:
        with Load(served, codes) as load:
            for number in range(kills):
                load.wait_for(chance.randrange(5))
                time.sleep(chance.random() * 0.1)
                if number % 20 == 10:
                    counts["web"] += 1
                    served.process.kill()
                    served.stop()
                    served.start(port)
                elif number % 5 == 3 and postgres is not None:
                    counts["database"] += 1
                    postgres.kill()
                    postgres.start()
                else:
                    counts["worker"] += 1
                    working.kill(chance.randrange(3))
            load.wait_for(6)
        with use_site(config):
            settle(config)
            wait_for_matches(len(codes))
            seasons.end(Season.objects.get(), timezone.now())
            settle(config)
    return load, counts


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=pytest.mark.nightly)])
def any_folder(request: pytest.FixtureRequest, tmp_path: Path, folder: Callable[..., SiteConfig]) -> SiteConfig:
    """Return the folder of a site that is not used by this process yet, with each database."""
    if request.param == "sqlite":
        return folder(**MANY)
    return make_folder(tmp_path / "club", request.getfixturevalue("postgres").new_database(), **MANY)


@pytest.mark.parametrize("kills", [20, pytest.param(200, marks=pytest.mark.nightly)])
def test_kills_at_random_moments_lose_nothing_and_repeat_nothing(
    any_folder: SiteConfig, serve: Callable[..., Served], request: pytest.FixtureRequest, kills: int
) -> None:
    postgres = None if any_folder.is_sqlite else request.getfixturevalue("postgres")
    served = serve(any_folder, "--no-dispatch")
    load, counts = kill_at_random(any_folder, served, kills, postgres, seed=kills)
    with use_site(any_folder):
        retaken = Job.objects.filter(attempt__gt=1).count()
        print(f"{counts} killed; {len(load.receipts)} receipts, {load.cut_off} cut off, {retaken} jobs leased again")
        print(f"{Match.objects.count()} matches")
        assert_nothing_is_lost(load.receipts, team_count=6)
        assert_matches_are_as_without_kills()
    assert len(load.receipts) > kills


@pytest.mark.nightly
def test_a_worker_that_was_suspended_stores_nothing_when_it_goes_on(any_folder: SiteConfig) -> None:
    with use_site(any_folder), workers(any_folder, 2) as working:
        teams = [make_team(f"Team {index}")[0] for index in range(6)]
        suspended, other = working.pids
        for number in range(2000):
            hand_in(any_folder, teams[number % 6], f"{number}".encode(), timezone.now())
            if number > 6 and held_by(suspended):
                os.kill(suspended, signal.SIGSTOP)
                # SQLite has one transaction: a worker that was suspended within it holds up all, as it must.
                if held_by(suspended) and (not any_folder.is_sqlite or can_write(any_folder)):
                    break
                os.kill(suspended, signal.SIGCONT)
        held = held_by(suspended)
        time.sleep(LEASE_S)
        settle(any_folder)
        os.kill(suspended, signal.SIGCONT)
        time.sleep(1.0)
        assert held
        for job in Job.objects.filter(pk__in=held):
            by = Audit.objects.get(act="verdict", about=job.key).actor
            assert f"-{other}-" in by, (by, suspended)
        assert_nothing_is_lost([], team_count=6)


def held_by(pid: int) -> list[int]:
    return list(Job.objects.filter(state=JobState.RUNNING, worker__contains=f"-{pid}-").values_list("pk", flat=True))


def can_write(config: SiteConfig) -> bool:
    import fcntl

    with config.write_lock.open("ab") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
    return True
