"""Swiss: in each round teams with equal points meet, and no two meet twice."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.fields import described
from rcj_challenges.tournament.codes import REMATCH_POSSIBLE, TOO_MANY_ROUNDS
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.groups import by_pot
from rcj_challenges.tournament.formats.play_off import play_offs
from rcj_challenges.tournament.formats.stage import Intake, LeagueFormat, StageSize
from rcj_challenges.tournament.formats.swiss_pairing import Player, pair
from rcj_challenges.tournament.models import LostBy
from rcj_challenges.tournament.season import Fixture, StageState, Table
from rcj_challenges.tournament.standings import Match, table


class Swiss(LeagueFormat):
    """In each round, teams with equal points meet; no two meet twice. With an odd number of teams, one has a bye."""

    stage: Literal["swiss"]
    rounds: int = described(
        ...,
        "number of rounds, fewer than teams; above half the number of teams, two may have to meet twice",
        ge=1,
        le=64,
    )

    def size(self, intake: Intake) -> StageSize:
        return StageSize(intake.teams, {"": intake.teams}, self.rounds * (intake.teams // 2), self.rounds)

    def problems(self, intake: Intake, size: StageSize) -> Iterator[Diagnostic]:
        most, safe = size.teams - 1, -(-size.teams // 2)
        if self.rounds > most:
            message = f"{self.rounds} rounds are too many for {size.teams} teams"
            help_ = f"at most {most}; all meet in a round_robin"
            yield issue(TOO_MANY_ROUNDS, ("rounds",), message, help_)
        elif self.rounds > safe:
            message = f"in {self.rounds} rounds of {size.teams} teams a rematch may be unavoidable"
            help_ = f"up to {safe} rounds need no rematch; all meet in a round_robin"
            yield issue(REMATCH_POSSIBLE, ("rounds",), message, help_)

    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        """Return the state of a Swiss stage: rounds are drawn one by one, as soon as the one before is over."""
        teams = tuple(entrant.team for entrant in entrants)
        pots = {entrant.team: entrant.pot for entrant in entrants}
        course = _Course(context, self, by_pot(pots, context.tournament.seed, f"{context.name}/order"))
        is_complete = course.play()
        found = course.table(complete=is_complete)
        more: list[Fixture] = []
        if self.play_off and is_complete:
            found, more = play_offs(context, self, found, self.rounds + 1)
        return context.state(
            self,
            teams,
            is_finished=found.complete,
            fixtures=(*course.fixtures, *more),
            expected_matches=len(course.fixtures) + len(more) + course.matches_to_come(),
            tables=(found,),
            has_matrices=True,
            byes=tuple(course.byes),
            places=found.rows if found.complete else (),
        )


@dataclass
class _Course:
    """The rounds of a Swiss stage, one after another."""

    context: StageContext
    stage: Swiss
    order: list[str]
    fixtures: list[Fixture] = field(default_factory=list)
    byes: list[tuple[int, str]] = field(default_factory=list)
    free_wins: Counter[str] = field(default_factory=Counter)
    """By team the wins without a match: byes, and opponents that have left."""
    matches: list[Match] = field(default_factory=list)
    drawn_rounds: int = 0

    def play(self) -> bool:
        """Draw as many rounds as can be; return whether all are over."""
        for number in range(1, self.stage.rounds + 1):
            fixtures, bye = self._draw(number)
            self.drawn_rounds = number
            if bye:
                self.byes.append((number, bye))
                self.free_wins[bye] += 1
            self.fixtures += fixtures
            self._settle_withdrawn(fixtures)
            self.matches += self.context.matches(fixtures)
            if not self.context.are_decided(fixtures):
                return False
        return True

    def matches_to_come(self) -> int:
        present = sum(not self.context.has_left(team) for team in self.order)
        return (self.stage.rounds - self.drawn_rounds) * (present // 2)

    def table(self, *, complete: bool) -> Table:
        """Return the table of what has been played."""
        points = {team: number * self.context.tournament.points.win for team, number in self.free_wins.items()}
        return table("", self.order, self.matches, self.context.rules(), complete=complete, extra_points=points)

    def _draw(self, number: int) -> tuple[list[Fixture], str]:
        present = [row for row in self.table(complete=False).rows if self.context.stays(row.team, number)]
        # Wins and losses, not points and places: rules of tables that change later leave a drawn round as it is.
        counts = sorted((row.team, row.won, row.drawn, row.lost, self.free_wins[row.team]) for row in present)
        inputs = number, counts, [fixture.id for fixture in self.fixtures]
        drawn = self.context.drawn

        def paired() -> tuple[list[tuple[str, str]], str]:
            players = [self._player(row.team, row.points) for row in present]
            return pair(players, number)

        pairs, bye = drawn.draw(self.context.name, inputs, paired)
        key = ("swiss", self.context.name, number, tuple(map(tuple, pairs)))
        if key not in self.context.cache:
            path, title = f"round{number}", f"Round {number}"
            self.context.cache[key] = [
                self.context.match(path, self.stage, (one, other), number, title) for one, other in pairs
            ]
        return self.context.cache[key], bye

    def _player(self, team: str, points: float) -> Player:
        pairs = [[side.teams[0] for side in fixture.sides] for fixture in self.fixtures]
        after = {second for first, second in pairs if first == team}
        before = {first for first, second in pairs if second == team}
        balance = sum((first == team) - (second == team) for first, second in pairs)
        return Player(team, points, balance, after | before, any(name == team for _, name in self.byes))

    def _settle_withdrawn(self, fixtures: Sequence[Fixture]) -> None:
        """Decide the open matches of teams that have left; if they do not count, the opponent has a bye."""
        for fixture in fixtures:
            left = self.context.left_first(fixture)
            was_played = not self.context.is_unplayed(fixture)
            self.context.lose_if_left(fixture)
            if left is not None and not was_played and not isinstance(self.context.tournament.withdrawn, LostBy):
                self.free_wins[fixture.sides[1 - left].teams[0]] += 1
