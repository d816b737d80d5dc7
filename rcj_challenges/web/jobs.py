"""The queue: jobs are leased to dispatchers, so that nothing is lost however a process ends.

A job and the submission it is about change in one transaction. A claim has a lease, which its worker renews; a lease
that runs out gives the job back. A result counts only for the claim that it belongs to.
"""

from __future__ import annotations

import fcntl
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from datetime import datetime, timedelta
from typing import Any, NamedTuple

from django.contrib.sessions.models import Session
from django.db import connection, transaction
from django.db.models import F, FloatField, OuterRef, Q, QuerySet, Subquery, Sum, Value
from django.db.models.functions import Coalesce
from django.utils import timezone

from rcj_challenges.web.config import current_site
from rcj_challenges.web.models import Entry, Event, Invite, Job, JobState, Match, State, Submission, Team, Worker

LEASE = timedelta(seconds=60)
HEARTBEAT_S = 5.0
MAX_TRIES = 3
_RETRY_AFTER = timedelta(seconds=5)
_DAY = timedelta(days=1)

PRIORITY = {"check": 0, "repair": 0, "event": 1, "placement": 2, "practice": 3, "ladder": 4, "again": 4}
"""Kinds of jobs, the most urgent first."""


class Verdict(NamedTuple):
    """What a check found.

    Attributes:
        state: of the submission.
        level: of the report.
        digest: of the programs.
        report: as JSON.
    """

    state: State
    level: str
    digest: str
    report: dict[str, Any] | None


@contextmanager
def writing() -> Iterator[None]:
    """Write to the database in one transaction, in turn: SQLite's own lock lets one process starve another."""
    if connection.vendor != "sqlite":
        with transaction.atomic():
            yield
        return
    with current_site().write_lock.open("ab") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        with transaction.atomic():
            yield


def database_now() -> datetime:
    """Return the time by the clock that all workers share: that of the server, if there is one."""
    if connection.vendor == "sqlite":
        return timezone.now()
    with connection.cursor() as cursor:
        cursor.execute("SELECT clock_timestamp()")
        now: datetime = cursor.fetchone()[0]
    return now


def enqueue(kind: str, about: Submission | Match | Event, now: datetime, team: Team | None = None) -> Job:
    """Put something into the queue, or once more if that is done; called inside `writing`.

    Args:
        kind: of the job, as in `PRIORITY`.
        about: what it is about.
        now: the time.
        team: whose lane time it takes; of a submission that of its team.
    """
    queued = {"state": JobState.QUEUED, "tries": 0, "not_before": now, "error": ""}
    made = {"kind": kind, "priority": PRIORITY[kind], "created_at": now, type(about).__name__.lower(): about}
    made["team"] = about.team if isinstance(about, Submission) else team
    job, is_new = Job.objects.get_or_create(key=f"{kind}/{about.pk}", defaults={**made, **queued})
    if not is_new:
        Job.objects.filter(pk=job.pk, state=JobState.DONE).update(**queued)
    return job


def waiting(now: datetime) -> QuerySet[Job]:
    """Return the queued jobs that may be claimed, in the order in which they are claimed.

    A team whose jobs took the least time of the last 24 hours goes first; one that has used its time waits.
    """
    used = (
        Job.objects.filter(team=OuterRef("team"), started_at__gt=now - _DAY)
        .order_by()
        .values("team")
        .annotate(total=Sum("lane_s"))
        .values("total")
    )
    share = Coalesce(Subquery(used, output_field=FloatField()), Value(0.0))
    queued = Job.objects.filter(state=JobState.QUEUED, not_before__lte=now)
    return (
        queued.annotate(share=share).filter(share__lt=current_site().lane_s_per_day).order_by("priority", "share", "id")
    )


def claim(
    worker: str, now: datetime, kinds: Collection[str] = tuple(PRIORITY), bases: Collection[int] = ()
) -> Job | None:
    """Lease the next job to a worker; None: there is none.

    Args:
        worker: its name.
        now: the time.
        kinds: of jobs.
        bases: of matches that it can play.
    """
    with writing():
        return_expired(now)
        fitting = Q(match=None) | Q(match__basis__in=bases)
        job = _locked(waiting(now).filter(fitting, kind__in=kinds)).first()
        if job is None:
            return None
        job.state, job.worker, job.attempt, job.tries = JobState.RUNNING, worker, job.attempt + 1, job.tries + 1
        job.started_at, job.lease_until, job.progress = now, now + LEASE, ""
        job.save(update_fields=("state", "worker", "attempt", "tries", "started_at", "lease_until", "progress"))
        if job.submission is not None:
            Submission.objects.filter(pk=job.submission.pk, state=State.QUEUED).update(state=State.CHECKING)
        return job


def _locked(found: QuerySet[Job]) -> QuerySet[Job]:
    """Lock rows without those that another transaction is changing; SQLite has one writer at a time anyway."""
    return found.select_for_update(skip_locked=True, of=("self",)) if connection.vendor == "postgresql" else found


def renew(worker: str, held: Collection[tuple[int, int]], now: datetime) -> set[tuple[int, int]]:
    """Renew the leases of a worker's claims (job and attempt); return those that it still holds."""
    with writing():
        still = set()
        for job, attempt in held:
            mine = Job.objects.filter(pk=job, worker=worker, attempt=attempt, state=JobState.RUNNING)
            if mine.update(lease_until=now + LEASE):
                still.add((job, attempt))
        return still


def report_progress(job: Job, progress: str) -> None:
    """Store which stage a job has reached, if it is still this worker's; an event that goes on has all its tries."""
    with writing():
        mine = Job.objects.filter(pk=job.pk, worker=job.worker, attempt=job.attempt, state=JobState.RUNNING)
        job.tries = 1 if job.event_id is not None else job.tries
        mine.update(progress=progress[:40], tries=job.tries)


def finish(job: Job, now: datetime, lane_s: float, store: Callable[[Job], None]) -> bool:
    """End a job and store its result, in one transaction; return False if the claim is no longer valid.

    Args:
        job: as it was claimed.
        now: the time.
        lane_s: how long it occupied a lane, in s.
        store: stores the result; runs in the transaction.
    """
    with writing():
        if job.team_id is not None:
            Team.objects.select_for_update().get(pk=job.team_id)  # a team is locked before its jobs, everywhere
        mine = Job.objects.filter(pk=job.pk, worker=job.worker, attempt=job.attempt, state=JobState.RUNNING)
        done = mine.update(
            state=JobState.DONE, finished_at=now, lane_s=F("lane_s") + lane_s, lease_until=None, error=""
        )
        if not done:
            return False
        store(job)
        return True


def store_verdict(submission: Submission, verdict: Verdict) -> None:
    """Store what a check found; the newest accepted submission of a team becomes the one that plays.

    Called inside `writing`, with the team locked.
    """
    submission.state, submission.level, submission.digest = verdict.state, verdict.level, verdict.digest
    submission.report = verdict.report
    submission.save(update_fields=("state", "level", "digest", "report"))
    if verdict.state == State.ACCEPTED:
        entry, _ = Entry.objects.get_or_create(team_id=submission.team_id, season_id=submission.season_id)
        if submission.replaces(entry.active, entry.chosen_over):
            entry.active = submission
            entry.save(update_fields=("active",))


def fail(job: Job, now: datetime, lane_s: float, error: str, *, is_try: bool = True) -> bool:
    """Give a job back because of a fault that is not the team's; after the last attempt it is stuck.

    Args:
        job: as it was claimed.
        now: the time.
        lane_s: how long it occupied a lane, in s.
        error: what happened.
        is_try: False if the worker was only stopped: that is not counted.

    Returns:
        Whether the claim was still valid.
    """
    with writing():
        mine = Job.objects.filter(pk=job.pk, worker=job.worker, attempt=job.attempt, state=JobState.RUNNING)
        tries = job.tries if is_try else job.tries - 1
        if not mine.update(lane_s=F("lane_s") + lane_s, error=error[:400], tries=tries):
            return False
        _give_back(Job.objects.get(pk=job.pk), now)
        return True


def return_expired(now: datetime) -> int:
    """Give back the jobs whose leases have run out; whoever looks at the queue next does it. Returns how many.

    Times that lie further ahead than any can have been set come from a clock that was set back since: they are
    brought to the present.
    """
    Job.objects.filter(state=JobState.RUNNING, lease_until__gt=now + LEASE).update(lease_until=now + LEASE)
    Job.objects.filter(state=JobState.QUEUED, not_before__gt=now + MAX_TRIES * _RETRY_AFTER).update(not_before=now)
    expired = list(_locked(Job.objects.filter(state=JobState.RUNNING, lease_until__lt=now)))
    for job in expired:
        job.error = "the dispatcher ended"
        _give_back(job, now)
    return len(expired)


def try_again(job: Job, now: datetime) -> None:
    """Put a stuck job back into the queue, with all its attempts."""
    with writing():
        if Job.objects.filter(pk=job.pk, state=JobState.STUCK).update(
            state=JobState.QUEUED, tries=0, not_before=now, error=""
        ):
            Submission.objects.filter(job=job.pk, state=State.UNCHECKED).update(state=State.QUEUED)


def cancel(found: QuerySet[Job]) -> None:
    """End jobs that are not done: late results are dropped. Called inside `writing`."""
    found.exclude(state=JobState.DONE).update(state=JobState.DONE, worker="", lease_until=None)


def clean_up(now: datetime) -> None:
    """Remove what has no use any more: expired sessions and invitations, and dispatchers not seen for a day."""
    with writing():
        Session.objects.filter(expire_date__lt=now).delete()
        Invite.objects.filter(expires_at__lt=now).delete()
        Worker.objects.filter(seen_at__lt=now - _DAY).delete()


def _give_back(job: Job, now: datetime) -> None:
    is_stuck = job.tries >= MAX_TRIES
    job.state = JobState.STUCK if is_stuck else JobState.QUEUED
    job.worker, job.lease_until, job.not_before = "", None, now + _RETRY_AFTER * max(0, job.tries - 1)
    job.save(update_fields=("state", "worker", "lease_until", "not_before", "error"))
    if job.submission_id is not None:
        checking = Submission.objects.filter(pk=job.submission_id, state=State.CHECKING)
        if is_stuck:
            checking.update(state=State.UNCHECKED, is_counted=False)
        else:
            checking.update(state=State.QUEUED)
