"""Pages of events for all: what is to come, what plays, results; and those of organizers: form, freeze, rulings."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from copy import copy
from itertools import chain
from pathlib import Path
from typing import Any, ClassVar

from csp.decorators import csp
from django import forms
from django.http import Http404, HttpRequest, HttpResponse, HttpResponseBase, JsonResponse
from django.shortcuts import get_object_or_404, redirect
from django.utils import timezone
from django.utils.translation import gettext
from django.views.decorators.http import require_GET, require_safe

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web import deadlines, events
from rcj_challenges.web.accounts import Viewer
from rcj_challenges.web.config import current_site
from rcj_challenges.web.files import file_answer
from rcj_challenges.web.models import Event, First, Job, JobState, Season
from rcj_challenges.web.pages import message_page, page, public_address
from rcj_challenges.web.settings import POLICY
from rcj_challenges.web.views.guards import done, only, plain
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
    return events.event_folder(event) / events.DATA / "site"


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
    if not _IS_PUBLIC.fullmatch(path):
        raise Http404
    answer = file_answer(site / path)
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


# --- for organizers ---------------------------------------------------------------------------------------------------


class EventForm(forms.ModelForm):  # type: ignore[type-arg]  # the class takes no argument when it runs
    """What an organizer chooses of an event. Times are in the zone of the site, and none that comes twice or never."""

    class Meta:
        """What of an event is chosen."""

        model = Event
        fields = ("title", "deadline", "first", "groups", "rounds", "finalists", "seeds", "premiere", "minutes_between")
        _time = forms.DateTimeInput({"type": "datetime-local"}, "%Y-%m-%dT%H:%M")
        widgets: ClassVar = {"deadline": _time, "premiere": _time}

    def clean_title(self) -> str:
        """Return the title without what cannot be shown."""
        return sanitize(" ".join(self.cleaned_data["title"].split()), 80)

    def clean_first(self) -> str:
        """Refuse a format that the scenario of the season does not have."""
        from rcj_challenges.scenario.load import load  # noqa: PLC0415 - loads the code of scenarios

        first, season = self.cleaned_data["first"], self.instance.season
        if (first == First.CHALLENGE) != (len(load(season.scenario, season.overrides).scenario.entrants) == 1):
            raise forms.ValidationError(gettext("The scenario of the season is not played in this way."))
        return str(first)


@only("organizer")
def new_event(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Show the form of a new event, and make it."""
    season = get_object_or_404(Season, is_current=True)
    event = Event(season=season, address=public_address(request, "/events/")[0])
    form = EventForm(request.POST or None, instance=event)
    if form.is_valid():
        return done(viewer, "new event", form.save(), f"/desk/events/{event.pk}")
    return page(request, "event_form.html", viewer, 400 if form.is_bound else 200, form=form, season=season)


@only("organizer")
def desk_event(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Show an event: what it waits for, its form, its matches; and change its form until they begin."""
    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    form, has_begun = EventForm(request.POST or None, instance=copy(event)), events.has_begun(event)
    if event.closed_at is not None:
        del form.fields["deadline"]
    if form.is_valid():
        if has_begun or not Event.objects.filter(pk=pk, closed_at=event.closed_at).update(**form.cleaned_data):
            return _not_now(request)
        if event.frozen_at is not None:
            events.write(form.instance)
        return done(viewer, "change event", form.instance, f"/desk/events/{pk}")
    values: dict[str, Any] = {"event": event, "form": form, "error": "", "state": None, "rulings": []}
    values |= {"has_begun": has_begun, "job": Job.objects.filter(event=event).first()}
    if event.frozen_at is None:
        values["pending"] = deadlines.pending(event).select_related("team").defer("report")[:50]
    else:
        try:
            with events.opened(event, writing=False) as tournament:
                values |= {"state": has_begun and tournament.state(), "rulings": tournament.rulings}
        except DiagnosticError as error:
            values["error"] = _words(error)
    return page(request, "desk_event.html", viewer, 400 if form.is_bound else 200, **values)


@only("organizer", post=True)
def change_event(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Do what the page of an event offers."""
    event, act = get_object_or_404(Event.objects.select_related("season"), pk=pk), request.POST.get("act", "")
    acts: dict[str, Callable[[], bool]] = {
        "freeze": lambda: events.freeze(event, timezone.now(), waits=False),
        "play": lambda: events.play(event, timezone.now()),
        "pause": lambda: events.pause(event),
        "delete": lambda: request.POST.get("confirm", "").strip() == event.title and events.delete(event),
    }
    if act not in acts or not acts[act]():
        return _not_now(request)
    return done(viewer, f"{act} event", event, "/desk" if act == "delete" else f"/desk/events/{pk}")


def _not_now(request: HttpRequest) -> HttpResponse:
    return message_page(request, 409, gettext("It is too early or too late. To delete an event, type its title."))


@only("organizer", post=True)
def rule(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Note a ruling on a match, or that a team leaves, or take the last one back."""
    from rcj_challenges.tournament import rulings  # noqa: PLC0415 - loads the code of tournaments
    from rcj_challenges.tournament.played import RulingKind  # noqa: PLC0415

    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    fixture, team, score = (request.POST.get(name, "") for name in ("match", "team", "score"))
    reason, cascade = sanitize(request.POST.get("reason", ""), 500), "cascade" in request.POST
    kind = next((one for one in RulingKind if one == request.POST.get("kind")), None)
    if kind is None or (kind != RulingKind.UNDONE and (kind == RulingKind.WITHDRAWN) == bool(fixture)):
        return message_page(request, 400, gettext("Choose the match; none if a team leaves the event."))
    losers = [team] if kind == RulingKind.FORFEIT else ()
    try:
        with events.opened(event, writing=events.has_begun(event)) as tournament:
            if fixture:
                scores = rulings.scores_of(score)
                rulings.decide(tournament, fixture, kind, reason, losers=losers, scores=scores, cascade=cascade)
            else:
                rulings.withdraw(tournament, team, reason, undo=kind == RulingKind.UNDONE, cascade=cascade)
    except DiagnosticError as error:
        return message_page(request, 409, _words(error))
    Event.objects.filter(pk=pk).update(publish_at=timezone.now())
    return done(viewer, "rule", f"{event}: {kind} {fixture or team}", f"/desk/events/{pk}", reason)


def _words(error: DiagnosticError) -> str:
    return "; ".join(one.sentence for one in error.diagnostics)
