"""Ratings: the Bradley-Terry model with ties (Davidson 1970), fitted to all results of a season at once.

A program's strength is its log-odds against an average program; with strengths `a` and `b`, a win, a loss and a draw
have the weights `exp((a - b) / 2)`, `exp((b - a) / 2)` and `exp(tie)`. The log-posterior is strictly concave, so there
is one optimum, whatever the order of the results. Results are counted before anything is added, so it is also equal
bit for bit.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from graphlib import TopologicalSorter

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MEAN = 1000
POINTS = 400 / math.log(10)
"""Points per unit of log-odds: 400 points are odds of ten to one, as in chess (Elo 1978)."""
FIRST_SD = 250 / POINTS
"""Standard deviation of a team's first program around `MEAN`, in log-odds."""
NEXT_SD = 150 / POINTS
"""Standard deviation of a team's next program around its last one, in log-odds."""
PLACEMENTS = 8
"""Matches that each program plays before it has a rank; in a small club as many as it has opponents."""
_DRAWS = 2000
_DRAWS_SEED = 20_260_101
_MAX_STEPS = 100
_SMALL_STEP, _LONG_STEP = 1e-10, 0.5


@dataclass(frozen=True)
class Result:
    """One rated match.

    Attributes:
        blue: digest of the programs of the blue team.
        yellow: digest of the programs of the yellow team.
        blue_goals: goals of the blue team.
        yellow_goals: goals of the yellow team.
    """

    blue: str
    yellow: str
    blue_goals: float
    yellow_goals: float


@dataclass(frozen=True)
class Rating:
    """The rating of one program.

    Attributes:
        digest: the program.
        value: its strength in points.
        sd: standard deviation of its distance from the mean of the shown programs, in points.
        games: number of rated matches.
        rank: place among the ranked programs, shared by equal values; None while it is placing.
        low: best rank of its interval; None while it is placing.
        high: worst rank of its interval; None while it is placing.
    """

    digest: str
    value: int
    sd: int
    games: int
    rank: int | None
    low: int | None
    high: int | None


@dataclass(frozen=True)
class Fit:
    """Strengths of all programs of a season.

    Attributes:
        digests: the programs, sorted.
        strengths: log-odds against an average program, shape (n,).
        covariance: of the strengths, shape (n, n).
        games: rated matches of each program, shape (n,).
        tie: log-weight of a draw; minus infinity if there was none.
    """

    digests: tuple[str, ...]
    strengths: Floats
    covariance: Floats
    games: Ints
    tie: float

    def value_of(self, digest: str) -> int:
        """The strength of a program in points."""
        return MEAN + _rounded(self.strengths[self.digests.index(digest)] * POINTS)


def fit(results: Iterable[Result], predecessors: Mapping[str, str | None]) -> Fit:
    """Fit the strengths of programs to results.

    Args:
        results: in any order; matches of a program against itself are not rated.
        predecessors: for each program, the one its team played before when it was first accepted; None for a first one.

    Raises:
        ValueError: a result or predecessor names an unlisted program, or a program is among its own predecessors.
    """
    rated = list(results)
    named = {before for before in predecessors.values() if before is not None}
    if unlisted := named.union(*((one.blue, one.yellow) for one in rated)) - predecessors.keys():
        raise ValueError(f"program {min(unlisted)} is not listed")
    TopologicalSorter({one: [before] for one, before in predecessors.items() if before is not None}).prepare()
    digests = tuple(sorted(predecessors))
    n, place = len(digests), {digest: i for i, digest in enumerate(digests)}
    prior = np.zeros((n, n))
    for digest in digests:
        ends = [place[one] for one in (digest, predecessors[digest]) if one is not None]
        signs, sd = ([1.0, -1.0], NEXT_SD) if len(ends) > 1 else ([1.0], FIRST_SD)
        prior[np.ix_(ends, ends)] += np.outer(signs, signs) * sd**-2
    pairs, counts = _counted(rated, place)
    games = np.zeros(n, np.int64)
    np.add.at(games, pairs, counts.sum(1, keepdims=True))
    optimum, curvature = _optimum(pairs, counts, prior)
    covariance = np.linalg.inv(-curvature)[:n, :n]
    tie = float(optimum[n]) if len(optimum) > n else -math.inf
    return Fit(digests, optimum[:n], (covariance + covariance.T) / 2, games, tie)


def standings(fitted: Fit, shown: Collection[str]) -> list[Rating]:
    """Ratings of the shown programs, best first; those that are placing have no rank and are compared with no other.

    Args:
        fitted: the fit of all programs.
        shown: those that play now; each must be in the fit.
    """
    rows = [i for i, digest in enumerate(fitted.digests) if digest in shown]
    values = {i: fitted.value_of(fitted.digests[i]) for i in rows}
    sds = dict(zip(rows, _centred_sds(fitted, rows), strict=True))
    needed = min(PLACEMENTS, max(1, len(rows) - 1))
    ranked = [i for i in rows if fitted.games[i] >= needed]
    intervals = dict(zip(ranked, _rank_intervals(fitted, ranked), strict=True))
    ratings = []
    for i in sorted(rows, key=lambda i: (-values[i], fitted.digests[i])):
        rank = low = high = None
        if i in intervals:
            rank = 1 + sum(values[j] > values[i] for j in ranked)
            low, high = min(rank, intervals[i][0]), max(rank, intervals[i][1])
        ratings.append(Rating(fitted.digests[i], values[i], sds[i], int(fitted.games[i]), rank, low, high))
    return ratings


def _counted(results: Iterable[Result], place: Mapping[str, int]) -> tuple[Ints, Ints]:
    """Pairs that met, sorted, shape (m, 2); wins of the first, draws and wins of the second, shape (m, 3)."""
    counted: dict[tuple[int, int], list[int]] = {}
    for one in results:
        lead = one.blue_goals - one.yellow_goals
        (first, lead), (second, _) = sorted([(place[one.blue], lead), (place[one.yellow], -lead)])
        if first != second:
            counted.setdefault((first, second), [0, 0, 0])[1 - (lead > 0) + (lead < 0)] += 1
    pairs = sorted(counted)
    counts = [counted[pair] for pair in pairs]
    return np.array(pairs, np.int64).reshape(-1, 2), np.array(counts, np.int64).reshape(-1, 3)


def _slopes(at: Floats, pairs: Ints, counts: Ints, prior: Floats) -> tuple[Floats, Floats]:
    """The gradient of the log-posterior, and the matrix of its second derivatives.

    At the end of ``at`` is the log-weight of a draw, if there was one; else its optimum is minus infinity, so the model
    is the one without ties. One imagined match between equals that one of them won keeps it finite if all are drawn.
    """
    n, (first, second), games = len(prior), pairs.T, counts.sum(1)
    has_ties = len(at) > n
    half = (at[first] - at[second]) / 2
    logs = np.stack([half, np.full_like(half, at[n] if has_ties else -np.inf), -half])
    win, draw, loss = np.exp(logs - np.logaddexp.reduce(logs))
    lead = win - loss
    gradient, curvature = np.zeros(len(at)), np.zeros((len(at), len(at)))
    slope = (counts[:, 0] - counts[:, 2] - games * lead) / 2
    bend = games * (win + loss - lead**2) / 4
    mixed = games * draw * lead / 2
    for a, b, sign in ((first, second, 1), (second, first, -1)):
        np.add.at(gradient, a, sign * slope)
        np.add.at(curvature, (a, a), -bend)
        np.add.at(curvature, (a, b), bend)
        if has_ties:
            np.add.at(curvature[n], a, sign * mixed)
    gradient[:n] -= prior @ at[:n]
    curvature[:n, :n] -= prior
    if has_ties:
        imagined = 1 / (1 + 2 * math.exp(-at[n]))
        gradient[n] = (counts[:, 1] - games * draw).sum() - imagined
        curvature[n, n] = -(games * draw * (1 - draw)).sum() - imagined * (1 - imagined)
        curvature[:n, n] = curvature[n, :n]
    return gradient, curvature


def _optimum(pairs: Ints, counts: Ints, prior: Floats) -> tuple[Floats, Floats]:
    """The maximum by Newton steps, and the second derivatives there.

    No step is so long that the log-odds of two outcomes change by more than 1: then each leads uphill, as the third
    derivative of such a posterior is bounded by the second (Bach 2010, lemma 1).
    """
    at = np.zeros(len(prior) + bool(counts[:, 1].any()))
    for _ in range(_MAX_STEPS):
        gradient, curvature = _slopes(at, pairs, counts, prior)
        step = -np.linalg.solve(curvature, gradient)
        size = float(np.abs(step).max(initial=0.0))
        if size < _SMALL_STEP:
            return at, curvature
        at = at + step * min(1.0, _LONG_STEP / size)
    raise ArithmeticError(f"no maximum after {_MAX_STEPS} steps")


def _centred_sds(fitted: Fit, rows: list[int]) -> list[int]:
    """Standard deviations of the distances from the mean of these rows, in points.

    Matches show differences only. The level that all programs share keeps the doubt of the prior for ever: 102 points
    with six first programs, with which no program of a small club would have a rank.
    """
    if not rows:
        return []
    part = fitted.covariance[np.ix_(rows, rows)]
    variances = np.diag(part) - 2 * part.mean(1) + part.mean()
    return [_rounded(math.sqrt(max(variance, 0.0)) * POINTS) for variance in variances]


def _rank_intervals(fitted: Fit, rows: list[int]) -> list[tuple[int, int]]:
    """The ranks between which 90 % of draws from the posterior lie, for each row."""
    root = np.linalg.cholesky(fitted.covariance[np.ix_(rows, rows)])
    draws = np.random.default_rng(_DRAWS_SEED).standard_normal((_DRAWS, len(rows)))
    strengths = fitted.strengths[rows] + draws @ root.T
    ranks = np.sort(1 + np.argsort(np.argsort(-strengths, axis=1, kind="stable"), axis=1, kind="stable"), axis=0)
    low, high = ranks[_DRAWS // 20], ranks[_DRAWS - _DRAWS // 20 - 1]
    return [(int(a), int(b)) for a, b in zip(low, high, strict=True)]


def _rounded(points: float) -> int:
    """The nearest integer. What differs by the rounding of another computer only is first made equal."""
    return math.floor(round(float(points), 6) + 0.5)
