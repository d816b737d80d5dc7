"""Pages of the ladder: the table, the programs of a team, matches with their replays; and practice."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from csp.decorators import csp
from django.core.paginator import Paginator
from django.db.models import Q, QuerySet
from django.http import Http404, HttpRequest, HttpResponse, HttpResponseBase
from django.shortcuts import get_object_or_404, redirect
from django.utils import timezone
from django.utils.translation import gettext
from django.views.decorators.http import require_GET, require_POST

from rcj_challenges.records.folder import REPLAY
from rcj_challenges.web import jobs, seasons, stage
from rcj_challenges.web.accounts import Viewer, viewer_of
from rcj_challenges.web.blobs import match_folder, record_folder
from rcj_challenges.web.config import current_site
from rcj_challenges.web.models import Entry, Job, JobState, Match, MatchKind, Season, State, Submission, Team
from rcj_challenges.web.pages import message_page, page
from rcj_challenges.web.tables import standings_of
from rcj_challenges.web.views.guards import only, plain
from rcj_challenges.web.views.team import REPLAY_POLICY

_ROWS = 100
_CROSS = 12
_MATCHES = 50
_MAX_AGAIN = 20
"""Replays that are made again at a time: more would delay the ladder."""


@require_GET
def ladder(request: HttpRequest, pk: int = 0) -> HttpResponse:
    """Show the table of a season, of the current one without a number."""
    season = get_object_or_404(Season, pk=pk) if pk else seasons.current()
    basis = seasons.shown_basis(season)
    others = Season.objects.filter(begun_at__isnull=False).exclude(pk=season.pk if season else 0).order_by("-begun_at")
    values: dict[str, Any] = {"season": season, "others": others, "table": None}
    if basis is not None:
        table = standings_of(basis)
        rows = Paginator(table.published.table, _ROWS).get_page(request.GET.get("page"))
        values |= {"table": table, "rows": rows, "cross": table.ranked[:_CROSS]}
    return page(request, "ladder.html", **values)


@require_GET
def team(request: HttpRequest, pk: int) -> HttpResponse:
    """Show the programs of a team with their ratings, its opponents and its last matches."""
    found = get_object_or_404(Team.objects.select_related("group"), pk=pk, deleted_at=None)
    season = seasons.current()
    basis = seasons.shown_basis(season)
    values: dict[str, Any] = {"team": found, "versions": [], "matches": []}
    if basis is not None:
        accepted = Submission.objects.filter(team=found, season=season, state=State.ACCEPTED).defer("report")
        values |= {"versions": list(accepted[:_MATCHES]), "table": standings_of(basis)}
        theirs = Match.objects.filter(Q(blue__team=found) | Q(yellow__team=found), basis=basis, kind=MatchKind.RATED)
        values["matches"] = seasons.with_sides(theirs.filter(played_at__isnull=False).order_by("-played_at"))[:_MATCHES]
    return page(request, "ladder_team.html", **values)


def _seen_match(request: HttpRequest, pk: int) -> tuple[Viewer, Match, list[str]]:
    """Return a match that the viewer may see, and the sides whose details it may see.

    Raises:
        Http404: there is none, or it is practice of other teams.
    """
    viewer = viewer_of(request)
    match = get_object_or_404(seasons.with_sides(Match.objects.filter(played_at__isnull=False)), pk=pk)
    own = [side for side in seasons.SIDES if viewer.may_see(getattr(match, side).team)]
    if match.kind == MatchKind.PRACTICE and not own:
        raise Http404
    return viewer, match, own


@require_GET
def match(request: HttpRequest, pk: int) -> HttpResponse:
    """Show a match: its result, faults by kind, and what the viewer's own programs printed."""
    viewer, found, own = _seen_match(request, pk)
    again = Job.objects.filter(key=f"again/{pk}").exclude(state=JobState.DONE).first()
    record = record_folder(current_site().folder, found)
    values: dict[str, Any] = {"match": found, "own": own, "again": again, "has_replay": (record / REPLAY).is_file(),
              "logs": _own_logs(record, own), "can_repeat": _can_repeat(found), "period": _period(found)}  # fmt: skip
    return page(request, "match.html", viewer, **values)


def _period(found: Match) -> str:
    """What a half is called in the scenario of a match."""
    from rcj_challenges.records.recorded_scenario import read_period  # noqa: PLC0415 - loads the code of scenarios

    scenario = match_folder(current_site().folder) / "scenarios" / f"{found.basis.scenario}.json"
    return read_period(scenario) if found.faults else ""


def _can_repeat(found: Match) -> bool:
    is_there = not (found.blue.is_deleted or found.yellow.is_deleted)
    return is_there and not found.is_doubtful and found.basis.versions == seasons.own_versions()


def _own_robots(record: Path, own: list[str]) -> frozenset[tuple[int, str]]:
    """Return (half, robot) for each robot that programs of the viewer's side drove."""
    from rcj_challenges.tournament.site.private import driven  # noqa: PLC0415 - loads the code of matches

    return driven(record, lambda seat, _: seat in own) if own else frozenset()


def _own_logs(record: Path, own: list[str]) -> dict[str, str]:
    """Return the output of programs of the viewer's side, by robot."""
    from rcj_challenges.tournament.site.private import own_logs  # noqa: PLC0415 - loads the code of matches

    robots = _own_robots(record, own)
    return own_logs(record, {half for half, _ in robots}, robots)


@require_GET
def match_log(request: HttpRequest, pk: int, robot: str) -> HttpResponse:
    """Show the output of a program of the viewer's side."""
    _, found, own = _seen_match(request, pk)
    logs = _own_logs(record_folder(current_site().folder, found), own)
    if robot not in logs:
        raise Http404
    return plain(logs[robot])


@require_GET
@csp(REPLAY_POLICY)  # type: ignore[arg-type]  # views take numbers, too
def match_replay(request: HttpRequest, pk: int) -> HttpResponseBase:
    """Return the replay in an origin of its own, with details of the viewer's own programs only."""
    from rcj_challenges.views.replay.page import page_text  # noqa: PLC0415 - as above

    _, found, own = _seen_match(request, pk)
    try:
        replay = stage.public_replay(found, _own_robots(record_folder(current_site().folder, found), own))
    except (OSError, ValueError) as error:
        raise Http404 from error
    return HttpResponse(page_text(replay.facts, replay.poses, {}))


@require_POST
def match_again(request: HttpRequest, pk: int) -> HttpResponseBase:
    """Play a match again, bit for bit, whose replay is no longer kept."""
    _, found, _ = _seen_match(request, pk)
    with jobs.writing():
        waiting = Job.objects.filter(kind="again", state=JobState.QUEUED).count()
        if waiting >= _MAX_AGAIN or not _can_repeat(found):
            return message_page(request, 409, gettext("It can be played no more, or too many are waiting."))
        jobs.enqueue("again", found, timezone.now())
    return redirect("match", pk=pk)


# --- practice ---------------------------------------------------------------------------------------------------------


_WAITING = 3
_SHOWN = 20


@only("team")
def practice(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Show the practice matches of a team, and the opponents that it can choose."""
    entry, either = _entry(viewer), Q(blue__team=viewer.team) | Q(yellow__team=viewer.team)
    theirs = seasons.with_sides(Match.objects.filter(either, kind=MatchKind.PRACTICE))
    values: dict[str, Any] = {"season": seasons.running(), "opponents": _opponents(entry) if entry else ()}
    return page(request, "practice.html", viewer, entry=entry, matches=theirs[:_SHOWN], **values)


def _entry(viewer: Viewer) -> Entry | None:
    return Entry.objects.filter(team=viewer.team, season=seasons.running()).select_related("active").first()


def _opponents(entry: Entry) -> QuerySet[Submission]:
    """Return the submissions that a team may practise against."""
    allowed = Q(via="sample") | Q(team=entry.team) | Q(entry__isnull=False, team__allows_practice=True)
    found = Submission.objects.filter(allowed, season=entry.season_id, state=State.ACCEPTED, is_deleted=False)
    others = found.exclude(pk=entry.active_id or 0).order_by("via", "team", "-number")
    return others.select_related("team").defer("report")


@only("team", post=True)
def new_practice(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Put a practice match into the queue."""
    number = request.POST.get("opponent", "")[:12]
    now = timezone.now()
    with jobs.writing():
        entry, basis = _entry(viewer), seasons.current_basis(seasons.running())
        against = _opponents(entry).filter(pk=int(number) if number.isdecimal() else 0).first() if entry else None
        if entry is None or entry.active is None or basis is None or against is None:
            return message_page(request, 409, gettext("Choose one of the opponents of the list."))
        waiting = Match.objects.filter(blue__team=viewer.team, kind=MatchKind.PRACTICE, played_at=None, void="")
        if waiting.exclude(job__state=JobState.STUCK).count() >= _WAITING:
            return message_page(request, 409, gettext("Wait until your practice matches have been played."))
        (match,) = seasons.add_matches(basis, MatchKind.PRACTICE, [(entry.active, against)], now)
        jobs.enqueue("practice", match, now, team=viewer.team)
    return redirect("practice")


@only("team", post=True)
def allow_practice(request: HttpRequest, viewer: Viewer) -> HttpResponseBase:
    """Let other teams practise against this one, or no more."""
    assert viewer.team is not None  # noqa: S101 - it is a page of teams
    Team.objects.filter(pk=viewer.team.pk).update(allows_practice=request.POST.get("allow") == "yes")
    return redirect("practice")
