"""Pages of organizers for events: the form, the freeze, the matches, rulings."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

from django import forms
from django.core.validators import MaxValueValidator, MinValueValidator
from django.http import HttpRequest, HttpResponseBase
from django.shortcuts import get_object_or_404, redirect
from django.utils import timezone
from django.utils.translation import gettext, gettext_lazy

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web import deadlines, events, jobs
from rcj_challenges.web.accounts import Viewer, write_audit
from rcj_challenges.web.models import Event, Job, Season
from rcj_challenges.web.pages import message_page, page, public_address
from rcj_challenges.web.views.guards import only

_TIME = forms.DateTimeInput({"type": "datetime-local"}, "%Y-%m-%dT%H:%M")
_FILE_TIME = "%Y-%m-%d %H:%M"
_YEARS = (MinValueValidator(datetime(2000, 1, 1, tzinfo=UTC)), MaxValueValidator(datetime(2200, 1, 1, tzinfo=UTC)))


class EventForm(forms.Form):
    """What an organizer chooses of an event. Times are in the zone of the site, and none that comes twice or never."""

    title = forms.CharField(label=gettext_lazy("Title"), max_length=80)
    deadline = forms.DateTimeField(label=gettext_lazy("Deadline"), widget=_TIME, validators=_YEARS)
    first = forms.ChoiceField(
        label=gettext_lazy("First stage"),
        choices=(
            ("groups", gettext_lazy("groups: all of each group meet")),
            ("swiss", gettext_lazy("Swiss: in each round, teams with equal points meet")),
            ("knock_out", gettext_lazy("none, only the knock-out")),
            ("challenge", gettext_lazy("challenge: each team plays alone, for a scenario with one team")),
        ),
    )
    groups = forms.IntegerField(label=gettext_lazy("Groups"), min_value=1, max_value=26, initial=1)
    rounds = forms.IntegerField(label=gettext_lazy("Rounds of a Swiss stage"), min_value=1, max_value=64, initial=5)
    finalists = forms.IntegerField(
        label=gettext_lazy("Teams that reach the knock-out, of each group; 0: there is none"),
        min_value=0, max_value=64, initial=4,
    )  # fmt: skip
    seeds = forms.IntegerField(label=gettext_lazy("Runs of a challenge"), min_value=1, max_value=1000, initial=5)
    premiere = forms.DateTimeField(
        label=gettext_lazy("First premiere of the last stage; empty: results are shown as soon as they are known"),
        widget=_TIME, required=False, validators=_YEARS,
    )  # fmt: skip
    minutes_between = forms.IntegerField(
        label=gettext_lazy("Minutes between premieres"), min_value=0, max_value=10_080, initial=30
    )

    def __init__(self, season: Season, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self._season = season

    def clean_title(self) -> str:
        """Return the title without what cannot be shown."""
        return sanitize(self.cleaned_data["title"], 80)

    def clean_first(self) -> str:
        """Refuse a format that the scenario of the season does not have."""
        from rcj_challenges.scenario.load import load  # noqa: PLC0415 - loads the code of scenarios

        first, seats = self.cleaned_data["first"], load(self._season.scenario, self._season.overrides).scenario.entrants
        if (first == "challenge") != (len(seats) == 1):
            raise forms.ValidationError(gettext("The scenario of the season is not played in this way."))
        return str(first)

    def fields_of_event(self) -> dict[str, Any]:
        """Return what an event keeps of a form that is valid."""
        choices = {name: value for name, value in self.cleaned_data.items() if name not in {"title", "deadline"}}
        at = choices["premiere"]
        choices["premiere"] = timezone.localtime(at).strftime(_FILE_TIME) if at else ""
        return {"title": self.cleaned_data["title"], "deadline": self.cleaned_data["deadline"], "choices": choices}


@only("organizer")
def new_event(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Show the form of a new event, and make it."""
    season = get_object_or_404(Season, is_current=True)
    form = EventForm(season, request.POST or None)
    if request.method == "POST" and form.is_valid():
        event = events.new_event(season, **form.fields_of_event())
        event.address = public_address(request, f"/events/{event.pk}/")[0]
        event.save(update_fields=("address",))
        write_audit(viewer, "new event", event, "", timezone.now())
        return redirect("desk_event", pk=event.pk)
    return page(request, "event_form.html", viewer, 400 if form.is_bound else 200, form=form, season=season)


@only("organizer")
def desk_event(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Show an event: what it waits for, its form, its matches."""
    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    return _desk_page(request, viewer, event, EventForm(event.season, initial=_initial(event)))


def _initial(event: Event) -> dict[str, Any]:
    premiere = event.choices["premiere"].replace(" ", "T")
    return {"title": event.title, "deadline": event.deadline, **event.choices, "premiere": premiere}


def _desk_page(
    request: HttpRequest, viewer: Viewer, event: Event, form: EventForm, status: int = 200
) -> HttpResponseBase:
    values: dict[str, Any] = {"event": event, "form": form, "error": "", "state": None, "rulings": []}
    values |= {"has_begun": events.has_begun(event), "job": Job.objects.filter(event=event).first()}
    if event.frozen_at is None:
        values["pending"] = deadlines.pending(event).select_related("team").defer("report")[:50]
    else:
        try:
            with events.opened(event, writing=False) as tournament:
                values |= {"state": values["has_begun"] and tournament.state(), "rulings": tournament.rulings}
        except DiagnosticError as error:
            values["error"] = _words(error)
    return page(request, "desk_event.html", viewer, status, **values)


@only("organizer", post=True)
def rule(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Note a ruling on a match, or that a team leaves, or take the last one back."""
    from rcj_challenges.tournament import rulings  # noqa: PLC0415 - loads the code of tournaments
    from rcj_challenges.tournament.played import RulingKind  # noqa: PLC0415

    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    given = {key: str(value) for key, value in request.POST.items()}
    fixture, team, reason = given.get("match", ""), given.get("team", ""), sanitize(given.get("reason", ""), 500)
    is_cascade = "cascade" in given
    try:
        kind = RulingKind(given.get("kind", ""))
        if kind != RulingKind.UNDONE and (kind == RulingKind.WITHDRAWN) == bool(fixture):
            text = gettext("Choose the match that it is about; no match if the team leaves the event.")
            return message_page(request, 400, gettext("Not decided"), text)
        scores = [float(int(one)) for one in given.get("score", "").split(":") if one.strip()]
        with events.opened(event, writing=events.has_begun(event)) as tournament:
            if fixture:
                losers = [team] if kind == RulingKind.FORFEIT else ()
                rulings.decide(tournament, fixture, kind, reason, losers=losers, scores=scores, cascade=is_cascade)
            else:
                rulings.withdraw(tournament, team, reason, undo=kind == RulingKind.UNDONE, cascade=is_cascade)
    except DiagnosticError as error:
        return message_page(request, 409, gettext("Not decided"), _words(error))
    except (ValueError, OverflowError):
        return message_page(request, 400, gettext("Not decided"), gettext("Write a score as 2:1."))
    Event.objects.filter(pk=pk).update(publish_at=timezone.now())
    write_audit(viewer, "rule", f"{event}: {kind} {fixture or team}", reason, timezone.now())
    return redirect("desk_event", pk=pk)


def _words(error: DiagnosticError) -> str:
    return "; ".join(f"{one.message}: {one.help}" for one in error.diagnostics)


def _save(request: HttpRequest, viewer: Viewer, event: Event) -> HttpResponseBase:
    form = EventForm(event.season, request.POST)
    if not form.is_valid():
        return _desk_page(request, viewer, event, form, 400)
    if events.has_begun(event):
        return message_page(request, 409, gettext("Not changed"), gettext("Its matches have begun."))
    given = form.fields_of_event()
    if event.closed_at is not None:
        del given["deadline"]
    Event.objects.filter(pk=event.pk, closed_at=event.closed_at).update(**given)
    if event.frozen_at is not None:
        events.write(Event.objects.get(pk=event.pk))
    write_audit(viewer, "change event", event, "", timezone.now())
    return redirect("desk_event", pk=event.pk)


@only("organizer", post=True)
def change_event(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Change the form of an event, or do what its page offers."""
    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    act, now = request.POST.get("act", ""), timezone.now()
    if act == "save":
        return _save(request, viewer, event)
    if act == "freeze":
        events.freeze(event, now, waits=False)
    elif act == "play" and event.frozen_at is not None:
        Event.objects.filter(pk=pk).update(plays=True)
        for job in Job.objects.filter(event=event):
            jobs.try_again(job, now)
    elif act == "pause":
        with jobs.writing():
            events.pause(event)
    else:
        return message_page(request, 409, gettext("Not done"), gettext("The event is not that far."))
    write_audit(viewer, f"{act} event", event, "", now)
    return redirect("desk_event", pk=pk)
