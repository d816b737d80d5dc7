"""Pages of a team: hand in, follow the check, read the report, repair, choose what plays."""

from __future__ import annotations

import hashlib
import re
import secrets
from datetime import datetime
from pathlib import Path
from typing import Any

from csp.decorators import csp
from django.db.models import Max
from django.http import Http404, HttpRequest, HttpResponse, HttpResponseBase, JsonResponse
from django.shortcuts import redirect
from django.utils import timezone
from django.utils.translation import gettext
from django.views.decorators.http import condition, require_GET, require_POST

from rcj_challenges.web import deadlines, jobs, seasons
from rcj_challenges.web.accounts import Viewer
from rcj_challenges.web.blobs import Blobs, report_folder
from rcj_challenges.web.codes import NO_FILE
from rcj_challenges.web.config import current_site
from rcj_challenges.web.files import HTML, file_answer
from rcj_challenges.web.models import Entry, Event, Job, JobState, State, Submission
from rcj_challenges.web.pages import page
from rcj_challenges.web.receiving import RefusedError, ensure_may_upload, receive
from rcj_challenges.web.views.guards import only, plain, seen_submission

_CHUNK = 65536
_STAGES = ("archive", "layout", "identity", "design", "sources", "start", "play")
_REPORT_POLICY = {
    "default-src": ["'none'"],
    "style-src": ["'unsafe-inline'"],
    "img-src": ["data:"],
    "sandbox": ["allow-scripts"],
}
REPLAY_POLICY = {**_REPORT_POLICY, "script-src": ["'unsafe-inline'"], "img-src": ["data:", "blob:"]}
"""Both run in an origin of their own, so that their inline scripts and styles reach nothing of the site."""
_IS_REPLAY = re.compile(r"replay-[A-Za-z0-9_-]{1,60}\.html")


@only("team")
def my(request: HttpRequest, viewer: Viewer) -> HttpResponse:
    """Show what the team has handed in, and the form."""
    return _my_page(request, viewer)


def _my_page(request: HttpRequest, viewer: Viewer, error: str = "", status: int = 200) -> HttpResponse:
    season = seasons.current()
    mine = Submission.objects.filter(team=viewer.team, season=season, is_deleted=False).select_related("late_for")
    entry = Entry.objects.filter(team=viewer.team, season=season).select_related("active").first()
    values: dict[str, Any] = {
        "season": season,
        "submissions": mine[:50],
        "active": entry.active if entry else None,
        "events": Event.objects.filter(season=season, closed_at=None).order_by("deadline"),
        "error": error,
    }
    return page(request, "my.html", viewer, status, now=timezone.now(), max_bytes=current_site().upload_bytes, **values)


@only("team", post=True)
def upload(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Take the archive of the form."""
    assert viewer.team is not None  # noqa: S101 - it is a page of teams
    given = request.FILES.get("archive")
    begun_at = begun(request)
    is_script = request.headers.get("Accept") == "application/json"
    try:
        if given is None:
            raise RefusedError(400, NO_FILE, gettext("Choose a ZIP first."))
        season = ensure_may_upload(viewer.team, seasons.current(), begun_at)
        path = Blobs(current_site().folder).incoming / f"form-{secrets.token_hex(8)}"
        digest, size = hashlib.sha256(), 0
        try:
            with path.open("xb") as file:
                for chunk in given.chunks(_CHUNK):
                    digest.update(chunk)
                    size += len(chunk)
                    file.write(chunk)
            new = Submission(
                team=viewer.team, season=season, sha256=digest.hexdigest(), size_bytes=size, begun_at=begun_at,
                received_at=timezone.now(), via="page",
            )  # fmt: skip
            submission = receive(path, new)
        finally:
            path.unlink(missing_ok=True)
    except RefusedError as refused:
        if is_script:
            return JsonResponse({"code": refused.code, "message": str(refused)}, status=refused.status)
        return _my_page(request, viewer, str(refused), refused.status)
    address = f"/my/submissions/{submission.pk}"
    return JsonResponse({"address": address}, status=201) if is_script else redirect(address)


def begun(request: HttpRequest) -> datetime:
    """Return when a request began, before its body came."""
    scope: dict[str, Any] = getattr(request, "scope", {})
    found = scope.get("rcj.begun_at")
    return found if isinstance(found, datetime) else timezone.now()


def progress_of(submission: Submission) -> dict[str, Any]:
    """The progress of a submission that is not yet checked: its place, an estimate, its stage."""
    job = Job.objects.filter(submission=submission).order_by("-id").first()
    state: dict[str, Any] = {"state": submission.state, "stage": "", "place": 0, "estimate_s": None}
    if job is None:
        return state
    state["job"] = job.state  # also of a repair, whose end the page waits for
    if job.state not in {JobState.QUEUED, JobState.RUNNING}:
        return state
    state["stage"] = job.progress
    if job.state == JobState.QUEUED:
        ahead = list(jobs.waiting(timezone.now()).values_list("pk", flat=True))
        state["place"] = ahead.index(job.pk) + 1 if job.pk in ahead else len(ahead) + 1
        last = Job.objects.filter(kind=job.kind, state=JobState.DONE, lane_s__gt=0).order_by("-id")[:20]
        took_s = [one.lane_s for one in last]
        if took_s:
            state["estimate_s"] = round(sum(took_s) / len(took_s) * state["place"] / current_site().lanes)
    return state


@require_GET
def submission(request: HttpRequest, pk: int) -> HttpResponse:
    """Show a submission: its receipt, where its check stands, and the report."""
    viewer, found = seen_submission(request, pk)
    entry = Entry.objects.filter(team=found.team, season=found.season).first()
    repaired = Submission.objects.filter(repaired_from=found).order_by("-id").first()
    repair_job = Job.objects.filter(key=f"repair/{found.pk}").first()
    progress = progress_of(found)
    values: dict[str, Any] = {
        "submission": found,
        "progress": progress,
        "tag": _tag_of(progress),
        "stages": _STAGES,
        "is_active": entry is not None and entry.active_id == found.pk,
        "is_own": viewer.team is not None and viewer.team.pk == found.team_id,
        "replays": [path.name for path in _replays(found)],
        "repaired": repaired,
        "repair_state": repair_job.state if repair_job is not None else "",
    }
    return page(request, "submission.html", viewer, **values)


def _state_tag(request: HttpRequest, pk: int) -> str:
    _, found = seen_submission(request, pk)
    return _tag_of(progress_of(found))


def _tag_of(state: dict[str, Any]) -> str:
    return '"' + hashlib.sha256(repr(sorted(state.items())).encode()).hexdigest()[:16] + '"'


@require_GET
@condition(etag_func=_state_tag)
def submission_state(request: HttpRequest, pk: int) -> JsonResponse:
    """Return where a check stands, for the page that waits for it."""
    _, found = seen_submission(request, pk)
    return JsonResponse(progress_of(found))


def _replays(found: Submission) -> list[Path]:
    folder = report_folder(current_site().folder, found)
    return sorted(path for path in folder.glob("replay-*.html") if _IS_REPLAY.fullmatch(path.name))


@require_GET
@csp(_REPORT_POLICY)  # type: ignore[arg-type]  # views take numbers, too
def report(request: HttpRequest, pk: int) -> HttpResponseBase:
    """Return the report as ``check --html`` writes it, in an origin of its own."""
    _, found = seen_submission(request, pk)
    return file_answer(report_folder(current_site().folder, found) / "report.html", content_type=HTML)


@require_GET
@csp(REPLAY_POLICY)  # type: ignore[arg-type]  # views take numbers, too
def replay(request: HttpRequest, pk: int, name: str) -> HttpResponseBase:
    """Return a replay of the check, in an origin of its own: its script reaches nothing of the site."""
    _, found = seen_submission(request, pk)
    if name not in {path.name for path in _replays(found)}:
        raise Http404
    return file_answer(report_folder(current_site().folder, found) / name, content_type=HTML)


@require_GET
def archive(request: HttpRequest, pk: int) -> HttpResponseBase:
    """Return the archive as it was handed in."""
    _, found = seen_submission(request, pk)
    path, name = Blobs(current_site().folder).path(found.sha256), f"team{found.team_id}-{found.number}.zip"
    return file_answer(path, as_attachment=True, filename=name, content_type="application/zip")


@only("team", post=True)
def repair(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Queue the repair of a rejected archive; what comes of it is a new submission."""
    _, found = seen_submission(request, pk)
    if found.state != State.REJECTED:
        return plain("Only a rejected submission can be repaired.", 409)
    now = timezone.now()
    with jobs.writing():
        jobs.enqueue("repair", found, now)
    return redirect(f"/my/submissions/{pk}")


@require_POST
def activate(request: HttpRequest, pk: int) -> HttpResponseBase:
    """Let an older accepted submission play again."""
    viewer, found = seen_submission(request, pk)
    if viewer.team is None:
        raise Http404
    if found.state != State.ACCEPTED:
        return plain("Only an accepted submission can play.", 409)
    with jobs.writing():
        deadlines.close(timezone.now())
        last = Submission.objects.filter(team=found.team, season=found.season).aggregate(last=Max("number"))["last"]
        Entry.objects.update_or_create(
            team=found.team, season=found.season, defaults={"active": found, "chosen_over": last}
        )
    return redirect("my")
