"""Super teams: each robot of a side is driven by the program of another team."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.tournament.codes import LISTED_TEAMS, TOO_FEW_TEAMS
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.groups import all_meet, pairings
from rcj_challenges.tournament.formats.stage import Intake, MatchFormat, StageSize, listed_problems
from rcj_challenges.tournament.models import TeamId
from rcj_challenges.tournament.scenarios import ScenarioInfo
from rcj_challenges.tournament.season import Fixture, StageState, humanized
from rcj_challenges.tournament.seeds import shuffled
from rcj_challenges.tournament.standings import table


class SuperTeam(MatchFormat):
    """Each robot of a side is driven by the program of another team; all super teams meet each other."""

    stage: Literal["super_team"]
    super_teams: dict[Name, Annotated[tuple[TeamId, ...], Field(min_length=1)]] | None = described(
        None, "the teams of each super team, in the order of the side's robots; if omitted: drawn"
    )
    legs: int = described(1, "how often two super teams meet; 2: with the sides changed", ge=1, le=2)

    RANKS_TEAMS: ClassVar[bool] = False

    def size(self, intake: Intake) -> StageSize:
        """Return the size of the stage; of a scenario that cannot be loaded with sides of three robots."""
        info = intake.info(self)
        side = max(1, min(info.seats.values())) if info is not None else 3
        tables = {"": len(self.super_teams) if self.super_teams is not None else -(-intake.teams // side)}
        return StageSize(intake.teams, tables, *all_meet(tables, self.legs))

    def scenario_problems(self, info: ScenarioInfo) -> Iterator[tuple[str, str]]:
        if len(set(info.seats.values())) > 1:
            message = f"the sides of scenario '{info.id}' have different numbers of robots"
            yield message, "super teams need sides of the same size"

    def problems(self, intake: Intake, size: StageSize) -> Iterator[Diagnostic]:
        info = intake.info(self)
        if info is None:
            return
        side = min(info.seats.values(), default=1)
        if self.super_teams is None:
            if size.teams <= side:
                message = f"{size.teams} teams are too few for two super teams of {side}"
                yield issue(TOO_FEW_TEAMS, (), message, "add teams, or remove the stage")
            return
        yield from listed_problems("super_teams", self.super_teams, intake.present)
        if len(self.super_teams) < 2:
            message = "one super team has no opponent"
            yield issue(TOO_FEW_TEAMS, ("super_teams",), message, "list at least two")
        for name, listed in self.super_teams.items():
            if len(listed) != side:
                message = f"super team '{name}' has {len(listed)} teams, a side of '{info.id}' has {side} robots"
                yield issue(LISTED_TEAMS, ("super_teams", name), message, "list one team for each robot")

    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        """Return the state of a stage of super teams. A team that leaves in the middle still lends its program."""
        teams = tuple(entrant.team for entrant in entrants)
        robots = min(context.scenarios[context.names.of_matches(self)].seats.values())
        sides = self.super_teams or context.draw(
            self, teams, lambda: drawn(teams, robots, context.tournament.seed, context.name)
        )
        fixtures = _fixtures(context, self, sides)
        is_complete = context.are_decided(fixtures)
        joined = ["+".join(own) for own in sides.values()]
        found = table("", joined, context.matches(fixtures), context.rules(), complete=is_complete)
        return context.state(
            self,
            teams,
            is_finished=is_complete,
            fixtures=tuple(fixtures),
            expected_matches=len(fixtures),
            tables=(found,),
            places=found.rows if is_complete else (),
        )


def drawn(teams: Sequence[str], size: int, seed: int | str, use: str) -> dict[str, tuple[str, ...]]:
    """Return super teams of a size by name; the last one is filled up with teams that play in two."""
    order = shuffled(seed, f"{use}/super_teams", teams)
    missing = -len(order) % size
    order += order[:missing]
    return {f"super{i // size + 1}": tuple(order[i : i + size]) for i in range(0, len(order), size)}


def _fixtures(context: StageContext, stage: SuperTeam, sides: Mapping[str, Sequence[str]]) -> list[Fixture]:
    names = list(sides)
    return [
        context.match(
            f"round{number}",
            stage,
            (names[one], names[other]),
            number,
            f"{humanized(names[one])} and {humanized(names[other])}, round {number}",
            sides=(tuple(sides[names[one]]), tuple(sides[names[other]])),
        )
        for number, pairs in enumerate(pairings(len(names), stage.legs), 1)
        for one, other in pairs
    ]
