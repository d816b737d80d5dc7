"""How many teams and matches each stage will have, before anything is played."""

from __future__ import annotations

from collections.abc import Mapping

from rcj_challenges.tournament.formats.stage import Intake, StageSize
from rcj_challenges.tournament.models import FromModel, place_range
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import Team
from rcj_challenges.tournament.tournament_file import Tournament


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
        sizes[name] = stage.size(Intake(count, present, names, scenarios))
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
