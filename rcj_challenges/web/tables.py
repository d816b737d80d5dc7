"""The table of a season, and its results as they are published."""

from __future__ import annotations

from collections import Counter, defaultdict
from functools import lru_cache

from django.db.models import Count, Q

from rcj_challenges.web import matchmaking, seasons
from rcj_challenges.web.ladder.published import PlayedMatch, Program, Results, Row, row_of
from rcj_challenges.web.ladder.ratings import Fit, fit, standings
from rcj_challenges.web.models import Basis, Match, MatchKind, Season, State, Submission

Record = Counter[str]
"""How matches ended: ``won``, ``drawn`` and ``lost``."""


@lru_cache(maxsize=4)
def _computed(basis: Basis, _version: tuple[object, ...], playing: tuple[str, ...]) -> tuple[list[Row], Fit]:
    fitted = fit(matchmaking.results_of(basis), matchmaking.programs_of(basis.season))
    return [row_of(rating) for rating in standings(fitted, set(playing))], fitted


def table_of(basis: Basis) -> tuple[list[Row], Fit]:
    """Return the table and the fit it comes from; they are computed once for each change."""
    counts = Match.objects.filter(basis=basis).aggregate(
        played=Count("played_at"), void=Count("pk", filter=~Q(void=""))
    )
    accepted = Submission.objects.filter(season=basis.season_id, state=State.ACCEPTED).count()
    playing = tuple(sorted(matchmaking.playing_now(basis.season)))
    return _computed(basis, (*counts.values(), accepted), playing)


def records_of(basis: Basis) -> dict[str, dict[str, Record]]:
    """Return how matches ended, by program and opponent."""
    found: dict[str, dict[str, Record]] = defaultdict(lambda: defaultdict(Record))
    for one in matchmaking.results_of(basis):
        lead = one.blue_goals - one.yellow_goals
        for own, other, ours in ((one.blue, one.yellow, lead), (one.yellow, one.blue, -lead)):
            found[own][other]["won" if ours > 0 else "lost" if ours < 0 else "drawn"] += 1
    return found


def published(season: Season) -> Results | None:
    """Return what is published of a season; None: its ladder has not begun."""
    basis = seasons.shown_basis(season)
    if basis is None:
        return None
    rows, _ = table_of(basis)
    playing = matchmaking.playing_now(season)
    played = Match.objects.filter(basis=basis, kind=MatchKind.RATED, played_at__isnull=False).order_by("number")
    return Results(
        season=season.title, scenario=basis.scenario, versions=basis.versions, secret_hash=season.secret_hash,
        secret=season.secret if season.ended_at is not None else None,
        programs=[
            Program(digest=digest, follows=before, plays=digest in playing)
            for digest, before in matchmaking.programs_of(season).items()
        ],
        matches=[
            PlayedMatch(
                number=one.number, seed=one.seed, blue=one.blue.digest, yellow=one.yellow.digest,
                score=(one.blue_goals or 0, one.yellow_goals or 0), digest=one.digest, void=one.void,
            )
            for one in played.select_related("blue", "yellow").defer("blue__report", "yellow__report")
        ],
        table=rows,
    )  # fmt: skip
