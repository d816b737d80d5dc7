"""The scenarios that a tournament plays, their settings, and the facts that it needs of them."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from pathlib import Path

from rcj_challenges.rules.fields import Scalar
from rcj_challenges.rules.ranked import Ranked
from rcj_challenges.scenario.resources import shipped_scenarios
from rcj_challenges.tournament.models import General, MatchesModel
from rcj_challenges.tournament.season import Outcome, Ruled


@dataclass(frozen=True, slots=True)
class ScenarioUse:
    """A scenario with settings.

    Attributes:
        source: name of a shipped scenario, or a path.
        overrides: ``PATH=VALUE`` each.
    """

    source: str
    overrides: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ScenarioInfo:
    """The facts of a scenario that a tournament needs.

    Attributes:
        seats: number of robots by seat, in the scenario's order.
        rank: the values by which it ranks, the first one first.
        duration_s: simulated time of all halves.
    """

    id: str
    title: str
    seats: Mapping[str, int]
    rank: tuple[Ranked, ...]
    duration_s: float

    def sort_key(self, outcome: Outcome) -> tuple[float, ...]:
        """Return a key for the run of one team alone, the smallest for the best; without a run it is the worst."""
        if outcome.ruled in (Ruled.ANNULLED, Ruled.FORFEIT):
            return (inf,)
        values = outcome.values or outcome.scores
        return tuple(rank.number(value) for value, rank in zip(values, self.rank, strict=False))


class ScenarioNames:
    """Finds the scenarios that a tournament file names."""

    def __init__(self, tournament: General, folder: Path) -> None:
        self._tournament = tournament
        self._folder = folder
        self._shipped = shipped_scenarios()
        self._found: dict[str, str] = {}
        self._of_matches: dict[int, ScenarioUse] = {}  # asked for once for each fixture

    def of_matches(self, stage: MatchesModel) -> ScenarioUse:
        """Return the scenario of a stage of matches."""
        found = self._of_matches.get(id(stage))
        if found is None:
            if stage.scenario is not None:
                found = self.use(stage.scenario, stage.set)
            else:
                found = self.use(self._tournament.scenario, {**self._tournament.set, **stage.set})
            self._of_matches[id(stage)] = found
        return found

    def with_extra_time(self, played: ScenarioUse) -> ScenarioUse:
        """Return the scenario of a match's extra time."""
        return ScenarioUse(played.source, (*played.overrides, *_overrides(self._tournament.drawn.extra_time or {})))

    def use(self, source: str, settings: Mapping[str, Scalar]) -> ScenarioUse:
        """Return a scenario with settings as the rest of the package takes them."""
        found = self._found.get(source)
        if found is None:
            file = self._folder / source
            is_shipped = source in self._shipped and not os.path.isfile(file)  # noqa: PTH113 - pathlib's raises
            found = self._found[source] = source if is_shipped else str(file)
        return ScenarioUse(found, _overrides(settings))


def _overrides(settings: Mapping[str, Scalar]) -> tuple[str, ...]:
    return tuple(f"{path}={json.dumps(value, ensure_ascii=False)}" for path, value in settings.items())
