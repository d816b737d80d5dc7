"""The dispatcher: leases jobs, has them done by processes of their own, and stores what came of them."""

from __future__ import annotations

import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager, suppress
from datetime import datetime
from pathlib import Path
from typing import Any

from django.db import DatabaseError, close_old_connections, connections

from rcj_challenges.match.worker_pool import python_command
from rcj_challenges.web import deadlines, events, jobs, matchmaking, seasons, stage
from rcj_challenges.web.blobs import Blobs, record_folder, report_folder
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.jobs import Verdict
from rcj_challenges.web.models import Event, Job, Match, State, Submission, Worker
from rcj_challenges.web.playing import job_of
from rcj_challenges.web.receiving import accept_repaired

_START = "import sys; sys.path.append(sys.argv[1]); from rcj_challenges.web.check_process import work; work()"
_POLL_S = 0.5
_MAX_JOB_S, _MAX_EVENT_S = 3600.0, 24 * 3600.0
_CLEAN_UP_S = 3600.0
_KEPT_LANE = ("check", "repair")
"""Kinds of jobs for which the first of several lanes is kept."""


class _HostFaultError(Exception):
    """A job could not be done because of this computer or a bug of ours."""


@contextmanager
def _logged() -> Iterator[None]:
    """Log a failure, and go on: the database may be away for a moment."""
    try:
        yield
    except Exception as error:  # noqa: BLE001 - whatever it is, the other jobs are to be done
        sys.stderr.write(f"dispatcher: {type(error).__name__}: {error}\n")
    finally:
        with suppress(DatabaseError):
            close_old_connections()


def _move(made: Path, target: Path) -> None:
    """Move what a job has made to its place, unless a first attempt to store the result did."""
    if made.exists():
        shutil.rmtree(target, ignore_errors=True)
        target.parent.mkdir(parents=True, exist_ok=True)
        made.rename(target)


class Dispatcher:
    """Does jobs in as many lanes as the site has.

    Args:
        config: the settings of the site.
        now: returns the time.
    """

    def __init__(self, config: SiteConfig, now: Callable[[], datetime] = jobs.database_now) -> None:
        self.name = f"{socket.gethostname()}-{os.getpid()}-{secrets.token_hex(3)}"[:80]
        self._config = config
        self._blobs = Blobs(config.folder)
        self._now = now
        self._held: set[tuple[int, int]] = set()
        self._processes: dict[tuple[int, int], subprocess.Popen[str]] = {}
        self._lock = threading.Lock()
        self._stopped = threading.Event()
        self._cleans_at = 0.0
        self._versions = seasons.own_versions()

    def run(self, parent: int | None = None) -> None:
        """Work until it is interrupted; then the running processes are ended, and their jobs given back.

        Args:
            parent: a process with which this one ends.
        """
        kinds = [tuple(jobs.PRIORITY)] * self._config.lanes
        if len(kinds) > 1:
            kinds[0] = _KEPT_LANE
        lanes = [threading.Thread(target=self._lane, args=(of_lane,)) for of_lane in kinds]
        for lane in lanes:
            lane.start()
        try:
            while parent is None or os.getppid() == parent:
                self._heartbeat()
                time.sleep(jobs.HEARTBEAT_S)
        except KeyboardInterrupt:
            pass
        finally:
            self._stop()
        for lane in lanes:
            lane.join()

    def _stop(self) -> None:
        self._stopped.set()
        with self._lock:
            for process in self._processes.values():
                if process.stdin is not None:
                    process.stdin.close()

    def do_next(self, kinds: Collection[str] = tuple(jobs.PRIORITY)) -> bool:
        """Claim a job of some kinds and do it; return False if there is none."""
        if not self._blobs.has_room():
            return False
        job = jobs.claim(self.name, self._now(), kinds, seasons.fitting_bases(self._versions))
        if job is None:
            return False
        claim = (job.pk, job.attempt)
        with self._lock:
            self._held.add(claim)
        began = time.monotonic()
        try:
            store = self._do(job, claim)
            self._insist(lambda took_s: jobs.finish(job, self._now(), took_s, store), began)
        except (_HostFaultError, OSError) as error:
            text, is_try = str(error), not self._stopped.is_set()
            self._insist(lambda took_s: jobs.fail(job, self._now(), took_s, text, is_try=is_try), began)
        finally:
            with self._lock:
                self._held.discard(claim)
            shutil.rmtree(self._blobs.working(job), ignore_errors=True)
        return True

    def _insist(self, end: Callable[[float], bool], began: float) -> None:
        """Store how a job ended; if the database is away, try again as long as a lease lasts."""
        took_s = time.monotonic() - began
        until = time.monotonic() + jobs.LEASE.total_seconds()
        while True:
            try:
                end(took_s)
            except DatabaseError:
                close_old_connections()
                if time.monotonic() > until or self._stopped.wait(_POLL_S):
                    raise
            else:
                return

    def _lane(self, kinds: Collection[str]) -> None:
        while not self._stopped.is_set():
            with _logged():
                if self.do_next(kinds):
                    continue
            self._stopped.wait(_POLL_S)
        connections.close_all()

    def _heartbeat(self) -> None:
        """Renew the leases; a process whose lease another worker has is ended."""
        with self._lock:
            held = set(self._held)
        lost: set[tuple[int, int]] = set()
        with _logged():
            now = self._now()
            seen = {"seen_at": now, "lanes": self._config.lanes, "versions": self._versions}
            with jobs.writing():
                Worker.objects.update_or_create(name=self.name, defaults=seen)
            lost = held - jobs.renew(self.name, held, now)
            if time.monotonic() >= self._cleans_at:
                self._cleans_at = time.monotonic() + _CLEAN_UP_S
                jobs.clean_up(now)
                seasons.drop_records(now)
                stage.drop_shown(now)
        with self._lock:
            for claim in lost & self._held:
                if claim in self._processes:
                    self._processes[claim].kill()
        with _logged():
            events.attend(self._now())
        with _logged():
            matchmaking.fill(self._config.lanes, self._now(), seasons.fitting_bases(self._versions))
            stage.fill(self._now())

    def _do(self, job: Job, claim: tuple[int, int]) -> Callable[[Job], None]:
        """Do a job; return what stores its result."""
        self._blobs.remove_left(job)
        self._blobs.working(job).mkdir()
        if job.match is not None:
            return self._play(job, job.match, claim)
        if job.event is not None:
            return self._play_event(job, job.event, claim)
        submission = job.submission
        assert submission is not None  # noqa: S101 - a job is about one of the three
        if job.kind == "repair":
            return self._repair(job, submission, claim)
        answer = self._answer(job, claim, {"kind": "check", **self._about(submission)})
        report = answer["report"]
        if answer["host"] or report["level"] == "unchecked":
            raise _HostFaultError(report["blocked_by"] or "the check itself failed")
        state = State.REJECTED if report["level"] == "error" else State.ACCEPTED
        verdict = Verdict(state, report["level"], report["digest"], report)

        def store(_job: Job) -> None:
            deadlines.close(self._now())
            jobs.store_verdict(submission, verdict)
            _move(self._blobs.working(job), report_folder(self._config.folder, submission))

        return store

    def _repair(self, job: Job, submission: Submission, claim: tuple[int, int]) -> Callable[[Job], None]:
        answer = self._answer(job, claim, {"kind": "repair", **self._about(submission)})
        if answer["repaired"] is None:
            return lambda _: None

        def store(_job: Job) -> None:  # runs only if the result still counts: the team may have been deleted since
            accept_repaired(submission, *self._blobs.keep_bytes(Path(answer["repaired"]).read_bytes()), self._now())

        return store

    def _play(self, job: Job, match: Match, claim: tuple[int, int]) -> Callable[[Job], None]:
        played = job_of(match, self._sandbox).to_json()
        answer = self._answer(job, claim, {"kind": "match", "job": played, "site": str(self._config.folder)})
        if match.digest not in {"", answer["result"]["digest"]}:
            raise _HostFaultError("the match ended differently from the first time")

        def store(_job: Job) -> None:
            seasons.store_result(match, answer, self._now())
            _move(Path(answer["folder"]), record_folder(self._config.folder, match))

        return store

    def _play_event(self, job: Job, event: Event, claim: tuple[int, int]) -> Callable[[Job], None]:
        events.write(event)
        request = {"kind": "event", "lanes": max(1, self._config.lanes // 2), **events.request_of(event)}
        answer = self._answer(job, claim, request)
        if answer["failed"]:
            raise _HostFaultError(answer["failed"][0])
        return lambda _: events.store_played(event, answer, self._now())

    @property
    def _sandbox(self) -> str:
        return "auto" if self._config.trust_all_teams else "strict"

    def _about(self, submission: Submission) -> dict[str, Any]:
        season = submission.season
        return {
            "path": str(self._blobs.path(submission.sha256)),
            "name": f"{submission.team.public_name}, no. {submission.number}",
            "scenario": season.scenario,
            "overrides": season.overrides,
        }

    def _answer(self, job: Job, claim: tuple[int, int], request: dict[str, Any]) -> dict[str, Any]:
        """Have a process of its own do a job; return its last line."""
        request |= {"folder": str(self._blobs.working(job)), "sandbox": self._sandbox}
        with subprocess.Popen(
            python_command(_START), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8"
        ) as process:
            timer = threading.Timer(_MAX_EVENT_S if job.event_id else _MAX_JOB_S, process.kill)
            timer.start()
            with self._lock:
                self._processes[claim] = process
                if self._stopped.is_set() and process.stdin is not None:
                    process.stdin.close()
            try:
                last = self._read(job, process, request)
            finally:
                timer.cancel()
                with self._lock:
                    del self._processes[claim]
                if process.stdin is not None:
                    process.stdin.close()
        if last is not None and set(last) == {"error"}:
            raise _HostFaultError(last["error"])
        if last is None:
            raise _HostFaultError(f"the process ended without a result (exit status {process.returncode})")
        return last

    @staticmethod
    def _read(job: Job, process: subprocess.Popen[str], request: dict[str, Any]) -> dict[str, Any] | None:
        assert process.stdin is not None  # noqa: S101 - both are pipes
        assert process.stdout is not None  # noqa: S101
        try:
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()
        except (OSError, ValueError):  # it has ended, or is to end
            return None
        for line in process.stdout:
            try:
                message = json.loads(line)
            except ValueError:
                continue
            if "stage" in message:
                with suppress(DatabaseError):  # the stage is only shown
                    jobs.report_progress(job, message["stage"])
            else:
                return dict(message)
        return None
