"""The tournament file as a model, and what follows from it before anything is played."""

from collections.abc import Mapping

from rcj_challenges.rules.fields import Name, described
from rcj_challenges.tournament.formats import Stage
from rcj_challenges.tournament.formats.stage import Intake, StageSize
from rcj_challenges.tournament.models import ChallengeScenario, General
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import Team


class Tournament(General):
    """A tournament: its teams, its stages, and what decides."""

    stages: dict[Name, Stage] = described(
        ..., "the stages by name, in the order of playing", min_length=1, max_length=64
    )

    @property
    def challenges(self) -> dict[tuple[str, str], ChallengeScenario]:
        """The scenarios that each team plays alone, by stage and name."""
        return {(name, key): one for name, stage in self.stages.items() for key, one in stage.challenges.items()}

    def uses(self, names: ScenarioNames) -> dict[ScenarioUse, tuple[str | int, ...]]:
        """Return all scenarios that are played, each with the keys that name it."""
        found: dict[ScenarioUse, tuple[str | int, ...]] = {}
        for name, stage in self.stages.items():
            for use, keys in stage.uses(names):
                found.setdefault(use, ("stages", name, *keys) if keys else ("scenario",))
                if stage.has_ties and self.drawn.extra_time is not None:
                    found.setdefault(names.with_extra_time(use), ("drawn", "extra_time"))
            if stage.has_ties and (tie := self.drawn.tie_scenario) is not None:
                found.setdefault(names.use(tie.scenario, tie.set), ("drawn", "tie_scenario", "scenario"))
        return found

    def sizes(
        self, teams: Mapping[str, Team], scenarios: Mapping[ScenarioUse, ScenarioInfo], names: ScenarioNames
    ) -> dict[str, StageSize]:
        """Return the sizes of all stages, by name; ``scenarios`` has nothing of those that cannot be loaded."""
        sizes: dict[str, StageSize] = {}
        for name, stage in self.stages.items():
            source = sizes.get(stage.from_ or "")
            present = [team for team, one in teams.items() if not one.withdrawn or name in one.last_rounds]
            count = len(present) if source is None else sum(len(stage.taken(size)) for size in source.tables.values())
            sizes[name] = stage.size(Intake(count, present, names, scenarios))
        return sizes

    def cuts(self, name: str, sizes: Mapping[str, StageSize]) -> frozenset[int]:
        """Return the places after which the teams of a stage are divided among later ones: of places 1-2 it is 2."""
        largest = max(sizes[name].tables.values(), default=0)
        takers = (stage for stage in self.stages.values() if stage.from_ == name and stage.places is not None)
        found = {cut for taken in (one.taken(largest) for one in takers) for cut in (taken.start - 1, taken.stop - 1)}
        return frozenset(cut for cut in found if 0 < cut < largest)
