"""The table of a season, and its results as they are published."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from django.db.models import Count, Q

from rcj_challenges.web import seasons
from rcj_challenges.web.ladder.published import PlayedMatch, Program, Results, fit_of, table_of
from rcj_challenges.web.ladder.ratings import Fit, Rating
from rcj_challenges.web.models import Basis, Match, MatchKind, State, Submission

Record = Counter[str]
"""How matches ended: ``won``, ``drawn`` and ``lost``."""


@dataclass(frozen=True)
class Standings:
    """What follows from the results of a season.

    Attributes:
        published: the results and the table, as they are published.
        fitted: the strengths of all programs.
        records: how matches ended, by program and opponent.
        playing: what plays now, by program.
    """

    published: Results
    fitted: Fit
    records: Mapping[str, Mapping[str, Record]]
    playing: Mapping[str, list[Submission]]

    @property
    def ranked(self) -> list[Rating]:
        """The rows of the table that have a rank."""
        return [row for row in self.published.table if row.rank is not None]

    def record(self, digest: str) -> Record:
        """How all matches of a program ended."""
        return sum(self.records[digest].values(), Counter())


def standings_of(basis: Basis) -> Standings:
    """Return the standings; they are computed once for each change."""
    season, playing = basis.season, seasons.playing_now(basis.season)
    matches = Match.objects.filter(basis=basis)
    counts = matches.aggregate(played=Count("played_at"), void=Count("pk", filter=~Q(void="")))
    accepted = Submission.objects.filter(season=season, state=State.ACCEPTED).count()
    version = (season.title, season.secret_hash, season.ended_at, *counts.values(), accepted)
    return Standings(*_computed(basis, tuple(sorted(playing)), version), playing)


@lru_cache(maxsize=2)
def _computed(
    basis: Basis, playing: tuple[str, ...], _version: tuple[object, ...]
) -> tuple[Results, Fit, dict[str, dict[str, Record]]]:
    """Compute all from what is published: matches end meanwhile, and the table must be that of the same results."""
    season = basis.season
    played = Match.objects.filter(basis=basis, kind=MatchKind.RATED, played_at__isnull=False).order_by("number")
    columns = ("number", "seed", "blue__digest", "yellow__digest", "blue_goals", "yellow_goals", "digest", "void")
    matches = [
        PlayedMatch(number=number, seed=seed, blue=blue, yellow=yellow, score=(ours or 0, theirs or 0),
                    digest=digest, void=void)
        for number, seed, blue, yellow, ours, theirs, digest, void in played.values_list(*columns)
    ]  # fmt: skip
    results = Results(
        season=season.title, scenario=basis.scenario, versions=basis.versions, secret_hash=season.secret_hash,
        secret=season.secret if season.ended_at is not None else None, matches=matches, table=[],
        programs=[
            Program(digest=digest, follows=before, plays=digest in playing)
            for digest, before in seasons.programs_of(season).items()
        ],
    )  # fmt: skip
    fitted = fit_of(results)
    results.table = table_of(results, fitted)
    return results, fitted, _records(results)


def _records(results: Results) -> dict[str, dict[str, Record]]:
    records: dict[str, dict[str, Record]] = {one.digest: {} for one in results.programs}
    for one in results.matches:
        lead = one.score[0] - one.score[1]
        for own, other, ours in ((one.blue, one.yellow, lead), (one.yellow, one.blue, -lead)) * (not one.void):
            records[own].setdefault(other, Counter())["won" if ours > 0 else "lost" if ours < 0 else "drawn"] += 1
    return records
