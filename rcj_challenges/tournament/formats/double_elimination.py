"""Double elimination: a team is out when it has lost twice."""

from typing import ClassVar, Literal

from rcj_challenges.rules.fields import described
from rcj_challenges.tournament.formats.bracket import (
    Bracket,
    BracketFormat,
    Entry,
    first_round,
    loser,
    round_count,
    winner,
)
from rcj_challenges.tournament.formats.stage import Intake, StageSize
from rcj_challenges.tournament.season import Tie


class DoubleElimination(BracketFormat):
    """The losers of the upper bracket go on in the lower one; the winners of both play the grand final."""

    stage: Literal["double_elimination"]
    second_final: bool = described(
        True,
        "whether a second grand final decides if the team from the lower bracket wins the first: until then the other "
        "one has lost once only",
    )

    MIN_TEAMS: ClassVar[int] = 3

    def size(self, intake: Intake) -> StageSize:
        """Return the size of the stage, with one grand final."""
        matches = max(0, 2 * intake.teams - 2) * self.matches_of_tie[0]
        rounds = 2 * round_count(intake.teams) + self.second_final
        return StageSize(intake.teams, {"": intake.teams}, matches, rounds)

    def shared_cuts(self, cuts: frozenset[int], teams: int) -> frozenset[int]:
        """Return the places that losers of one round share: single are 1 to 4, then 5-6, 7-8, 9-12, 13-16, …."""
        return cuts - {factor << power for factor in (1, 3) for power in range(16)}

    def play(self, bracket: Bracket) -> None:
        """Fill the ties in an order in which they can be played.

        The lower bracket has two rounds for each of the upper one after the first: its winners meet each other, then
        the losers from above.
        """
        upper = bracket.ties_of("upper_round_1", first_round(bracket.entrants), 1, "upper")
        lower = [loser(tie) for tie in upper]
        last = round_count(len(bracket.entrants))
        for number in range(2, last + 1):
            round_ = 2 * number - 2
            winners = bracket.ties_of(f"lower_round_{round_ - 1}", lower, round_, "lower")
            upper = bracket.ties_of(f"upper_round_{number}", [winner(tie) for tie in upper], round_, "upper")
            fallen = [loser(tie) for tie in upper]
            # From the other end in every other round, so that a pair of before meets late.
            fallen = fallen[::-1] if number % 2 == 0 else fallen
            entries = [entry for tie, other in zip(winners, fallen, strict=True) for entry in (winner(tie), other)]
            lower = [winner(tie) for tie in bracket.ties_of(f"lower_round_{round_}", entries, round_ + 1, "lower")]
        self._finals(bracket, winner(upper[0]), lower[0], 2 * last)

    def _finals(self, bracket: Bracket, one: Entry, two: Entry, round_: int) -> None:
        tie = bracket.tie("grand_final", 1, (one, two), round_, "upper")
        if self.second_final and tie.decided_by not in ("", "bye") and tie.winner and tie.winner == two[0]:
            bracket.tie("grand_final", 2, (one, two), round_ + 1, "upper")

    def levels(self, bracket: Bracket) -> list[list[str]]:
        final: Tie = bracket.ties[-1]
        rounds = dict.fromkeys(tie.round for tie in reversed(bracket.ties) if tie.tree == "lower")
        return [[final.winner], [loser(final)[0]], *(bracket.losers(name) for name in rounds)]
