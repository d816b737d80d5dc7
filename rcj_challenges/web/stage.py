"""The stage: matches that have been played, shown to all at match pace, one after another."""

from __future__ import annotations

import json
import secrets
import shutil
from collections.abc import Iterable
from contextlib import suppress
from datetime import datetime, timedelta
from typing import TYPE_CHECKING, Any

from django.db.models import Count, QuerySet

from rcj_challenges.records.folder import REPLAY
from rcj_challenges.web import jobs, seasons
from rcj_challenges.web.blobs import record_folder, stage_folder
from rcj_challenges.web.config import current_site
from rcj_challenges.web.models import Basis, Match, MatchKind, Season, Show
from rcj_challenges.web.stream import DATA, RELEASE
from rcj_challenges.web.tables import standings_of

if TYPE_CHECKING:
    from rcj_challenges.tournament.site.public import ReplayData

PAGE = "page.html"
LEAD, PAUSE = timedelta(seconds=30), timedelta(seconds=60)
"""From planning a match to its kick-off, and from the end of one to the kick-off of the next, at least."""
_LOOKED_AT = 300


def public_replay(match: Match, own: Iterable[tuple[int, str]] = ()) -> ReplayData:
    """Return the replay of a match without details of programs, but of ``own`` (half, robot), and unreleased logos.

    Raises:
        OSError: there is none at present.
        ValueError: it is damaged.
    """
    from rcj_challenges.tournament.site.public import ReplayData, public_facts, read_replay  # noqa: PLC0415 - heavy

    replay = read_replay((record_folder(current_site().folder, match) / REPLAY).read_text(encoding="utf-8"))
    unnamed = [side for side in seasons.SIDES if not getattr(match, side).team.is_name_public]
    return ReplayData(public_facts(replay.facts, own, unnamed), replay.poses)


def candidates(basis: Basis | None) -> list[Match]:
    """Return the last matches of a table whose replays are there, the newest first."""
    site = current_site().folder
    played = Match.objects.filter(basis=basis, kind=MatchKind.RATED, void="", played_at__isnull=False)
    last = seasons.with_sides(played).annotate(shows=Count("show")).order_by("-played_at")[:_LOOKED_AT]
    return [match for match in last if (record_folder(site, match) / REPLAY).is_file()]


def schedule(match: Match, after: datetime, now: datetime, *, is_chosen: bool) -> Show:
    """Put a match on the stage, at the first time after one when it is free.

    Args:
        match: that has been played.
        after: the earliest kick-off.
        now: the time; what is there by itself and has not begun gives way.
        is_chosen: whether an organizer wants it.

    Raises:
        OSError: there is no replay of it at present.
        ValueError: its replay is damaged.
    """
    from rcj_challenges.tournament.site.source import HALF_TIME_S  # noqa: PLC0415 - loads the code of matches
    from rcj_challenges.views.live.recorded import STEP_S, recorded_feed  # noqa: PLC0415
    from rcj_challenges.views.replay.page import STAGE_PAGE, page_text  # noqa: PLC0415

    replay = public_replay(match)
    feed = recorded_feed(replay.facts, replay.poses, HALF_TIME_S)
    made = stage_folder(current_site().folder) / f"new-{secrets.token_hex(8)}"
    made.mkdir(parents=True)
    (made / DATA).write_bytes(feed.data)
    (made / PAGE).write_text(page_text(feed.facts, {}, {}, STAGE_PAGE), encoding="utf-8")
    length = timedelta(seconds=max(len(feed.ends) * STEP_S, feed.planned_s))
    with jobs.writing():
        Season.objects.select_for_update().get(pk=match.basis.season_id)  # one at a time plans
        take_off(Show.objects.filter(begins_at__gt=now, is_chosen=False))
        begins_at = _free_time(max(after, now + LEAD), length)
        show = Show.objects.create(
            match=match, begins_at=begins_at, ends_at=begins_at + length, is_chosen=is_chosen, goals=feed.goals
        )
        release = {"begins_s": begins_at.timestamp(), "step_s": STEP_S, "ends": feed.ends}
        (made / RELEASE).write_text(json.dumps(release), encoding="ascii")
        made.rename(made.with_name(str(show.pk)))
    return show


def _free_time(after: datetime, length: timedelta) -> datetime:
    for show in Show.objects.filter(ends_at__gt=after - PAUSE):
        if after + length + PAUSE <= show.begins_at:
            break
        after = max(after, show.ends_at + PAUSE)
    return after


def fill(now: datetime) -> Show | None:
    """Put a match on the stage by itself, if none of that kind waits: the closest ratings of those shown least."""
    basis = seasons.shown_basis(seasons.running())
    if basis is None or Show.objects.filter(begins_at__gt=now, is_chosen=False).exists():
        return None
    table = standings_of(basis)

    def order(match: Any) -> tuple[int, int]:
        return match.shows, abs(table.fitted.value_of(match.blue.digest) - table.fitted.value_of(match.yellow.digest))

    found = [one for one in candidates(basis) if {one.blue.digest, one.yellow.digest} <= table.playing.keys()]
    for match in sorted(found, key=order):
        with suppress(OSError, ValueError):  # its replay has just been dropped, or is damaged
            return schedule(match, now, now, is_chosen=False)
    return None


def take_off(shows: QuerySet[Show]) -> None:
    """Take matches off the stage, also while they are shown; called inside `jobs.writing`."""
    for show in shows:
        shutil.rmtree(stage_folder(current_site().folder) / str(show.pk), ignore_errors=True)
    shows.delete()


def drop_shown(now: datetime) -> None:
    """Remove the files of what was shown, and what was left by attempts to put something on the stage."""
    kept = {str(pk) for pk in Show.objects.filter(ends_at__gt=now - PAUSE).values_list("pk", flat=True)}
    for folder in stage_folder(current_site().folder).glob("*"):
        if folder.name not in kept and folder.stat().st_mtime < (now - PAUSE).timestamp():
            shutil.rmtree(folder, ignore_errors=True)
