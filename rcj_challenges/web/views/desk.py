"""Pages of organizers: the queue and its alarms, invitations, names, and the export."""

from __future__ import annotations

import tempfile
import zipfile
from datetime import timedelta
from typing import Any

from django.http import HttpRequest, HttpResponse, HttpResponseBase
from django.shortcuts import get_object_or_404
from django.utils import timezone
from django.utils.translation import gettext

from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web import jobs, seasons
from rcj_challenges.web.accounts import Viewer, invite, write_audit
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.config import current_site
from rcj_challenges.web.files import FileAnswer
from rcj_challenges.web.models import Audit, Entry, Event, Group, Job, JobState, Match, Role, Season, Team, Worker
from rcj_challenges.web.pages import message_page, page, public_address
from rcj_challenges.web.views.guards import done, only


@only("organizer")
def desk(request: HttpRequest, viewer: Viewer) -> HttpResponse:
    """Show what needs a person: stuck jobs, names to release, dispatchers, the disk."""
    now, season = timezone.now(), seasons.current()
    basis = seasons.current_basis(season)
    values: dict[str, Any] = {
        "stuck": Job.objects.filter(state=JobState.STUCK).select_related("team", "match", "event")[:50],
        "running": Job.objects.filter(state=JobState.RUNNING).select_related("team", "match", "event")[:50],
        "waiting": jobs.waiting(now).select_related("team", "match", "event")[:50],
        "count": Job.objects.filter(state=JobState.QUEUED).count(),
        "workers": Worker.objects.filter(seen_at__gt=now - timedelta(days=1)).order_by("-seen_at"),
        "names": Team.objects.filter(is_name_public=False, deleted_at=None).select_related("group")[:100],
        "groups": Group.objects.order_by("label"),
        "events": Event.objects.all()[:20],
        "audit": Audit.objects.order_by("-id")[:20],
        "has_room": Blobs(current_site().folder).has_room(),
        "season": season,
        "basis": basis,
        "left": seasons.open_rated(basis).count(),
        "has_other_versions": basis is not None and basis.versions != seasons.own_versions(),
    }
    return page(request, "desk.html", viewer, now=now, lease=jobs.LEASE, **values)


@only("organizer", post=True)
def change_season(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Begin or end the ladder of the season, or play all its matches again with the versions of now."""
    season = get_object_or_404(Season, is_current=True)
    act = request.POST.get("act", "")
    acts = {"begin": seasons.begin, "rebase": seasons.rebase, "end": seasons.end}
    if act not in acts or (act == "end" and request.POST.get("confirm", "").strip() != season.title):
        return message_page(request, 400, gettext("Type the title of the season to confirm."))
    try:
        acts[act](season, timezone.now())
    except RcjError as error:
        return message_page(request, 409, str(error))
    return done(viewer, f"{act} season", season, "desk")


@only("organizer", post=True)
def void_match(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Let a match not count, for a reason that all can read."""
    found = get_object_or_404(Match.objects.select_related("basis"), pk=pk)
    reason = sanitize(request.POST.get("reason", "").strip(), 200)
    if not reason:
        return message_page(request, 400, gettext("Write why the match does not count."))
    with jobs.writing():
        # All may be played again at this time: then the match is there twice.
        same = Match.objects.filter(basis__season=found.basis.season_id, kind=found.kind, number=found.number)
        seasons.void(same, reason)
        return done(viewer, "void", found, "/desk" if found.played_at is None else f"/matches/{pk}", reason)


@only("organizer", post=True)
def job_again(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Put a stuck job back into the queue."""
    job = get_object_or_404(Job, pk=pk)
    jobs.try_again(job, timezone.now())
    return done(viewer, "try again", job, "desk")


@only("organizer", post=True)
def release_name(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Show a team's own name to all."""
    team = get_object_or_404(Team, pk=pk, deleted_at=None)
    Team.objects.filter(pk=pk).update(is_name_public=True)
    return done(viewer, "release name", f"team {team.pk}", "desk")


@only("organizer", post=True)
def new_invite(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Make a link for a mentor of a group, or for another organizer; it is shown this once."""
    role = Role.ORGANIZER if request.POST.get("role") == Role.ORGANIZER else Role.MENTOR
    label = sanitize(" ".join(request.POST.get("group", "").split()), 60)
    if role == Role.MENTOR and not label:
        return message_page(request, 400, gettext("Write the label of the mentor's group."))
    now = timezone.now()
    with jobs.writing():
        group = None
        if role == Role.MENTOR:
            group, _ = Group.objects.get_or_create(label=label, defaults={"quota": current_site().team_quota})
        code = invite(role, group, now)
        write_audit(viewer, "invite", group or role, "", now)
    return page(request, "invite.html", viewer, address=public_address(request, f"/invite/{code}")[0], group=group)


@only("organizer")
def export(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Return a ZIP with one archive for each team that plays, as ``tournament run`` takes them."""
    blobs = Blobs(current_site().folder)
    entries = Entry.objects.filter(season__is_current=True, active__isnull=False, team__deleted_at=None)
    made = tempfile.TemporaryFile()  # noqa: SIM115 - the answer closes it
    with zipfile.ZipFile(made, "w") as archive:
        lines = []
        for entry in entries.select_related("team", "active").order_by("team__pk"):
            assert entry.active is not None  # noqa: S101 - filtered
            name = f"team{entry.team_id}.zip"
            if not blobs.path(entry.active.sha256).exists():
                lines.append(f"# missing: submissions/{name}\n")
                continue
            archive.write(blobs.path(entry.active.sha256), f"submissions/{name}")
            if entry.active.is_late:
                lines.append(f"# late: submissions/{name}\n")  # a comment for sha256sum
            lines.append(f"{entry.active.sha256}  submissions/{name}\n")
        archive.writestr("hashes.txt", "".join(lines))
    made.seek(0)
    return FileAnswer(made, as_attachment=True, filename="submissions.zip", content_type="application/zip")
