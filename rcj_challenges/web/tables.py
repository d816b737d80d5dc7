"""The table of a season, and its results as they are published."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from functools import lru_cache
from typing import NamedTuple

from django.db.models import Count, Q

from rcj_challenges.web import matchmaking, seasons
from rcj_challenges.web.ladder.published import PlayedMatch, Program, Results, Row, row_of
from rcj_challenges.web.ladder.ratings import Fit, fit, standings
from rcj_challenges.web.models import Basis, Match, MatchKind, Season, State, Submission

Record = Counter[str]
"""How matches ended: ``won``, ``drawn`` and ``lost``."""


class Table(NamedTuple):
    """What follows from the results of a season.

    Attributes:
        rows: of the programs that play now, best first.
        fitted: the strengths of all programs.
        records: how matches ended, by program and opponent.
    """

    rows: list[Row]
    fitted: Fit
    records: Mapping[str, Mapping[str, Record]]


@lru_cache(maxsize=4)
def _computed(basis: Basis, _version: tuple[object, ...], playing: tuple[str, ...]) -> Table:
    results = matchmaking.results_of(basis)
    fitted = fit(results, matchmaking.programs_of(basis.season))
    records: dict[str, dict[str, Record]] = {digest: {} for digest in fitted.digests}
    for one in results:
        lead = one.blue_goals - one.yellow_goals
        for own, other, ours in ((one.blue, one.yellow, lead), (one.yellow, one.blue, -lead)):
            records[own].setdefault(other, Counter())["won" if ours > 0 else "lost" if ours < 0 else "drawn"] += 1
    return Table([row_of(rating) for rating in standings(fitted, set(playing))], fitted, records)


def table_of(basis: Basis) -> Table:
    """Return the table; it is computed once for each change."""
    counts = Match.objects.filter(basis=basis).aggregate(
        played=Count("played_at"), void=Count("pk", filter=~Q(void=""))
    )
    accepted = Submission.objects.filter(season=basis.season_id, state=State.ACCEPTED).count()
    playing = tuple(sorted(matchmaking.playing_now(basis.season)))
    return _computed(basis, (basis.season.secret_hash, *counts.values(), accepted), playing)


def published(season: Season) -> Results | None:
    """Return what is published of a season; None: its ladder has not begun."""
    basis = seasons.shown_basis(season)
    if basis is None:
        return None
    playing = matchmaking.playing_now(season)
    played = Match.objects.filter(basis=basis, kind=MatchKind.RATED, played_at__isnull=False).order_by("number")
    columns = ("number", "seed", "blue__digest", "yellow__digest", "blue_goals", "yellow_goals", "digest", "void")
    return Results(
        season=season.title, scenario=basis.scenario, versions=basis.versions, secret_hash=season.secret_hash,
        secret=season.secret if season.ended_at is not None else None,
        programs=[
            Program(digest=digest, follows=before, plays=digest in playing)
            for digest, before in matchmaking.programs_of(season).items()
        ],
        matches=[
            PlayedMatch(number=number, seed=seed, blue=blue, yellow=yellow, score=(ours or 0, theirs or 0),
                        digest=digest, void=void)
            for number, seed, blue, yellow, ours, theirs, digest, void in played.values_list(*columns)
        ],
        table=table_of(basis).rows,
    )  # fmt: skip
