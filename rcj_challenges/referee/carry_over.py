"""State carried over from half to half of a match, whether it is played or judged again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.referee.ranking import Tally, ranking
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
        self._tallies: list[Tally] = []

    def add(self, half: HalfInfo, referee: Referee, ticks: int) -> None:
        """Add a half that is over; so many ticks of it were judged."""
        self.scores = by_team(referee.scores, half.teams)
        self.kept = dict(referee.kept)
        began = half.kept.get("counters", {})
        self._tallies.append(Tally(dict(referee.counters), half.teams, s_from_ticks(ticks), began))

    def ranking(self) -> list[dict[str, Any]]:
        """Return the ranking after the halves so far, as in ``result.json``."""
        return ranking(self._scenario, self.scores, self._tallies)
