"""The tournament file as a model."""

from pathlib import Path

from rcj_challenges.rules.fields import Name, described
from rcj_challenges.tournament.formats import Stage
from rcj_challenges.tournament.models import ChallengeScenario, General
from rcj_challenges.tournament.scenarios import ScenarioNames, ScenarioUse


class Tournament(General):
    """A tournament: its teams, its stages, and what decides."""

    stages: dict[Name, Stage] = described(
        ..., "the stages by name, in the order of playing", min_length=1, max_length=64
    )

    @property
    def challenges(self) -> dict[tuple[str, str], ChallengeScenario]:
        """The scenarios that each team plays alone, by stage and name."""
        return {(name, key): one for name, stage in self.stages.items() for key, one in stage.challenges.items()}


def scenario_uses(tournament: Tournament, folder: Path) -> dict[ScenarioUse, tuple[str | int, ...]]:
    """Return all scenarios that a tournament plays, each with where the file names it.

    Args:
        tournament: the file.
        folder: where it lies.
    """
    names = ScenarioNames(tournament, folder)
    found: dict[ScenarioUse, tuple[str | int, ...]] = {}
    for name, stage in tournament.stages.items():
        for use, keys in stage.uses(names):
            found.setdefault(use, ("stages", name, *keys) if keys else ("scenario",))
            if stage.has_ties and tournament.drawn.extra_time is not None:
                found.setdefault(names.with_extra_time(use), ("drawn", "extra_time"))
        if stage.has_ties and (tie := tournament.drawn.tie_scenario) is not None:
            found.setdefault(names.use(tie.scenario, tie.set), ("drawn", "tie_scenario", "scenario"))
    return found
