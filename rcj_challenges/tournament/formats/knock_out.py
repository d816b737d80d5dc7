"""Knock-out: a bracket, whose loser is out in each tie."""

from collections.abc import Iterator
from typing import Literal

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.fields import described
from rcj_challenges.tournament.codes import TOO_FEW_TEAMS
from rcj_challenges.tournament.formats.bracket import Bracket, BracketFormat, first_round, loser, round_count, winner
from rcj_challenges.tournament.formats.stage import Intake, StageSize

_NAMES = {1: "final", 2: "semi_finals", 4: "quarter_finals"}


class KnockOut(BracketFormat):
    """The loser of each tie is out. If the number of teams is not a power of two, the best seeds have a bye."""

    stage: Literal["knock_out"]
    third_place: bool = described(False, "whether the losers of the semi-finals play for third place")

    def size(self, intake: Intake) -> StageSize:
        """Return the size of the stage; of a best-of the matches that are played in any case."""
        ties = max(0, intake.teams - 1) + (self.third_place and intake.teams >= 4)
        matches = ties * self.matches_of_tie[0]
        return StageSize(intake.teams, {"": intake.teams}, matches, round_count(intake.teams))

    def problems(self, intake: Intake, size: StageSize) -> Iterator[Diagnostic]:
        yield from super().problems(intake, size)
        if self.third_place and size.teams < 4:
            message = f"of {size.teams} teams no two lose a semi-final"
            yield issue(TOO_FEW_TEAMS, ("third_place",), message, "remove 'third_place'")

    def shared_cuts(self, cuts: frozenset[int], teams: int) -> frozenset[int]:
        decided = {1, 2, 3} if self.third_place and teams >= 4 else {1, 2}
        return cuts - decided - {1 << power for power in range(16)}

    def play(self, bracket: Bracket) -> None:
        entries = first_round(bracket.entrants)
        for round_ in range(1, round_count(len(bracket.entrants)) + 1):
            if len(entries) == 2 and self.third_place and len(bracket.entrants) >= 4:
                one, two = bracket.ties[-2:]
                bracket.tie("third_place", 1, (loser(one), loser(two)), round_)
            count = len(entries) // 2
            ties = bracket.ties_of(_NAMES.get(count, f"round_of_{2 * count}"), entries, round_)
            entries = [winner(tie) for tie in ties]

    def levels(self, bracket: Bracket) -> list[list[str]]:
        by_round = dict.fromkeys(tie.round for tie in reversed(bracket.ties))
        found = []
        for tie in reversed([tie for tie in bracket.ties if tie.round in ("final", "third_place")]):
            found += [[tie.winner], [loser(tie)[0]]]
        settled = {"final", "third_place", "semi_finals"} if "third_place" in by_round else {"final"}
        return found + [bracket.losers(name) for name in by_round if name not in settled]
