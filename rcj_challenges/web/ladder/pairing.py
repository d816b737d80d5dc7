"""Match-making: which programs play next, so that the table becomes certain soon and none waits for long."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from rcj_challenges.web.ladder.ratings import PLACEMENTS, Fit, Floats, Ints

MEETINGS = 3
"""Rated matches of one pair of programs at most: more of the same say little, and could be used to farm points."""
_SIGNIFICANT = 9
"""Decimals of the value of a match that count: further ones differ between computers."""


@dataclass(frozen=True)
class Candidate:
    """A program that plays now.

    Attributes:
        digest: the program.
        meetings: by group of its teams, how often two programs of the group may meet.
        waited_h: since its last match was put into the queue, or since it was handed in, in hours.
        lane_s: expected time of a match with it, in s.
    """

    digest: str
    meetings: Mapping[int, int]
    waited_h: float
    lane_s: float


@dataclass(frozen=True)
class Pairing:
    """A match to be played.

    Attributes:
        blue: digest of the program that begins on blue.
        yellow: digest of the other one.
        is_placement: whether one of them has not played its placements yet.
    """

    blue: str
    yellow: str
    is_placement: bool


def choose(
    fitted: Fit,
    candidates: Collection[Candidate],
    met: Mapping[tuple[str, str], int],
    waiting: Iterable[tuple[str, str]],
    count: int,
) -> list[Pairing]:
    """Choose the next matches; the same arguments give the same choice.

    Args:
        fitted: the fit of all programs to all results.
        candidates: those that play now, in any order; each must be in the fit.
        met: rated matches of each pair of digests, sorted, also those in the queue.
        waiting: pairs of matches in the queue; what they will show is not to be shown again.
        count: how many to choose; if fewer are allowed, so many are returned.
    """
    table = _Table(fitted, sorted(candidates, key=lambda one: one.digest), met)
    for pair in waiting:
        table.expect(*pair)
    found: list[Pairing] = []
    while len(found) < count and (pairing := table.next_pair()) is not None:
        found.append(pairing)
    return found


class _Table:
    def __init__(self, fitted: Fit, candidates: list[Candidate], met: Mapping[tuple[str, str], int]) -> None:
        place = {digest: i for i, digest in enumerate(fitted.digests)}
        rows = [place[one.digest] for one in candidates]
        n = len(rows)
        self._digests = [one.digest for one in candidates]
        self._place = {digest: i for i, digest in enumerate(self._digests)}
        self._strengths: Floats = fitted.strengths[rows]
        self._covariance: Floats = fitted.covariance[np.ix_(rows, rows)]
        self._waited_h: Floats = np.array([one.waited_h for one in candidates])
        self._lane_s: Floats = np.array([one.lane_s for one in candidates])
        self._games: Ints = np.zeros(n, np.int64)
        self._left: Ints = np.full((n, n), MEETINGS, np.int64)
        limits = {group: most for one in candidates for group, most in one.meetings.items()}
        for group, most in limits.items():
            members = np.ix_(*2 * ([i for i, one in enumerate(candidates) if group in one.meetings],))
            self._left[members] = np.minimum(self._left[members], most)
        np.fill_diagonal(self._left, 0)
        for pair, games in met.items():
            at = [self._place[digest] for digest in pair if digest in self._place]
            self._games[at] += games
            if len(at) == len(pair):
                self._left[at, at[::-1]] -= games

    def next_pair(self) -> Pairing | None:
        """Choose a match and count it as expected; None: no two may meet."""
        free = self._left > 0
        is_placing = (self._games < PLACEMENTS) & free.any(1)
        if not free.any():
            return None
        if is_placement := bool(is_placing.any()):
            i = int(np.lexsort((-self._waited_h, self._games, ~is_placing))[0])
            j = self._placement_opponent(i, np.flatnonzero(free[i]))
        else:
            i, j = self._most_informative(free)
        blue, yellow = (i, j) if self._left[i, j] % 2 else (j, i)
        self._games[[i, j]] += 1
        self._left[[i, j], [j, i]] -= 1
        self._waited_h[[i, j]] = 0.0
        self.expect(self._digests[i], self._digests[j])
        return Pairing(self._digests[blue], self._digests[yellow], is_placement)

    def _placement_opponent(self, i: int, others: Ints) -> int:
        """The nearest opponent and one at random in turn: random ones keep all programs connected."""
        games = int(self._games[i])
        if games % 2:
            drawn = hashlib.sha256(f"{self._digests[i]}/{games}".encode()).digest()
            return int(others[int.from_bytes(drawn[:8], "big") % len(others)])
        distance = np.round(np.abs(self._strengths[others] - self._strengths[i]), _SIGNIFICANT)
        return int(others[np.lexsort((self._games[others], distance))[0]])

    def _most_informative(self, free: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]) -> tuple[int, int]:
        """The pair whose match shows most for the time that it takes, and the sooner the longer one has waited."""
        variances = np.diag(self._covariance)
        doubt = variances[:, None] + variances - 2 * self._covariance
        waited_h = np.maximum(self._waited_h[:, None], self._waited_h)
        lane_s = (self._lane_s[:, None] + self._lane_s) / 2
        value = np.where(np.triu(free), self._information() * doubt * (1 + waited_h) / lane_s, -1.0)
        i, j = np.unravel_index(np.argmax(np.round(value / value.max(), _SIGNIFICANT)), value.shape)
        return int(i), int(j)

    def _information(self) -> Floats:
        """For each pair the variance of the outcome of a match."""
        won = 1 / (1 + np.exp(self._strengths - self._strengths[:, None]))
        return np.asarray(won * (1 - won))

    def expect(self, one: str, other: str) -> None:
        """Reduce the doubt by what a match of two programs will show."""
        if one not in self._place or other not in self._place:
            return
        i, j = self._place[one], self._place[other]
        information = self._information()[i, j]
        lead = self._covariance[:, i] - self._covariance[:, j]
        self._covariance = self._covariance - np.outer(lead, lead) * information / (
            1 + information * (lead[i] - lead[j])
        )
