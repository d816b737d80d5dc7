"""How many teams and matches each stage will have, before anything is played."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rcj_challenges.tournament.formats import knock_out
from rcj_challenges.tournament.formats.groups import group_names, groups_of
from rcj_challenges.tournament.models import (
    Challenge,
    FromModel,
    KnockOut,
    RoundRobin,
    Stage,
    Swiss,
    Tournament,
    place_range,
)
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import Team


@dataclass(frozen=True, slots=True)
class StageSize:
    """The size of a stage.

    Attributes:
        teams: that take part.
        tables: number of teams by table from which places are taken; of a stage without groups the name is empty.
        matches: drawn ones not counted twice; of a best-of those played in any case.
        rounds: of fixtures that can be released one after another.
    """

    teams: int
    tables: Mapping[str, int]
    matches: int
    rounds: int


def stage_sizes(
    tournament: Tournament,
    teams: Mapping[str, Team],
    scenarios: Mapping[ScenarioUse, ScenarioInfo],
    names: ScenarioNames,
) -> dict[str, StageSize]:
    """Return the sizes of all stages, by name.

    Args:
        tournament: the file.
        teams: all that take part.
        scenarios: what is known of them; of those that cannot be loaded nothing.
        names: finds them.
    """
    sizes: dict[str, StageSize] = {}
    for name, stage in tournament.stages.items():
        source = sizes.get(stage.from_ or "")
        present = [team for team, one in teams.items() if not one.withdrawn or name in one.last_rounds]
        count = len(present) if source is None else taken_places(stage, source)
        if isinstance(stage, RoundRobin) and source is None:
            pots = {team: teams[team].pot for team in present}
            groups = groups_of(stage, pots, tournament.seed, f"{name}/groups")
            tables = {group: len(own) for group, own in groups.items()}
        elif isinstance(stage, RoundRobin):
            tables = _even_groups(stage, count)
        else:
            tables = {"": count}
        if not isinstance(stage, Challenge | RoundRobin | Swiss | KnockOut):
            info = scenarios.get(names.of_matches(stage))
            side = max(1, min(info.seats.values())) if info is not None else 3
            tables = {"": len(stage.super_teams) if stage.super_teams is not None else -(-count // side)}
        sizes[name] = StageSize(count, tables, _matches(stage, count, tables), _rounds(stage, count, tables))
    return sizes


def taken_places(stage: FromModel, source: StageSize) -> int:
    """Return how many teams a stage takes from another one."""
    count = 0
    for size in source.tables.values():
        first, last = place_range(stage.places, size)
        count += max(0, min(last, size) - first + 1)
    return count


def cuts(tournament: Tournament, name: str, sizes: Mapping[str, StageSize]) -> frozenset[int]:
    """Return the places after which the teams of a stage are divided among later stages: of places 1-2 it is 2."""
    largest = max(sizes[name].tables.values(), default=0)
    found = set()
    for stage in tournament.stages.values():
        if stage.from_ == name and stage.places is not None:
            first, last = place_range(stage.places, largest)
            found |= {first - 1, last}
    return frozenset(cut for cut in found if 0 < cut < largest)


def _even_groups(stage: RoundRobin, count: int) -> dict[str, int]:
    if isinstance(stage.groups, dict):
        return {name: len(own) for name, own in stage.groups.items()}
    if stage.groups == 1:
        return {"": count}
    least, more = divmod(count, stage.groups)
    return {name: least + (index < more) for index, name in enumerate(group_names(stage.groups))}


def _matches(stage: Stage, count: int, tables: Mapping[str, int]) -> int:
    if isinstance(stage, Swiss):
        return stage.rounds * (count // 2)
    if isinstance(stage, KnockOut):
        return knock_out.match_count(count, stage)
    if isinstance(stage, Challenge):
        return count * len(stage.scenarios) * stage.seeds
    return sum(size * (size - 1) // 2 * stage.legs for size in tables.values())


def _rounds(stage: Stage, count: int, tables: Mapping[str, int]) -> int:
    if isinstance(stage, Swiss):
        return stage.rounds
    if isinstance(stage, KnockOut):
        return knock_out.round_count(count)
    if isinstance(stage, Challenge):
        return len(stage.scenarios)
    largest = max(tables.values(), default=0)
    return (largest - 1 + largest % 2) * stage.legs if largest > 1 else 0
