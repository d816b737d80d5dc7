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
_SMALL_STEP = 1e-10


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
    if unknown := {before for before in predecessors.values() if before is not None} - set(predecessors):
        raise ValueError(f"program {min(unknown)} is not listed")
    TopologicalSorter({one: [before] for one, before in predecessors.items() if before is not None}).prepare()
    digests = tuple(sorted(predecessors))
    place = {digest: i for i, digest in enumerate(digests)}
    pairs, counts = _counted(results, place)
    prior = np.zeros((len(digests), len(digests)))
    for digest in digests:
        i, before = place[digest], predecessors[digest]
        if before is None:
            prior[i, i] += FIRST_SD**-2
        else:
            ends = [i, place[before]]
            prior[np.ix_(ends, ends)] += np.array([[1.0, -1.0], [-1.0, 1.0]]) * NEXT_SD**-2
    games = np.zeros(len(digests), np.int64)
    np.add.at(games, pairs, counts.sum(1, keepdims=True))
    posterior = _Posterior(pairs, counts, prior)
    optimum = posterior.optimum()
    n = len(digests)
    covariance = np.linalg.inv(-posterior.slopes(optimum)[1])[:n, :n]
    tie = float(optimum[n]) if posterior.has_ties else -math.inf
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
    for result in results:
        for digest in (result.blue, result.yellow):
            if digest not in place:
                raise ValueError(f"program {digest} is not listed")
        if result.blue == result.yellow:
            continue
        blue, yellow = place[result.blue], place[result.yellow]
        lead = result.blue_goals - result.yellow_goals
        if blue > yellow:
            blue, yellow, lead = yellow, blue, -lead
        outcome = 1 if lead == 0 else 0 if lead > 0 else 2
        counted.setdefault((blue, yellow), [0, 0, 0])[outcome] += 1
    pairs = sorted(counted)
    counts = [counted[pair] for pair in pairs]
    return np.array(pairs, np.int64).reshape(-1, 2), np.array(counts, np.int64).reshape(-1, 3)


class _Posterior:
    """The log-posterior of the strengths and, after them, the log-weight of a draw.

    Without a draw, that weight has its optimum at minus infinity, so the model is the one without ties. One imagined
    match between equals that one of them won keeps it finite if all matches are drawn.
    """

    def __init__(self, pairs: Ints, counts: Ints, prior: Floats) -> None:
        self._first, self._second = pairs[:, 0], pairs[:, 1]
        self._counts = counts.astype(np.float64)
        self._games = self._counts.sum(1)
        self._prior = prior
        self.has_ties = bool(counts[:, 1].any())

    def _weights(self, at: Floats) -> tuple[Floats, Floats]:
        """Log-weights of the three outcomes of each pair, shape (m, 3), and the logarithm of their sums, shape (m,)."""
        n = len(self._prior)
        half = (at[self._first] - at[self._second]) / 2
        tie = at[n] if self.has_ties else -np.inf
        logs = np.stack([half, np.full_like(half, tie), -half], axis=1)
        return logs, np.logaddexp.reduce(logs, axis=1)

    def value(self, at: Floats) -> float:
        """The log-posterior, but for a constant."""
        n = len(self._prior)
        logs, totals = self._weights(at)
        seen = np.where(self._counts > 0, self._counts * np.where(self._counts > 0, logs, 0.0), 0.0)
        value = seen.sum() - (self._games * totals).sum() - at[:n] @ self._prior @ at[:n] / 2
        if self.has_ties:
            value -= np.logaddexp(math.log(2), at[n])
        return float(value)

    def slopes(self, at: Floats) -> tuple[Floats, Floats]:
        """The gradient and the matrix of second derivatives."""
        n, size = len(self._prior), len(at)
        first, second = self._first, self._second
        logs, totals = self._weights(at)
        win, draw, loss = np.exp(logs - totals[:, None]).T
        lead = win - loss
        gradient, curvature = np.zeros(size), np.zeros((size, size))
        slope = (self._counts[:, 0] - self._counts[:, 2] - self._games * lead) / 2
        np.add.at(gradient, first, slope)
        np.add.at(gradient, second, -slope)
        bend = self._games * (win + loss - lead**2) / 4
        for a, b, sign in ((first, first, -1), (second, second, -1), (first, second, 1), (second, first, 1)):
            np.add.at(curvature, (a, b), sign * bend)
        gradient[:n] -= self._prior @ at[:n]
        curvature[:n, :n] -= self._prior
        if self.has_ties:
            imagined = 1 / (1 + 2 * math.exp(-at[n]))
            gradient[n] = (self._counts[:, 1] - self._games * draw).sum() - imagined
            curvature[n, n] = -(self._games * draw * (1 - draw)).sum() - imagined * (1 - imagined)
            mixed = self._games * draw * lead / 2
            for a, sign in ((first, 1), (second, -1)):
                np.add.at(curvature[n], a, sign * mixed)
            curvature[:n, n] = curvature[n, :n]
        return gradient, curvature

    def optimum(self) -> Floats:
        """The maximum, by Newton steps, halved while they lead downhill."""
        at = np.zeros(len(self._prior) + self.has_ties)
        value = self.value(at)
        for _ in range(_MAX_STEPS):
            gradient, curvature = self.slopes(at)
            step = -np.linalg.solve(curvature, gradient)
            size = float(np.abs(step).max(initial=0.0))
            if size < _SMALL_STEP:
                return at
            # Close to the maximum, the difference of two values is only rounding.
            while size > 1e-3 and self.value(at + step) < value:
                step, size = step / 2, size / 2
            at = at + step
            value = self.value(at)
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
    if not rows:
        return []
    root = np.linalg.cholesky(fitted.covariance[np.ix_(rows, rows)])
    draws = np.random.default_rng(_DRAWS_SEED).standard_normal((_DRAWS, len(rows)))
    strengths = fitted.strengths[rows] + draws @ root.T
    ranks = np.sort(1 + np.argsort(np.argsort(-strengths, axis=1, kind="stable"), axis=1, kind="stable"), axis=0)
    low, high = ranks[_DRAWS // 20], ranks[_DRAWS - _DRAWS // 20 - 1]
    return [(int(a), int(b)) for a, b in zip(low, high, strict=True)]


def _rounded(points: float) -> int:
    """The nearest integer. What differs by the rounding of another computer only is first made equal."""
    return math.floor(round(float(points), 6) + 0.5)
