"""Deadlines of events: what is active as one passes, and what comes too late for it, whatever the clock says."""

from __future__ import annotations

from datetime import datetime, timedelta

from django.db.models import Q, QuerySet

from rcj_challenges.web.front import MAX_BODY_S
from rcj_challenges.web.models import Entry, Event, Season, State, Submission

_SLOW = timedelta(seconds=MAX_BODY_S + 60)
"""How long after a deadline an upload may come that began before it: it may also have waited for its turn."""
_HELD_UP = timedelta(seconds=30)
"""How old the time of a receipt may be that had to wait for its turn; if it is older, the clock was set back."""
_PENDING = (State.QUEUED, State.CHECKING, State.UNCHECKED)


def close(now: datetime) -> None:
    """Keep what is active when a deadline passes; called inside `jobs.writing`, before anything else becomes active."""
    for event in Event.objects.select_for_update().filter(closed_at=None, deadline__lt=now):
        entries = Entry.objects.filter(season=event.season_id)
        event.chosen = {str(one.team_id): [one.active_id, one.chosen_over] for one in entries}
        event.closed_at = now
        event.save(update_fields=("chosen", "closed_at"))


def late_for(season: Season, begun_at: datetime, now: datetime) -> Event | None:
    """Return the last event for which an upload comes too late; called inside `jobs.writing` as it is received.

    What is received after the receipts of an event are complete is late whatever the clock says, which may have been
    set back.
    """
    close(now)
    passed = Event.objects.select_for_update().filter(season=season, closed_at__isnull=False, played_at=None)
    return next((one for one in passed if begun_at > one.deadline or has_all_receipts(one, now)), None)


def has_all_receipts(event: Event, now: datetime) -> bool:
    """Return whether nothing that is received now can be in time for an event whose deadline has passed."""
    assert event.closed_at is not None  # noqa: S101 - only of those that are closed
    return event.frozen_at is not None or not event.closed_at - _HELD_UP <= now <= event.deadline + _SLOW


def in_time(event: Event) -> QuerySet[Submission]:
    """Return the submissions that are in time for an event."""
    found = Submission.objects.filter(season=event.season_id, begun_at__lte=event.deadline, is_deleted=False)
    return found.filter(Q(late_for=None) | Q(late_for__deadline__lt=event.deadline)).exclude(via="sample")


def pending(event: Event) -> QuerySet[Submission]:
    """Return the submissions in time whose verdicts are still to come."""
    return in_time(event).filter(state__in=_PENDING)
