"""How much of a tournament is left to play."""

from __future__ import annotations

from dataclasses import dataclass

from rcj_challenges.tournament.load import LoadedTournament
from rcj_challenges.tournament.scenarios import ScenarioNames
from rcj_challenges.tournament.season import SeasonState, StageState


@dataclass(frozen=True, slots=True)
class StageLeft:
    """What is left of a stage.

    Attributes:
        stage: its name.
        matches: that have no outcome yet.
        more: that may be added: extra time, tie scenarios, the last matches of a best-of.
        mean_s: simulated time of a match, in s.
    """

    stage: str
    matches: int
    more: int
    mean_s: float


def work_left(loaded: LoadedTournament, state: SeasonState) -> list[StageLeft]:
    """Return what is left of each stage."""
    infos = {(use.source, use.overrides): info.duration_s for use, info in loaded.scenarios.items()}
    found = []
    for stage in state.stages:
        known = [infos[one.scenario, one.overrides] for one in stage.fixtures] or list(infos.values())
        left = max(0, stage.expected_matches - sum(one.id in state.outcomes for one in stage.fixtures))
        found.append(StageLeft(stage.name, left, _more(loaded, stage), sum(known) / len(known)))
    return found


def _more(loaded: LoadedTournament, stage: StageState) -> int:
    model, drawn = loaded.tournament.stages[stage.name], loaded.tournament.drawn
    least, most = model.matches_of_tie
    most += drawn.extra_time is not None
    if drawn.tie_scenario is not None:
        use = ScenarioNames(loaded.tournament, loaded.path.parent).use(
            drawn.tie_scenario.scenario, drawn.tie_scenario.set
        )
        most += 2 if len(loaded.scenarios[use].seats) == 1 else 1  # each team by itself, or both together
    ties = [tie for tie in stage.ties if not tie.winner and "bye" not in tie.sources]
    return sum(max(0, most - max(least, len(tie.fixtures))) for tie in ties)
