"""Practice: unrated matches of a team's program against samples, its own older ones, and teams that allow it."""

from __future__ import annotations

from django.db.models import Q, QuerySet
from django.http import HttpRequest, HttpResponseBase
from django.shortcuts import redirect
from django.utils import timezone
from django.utils.translation import gettext

from rcj_challenges.web import jobs, seasons
from rcj_challenges.web.accounts import Viewer
from rcj_challenges.web.models import Entry, JobState, Match, MatchKind, State, Submission, Team
from rcj_challenges.web.pages import message_page, page
from rcj_challenges.web.views.guards import only

_WAITING = 3
_SHOWN = 20


@only("team")
def practice(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Show the practice of a team, and whom it can play against."""
    season, entry = seasons.running(), _entry(viewer)
    either = Q(blue__team=viewer.team) | Q(yellow__team=viewer.team)
    theirs = seasons.with_sides(Match.objects.filter(either, kind=MatchKind.PRACTICE))
    opponents = _opponents(entry) if entry else ()
    return page(
        request, "practice.html", viewer, season=season, entry=entry, matches=theirs[:_SHOWN], opponents=opponents
    )


def _entry(viewer: Viewer) -> Entry | None:
    return Entry.objects.filter(team=viewer.team, season=seasons.running()).select_related("active").first()


def _opponents(entry: Entry) -> QuerySet[Submission]:
    """Return the submissions that a team may practise against."""
    allowed = Q(via="sample") | Q(team=entry.team) | Q(entry__isnull=False, team__allows_practice=True)
    found = Submission.objects.filter(allowed, season=entry.season, state=State.ACCEPTED, is_deleted=False)
    return (
        found.exclude(pk=entry.active_id or 0).select_related("team").defer("report").order_by("via", "team", "-number")
    )


@only("team", post=True)
def new_practice(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Put a practice match into the queue."""
    number = request.POST.get("opponent", "")[:12]
    now = timezone.now()
    with jobs.writing():
        entry, basis = _entry(viewer), seasons.current_basis(seasons.running())
        against = _opponents(entry).filter(pk=int(number) if number.isdecimal() else 0).first() if entry else None
        if entry is None or entry.active is None or basis is None or against is None:
            return message_page(request, 409, gettext("Choose one of the opponents of the list."))
        waiting = Match.objects.filter(blue__team=viewer.team, kind=MatchKind.PRACTICE, played_at=None, void="")
        if waiting.exclude(job__state=JobState.STUCK).count() >= _WAITING:
            return message_page(request, 409, gettext("Wait until your practice matches have been played."))
        (match,) = seasons.add_matches(basis, MatchKind.PRACTICE, [(entry.active, against)], now)
        jobs.enqueue("practice", match, now, team=viewer.team)
    return redirect("practice")


@only("team", post=True)
def allow_practice(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Let other teams practise against this one, or no more."""
    assert viewer.team is not None  # noqa: S101 - it is a page of teams
    Team.objects.filter(pk=viewer.team.pk).update(allows_practice=request.POST.get("allow") == "yes")
    return redirect("practice")
