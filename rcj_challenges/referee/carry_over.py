"""State carried over from half to half of a match, whether it is played or judged again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.referee.ranking import HalfValues, ranking
from rcj_challenges.scenario.halves import by_team
from rcj_challenges.scenario.models.scenario import Scenario

if TYPE_CHECKING:  # it is loaded while programs start
    from rcj_challenges.referee.engine import Referee


class CarryOver:
    """Points by team, the values kept for the next half (`HalfInfo.kept`), and the totals so far."""

    def __init__(self, scenario: Scenario) -> None:
        self.scores: dict[str, Score] = dict.fromkeys(scenario.entrants, 0)
        self.kept: dict[str, Any] = {}
        self._scenario = scenario
        self._halves: list[HalfValues] = []

    def add(self, half: HalfInfo, referee: Referee) -> None:
        """Add a half that is over; ``half`` has what it began with, without what a test has given."""
        self.scores = by_team(referee.scores, half.teams)
        self.kept = dict(referee.kept)
        self._halves.append(referee.ranked(half))

    def ranking(self) -> list[dict[str, Any]]:
        """Return the ranking after the halves so far, as in ``result.json``."""
        return ranking(self._scenario.result.rank, list(self.scores), self._halves)
