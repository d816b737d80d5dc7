"""The stage for all to watch, and the organizers' list of what is shown there."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime, timedelta
from typing import Any

from csp.decorators import csp, csp_update
from django.http import HttpRequest, HttpResponse, HttpResponseBase
from django.shortcuts import get_object_or_404
from django.utils import timezone
from django.utils.dateparse import parse_datetime
from django.utils.translation import gettext
from django.views.decorators.clickjacking import xframe_options_sameorigin
from django.views.decorators.http import require_GET

from rcj_challenges.records.folder import REPLAY
from rcj_challenges.web import jobs, seasons, stage
from rcj_challenges.web.accounts import Viewer
from rcj_challenges.web.blobs import record_folder, stage_folder
from rcj_challenges.web.config import current_site
from rcj_challenges.web.files import HTML, file_answer
from rcj_challenges.web.models import Match, MatchKind, Show
from rcj_challenges.web.pages import message_page, page
from rcj_challenges.web.tables import standings_of
from rcj_challenges.web.views.guards import done, only
from rcj_challenges.web.views.team import REPLAY_POLICY

_COMING, _ROWS, _GOALS, _OFFERED = 5, 10, 12, 50
_HOUR = timedelta(hours=1)
_SEEN_AFTER = timedelta(seconds=2)
"""A goal is in the list only when all spectators have seen it."""
_AGAIN, _AFTER = timedelta(seconds=60), timedelta(seconds=15)
"""When the page loads itself again: if nothing begins soon, and after the end of a match."""
_POLICY = {**REPLAY_POLICY, "connect-src": ["'self'"], "frame-ancestors": ["'self'"]}


@require_GET
@csp_update({"frame-src": ["'self'"]})
def live(request: HttpRequest) -> HttpResponse:
    """Show the match on the stage, or when the next one begins; the table, and the goals of the last hour."""
    now = timezone.now()
    show, *coming = [*_shows(ends_at__gt=now)[: _COMING + 1]] or [None]
    basis = seasons.shown_basis(seasons.current())
    values: dict[str, Any] = {
        "show": show, "is_on": show is not None and show.begins_at <= now, "coming": coming,
        "table": None if basis is None else standings_of(basis), "rows": _ROWS,
        "goals": list(_goals(now))[:_GOALS], "is_bare": "stage" in request.GET,
        "begins_ms": 0 if show is None else _ms(show.begins_at - now),
        "again_ms": _ms(_AGAIN if show is None or show.begins_at > now + 2 * _AGAIN else show.ends_at - now + _AFTER),
    }  # fmt: skip
    return page(request, "live.html", **values)


def _shows(**when: datetime) -> Any:
    return seasons.with_sides(Show.objects.filter(**when), "match__")


def _ms(length: timedelta) -> int:
    return round(length / timedelta(milliseconds=1))


def _goals(now: datetime) -> Iterator[dict[str, Any]]:
    site = current_site().folder
    for show in _shows(begins_at__lte=now, ends_at__gt=now - _HOUR).reverse():
        is_over = show.ends_at <= now and (record_folder(site, show.match) / REPLAY).is_file()
        for at_s, half, tick, side, score in reversed(show.goals):
            at = show.begins_at + timedelta(seconds=at_s)
            if now - _HOUR < at <= now - _SEEN_AFTER:
                replay = f"/matches/{show.match_id}/replay#h{half}t{tick}" if is_over else ""
                yield {"at": at, "team": getattr(show.match, side).team, "match": show.match, "score": score,
                       "replay": replay}  # fmt: skip


@require_GET
@xframe_options_sameorigin
@csp(_POLICY)  # type: ignore[arg-type]
def live_page(_request: HttpRequest, pk: int) -> HttpResponseBase:
    """Return the page of a match on the stage, in an origin of its own; its feed comes from `stream`."""
    return file_answer(stage_folder(current_site().folder) / str(pk) / stage.PAGE, content_type=HTML)


@only("organizer")
def desk_stage(request: HttpRequest, viewer: Viewer) -> HttpResponse:
    """Show what is on the stage, and the matches that can be put there."""
    now = timezone.now()
    matches = stage.candidates(seasons.shown_basis(seasons.current()))[:_OFFERED]
    return page(request, "desk_stage.html", viewer, shows=_shows(ends_at__gt=now), matches=matches, now=now)


@only("organizer", post=True)
def put_on_stage(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Put a match on the stage, at the first free time after the one of the form."""
    now = timezone.now()
    rated = seasons.with_sides(Match.objects.filter(kind=MatchKind.RATED, void="", played_at__isnull=False))
    match = get_object_or_404(rated, pk=pk)
    try:
        after = timezone.make_aware(parse_datetime(request.POST.get("after", "")[:30]) or timezone.make_naive(now))
        show = stage.schedule(match, after, now, is_chosen=True)
    except (OSError, ValueError, OverflowError):
        return message_page(request, 409, gettext("There is no such time, or no replay. Make it on the match's page."))
    return done(viewer, "put on stage", show, "desk_stage")


@only("organizer", post=True)
def take_off_stage(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Take a match off the stage, also while it is shown."""
    found = get_object_or_404(Show, pk=pk)
    with jobs.writing():
        stage.take_off(Show.objects.filter(pk=pk))
        return done(viewer, "take off stage", found, "desk_stage")
