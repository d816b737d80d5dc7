"""Pages of events for all: what is to come, what plays, results, calendar and feed."""

from __future__ import annotations

from django.http import Http404, HttpRequest, HttpResponse
from django.shortcuts import get_object_or_404
from django.views.decorators.http import require_GET

from rcj_challenges.web.events import HASHES, event_folder
from rcj_challenges.web.models import Event, Team
from rcj_challenges.web.pages import page
from rcj_challenges.web.views.guards import plain


@require_GET
def all_events(request: HttpRequest) -> HttpResponse:
    """Show all events, the newest first."""
    return page(request, "events.html", events=Event.objects.all())


@require_GET
def event(request: HttpRequest, pk: int) -> HttpResponse:
    """Show an event: its deadline and format, the hash of its seed, and the teams that play."""
    found = get_object_or_404(Event, pk=pk)
    playing = Team.objects.filter(pk__in=[team for team, *_ in found.frozen]).order_by("pk")
    return page(request, "event.html", event=found, teams=playing)


@require_GET
def hashes(request: HttpRequest, pk: int) -> HttpResponse:
    """Return the SHA-256 of the archives that play."""
    try:
        return plain((event_folder(get_object_or_404(Event, pk=pk)) / HASHES).read_text(encoding="utf-8"))
    except OSError as error:
        raise Http404 from error
