"""Shared by the kinds of stages: entrants, fixtures, and the outcomes that count."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from rcj_challenges.tournament.drawing import Drawn
from rcj_challenges.tournament.entries import TeamEntry
from rcj_challenges.tournament.models import FromModel, General, LostBy, MatchesModel, StageModel
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import (
    Fixture,
    FixtureKind,
    Outcome,
    Ruled,
    Side,
    StageState,
    Status,
    Team,
    humanized,
)
from rcj_challenges.tournament.seeds import derived_seed, lot
from rcj_challenges.tournament.standings import Match, TableRules


@dataclass(frozen=True, slots=True)
class Entrant:
    """A team that has come into a stage.

    Attributes:
        team: id; empty if it is not known yet.
        pot: for the draw, 0 for none; of one that comes from another stage its place there.
        place: in the table that it comes from, from 1; 0: it comes from none.
        group: that table's name.
        origin: for people: ``A1``; empty if it comes from no stage.
    """

    team: str
    pot: int = 0
    place: int = 0
    group: str = ""
    origin: str = ""


@dataclass
class StageContext:
    """One stage in the middle of being computed.

    Attributes:
        teams, entries: all of the tournament, by id.
        drawn: the draws so far; new ones are added.
        outcomes: by fixture; those of withdrawals are added.
        hidden: fixtures that were played but whose outcomes are left out: withdrawals do not decide them.
        cuts: the last places of each table that others are kept apart from: between place 2 and 3 stands 2.
        cache: of what does not depend on outcomes, kept from one state to the next.
    """

    name: str
    kind: str
    tournament: General
    names: ScenarioNames
    scenarios: Mapping[ScenarioUse, ScenarioInfo]
    teams: Mapping[str, Team]
    entries: Mapping[str, TeamEntry]
    drawn: Drawn
    outcomes: dict[str, Outcome]
    hidden: Collection[str] = ()
    cuts: frozenset[int] = frozenset()
    cache: dict[Any, Any] = field(default_factory=dict)

    def title(self, stage: StageModel) -> str:
        """Return the title for people."""
        return stage.title or humanized(self.name)

    def state(self, stage: StageModel, teams: Sequence[str], *, is_finished: bool, **fields: Any) -> StageState:
        """Return the state of the stage, whose teams are known."""
        status = Status.FINISHED if is_finished else Status.RUNNING
        return StageState(self.name, self.kind, self.title(stage), status, tuple(teams), **fields)

    def draw(self, stage: FromModel, teams: Sequence[str], make: Callable[[], Any]) -> Any:
        """Return the draw of the stage, whose teams may come from another one, drawing it now if it was not."""
        return self.drawn.draw(self.name, teams if stage.from_ else None, make)

    def rules(self, use: str = "", *, with_lot: bool = False) -> TableRules:
        """Return the rules of a table with its lots, which ``with_lot`` draws even if the file does not list them."""
        points, words = self.tournament.points, self.tournament.tie_breaks
        if with_lot and "lot" not in words:
            words = (*words, "lot")
        return TableRules(points.win, points.draw, points.loss, words, lambda team: self.lot(use, team))

    def lot(self, use: str, team: str) -> bytes:
        """Return a team's lot in this stage; the smallest wins."""
        return lot(self.tournament.seed, f"{self.name}/{use}/lot", team)

    def stays(self, team: str, round_: int = 1) -> bool:
        """Return whether a team takes part in a round: it has not left before that round was drawn."""
        one = self.teams[team]
        return not one.withdrawn or one.last_rounds.get(self.name, -1) >= round_

    def has_left(self, team: str) -> bool:
        """Return whether a team has left the tournament."""
        return team in self.teams and self.teams[team].withdrawn

    def match(
        self,
        path: str,
        stage: MatchesModel,
        teams: tuple[str, str],
        round_: int,
        title: str,
        group: str = "",
        *,
        sides: tuple[tuple[str, ...], tuple[str, ...]] | None = None,
    ) -> Fixture:
        """Return the fixture of a match.

        Args:
            path: within the stage: ``A/round1``.
            stage: the model.
            teams: the one that begins on the scenario's first seat, and the other.
            round_: from 1.
            title: for people.
            group: left out: none.
            sides: the teams of each side; left out: one each.
        """
        use = self.names.of_matches(stage)
        return self.fixture(
            f"{path}/{teams[0]}-{teams[1]}", use, sides or ((teams[0],), (teams[1],)), round_, title, group=group
        )

    def fixture(
        self,
        path: str,
        use: ScenarioUse,
        sides: Sequence[tuple[str, ...]],
        round_: int,
        title: str,
        *,
        kind: FixtureKind = FixtureKind.MATCH,
        group: str = "",
        tie: str = "",
        leg: int = 1,
        seed_path: str = "",
    ) -> Fixture:
        """Return a fixture of this stage; its sides take the scenario's seats in order."""
        seats = self.scenarios[use].seats
        name = f"{self.name}/{path}"
        return Fixture(
            id=name,
            stage=self.name,
            group=group,
            round=round_,
            sides=tuple([Side(seat, teams) for seat, teams in zip(seats, sides, strict=True)]),
            scenario=use.source,
            overrides=use.overrides,
            seed=derived_seed(
                self.drawn.match_seed, f"{self.name}/{seed_path}" if seed_path else self.drawn.moved.get(name, name)
            ),
            kind=kind,
            tie=tie,
            leg=leg,
            title=title,
        )

    def matches(self, fixtures: Iterable[Fixture]) -> list[Match]:
        """Return the matches that count of fixtures: those with an outcome that was not annulled."""
        found = []
        for fixture in fixtures:
            outcome = self.outcomes.get(fixture.id)
            if outcome is not None and outcome.ruled is not Ruled.ANNULLED:
                first, second = ("+".join(side.teams) for side in fixture.sides)
                is_lost_by_both = outcome.ruled is Ruled.DOUBLE_FORFEIT
                found.append(Match((first, second), (outcome.scores[0], outcome.scores[1]), is_lost_by_both))
        return found

    def is_unplayed(self, fixture: Fixture) -> bool:
        """Return whether a fixture has no outcome, not even a hidden one."""
        return fixture.id not in self.outcomes and fixture.id not in self.hidden

    def annul(self, fixture: Fixture) -> None:
        """Let a fixture not count, because a team has left."""
        if fixture.id in self.hidden:
            return
        played = self.outcomes.get(fixture.id)
        scores = played.scores if played is not None else (0.0,) * len(fixture.sides)
        self.outcomes[fixture.id] = Outcome(scores, Ruled.ANNULLED, "withdrawn")

    def left_first(self, fixture: Fixture) -> int | None:
        """Return the side of a match whose team has left, of two the one that left first; None if both are there."""
        teams = [self.teams[side.teams[0]] for side in fixture.sides]
        left = [(team.left_after, at) for at, team in enumerate(teams) if team.withdrawn]
        return min(left)[1] if left else None

    def lose_if_left(self, fixture: Fixture) -> None:
        """Let a team that has left lose a match that it has not played, if the file says so; else annul it."""
        left = self.left_first(fixture)
        if left is None or not self.is_unplayed(fixture):
            return
        rule = self.tournament.withdrawn
        if not isinstance(rule, LostBy):
            self.annul(fixture)
            return
        scores = rule.lost[::-1] if left else rule.lost
        self.outcomes[fixture.id] = Outcome(tuple(map(float, scores)), Ruled.WITHDRAWN, "withdrawn")

    def are_decided(self, fixtures: Sequence[Fixture]) -> bool:
        """Return whether all of them have an outcome."""
        return all(fixture.id in self.outcomes for fixture in fixtures)
