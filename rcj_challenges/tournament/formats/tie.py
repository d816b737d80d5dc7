"""One pairing of which one team must win: legs, best of several, extra time, a tie scenario, a lot."""

from __future__ import annotations

from dataclasses import dataclass, field

from rcj_challenges.tournament.formats.context import StageContext
from rcj_challenges.tournament.models import MatchesModel
from rcj_challenges.tournament.scenarios import ScenarioUse
from rcj_challenges.tournament.season import Fixture, FixtureKind, Outcome, Ruled


@dataclass
class TieResult:
    """The state of a tie (`season.Tie`) with its known fixtures, in playing order.

    Its scores are the sum of the legs, with extra time; or matches won.
    """

    fixtures: list[Fixture] = field(default_factory=list)
    scores: tuple[float, float] | None = None
    winner: str = ""
    decided_by: str = ""


@dataclass
class TieGame:
    """A tie in the middle of being played.

    Attributes:
        path: within the stage.
        teams: the first one begins on the first seat.
        round_, title, group: of its fixtures.
    """

    context: StageContext
    stage: MatchesModel
    path: str
    teams: tuple[str, str]
    round_: int
    title: str
    group: str = ""

    def result(self, legs: int = 1, best_of: int = 1) -> TieResult:
        """Return the state: by so many legs, or with ``best_of`` by the majority of so many matches."""
        return self._by_forfeit(self._best_of(best_of) if best_of > 1 else self._legs(legs))

    def _legs(self, count: int) -> TieResult:
        fixtures = [self._match("leg", number, count) for number in range(1, count + 1)]
        outcomes = [found for one in fixtures if (found := self.context.outcomes.get(one.id)) is not None]
        result = TieResult(fixtures, self._total(fixtures))
        if len(outcomes) == count and result.scores is not None:
            return self._decided(result, outcomes) or self._extra_time(result, changed=count % 2 == 1)
        return result

    def _best_of(self, count: int) -> TieResult:
        needed, number, wins = count // 2 + 1, 0, [0, 0]
        result = TieResult()
        while number < count and max(wins) < needed:
            # As many as are played in any case may run at the same time.
            certain = min(needed - max(wins), count - number)
            fixtures = [self._match("match", number + more, count) for more in range(1, certain + 1)]
            result.fixtures += fixtures
            if not self.context.are_decided(fixtures):
                return TieResult(result.fixtures, self._total(result.fixtures, of_wins=True))
            wins = [int(one) for one in self._total(result.fixtures, of_wins=True) or (0, 0)]
            number += certain
        result.scores = (wins[0], wins[1])
        outcomes = [self.context.outcomes[one.id] for one in result.fixtures]
        return self._decided(result, outcomes) or self._extra_time(result, changed=False, counts_wins=True)

    def _by_forfeit(self, result: TieResult) -> TieResult:
        """Let the opponent of a team that has left advance, if the tie is not decided yet.

        One that has left itself has advanced if it was drawn for a later round before.
        """
        staying = [team for team in self.teams if self.context.stays(team, self.round_ + 1)]
        has_left = any(self.context.has_left(team) for team in self.teams)
        if result.decided_by or not has_left or any(one.id in self.context.hidden for one in result.fixtures):
            return result
        played = [one for one in result.fixtures if one.id in self.context.outcomes]
        return TieResult(played, result.scores, staying[0] if staying else "", "forfeit")

    def _match(self, word: str, number: int, count: int) -> Fixture:
        pair = self.teams if number % 2 else self.teams[::-1]
        title = f"{self.title}, {word} {number}" if count > 1 else self.title
        use = self.context.names.of_matches(self.stage)
        return self._fixture(f"{word}{number}", pair, use, title, FixtureKind.MATCH, number)

    def _fixture(
        self,
        name: str,
        teams: tuple[str, ...],
        use: ScenarioUse,
        title: str,
        kind: FixtureKind,
        leg: int,
        seed_path: str = "",
    ) -> Fixture:
        """Return a fixture of this tie, in which each of the teams has a side."""
        return self.context.fixture(
            f"{self.path}/{name}/{'-'.join(teams)}", use, [(team,) for team in teams], self.round_, title,
            kind=kind, group=self.group, tie=f"{self.context.name}/{self.path}", leg=leg, seed_path=seed_path,
        )  # fmt: skip

    def _scores(self, fixture: Fixture) -> tuple[float, float]:
        """Return the scores of a fixture in the order of the tie's teams; an annulled one is 0:0."""
        outcome = self.context.outcomes.get(fixture.id)
        if outcome is None or outcome.ruled is Ruled.ANNULLED:
            return (0, 0)
        first, second = outcome.scores
        return (first, second) if fixture.sides[0].teams[0] == self.teams[0] else (second, first)

    def _total(self, fixtures: list[Fixture], *, of_wins: bool = False) -> tuple[float, float] | None:
        scores = [self._scores(one) for one in fixtures if one.id in self.context.outcomes]
        if of_wins:
            scores = [(one > other, other > one) for one, other in scores]
        return (sum(one for one, _ in scores), sum(other for _, other in scores)) if scores else None

    def _decided(self, result: TieResult, outcomes: list[Outcome], by: str = "match") -> TieResult | None:
        """Return the result with its winner if the teams are not level; without one if both forfeit and are level."""
        if result.scores is None:
            return None
        one, other = result.scores
        ruled = {outcome.ruled for outcome in outcomes}
        if one == other and Ruled.DOUBLE_FORFEIT not in ruled:
            return None
        result.winner = "" if one == other else self.teams[other > one]
        is_forfeit = one == other or not ruled.isdisjoint((Ruled.FORFEIT, Ruled.WITHDRAWN))
        result.decided_by = "forfeit" if is_forfeit else by
        return result

    def _extra_time(self, result: TieResult, *, changed: bool, counts_wins: bool = False) -> TieResult:
        """Go on with extra time, if the file has it."""
        if self.context.tournament.drawn.extra_time is None:
            return self._tie_scenario(result)
        pair = self.teams[::-1] if changed else self.teams
        use = self.context.names.with_extra_time(self.context.names.of_matches(self.stage))
        title, leg = f"{self.title}, extra time", len(result.fixtures) + 1
        fixture = self._fixture("extra_time", pair, use, title, FixtureKind.EXTRA_TIME, leg)
        result.fixtures.append(fixture)
        outcome = self.context.outcomes.get(fixture.id)
        if outcome is None:
            return result
        one, other = self._scores(fixture)
        if counts_wins:
            one, other = one > other, other > one
        before = result.scores or (0, 0)
        result.scores = (before[0] + one, before[1] + other)
        return self._decided(result, [outcome], "extra_time") or self._tie_scenario(result)

    def _tie_scenario(self, result: TieResult) -> TieResult:
        """Go on with the tie scenario, if the file has one; then with a lot."""
        if (tie := self.context.tournament.drawn.tie_scenario) is not None:
            use = self.context.names.use(tie.scenario, tie.set)
            is_alone = len(self.context.scenarios[use].seats) == 1
            title, leg, seed_path = f"{self.title}, tie scenario", len(result.fixtures) + 1, f"{self.path}/tie_scenario"
            fixtures = [
                self._fixture("tie_scenario", teams, use, title, FixtureKind.TIE_SCENARIO, leg, seed_path)
                for teams in ([(team,) for team in self.teams] if is_alone else [self.teams])
            ]
            result.fixtures += fixtures
            if not self.context.are_decided(fixtures):
                return result
            if winner := self._better(fixtures, is_alone=is_alone):
                result.winner, result.decided_by = winner, "tie_scenario"
                return result
            if decided := self._decided(result, [self.context.outcomes[one.id] for one in fixtures]):
                return decided
        result.winner = min(self.teams, key=lambda team: self.context.lot(self.path, team))
        result.decided_by = "lot"
        return result

    def _better(self, fixtures: list[Fixture], *, is_alone: bool) -> str:
        """Return the team that was better in the tie scenario; empty if they are level."""
        if not is_alone:
            one, other = self._scores(fixtures[0])
            return "" if one == other else self.teams[other > one]
        info = self.context.scenarios[ScenarioUse(fixtures[0].scenario, fixtures[0].overrides)]
        keys = [info.sort_key(self.context.outcomes[one.id]) for one in fixtures]
        return "" if keys[0] == keys[1] else self.teams[keys[1] < keys[0]]
