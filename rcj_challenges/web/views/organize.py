"""Pages of organizers for events: the form, the freeze, the matches, rulings."""

from __future__ import annotations

from typing import Any, ClassVar

from django import forms
from django.http import HttpRequest, HttpResponseBase
from django.shortcuts import get_object_or_404, redirect
from django.urls import reverse
from django.utils import timezone
from django.utils.translation import gettext

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web import deadlines, events
from rcj_challenges.web.accounts import Viewer, write_audit
from rcj_challenges.web.models import Event, First, Job, Season
from rcj_challenges.web.pages import message_page, page, public_address
from rcj_challenges.web.views.guards import only


class EventForm(forms.ModelForm):  # type: ignore[type-arg]  # the class takes no argument when it runs
    """What an organizer chooses of an event. Times are in the zone of the site, and none that comes twice or never."""

    class Meta:
        """What of an event is chosen."""

        model = Event
        fields = ("title", "deadline", "first", "groups", "rounds", "finalists", "seeds", "premiere", "minutes_between")
        _time = forms.DateTimeInput({"type": "datetime-local"}, "%Y-%m-%dT%H:%M")
        widgets: ClassVar = {"deadline": _time, "premiere": _time}

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        if self.instance.closed_at is not None:
            del self.fields["deadline"]

    def clean_title(self) -> str:
        """Return the title without what cannot be shown."""
        return sanitize(self.cleaned_data["title"], 80)

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
        form.save()
        write_audit(viewer, "new event", event, "", timezone.now())
        return redirect("desk_event", pk=event.pk)
    return page(request, "event_form.html", viewer, 400 if form.is_bound else 200, form=form, season=season)


@only("organizer")
def desk_event(request: HttpRequest, viewer: Viewer, pk: int) -> HttpResponseBase:
    """Show an event: what it waits for, its form, its matches; and change its form until they begin."""
    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    form, has_begun = EventForm(request.POST or None, instance=event), events.has_begun(event)
    if form.is_valid() and not has_begun:
        Event.objects.filter(pk=pk, closed_at=event.closed_at).update(**form.cleaned_data)
        if event.frozen_at is not None:
            events.write(event)
        write_audit(viewer, "change event", event, "", timezone.now())
        return redirect("desk_event", pk=pk)
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
    event = get_object_or_404(Event.objects.select_related("season"), pk=pk)
    act, now, confirm = request.POST.get("act", ""), timezone.now(), request.POST.get("confirm", "").strip()
    if act == "freeze":
        events.freeze(event, now, waits=False)
    elif act == "play" and event.frozen_at is not None:
        events.play(event, now)
    elif act == "pause":
        events.pause(event)
    elif act == "delete" and not (event.plays or events.has_begun(event)) and confirm == event.title:
        events.delete(event)
    else:
        return message_page(request, 409, gettext("It is too early or too late. To delete an event, type its title."))
    write_audit(viewer, f"{act} event", event, "", now)
    return redirect("desk" if act == "delete" else reverse("desk_event", args=[pk]))


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
    write_audit(viewer, "rule", f"{event}: {kind} {fixture or team}", reason, timezone.now())
    return redirect("desk_event", pk=pk)


def _words(error: DiagnosticError) -> str:
    return "; ".join(one.sentence for one in error.diagnostics)
