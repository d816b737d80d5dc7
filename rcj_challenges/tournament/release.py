"""Times of release: those of the file, which are also the schedule for spectators."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta, tzinfo
from zoneinfo import ZoneInfo

from rcj_challenges.tournament.season import SeasonState
from rcj_challenges.tournament.tournament_file import Tournament

_FORMAT = "%Y-%m-%d %H:%M"


def moments_of(text: str, zone: tzinfo) -> tuple[datetime, ...]:
    """Return the moments, in UTC, that a time of the file stands for.

    There are none if the clock is put forward over it, and two if the clock is put back over it.

    Raises:
        ValueError: it is not of the form ``2021-06-22 18:00``.
        OverflowError: it is not in the years 1 to 9999.
    """
    local = datetime.strptime(text, _FORMAT)  # noqa: DTZ007 - the zone follows
    if f"{local:{_FORMAT}}" != text:
        raise ValueError(text)
    moments = {local.replace(tzinfo=zone, fold=fold).astimezone(UTC) for fold in (0, 1)}
    return tuple(sorted(one for one in moments if one.astimezone(zone).replace(tzinfo=None) == local))


def release_times(tournament: Tournament, state: SeasonState) -> dict[str, datetime]:
    """Return the times from which on fixtures are shown, in UTC; others are shown as soon as played.

    All matches of one knock-out tie are released together, since each would give away the outcome of the one before.
    """
    found: dict[str, datetime] = {}
    for stage in state.stages:
        times = round_times(tournament, stage.name)
        minutes_between = tournament.stages[stage.name].minutes_between
        slots: dict[int, dict[str, int]] = {}
        for fixture in stage.fixtures if times else ():
            index = min(fixture.round, len(times)) - 1
            own = slots.setdefault(index, {})
            slot = own.setdefault(fixture.tie or fixture.id, len(own))
            found[fixture.id] = times[index] + slot * timedelta(minutes=minutes_between)
    return found


def round_times(tournament: Tournament, stage: str) -> tuple[datetime, ...]:
    """Return the times of release, in UTC, of a stage: one for all its rounds, one for each, or none."""
    release = tournament.stages[stage].release
    texts = (release,) if isinstance(release, str) else release or ()
    zone = ZoneInfo(tournament.time_zone)
    return tuple(moments_of(text, zone)[0] for text in texts)
