"""Tables of matches: the places of teams by an ordered list of tie-breaks."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import groupby
from typing import Any

from rcj_challenges.core.grouping import grouped
from rcj_challenges.tournament.season import Row, Table


@dataclass(frozen=True, slots=True)
class Match:
    """A match that counts: two teams and their goals; one that both forfeit is lost by both."""

    teams: tuple[str, str]
    goals: tuple[float, float]
    is_lost_by_both: bool = False


@dataclass(frozen=True, slots=True)
class TableRules:
    """The rules of a table: points for a match, tie-breaks, and the lot of each team; the smallest wins."""

    win: float
    draw: float
    loss: float
    tie_breaks: tuple[str, ...]
    lot: Callable[[str], Any]


@dataclass(slots=True)
class Tally:
    """The totals of a team over some matches."""

    played: int = 0
    won: int = 0
    drawn: int = 0
    lost: int = 0
    goals: float = 0
    conceded: float = 0
    points: float = 0

    def add(self, goals: float, conceded: float, rules: TableRules, *, is_lost_by_both: bool = False) -> None:
        """Add a match."""
        self.played += 1
        self.goals += goals
        self.conceded += conceded
        if goals > conceded:
            self.won += 1
            self.points += rules.win
        elif goals < conceded or is_lost_by_both:
            self.lost += 1
            self.points += rules.loss
        else:
            self.drawn += 1
            self.points += rules.draw

    def filled(self, row: Row, *, by_lot: bool = False) -> Row:
        """Return a line of a table with these totals."""
        return Row(
            row.team, row.place, row.shared, self.played, self.won, self.drawn, self.lost, self.goals, self.conceded,
            self.points, row.by_lot or by_lot,
        )  # fmt: skip


def tally(teams: Iterable[str], matches: Iterable[Match], rules: TableRules) -> dict[str, Tally]:
    """Return the totals of each team."""
    tallies = {team: Tally() for team in teams}
    for match in matches:
        (first, second), (goals, conceded) = match.teams, match.goals
        tallies[first].add(goals, conceded, rules, is_lost_by_both=match.is_lost_by_both)
        tallies[second].add(conceded, goals, rules, is_lost_by_both=match.is_lost_by_both)
    return tallies


def table(
    name: str,
    teams: Sequence[str],
    matches: Sequence[Match],
    rules: TableRules,
    *,
    complete: bool,
    extra_points: Mapping[str, float] | None = None,
) -> Table:
    """Return the table of the matches that count; teams that share a place keep their order.

    If it is complete, no match is missing; lots are drawn only then. ``extra_points`` are those for byes.
    """
    tallies = tally(teams, matches, rules)
    for team, points in (extra_points or {}).items():
        tallies[team].points += points
    ranking = _Ranking(matches, rules, tallies)
    words = rules.tie_breaks if complete else tuple(word for word in rules.tie_breaks if word != "lot")
    rows = placed(ranking.levels(list(teams), words))
    filled = tuple([tallies[row.team].filled(row, by_lot=row.team in ranking.by_lot) for row in rows])
    return Table(name, filled, (), complete)


def placed(levels: Iterable[Sequence[str]], lot: Callable[[str], Any] | None = None) -> Iterator[Row]:
    """Yield rows of teams, the best level first; those of one level share a place, unless a lot decides."""
    place = 1
    for level in levels:
        is_by_lot = lot is not None and len(level) > 1
        for index, team in enumerate(sorted(level, key=lot) if is_by_lot else level):
            is_shared = len(level) > 1 and not is_by_lot
            yield Row(team, place + index * is_by_lot, shared=is_shared, by_lot=is_by_lot)
        place += len(level)


@dataclass
class _Ranking:
    matches: Sequence[Match]
    rules: TableRules
    tallies: Mapping[str, Tally]
    by_lot: set[str] = field(default_factory=set)

    @cached_property
    def _by_team(self) -> dict[str, list[Match]]:
        return grouped((match.teams[0], match) for match in self.matches)

    def levels(self, teams: list[str], words: Sequence[str]) -> list[list[str]]:
        """Return teams best first; those that are level in all criteria are in one list."""
        if len(teams) == 1 or not words:
            return [teams]
        word, rest = words[0], words[1:]
        keys = self._keys(word, teams)
        parts = [list(part) for _, part in groupby(sorted(teams, key=keys.__getitem__), key=keys.__getitem__)]
        if word == "lot":
            self.by_lot.update(teams)
        # Some are separated: those still level are compared again, by the matches among themselves only.
        following = words if word == "head_to_head" and len(parts) > 1 else rest
        return [level for part in parts for level in self.levels(part, following)]

    def _keys(self, word: str, teams: list[str]) -> dict[str, Any]:
        """Return a key for each team, the smallest for the best."""
        if word == "lot":
            return {team: self.rules.lot(team) for team in teams}
        if word == "head_to_head":
            return self._head_to_head(teams)
        if word in ("buchholz", "median_buchholz", "sonneborn_berger"):
            return {team: -round(self._by_opponents(word, team), 9) for team in teams}
        tallies = self.tallies
        if word == "goal_difference":
            return {team: tallies[team].conceded - tallies[team].goals for team in teams}
        attribute = {"points": "points", "goals": "goals", "wins": "won"}[word]
        return {team: -getattr(tallies[team], attribute) for team in teams}

    def _by_opponents(self, word: str, team: str) -> float:
        met = [match for match in self.matches if team in match.teams]
        points = [self.tallies[match.teams[match.teams[0] == team]].points for match in met]
        if word == "sonneborn_berger":
            own = [tally(match.teams, [match], self.rules)[team] for match in met]
            return sum(of_other * (one.won + one.drawn / 2) for of_other, one in zip(points, own, strict=True))
        return sum(sorted(points)[1:-1] if word == "median_buchholz" and len(points) > 2 else points)

    def _head_to_head(self, teams: list[str]) -> dict[str, Any]:
        among = set(teams)
        matches = [match for team in teams for match in self._by_team.get(team, ()) if match.teams[1] in among]
        met = {frozenset(match.teams) for match in matches}
        own = tally(teams, matches, self.rules)
        if len(met) < len(teams) * (len(teams) - 1) // 2:  # in a Swiss stage not all have met: no fair comparison
            return dict.fromkeys(teams, ())
        return {team: (-one.points, one.conceded - one.goals, -one.goals) for team, one in own.items()}
