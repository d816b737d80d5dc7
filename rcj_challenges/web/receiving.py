"""Takes what teams hand in: a receipt is given when it is on the disk and in the database."""

from __future__ import annotations

import os
import shutil
from contextlib import suppress
from datetime import datetime, timedelta
from pathlib import Path

from django.db import DatabaseError
from django.db.models import Max, QuerySet, Sum
from django.utils.timezone import localtime
from django.utils.translation import gettext

from rcj_challenges.core.codes import DISK_FULL
from rcj_challenges.web import deadlines, jobs
from rcj_challenges.web.blobs import Blobs, report_folder
from rcj_challenges.web.codes import NO_SEASON, NO_TEAM, NOT_OPEN, NOT_STORED, TOO_MUCH, TOO_OFTEN
from rcj_challenges.web.config import current_site
from rcj_challenges.web.models import Job, JobState, Season, State, Submission, Team

_HOUR, _DAY = timedelta(hours=1), timedelta(days=1)
_UNCOUNTED_FACTOR = 5
"""Of the uploads a day, for those that count for no quota: they need the disk, too."""


class RefusedError(Exception):
    """An upload that is not taken; the message says why and what to do.

    Attributes:
        status: of the HTTP answer.
        code: stable, for programs.
    """

    def __init__(self, status: int, code: str, message: str) -> None:
        super().__init__(message)
        self.status = status
        self.code = code


def ensure_may_upload(team: Team, season: Season | None, begun_at: datetime) -> Season:
    """Return the season that an upload is for.

    Raises:
        RefusedError: the season takes no uploads yet, or the team has handed in too often, or there is no room.
    """
    if season is None:
        message = gettext("nothing is open for uploads; the organizers announce the next season")
        raise RefusedError(409, NO_SEASON, message)
    if season.opens_at is not None and begun_at < season.opens_at:
        message = gettext("uploads open on {time:%Y-%m-%d at %H:%M %Z}").format(time=localtime(season.opens_at))
        raise RefusedError(409, NOT_OPEN, message)
    if not Blobs(current_site().folder).has_room():
        raise RefusedError(507, DISK_FULL, gettext("the site has no room for more; the organizers can see this"))
    _ensure_within_quotas(team, begun_at)
    return season


def _ensure_within_quotas(team: Team, begun_at: datetime) -> None:
    config = current_site()
    today = Submission.objects.filter(team=team, received_at__gt=begun_at - _DAY)
    counted = today.filter(is_counted=True)
    if counted.filter(received_at__gt=begun_at - _HOUR).count() >= config.uploads_per_hour:
        message = gettext("{count} uploads an hour are taken; try again later").format(count=config.uploads_per_hour)
        raise RefusedError(429, TOO_OFTEN, message)
    limit = config.uploads_per_day
    if counted.count() >= limit or today.count() >= _UNCOUNTED_FACTOR * limit:
        message = gettext("{count} uploads a day are taken; try again tomorrow").format(count=limit)
        raise RefusedError(429, TOO_OFTEN, message)
    if (today.aggregate(total=Sum("size_bytes"))["total"] or 0) >= config.upload_bytes_per_day:
        message = gettext("{count} bytes a day are taken of a team; try again tomorrow")
        raise RefusedError(429, TOO_MUCH, message.format(count=config.upload_bytes_per_day))


def receive(received: Path, new: Submission) -> Submission:
    """Take an archive: store it, and queue its check, in one transaction; return it with its number.

    Bytes that were checked before for this season get the earlier verdict at once.

    Args:
        received: the file in `Blobs.incoming`; it is moved away.
        new: not saved yet: the team, the season, the file and its times. When the upload began is what counts for the
            deadline; `front` waits for a body for a limited time.

    Raises:
        RefusedError: the disk is full or broken or the database away, or the team was deleted or has reached a quota
            in the meantime: nothing was taken.
    """
    try:
        Blobs(current_site().folder).keep(received, new.sha256)
        with jobs.writing():
            return _record(new)
    except RefusedError:
        with jobs.writing():
            remove_unneeded(new.sha256)
        raise
    except (OSError, DatabaseError) as error:
        message = gettext("the site cannot store it at this moment; nothing was taken: try again")
        raise RefusedError(507, NOT_STORED, message) from error


def accept_repaired(submission: Submission, sha256: str, size_bytes: int, now: datetime) -> Submission:
    """Make a new submission of a repaired archive; called inside `jobs.writing`."""
    return _record(
        Submission(
            team=submission.team, season=submission.season, sha256=sha256, size_bytes=size_bytes, begun_at=now,
            received_at=now, via="repair", repaired_from=submission,
        )
    )  # fmt: skip


def _record(new: Submission) -> Submission:
    team, season = new.team, new.season
    if Team.objects.select_for_update().filter(pk=team.pk, deleted_at=None).first() is None:
        raise RefusedError(409, NO_TEAM, gettext("this team has been deleted"))
    if new.repaired_from is None:
        _ensure_within_quotas(team, new.begun_at)
    new.late_for = deadlines.late_for(season, new.begun_at, new.received_at)
    new.is_late = season.closes_at is not None and new.begun_at > season.closes_at
    mine = Submission.objects.filter(team=team, season=season)
    new.number = (mine.aggregate(last=Max("number"))["last"] or 0) + 1
    checked = mine.filter(sha256=new.sha256, state__in=(State.ACCEPTED, State.REJECTED), is_deleted=False)
    earlier = checked.order_by("-id").first()
    new.is_counted = earlier is None and new.via != "repair"
    new.save()
    _supersede(mine.exclude(pk=new.pk).filter(state=State.QUEUED, late_for=new.late_for))
    if earlier is not None:
        jobs.store_verdict(new, jobs.Verdict(State(earlier.state), earlier.level, earlier.digest, earlier.report))
        _link_report(earlier, new)
    else:
        jobs.enqueue("check", new, new.received_at)
    if not Blobs(current_site().folder).path(new.sha256).exists():  # a team with the same bytes was deleted just now
        raise RefusedError(503, NOT_STORED, gettext("the site could not store it; try again"))
    return new


def remove_unneeded(sha256: str) -> None:
    """Remove an archive that belongs to no submission; called inside `jobs.writing`."""
    if not Submission.objects.filter(sha256=sha256, is_deleted=False).exists():
        Blobs(current_site().folder).path(sha256).unlink(missing_ok=True)


def _link_report(earlier: Submission, submission: Submission) -> None:
    """Show the pages of an earlier check of the same bytes; without them there is still the verdict."""
    folder = current_site().folder
    with suppress(OSError):
        shutil.copytree(report_folder(folder, earlier), report_folder(folder, submission), copy_function=os.link)


def _supersede(queued: QuerySet[Submission]) -> None:
    """End the checks of older submissions that have not begun: the newest one is what the team wants to know about."""
    for submission in queued:
        ended = Job.objects.filter(submission=submission, state=JobState.QUEUED).update(state=JobState.DONE)
        if ended:
            submission.state, submission.is_counted = State.SUPERSEDED, False
            submission.save(update_fields=("state", "is_counted"))
