"""Fills the queue with matches of the ladder, as `ladder.pairing` chooses them."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Mapping
from datetime import datetime, timedelta
from itertools import chain

from rcj_challenges.web import jobs, seasons
from rcj_challenges.web.config import current_site
from rcj_challenges.web.ladder.pairing import Candidate, choose
from rcj_challenges.web.models import Basis, Job, JobState, Match, MatchKind, Season, Submission
from rcj_challenges.web.tables import standings_of

WAITING_PER_LANE = 4
_KINDS = ("placement", "ladder")
_DAY, _WEEK = timedelta(days=1), timedelta(days=7)
_HOUR_S = 3600.0
_FIRST_LANE_S = 10.0
"""Expected time of a match as long as none has been played, in s."""


def fill(lanes: int, now: datetime, fitting: Collection[int]) -> int:
    """Fill the queue of the current season, if half of what lanes are given ahead is gone.

    Args:
        lanes: that play.
        now: the time.
        fitting: the bases whose matches they can play.

    Returns:
        How many matches were added.
    """
    basis = seasons.current_basis(seasons.running())
    if basis is None or basis.pk not in fitting:
        return 0
    queued = Job.objects.filter(match__basis=basis, kind__in=_KINDS, state=JobState.QUEUED).count()
    wanted = WAITING_PER_LANE * lanes - queued
    if 2 * wanted < WAITING_PER_LANE * lanes:
        return 0
    return _add_chosen(basis, wanted, now) if basis.is_whole else _add_again(basis, wanted, now)


def _add_again(basis: Basis, wanted: int, now: datetime) -> int:
    """Queue matches that are to be played again; with the last one, the table becomes that of this basis."""
    with jobs.writing():
        matches = seasons.open_rated(basis).filter(job=None).order_by("number")[:wanted]
        for match in matches:
            jobs.enqueue("ladder", match, now)
        if not seasons.open_rated(basis).exists():
            Basis.objects.filter(pk=basis.pk).update(is_whole=True)
        return len(matches)


def _add_chosen(basis: Basis, wanted: int, now: datetime) -> int:
    before = Match.objects.filter(basis=basis).count()
    table = standings_of(basis)
    chosen = choose(table.fitted, _candidates(basis, table.playing, now), *_met(basis), wanted)
    with jobs.writing():
        # Another dispatcher may have chosen at the same time: then the next look at the queue decides.
        Season.objects.select_for_update().get(pk=basis.season_id)
        if not Basis.objects.filter(pk=basis.pk).exists() or Match.objects.filter(basis=basis).count() != before:
            return 0
        pairs = [(table.playing[one.blue][0], table.playing[one.yellow][0]) for one in chosen]
        matches = seasons.add_matches(basis, MatchKind.RATED, pairs, now)
        for match, one in zip(matches, chosen, strict=True):
            jobs.enqueue("placement" if one.is_placement else "ladder", match, now)
    return len(matches)


def _met(basis: Basis) -> tuple[Counter[tuple[str, str]], list[tuple[str, str]]]:
    """The number of matches of each pair, played or queued, and the pairs of those in the queue."""
    rated = Match.objects.filter(basis=basis, kind=MatchKind.RATED, void="")
    rows = rated.values_list("blue__digest", "yellow__digest", "played_at")
    pairs = [((min(blue, yellow), max(blue, yellow)), played_at) for blue, yellow, played_at in rows]
    return Counter(pair for pair, _ in pairs), [pair for pair, played_at in pairs if played_at is None]


def _candidates(basis: Basis, playing: Mapping[str, list[Submission]], now: datetime) -> list[Candidate]:
    """Return the programs that play now, without those that have had their lane time of the last 24 hours."""
    used_s: defaultdict[str, float] = defaultdict(float)
    lanes_s: dict[str, list[float]] = defaultdict(list)
    since = {digest: min(one.received_at for one in same) for digest, same in playing.items()}
    rows = Job.objects.filter(match__basis=basis, kind__in=_KINDS, created_at__gt=now - _WEEK).values_list(
        "match__blue__digest", "match__yellow__digest", "created_at", "finished_at", "lane_s"
    )
    for blue, yellow, created_at, finished_at, lane_s in rows:
        for digest in (blue, yellow):
            since[digest] = max(since.get(digest, created_at), created_at)
            if finished_at is not None:
                lanes_s[digest].append(lane_s)
                used_s[digest] += lane_s if finished_at > now - _DAY else 0.0
    every = list(chain.from_iterable(lanes_s.values())) or [_FIRST_LANE_S]
    mean_s = sum(every) / len(every)
    return [
        Candidate(
            digest,
            {one.team.group_id: one.team.group.meetings for one in same},
            max(0.0, (now - since[digest]).total_seconds() / _HOUR_S),
            max(1.0, (sum(lanes_s[digest]) + mean_s) / (len(lanes_s[digest]) + 1)),
        )
        for digest, same in playing.items()
        if used_s[digest] < current_site().lane_s_per_day
    ]
