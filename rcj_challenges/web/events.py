"""Events: what plays in them is fixed after their deadlines, and each is a tournament in a folder of its own."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml
from django.db.models import Q
from django.utils import timezone

from rcj_challenges.records.folder import replaced
from rcj_challenges.web import jobs, seasons
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.config import current_site
from rcj_challenges.web.deadlines import close, has_all_receipts, in_time, pending
from rcj_challenges.web.models import Event, First, Job, JobState, State, Submission, Team
from rcj_challenges.web.tables import standings_of

if TYPE_CHECKING:
    from rcj_challenges.tournament.opened import OpenTournament

FILE, DATA, HASHES = "tournament.yaml", "tournament_data", "hashes.txt"
_MOST_POTS = 64
"""The most that a tournament file takes; in each, the order is drawn."""


def event_folder(event: Event) -> Path:
    """Return the folder of an event: all commands for tournaments work in it."""
    return current_site().folder / "events" / str(event.pk)


def has_begun(event: Event) -> bool:
    """Return whether its tournament has been drawn: then its form is not changed any more."""
    return (event_folder(event) / DATA).exists()


# --- the freeze -------------------------------------------------------------------------------------------------------


def freeze(event: Event, now: datetime, *, waits: bool = True) -> bool:
    """Fix what plays in an event, once all that was in time has been received and checked; return whether it was.

    Args:
        event: whose deadline has passed.
        now: the time.
        waits: False: what has no verdict yet does not play.
    """
    with jobs.writing():
        event = Event.objects.select_for_update().get(pk=event.pk)
        is_due = event.closed_at is not None and event.frozen_at is None and has_all_receipts(event, now)
        if not is_due or (waits and pending(event).exists()):
            return False
        event.frozen, event.frozen_at = _chosen(event), now
        event.save(update_fields=("frozen", "frozen_at"))
    write(event)
    return True


def _chosen(event: Event) -> list[tuple[int, str, int]]:
    """Return what plays: what was active at the deadline, or a newer submission in time that was accepted since."""
    basis = seasons.shown_basis(event.season)
    ranked = [] if basis is None else standings_of(basis).ranked
    places = {row.digest: place for place, row in enumerate(ranked, 1)}
    accepted = in_time(event).filter(state=State.ACCEPTED).defer("report").order_by("team", "number")
    playing: dict[int, Submission] = {}
    for one in accepted:
        active, chosen_over = event.chosen.get(str(one.team_id), (None, 0))
        if one.pk == active or one.replaces(playing.get(one.team_id), chosen_over):
            playing[one.team_id] = one
    return [(team, one.sha256, places.get(one.digest, 0)) for team, one in playing.items()]


def attend(now: datetime) -> None:
    """Do what is due in all events: dispatchers call it every few seconds."""
    if Event.objects.filter(closed_at=None, deadline__lt=now).exists():
        with jobs.writing():
            close(now)
    for event in Event.objects.filter(closed_at__isnull=False, frozen_at=None):
        freeze(event, now)
    due = Event.objects.filter(Q(plays=True) | Q(publish_at__lte=now))
    for event in due.exclude(job__state__in=(JobState.QUEUED, JobState.RUNNING, JobState.STUCK)):
        with jobs.writing():
            jobs.enqueue("event", event, now)


# --- the matches ------------------------------------------------------------------------------------------------------


def request_of(event: Event) -> dict[str, Any]:
    """Return what the process of an event is to do."""
    folder, unnamed = event_folder(event), [f"team{one.pk}" for one in event.teams.filter(is_name_public=False)]
    return {
        "file": str(folder / FILE),
        "data": str(folder / DATA),
        "plays": event.plays,
        "url": f"{event.address}{event.pk}/",
        "site": {"id": f"event{event.pk}", "home": f"/events/{event.pk}", "unnamed": unnamed},
        "hashes": {f"team{team}": sha256 for team, sha256, _ in event.frozen},
    }


def store_played(event: Event, answer: Mapping[str, Any], now: datetime) -> None:
    """Store what came of an event's matches; called inside `jobs.writing`."""
    publish_at = answer["publish_at"] and datetime.fromisoformat(answer["publish_at"])
    # A ruling may have come meanwhile, which is to be shown.
    Event.objects.filter(pk=event.pk, publish_at=event.publish_at).update(publish_at=publish_at)
    if event.plays:
        Event.objects.filter(pk=event.pk).update(plays=False, played_at=now if answer["is_over"] else None)


def play(event: Event, now: datetime) -> bool:
    """Have the matches of an event played, or what is left of them; return whether it is frozen."""
    for job in Job.objects.filter(event=event):
        jobs.try_again(job, now)
    return Event.objects.filter(pk=event.pk, frozen_at__isnull=False).update(plays=True) > 0


def pause(event: Event) -> bool:
    """Stop the matches of an event; a dispatcher ends their process within seconds. Return whether they were played."""
    with jobs.writing():
        jobs.cancel(Job.objects.filter(event=event))
        return Event.objects.filter(pk=event.pk, plays=True).update(plays=False) > 0


def delete(event: Event) -> bool:
    """Delete an event, unless its matches have begun or are to; return whether it was."""
    with jobs.writing():
        is_deleted = not has_begun(event) and Event.objects.filter(pk=event.pk, plays=False).delete()[0] > 0
    if is_deleted:
        shutil.rmtree(event_folder(event), ignore_errors=True)
    return is_deleted


def _events_of(team: Team) -> Iterator[Event]:
    found = Event.objects.exclude(frozen=[]).select_related("season")
    return (one for one in found if any(playing == team.pk for playing, *_ in one.frozen))


def unfinished(team: Team) -> Event | None:
    """Return an event in which a team is playing at this time."""
    return next((one for one in _events_of(team) if has_begun(one) and (one.plays or one.played_at is None)), None)


def forget(team: Team, name: str, now: datetime) -> None:
    """Remove what events keep of a team that was deleted, also its name; results stay. Called inside `jobs.writing`."""
    from rcj_challenges.tournament.store.store import Store  # noqa: PLC0415 - loads the code of tournaments

    for event in _events_of(team):
        folder, archives = event_folder(event), {one: sha256 for one, sha256, _ in event.frozen}
        sha256, data, archive = archives.pop(team.pk), folder / DATA, folder / _archive(team.pk)
        if not has_begun(event):
            archive.unlink(missing_ok=True)
            event.frozen = [one for one in event.frozen if one[0] != team.pk]
            event.save(update_fields=("frozen",))
            write(event)
            continue
        archive.write_bytes(b"")  # the tournament file names it
        with Store(data, writing=True) as store:
            for job in store.rename(sha256, name, team.public_name):
                shutil.rmtree(store.place.record_of(job), ignore_errors=True)
        if sha256 not in archives.values():
            (data / "submissions" / f"{sha256}.zip").unlink(missing_ok=True)
        for shown in ("site", "for_teams", "premieres", "organizer"):  # they are published again at once
            shutil.rmtree(data / shown, ignore_errors=True)
        Event.objects.filter(pk=event.pk).update(publish_at=now)


# --- the folder -------------------------------------------------------------------------------------------------------


def write(event: Event) -> None:
    """Write the folder of an event: its submissions, their hashes, and the tournament file with the names of now."""
    folder, blobs = event_folder(event), Blobs(current_site().folder)
    (folder / "frozen").mkdir(parents=True, exist_ok=True)
    for team, sha256, _ in event.frozen:
        path = folder / _archive(team)
        if not path.exists() and blobs.path(sha256).exists():
            with blobs.path(sha256).open("rb") as source, replaced(path) as target:
                shutil.copyfileobj(source, target)
    with replaced(folder / FILE) as file:
        file.write(yaml.safe_dump(_tournament(event), allow_unicode=True, sort_keys=False).encode())
    with replaced(folder / HASHES) as file:
        file.write(hashes(event).encode())


def hashes(event: Event) -> str:
    """Return the SHA-256 of the archives that play, as ``sha256sum`` reads them."""
    return "".join(f"{sha256}  {_archive(team)}\n" for team, sha256, _ in event.frozen)


def _archive(team: int) -> str:
    return f"frozen/team{team}.zip"


def opened(event: Event, *, writing: bool) -> AbstractContextManager[OpenTournament]:
    """Open the tournament of an event.

    Raises:
        DiagnosticError: its formats do not fit its teams, or its matches are being played, and it is to be written.
    """
    from rcj_challenges.tournament.opened import open_tournament  # noqa: PLC0415 - loads the code of scenarios

    if not (event_folder(event) / FILE).exists():  # a process was killed before it wrote it
        write(event)
    return open_tournament(event_folder(event) / FILE, event_folder(event) / DATA, writing=writing)


def _tournament(event: Event) -> dict[str, Any]:
    """Return the content of the tournament file."""
    season, path = event.season, Path(event.season.scenario)
    scenario = str(path.resolve()) if path.is_file() else season.scenario
    names = {team.pk: team.public_name for team in event.teams}
    order = sorted(event.frozen, key=lambda one: (one[2] == 0, one[2], one[0]))
    ranked = sum(place > 0 for *_, place in order)  # places are of all programs of the ladder, pots of what plays
    size = max(event.groups, -(-ranked // _MOST_POTS))
    return {
        "tournament_version": 1,
        "title": event.title,
        "seed": event.seed,
        "time_zone": current_site().time_zone,
        "scenario": scenario,
        "set": {path: yaml.safe_load(value) for path, _, value in (one.partition("=") for one in season.overrides)},
        "teams_folder": "frozen",
        "teams": {
            f"team{team}": {"name": names[team], "pot": 1 + number // size if number < ranked else 0}
            for number, (team, *_) in enumerate(order)
        },
        "tie_breaks": ["points", "goal_difference", "goals", "head_to_head", "lot"],
        "drawn": {"extra_time": {}},
        "stages": _stages(event, scenario),
    }


def _stages(event: Event, scenario: str) -> dict[str, Any]:
    known: dict[str, dict[str, Any]] = {
        First.GROUPS: {"stage": "round_robin", "groups": event.groups},
        First.SWISS: {"stage": "swiss", "rounds": event.rounds},
        First.CHALLENGE: {"stage": "challenge", "scenarios": {"run": {"scenario": scenario}}, "seeds": event.seeds},
        First.FINALS: {"stage": "knock_out"},
    }
    stages = {event.first: known[event.first]}
    if event.finalists and event.first in {First.GROUPS, First.SWISS}:
        stages["finals"] = {**known[First.FINALS], "from": event.first, "places": f"1-{event.finalists}"}
    if event.premiere is not None:
        release = f"{timezone.localtime(event.premiere):%Y-%m-%d %H:%M}"
        stages[list(stages)[-1]] |= {"release": release, "minutes_between": event.minutes_between}
    return stages
