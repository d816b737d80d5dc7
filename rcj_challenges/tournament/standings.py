"""Tables of matches: the places of teams by an ordered list of tie-breaks."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from rcj_challenges.tournament.season import Row, Table


@dataclass(frozen=True, slots=True)
class Match:
    """A match that counts: two teams and their goals; one that both forfeit is lost by both."""

    teams: tuple[str, str]
    goals: tuple[float, float]
    is_lost_by_both: bool = False


@dataclass(frozen=True, slots=True)
class TableRules:
    """How a table is ranked.

    Attributes:
        win, draw, loss: points for a match.
        tie_breaks: first criterion first.
        lot: gives each team its lot; the smallest wins.
    """

    win: float
    draw: float
    loss: float
    tie_breaks: tuple[str, ...]
    lot: Callable[[str], Any]


@dataclass(slots=True)
class Tally:
    """What a team has achieved in some matches."""

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

    def row(self, team: str, place: int, *, shared: bool, by_lot: bool) -> Row:
        """Return the line of a table for a team that has achieved this."""
        return Row(
            team, place, shared, self.played, self.won, self.drawn, self.lost, self.goals, self.conceded, self.points,
            by_lot,
        )  # fmt: skip


def tally(teams: Iterable[str], matches: Iterable[Match], rules: TableRules) -> dict[str, Tally]:
    """Return what each team has achieved in the matches."""
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
    """Return the table of matches among teams.

    Args:
        name: of the group, or empty.
        teams: ids; teams that share a place keep this order.
        matches: those that count.
        rules: how it is ranked.
        complete: whether no match is missing; lots are drawn only then.
        extra_points: points without a match, for byes.
    """
    tallies = tally(teams, matches, rules)
    for team, points in (extra_points or {}).items():
        tallies[team].points += points
    ranking = _Ranking(matches, rules, tallies)
    words = rules.tie_breaks if complete else tuple(word for word in rules.tie_breaks if word != "lot")
    return Table(name, _rows(ranking.levels(list(teams), words), tallies, ranking.by_lot), (), complete)


def _rows(levels: Sequence[Sequence[str]], tallies: Mapping[str, Tally], by_lot: set[str]) -> tuple[Row, ...]:
    rows: list[Row] = []
    for level in levels:
        place = len(rows) + 1
        rows += [tallies[team].row(team, place, shared=len(level) > 1, by_lot=team in by_lot) for team in level]
    return tuple(rows)


@dataclass
class _Ranking:
    matches: Sequence[Match]
    rules: TableRules
    tallies: Mapping[str, Tally]
    by_lot: set[str] = field(default_factory=set)
    _by_team: dict[str, list[Match]] = field(default_factory=dict)

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
        if not self._by_team:
            for match in self.matches:
                self._by_team.setdefault(match.teams[0], []).append(match)
        among = set(teams)
        matches = [match for team in teams for match in self._by_team.get(team, ()) if match.teams[1] in among]
        met = {frozenset(match.teams) for match in matches}
        own = tally(teams, matches, self.rules)
        if len(met) < len(teams) * (len(teams) - 1) // 2:  # in a Swiss stage not all have met: no fair comparison
            return dict.fromkeys(teams, ())
        return {team: (-one.points, one.conceded - one.goals, -one.goals) for team, one in own.items()}
