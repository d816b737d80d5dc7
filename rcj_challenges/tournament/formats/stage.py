"""What every format has: its keys, and the methods that engine, sizes, checks, drawing again and site call.

A format is one class in a file of its own, and one line in the list of ``formats/__init__.py``.
"""

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.fields import described
from rcj_challenges.scenario.errors import did_you_mean, listing
from rcj_challenges.scenario.tree import Step
from rcj_challenges.tournament.codes import LISTED_TEAMS, UNKNOWN_TEAM
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.models import ChallengeScenario, FromModel, MatchesModel
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import StageState, Status


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


@dataclass(frozen=True, slots=True)
class Intake:
    """The teams that come into a stage, before anything is played.

    Attributes:
        teams: their number.
        present: ids of all teams of the tournament that could take part.
        scenarios: those that can be loaded.
    """

    teams: int
    present: Collection[str]
    names: ScenarioNames = field(repr=False)
    scenarios: Mapping[ScenarioUse, ScenarioInfo] = field(repr=False)

    def info(self, stage: MatchesModel) -> ScenarioInfo | None:
        """Return the scenario of a stage's matches; None if it cannot be loaded."""
        return self.scenarios.get(self.names.of_matches(stage))


class Format(FromModel, ABC):
    """A format: how the teams of a stage play."""

    MIN_TEAMS: ClassVar[int] = 2
    SEATS: ClassVar[int] = 2
    """Of each scenario that is played."""
    RANKS_TEAMS: ClassVar[bool] = True
    """Whether another stage can take its teams from this one."""
    FOLLOWS_PAIRS: ClassVar[bool] = False
    """Whether a result counts for the new match of its pair when all is drawn again."""
    CAN_PLAY_OFF: ClassVar[bool] = False

    @property
    def challenges(self) -> Mapping[str, ChallengeScenario]:
        """The scenarios that each team plays alone, by name."""
        return {}

    @property
    def has_ties(self) -> bool:
        """Whether there may be pairings of which one team must win."""
        return False

    @property
    def matches_of_tie(self) -> tuple[int, int]:
        """The least and the most matches of a tie, without extra time."""
        return 1, 1

    @abstractmethod
    def uses(self, names: ScenarioNames) -> Iterator[tuple[ScenarioUse, tuple[Step, ...]]]:
        """Yield the scenarios, each with the keys within the stage that name it."""

    @abstractmethod
    def size(self, intake: Intake) -> StageSize:
        """Return the size of the stage."""

    def problems(self, intake: Intake, size: StageSize) -> Iterator[Diagnostic]:
        """Yield the problems of the keys for these teams."""
        yield from ()

    def scenario_problems(self, info: ScenarioInfo) -> Iterator[tuple[str, str]]:
        """Yield problems of a scenario with the right number of seats, and help."""
        yield from ()

    def shared_cuts(self, cuts: frozenset[int], teams: int) -> frozenset[int]:
        """Return those of the places after which teams are divided that may be shared, without a lot."""
        return cuts

    @abstractmethod
    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        """Return the state after the outcomes so far."""

    def waiting(self, context: StageContext, entrants: Sequence[Entrant], matches: int) -> StageState:
        """Return the state while the teams are not known, only their sources and the number of matches."""
        return StageState(context.name, context.kind, context.title(self), Status.WAITING, expected_matches=matches)

    def keep_seats(self, draw: Any, before: Collection[tuple[str, str]]) -> None:
        """Give pairs that have met the seats that they had, in a new draw."""

    def add_late(self, draw: Any, team: str, present: Collection[str]) -> bool:
        """Add a team to the draw of a stage that has begun, for matches with the teams that are present.

        Return whether it can be added.
        """
        return False


class MatchFormat(MatchesModel, Format):
    """A format in which teams play matches."""

    def uses(self, names: ScenarioNames) -> Iterator[tuple[ScenarioUse, tuple[Step, ...]]]:
        yield names.of_matches(self), ("scenario",) if self.scenario is not None else ("set",) if self.set else ()


class LeagueFormat(MatchFormat):
    """A format with a table of matches, and play-offs if they are needed."""

    play_off: bool = described(
        False, "whether teams that share a place play each other if only some of them can advance; after that, a lot"
    )

    CAN_PLAY_OFF: ClassVar[bool] = True

    @property
    def has_ties(self) -> bool:
        return self.play_off

    def shared_cuts(self, cuts: frozenset[int], teams: int) -> frozenset[int]:
        return frozenset() if self.play_off else cuts


def listed_problems(key: str, lists: Mapping[str, tuple[str, ...]], teams: Collection[str]) -> Iterator[Diagnostic]:
    """Yield unknown teams in the lists behind a key, and those that are listed twice."""
    seen: Counter[str] = Counter()
    for name, listed in lists.items():
        for index, team in enumerate(listed):
            seen[team] += 1
            path = (key, name, index)
            if team not in teams:
                help_ = did_you_mean(team, teams, f"Teams: {listing(teams)}")
                yield issue(UNKNOWN_TEAM, path, f"no team '{team}'", help_)
            elif seen[team] > 1:
                yield issue(LISTED_TEAMS, path, f"team '{team}' is listed twice", "keep it once")
