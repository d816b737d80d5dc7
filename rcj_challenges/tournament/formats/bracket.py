"""What brackets share: seeds, byes, ties whose winners and losers go on to others, places by the round of the loss."""

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from math import inf
from typing import Literal

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.fields import described
from rcj_challenges.tournament.codes import LEGS_AND_BEST_OF
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.stage import Intake, MatchFormat, StageSize
from rcj_challenges.tournament.formats.tie import TieGame
from rcj_challenges.tournament.season import Fixture, FixtureKind, Row, StageState, Status, Tie
from rcj_challenges.tournament.seeds import shuffled
from rcj_challenges.tournament.standings import placed, tally

Entry = tuple[str, str]
"""A team of a tie, empty if it is not known yet, and its source, for people."""


class BracketFormat(MatchFormat):
    """A format of ties that lead to each other."""

    seeding: Literal["by_place", "drawn"] = described(
        "by_place",
        "by_place: the best meet the last, and teams of the same group meet late; without 'from' the order of "
        "the teams decides, with the first pot first. drawn: by lot",
    )
    legs: int = described(1, "matches of a tie whose scores are added up; 2: with the sides changed", ge=1, le=2)
    best_of: Literal[1, 3, 5, 7] = described(
        1, "a tie is won by the majority of this many matches; drawn ones count for neither side"
    )

    @abstractmethod
    def play(self, bracket: "Bracket") -> None:
        """Fill a bracket of two entrants or more with ties."""

    @abstractmethod
    def levels(self, bracket: "Bracket") -> list[list[str]]:
        """Return the teams, best first; those of one list share a place, and empty ids are left out."""

    @property
    def has_ties(self) -> bool:
        return True

    @property
    def matches_of_tie(self) -> tuple[int, int]:
        return max(self.legs, self.best_of // 2 + 1), max(self.legs, self.best_of)

    def problems(self, intake: Intake, size: StageSize) -> Iterator[Diagnostic]:
        if self.legs > 1 and self.best_of > 1:
            message = "'legs' adds scores up, 'best_of' counts wins"
            yield issue(LEGS_AND_BEST_OF, ("best_of",), message, "keep one of them")

    def waiting(self, context: StageContext, entrants: Sequence[Entrant], matches: int) -> StageState:
        return self.state(context, entrants)

    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        bracket = Bracket(context, self, self._seeded(context, entrants))
        if len(entrants) > 1:
            self.play(bracket)
        is_known = all(entrant.team for entrant in entrants)
        is_finished = is_known and all(tie.decided_by for tie in bracket.ties)
        state = context.state(
            self,
            [entrant.team for entrant in entrants] if is_known else (),
            is_finished=is_finished,
            fixtures=tuple(bracket.fixtures),
            expected_matches=bracket.expected_matches(),
            ties=tuple(bracket.ties),
            places=bracket.places() if is_finished else (),
        )
        return state if is_known else replace(state, status=Status.WAITING)

    def _seeded(self, context: StageContext, entrants: Sequence[Entrant]) -> list[Entrant]:
        """Return the entrants in the order of their seeds, the best first."""
        if self.seeding == "drawn":
            by_team = {entrant.team: entrant for entrant in entrants}
            if "" in by_team:
                return [replace(entrant, origin="drawn") for entrant in entrants]
            teams = list(by_team)
            seed, stream = context.tournament.seed, f"{context.name}/seeding"
            order = context.draw(self, teams, lambda: shuffled(seed, stream, teams))
            return [by_team[team] for team in order if team in by_team]
        if self.from_ is None:
            return sorted(entrants, key=lambda one: one.pot or inf)
        return list(entrants)


def round_count(count: int) -> int:
    """Return the number of rounds for so many teams."""
    return max(0, count - 1).bit_length()


def fold(size: int) -> list[int]:
    """Return the seeds, from 0, from top to bottom of a bracket: the best two can meet in the final only."""
    order = [0]
    while len(order) < size:
        total = 2 * len(order)
        order = [seed for one in order for seed in (one, total - 1 - one)]
    return order


def first_round(entrants: Sequence[Entrant]) -> list[Entry]:
    """Return the entries of the first round from top to bottom: two of each tie.

    Two that come from one group do not meet there if another one with the same place can stand in.
    """
    size = 1 << round_count(len(entrants))
    seeds: list[Entrant | None] = [*entrants, *[None] * (size - len(entrants))]
    for low in range(size // 2, len(entrants)):
        high = size - 1 - low
        if not _same_group(seeds[high], seeds[low]):
            continue
        for other in range(size // 2, len(entrants)):
            one, two = seeds[low], seeds[other]
            is_better = not _same_group(seeds[high], two) and not _same_group(seeds[size - 1 - other], one)
            if one is not None and two is not None and one.place == two.place and is_better:
                seeds[low], seeds[other] = two, one
                break
    in_order = (seeds[seed] for seed in fold(size))
    return [(one.team, one.origin) if one is not None else ("", "bye") for one in in_order]


def _same_group(one: Entrant | None, other: Entrant | None) -> bool:
    return one is not None and other is not None and bool(one.group) and one.group == other.group


@dataclass
class Bracket:
    """A bracket in the middle of being played; the best seed of its entrants comes first."""

    context: StageContext
    stage: BracketFormat
    entrants: Sequence[Entrant]
    ties: list[Tie] = field(default_factory=list)
    fixtures: list[Fixture] = field(default_factory=list)

    def ties_of(self, name: str, entries: Sequence[Entry], round_: int, tree: str = "") -> list[Tie]:
        """Play a round, and return its ties.

        Args:
            name: of the round.
            entries: two of each tie, from top to bottom.
            round_: number of its fixtures.
            tree: the picture that it belongs to.
        """
        pairs = zip(entries[::2], entries[1::2], strict=True)
        return [self.tie(name, number, pair, round_, tree) for number, pair in enumerate(pairs, 1)]

    def tie(self, name: str, number: int, entries: tuple[Entry, Entry], round_: int, tree: str = "") -> Tie:
        """Play one tie, and return it; see `ties_of`."""
        (one, source), (two, other) = entries
        path = f"{name}/{number}"
        tie = Tie(f"{self.context.name}/{path}", name, number, (one, two), (source, other), tree=tree)
        if "bye" in tie.sources:
            is_decided = one or two or tie.sources == ("bye", "bye")
            tie = replace(tie, winner=one or two, decided_by="bye" if is_decided else "")
        elif one and two:
            title = f"{self.context.title(self.stage)}, {tie.title}"
            # The team above begins on the first seat in every other round.
            pair = (one, two) if round_ % 2 else (two, one)
            game = TieGame(self.context, self.stage, path, pair, round_, title)
            result = game.result(self.stage.legs, self.stage.best_of)
            self.fixtures += result.fixtures
            scores = result.scores if pair == (one, two) or result.scores is None else result.scores[::-1]
            tie = replace(
                tie,
                fixtures=tuple(fixture.id for fixture in result.fixtures),
                scores=scores,
                winner=result.winner,
                decided_by=result.decided_by,
            )
        self.ties.append(tie)
        return tie

    def losers(self, name: str) -> list[str]:
        """Return the teams that have lost in a round, in the order of their seeds."""
        losers = {loser(tie)[0] for tie in self.ties if tie.round == name}
        return [entrant.team for entrant in self.entrants if entrant.team in losers]

    def expected_matches(self) -> int:
        """Return the number of matches, as far as is known."""
        least = self.stage.matches_of_tie[0]
        is_open = [not tie.decided_by and "bye" not in tie.sources for tie in self.ties]
        return sum(max(least * more, len(tie.fixtures)) for tie, more in zip(self.ties, is_open, strict=True))

    def places(self) -> tuple[Row, ...]:
        """Return the ranking: teams of one level share a place, unless a lot is listed.

        Teams of a tie that is won by none of them have no place.
        """
        # Without a tie all others have left the tournament.
        levels = self.stage.levels(self) if self.ties else [[entrant.team for entrant in self.entrants]]
        return tuple(self._rows([ranked for level in levels if (ranked := [team for team in level if team])]))

    def _rows(self, levels: list[list[str]]) -> Iterator[Row]:
        rules = self.context.rules("places")
        counted = [one for one in self.fixtures if one.kind is not FixtureKind.TIE_SCENARIO]
        tallies = tally([entrant.team for entrant in self.entrants], self.context.matches(counted), rules)
        for row in placed(levels, rules.lot if "lot" in rules.tie_breaks else None):
            yield replace(tallies[row.team].filled(row), points=0)


def winner(tie: Tie) -> Entry:
    """Return the winner of a tie as an entry of another one; a bye if there is none."""
    one, other = tie.sources
    if tie.decided_by and not tie.winner:
        return "", "bye"
    if "bye" in tie.sources:
        return tie.winner, other if one == "bye" else one
    return tie.winner, f"winner of {tie.title}"


def loser(tie: Tie) -> Entry:
    """Return the loser of a tie as an entry of another one; a bye if there is none."""
    team = (tie.teams[1] if tie.winner == tie.teams[0] else tie.teams[0]) if tie.winner else ""
    is_bye = "bye" in tie.sources or (tie.decided_by and not team)
    return team, "bye" if is_bye else f"loser of {tie.title}"
