"""Super teams: each robot of a side is driven by the program of another team."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rcj_challenges.tournament.formats.circle import pairings
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.models import SuperTeam
from rcj_challenges.tournament.season import Fixture, StageState, Status, humanized
from rcj_challenges.tournament.seeds import shuffled
from rcj_challenges.tournament.standings import table


def super_team(context: StageContext, stage: SuperTeam, entrants: Sequence[Entrant]) -> StageState:
    """Return the state of a stage of super teams. A team that leaves in the middle still lends its program."""
    teams = tuple(entrant.team for entrant in entrants)
    robots = min(context.scenarios[context.names.of_matches(stage)].seats.values())
    sides = stage.super_teams or context.drawn.draw(
        context.name,
        teams if stage.from_ else None,
        lambda: drawn(teams, robots, context.tournament.seed, context.name),
    )
    fixtures = _fixtures(context, stage, sides)
    matches = [match for one in fixtures if (match := context.result(one)) is not None]
    is_complete = context.are_decided(fixtures)
    joined = ["+".join(own) for own in sides.values()]
    found = table("", joined, matches, context.rules(), complete=is_complete)
    return StageState(
        name=context.name,
        kind=stage.stage,
        title=context.title(stage),
        status=Status.FINISHED if is_complete else Status.RUNNING,
        teams=teams,
        fixtures=tuple(fixtures),
        expected_matches=len(fixtures),
        tables=(found,),
        places=found.rows if is_complete else (),
    )


def drawn(teams: Sequence[str], size: int, seed: int | str, use: str) -> dict[str, tuple[str, ...]]:
    """Return super teams by name; the last one is filled up with teams that play in two.

    Args:
        teams: ids.
        size: teams of a super team.
        seed: the tournament's.
        use: name of the draw.
    """
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
