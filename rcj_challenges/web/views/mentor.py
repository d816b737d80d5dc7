"""Pages of a mentor: the teams of the group, and their cards."""

from __future__ import annotations

import io
import shutil
from typing import Any

import segno
from django.db.models import Count, Q
from django.http import HttpRequest, HttpResponse, HttpResponseBase
from django.shortcuts import redirect
from django.utils import timezone
from django.utils.translation import gettext

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web import events, jobs, seasons
from rcj_challenges.web.accounts import Viewer, give_card, write_audit
from rcj_challenges.web.blobs import Blobs, report_folder
from rcj_challenges.web.config import current_site
from rcj_challenges.web.models import Entry, Group, Job, Submission, Team
from rcj_challenges.web.pages import message_page, page, public_address
from rcj_challenges.web.receiving import remove_unneeded
from rcj_challenges.web.views.guards import only, seen_team

_MAX_AT_ONCE = 60


@only("mentor")
def group(request: HttpRequest, viewer: Viewer) -> HttpResponse:
    """Show the teams of the group; an organizer sees those of all."""
    teams = Team.objects.filter(deleted_at=None).select_related("group").annotate(
        handed_in=Count("submission", filter=Q(submission__is_deleted=False))
    ).order_by("pk")  # fmt: skip
    if viewer.group is not None:
        teams = teams.filter(group=viewer.group)
    groups = [] if viewer.group else Group.objects.order_by("label")
    return page(request, "group.html", viewer, teams=teams, groups=groups)


@only("mentor", post=True)
def new_teams(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Make teams, one for each line, and show their cards, this once."""
    names = [sanitize(" ".join(line.split()), 40) for line in request.POST.get("names", "").splitlines()]
    names = [name for name in names if name][:_MAX_AT_ONCE]
    label = sanitize(" ".join(request.POST.get("group", "").split()), 60)
    if not names or not (viewer.group or label):
        return message_page(request, 400, gettext("Write the name of a team on each line."))
    with jobs.writing():
        owner = (
            viewer.group or Group.objects.get_or_create(label=label, defaults={"quota": current_site().team_quota})[0]
        )
        if Team.objects.filter(group=owner, deleted_at=None).count() + len(names) > owner.quota:
            return message_page(request, 409, gettext("Your group has as many teams as organizers allow it."))
        cards = [
            _card(request, team, give_card(team))
            for team in [Team.objects.create(group=owner, name=name) for name in names]
        ]
    return page(request, "cards.html", viewer, cards=cards)


@only("mentor", post=True)
def new_card(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Replace a card that was lost: the old code and all sessions end."""
    team = seen_team(viewer, pk)
    with jobs.writing():
        code = give_card(team)
        write_audit(viewer, "new card", f"team {pk}", request.POST.get("reason", ""), timezone.now())
    return page(request, "cards.html", viewer, cards=[_card(request, team, code)])


@only("mentor")
def team(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponse:
    """Show what a team of the group has handed in."""
    found = seen_team(viewer, pk)
    mine = Submission.objects.filter(team=found, is_deleted=False).select_related("late_for")[:50]
    entry = Entry.objects.filter(team=found, season__is_current=True).first()
    return page(
        request, "team.html", viewer, team=found, submissions=mine, active_id=entry.active_id if entry else None
    )


@only("mentor", post=True)
def delete_team(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Delete a team: its name, card and reports go at once; archives that nothing else needs go with them."""
    found = seen_team(viewer, pk)
    if request.POST.get("confirm", "").strip() != found.name:
        return message_page(request, 400, gettext("Type the name of the team to confirm."))
    if (event := events.unfinished(found)) is not None:
        text = gettext("It plays in {event} at this time. Delete it when its matches are over.").format(event=event)
        return message_page(request, 409, text)
    now, name = timezone.now(), found.name
    with jobs.writing():
        found.name, found.is_name_public, found.code_hmac, found.deleted_at = "", False, None, now
        found.epoch += 1
        found.save()
        Submission.objects.filter(team=found).update(is_deleted=True, report=None)
        Entry.objects.filter(team=found).delete()
        jobs.cancel(Job.objects.filter(team=found))
        write_audit(viewer, "delete team", f"team {pk}", request.POST.get("reason", ""), now)
        _remove_files(found)
        seasons.forget(found)
        events.forget(found, name, now)
    return redirect("group")


def _remove_files(deleted: Team) -> None:
    site = current_site().folder
    for submission in Submission.objects.filter(team=deleted):
        shutil.rmtree(report_folder(site, submission), ignore_errors=True)
        remove_unneeded(submission.sha256)
    for job in Job.objects.filter(team=deleted):
        Blobs(site).remove_left(job)


def _card(request: HttpRequest, team: Team, code: str) -> dict[str, Any]:
    """The address on a card. The code stands behind #, so that it is in no log of a server."""
    address, is_reached = public_address(request, "/enter")
    drawn = io.BytesIO()
    segno.make(f"{address}#{code}", error="m").save(drawn, kind="svg", xmldecl=False, svgns=True, border=2, scale=4)
    return {
        "team": team.name,
        "code": code,
        "address": address,
        "is_reached": is_reached,
        "qr": drawn.getvalue().decode(),
    }
