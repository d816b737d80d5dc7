"""Pages of events for all: what is to come, what plays, results, calendar and feed."""

from __future__ import annotations

import json
import re
from itertools import chain
from pathlib import Path

from csp.decorators import csp
from django.http import Http404, HttpRequest, HttpResponse, HttpResponseBase, JsonResponse
from django.shortcuts import get_object_or_404, redirect
from django.utils import timezone
from django.utils.translation import gettext
from django.views.decorators.http import require_GET, require_safe

from rcj_challenges.web import events
from rcj_challenges.web.config import current_site
from rcj_challenges.web.events import DATA, event_folder
from rcj_challenges.web.files import FileAnswer
from rcj_challenges.web.models import Event, Job, JobState
from rcj_challenges.web.pages import page, public_address
from rcj_challenges.web.settings import POLICY
from rcj_challenges.web.views.guards import plain
from rcj_challenges.web.views.team import REPLAY_POLICY

_PAGE_POLICY = {**POLICY, "script-src": ["'none'"], "img-src": ["'self'", "data:"]}
_PLAYER_POLICY = {**REPLAY_POLICY, "script-src": ["'self'", "'unsafe-inline'"], "connect-src": ["'self'"]}
_IS_PLAYER = re.compile(r"matches/[^/]+/replay\.html|premiere/[^/]+\.html")
_IS_PUBLIC = re.compile(r"[\w-][\w.-]*(/[\w-][\w.-]*)*")
_VEVENT = re.compile(r"BEGIN:VEVENT\r\n.*?END:VEVENT\r\n", re.DOTALL)
_MAX_NEWS = 100


@require_GET
def all_events(request: HttpRequest) -> HttpResponse:
    """Show all events, the newest first."""
    return page(request, "events.html", events=Event.objects.all())


@require_GET
def event(request: HttpRequest, pk: int) -> HttpResponse:
    """Show an event: its deadline and format, the hash of its seed, and the teams that play."""
    found = get_object_or_404(Event, pk=pk)
    job = Job.objects.filter(event=found, state=JobState.RUNNING).first()
    has_site = (_site(found) / "index.html").is_file()
    return page(request, "event.html", event=found, teams=found.teams, job=job, has_site=has_site)


def _site(event: Event) -> Path:
    return event_folder(event) / DATA / "site"


@require_GET
def hashes(request: HttpRequest, pk: int) -> HttpResponse:
    """Return the SHA-256 of the archives that play."""
    return plain(events.hashes(get_object_or_404(Event, pk=pk, frozen_at__isnull=False)))


@require_safe
def event_file(request: HttpRequest, pk: int, path: str = "index.html") -> HttpResponseBase:
    """Return a file of an event's published site. Pages that run scripts have an origin of their own."""
    site = _site(get_object_or_404(Event, pk=pk))
    if not site.is_dir():
        return redirect("event", pk=pk)
    try:
        if not _IS_PUBLIC.fullmatch(path):
            raise Http404
        answer = FileAnswer((site / path).open("rb"))
    except OSError as error:
        raise Http404 from error
    answer["Access-Control-Allow-Origin"], answer["Access-Control-Expose-Headers"] = "*", "Date"
    return csp(_PLAYER_POLICY if _IS_PLAYER.fullmatch(path) else _PAGE_POLICY)(lambda _: answer)(request)


@require_GET
def calendar(request: HttpRequest) -> HttpResponse:
    """Return the deadlines and the schedules of all events as a calendar."""
    from rcj_challenges.tournament.site.schedule import Appointment, Heading, as_ics  # noqa: PLC0415 - loads tournaments

    found, address = Event.objects.all(), public_address(request, "/")[0]
    rows = [
        Appointment(f"event{one.pk}", one.deadline, gettext("Deadline"), one.title, f"events/{one.pk}") for one in found
    ]
    heading = Heading("club", current_site().title, timezone.get_default_timezone(), timezone.now(), address)
    own, end, _ = as_ics(heading, rows).partition("END:VCALENDAR\r\n")
    schedules = (shown for one in found for shown in _VEVENT.findall(_published(one, "schedule.ics")))
    return HttpResponse("".join((own, *schedules, end)), content_type="text/calendar; charset=utf-8")


@require_GET
def feed(request: HttpRequest) -> HttpResponse:
    """Return the latest results of all events as a JSON Feed."""
    from rcj_challenges.tournament.site.schedule import FEED_VERSION  # noqa: PLC0415 - loads tournaments

    feeds = [json.loads(_published(one, "feed.json") or "{}") for one in Event.objects.all()]
    items = chain.from_iterable(one.get("items", ()) for one in feeds)
    news = sorted(items, key=lambda item: str(item.get("date_published", "")), reverse=True)
    made = {"version": FEED_VERSION, "title": current_site().title, "items": news[:_MAX_NEWS]}
    made |= {"home_page_url": public_address(request, "/")[0]}
    return JsonResponse(made, content_type="application/feed+json")


def _published(event: Event, name: str) -> str:
    """Return a text of an event's site; empty if nothing is published."""
    try:
        return (_site(event) / name).read_bytes().decode()
    except OSError:
        return ""
