"""When what was played is shown: the times of the file, which are also the schedule for spectators."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from zoneinfo import ZoneInfo

from rcj_challenges.tournament.models import StageModel, Tournament
from rcj_challenges.tournament.season import Fixture, SeasonState, StageState


def release_times(tournament: Tournament, state: SeasonState) -> dict[str, datetime]:
    """Return by fixture from when on it is shown, with the tournament's time zone; others are shown as soon as played.

    All matches of one knock-out tie are released together, since each would give away how the one before ended.
    """
    found: dict[str, datetime] = {}
    for stage in state.stages:
        found |= _of_stage(tournament, tournament.stages[stage.name], stage)
    return found


def round_times(tournament: Tournament, stage: str) -> tuple[datetime, ...]:
    """Return when the rounds of a stage are released: one time for all of them, one for each, or none."""
    release = tournament.stages[stage].release
    texts = (release,) if isinstance(release, str) else release or ()
    zone = ZoneInfo(tournament.time_zone)
    return tuple(datetime.strptime(text, "%Y-%m-%d %H:%M").replace(tzinfo=zone) for text in texts)


def _of_stage(tournament: Tournament, model: StageModel, stage: StageState) -> dict[str, datetime]:
    times = round_times(tournament, stage.name)
    if not times:
        return {}
    found: dict[str, datetime] = {}
    slots: dict[int, dict[str, int]] = {}
    for fixture in stage.fixtures:
        index = min(fixture.round, len(times)) - 1
        own = slots.setdefault(index, {})
        slot = own.setdefault(_slot(fixture), len(own))
        first = times[index]
        # Elapsed time, not the clock's: that may be put back in between.
        elapsed = first.astimezone(UTC) + slot * timedelta(minutes=model.minutes_between)
        found[fixture.id] = elapsed.astimezone(first.tzinfo)
    return found


def _slot(fixture: Fixture) -> str:
    return fixture.tie or fixture.id
