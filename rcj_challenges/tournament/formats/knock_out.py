"""Knock-out: a bracket, whose loser is out in each tie."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from math import inf
from typing import Literal

from rcj_challenges.rules.fields import described
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.stage import Intake, MatchFormat, StageProblem, StageSize
from rcj_challenges.tournament.formats.tie import play_tie
from rcj_challenges.tournament.season import Fixture, FixtureKind, Row, StageState, Status, Tie
from rcj_challenges.tournament.seeds import shuffled
from rcj_challenges.tournament.standings import tally

_NAMES = {1: "final", 2: "semi_finals", 4: "quarter_finals"}


class KnockOut(MatchFormat):
    """The loser of each tie is out. If the number of teams is not a power of two, the best seeds have a bye."""

    stage: Literal["knock_out"]
    seeding: Literal["by_place", "drawn"] = described(
        "by_place",
        "by_place: the best meet the last, and teams of the same group meet late; without 'from' the order of "
        "the teams decides, with the first pot first. drawn: by lot",
    )
    third_place: bool = described(False, "whether the losers of the semi-finals play for third place")
    legs: int = described(1, "matches of a tie whose scores are added up; 2: with the sides changed", ge=1, le=2)
    best_of: Literal[1, 3, 5, 7] = described(
        1, "a tie is won by the majority of this many matches; drawn ones count for neither side"
    )

    @property
    def has_ties(self) -> bool:
        """Whether there are ties: always."""
        return True

    @property
    def matches_of_tie(self) -> tuple[int, int]:
        """The least and the most matches of a tie, without extra time."""
        return max(self.legs, self.best_of // 2 + 1), max(self.legs, self.best_of)

    def size(self, intake: Intake) -> StageSize:
        """Return the size of the stage; of a best-of the matches that are played in any case."""
        ties = max(0, intake.teams - 1) + (self.third_place and intake.teams >= 4)
        matches = ties * self.matches_of_tie[0]
        return StageSize(intake.teams, {"": intake.teams}, matches, round_count(intake.teams))

    def problems(self, intake: Intake, size: StageSize) -> Iterator[StageProblem]:
        """Yield keys that contradict each other, and a third place that nobody can take."""
        if self.legs > 1 and self.best_of > 1:
            message = "'legs' adds scores up, 'best_of' counts wins"
            yield StageProblem(("best_of",), "legs-and-best-of", message, "keep one of them")
        if self.third_place and size.teams < 4:
            message = f"of {size.teams} teams no two lose a semi-final"
            yield StageProblem(("third_place",), "too-few-teams", message, "remove 'third_place'")

    def shared_cuts(self, cuts: frozenset[int], teams: int) -> frozenset[int]:
        """Return the places that losers of one round share."""
        decided = {1, 2, 3} if self.third_place and teams >= 4 else {1, 2}
        return cuts - decided - {1 << power for power in range(16)}

    def waiting(self, context: StageContext, entrants: Sequence[Entrant], matches: int) -> StageState:
        """Return the bracket with where the teams will come from."""
        return self.state(context, entrants)

    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        """Return the state of a knock-out; of entrants that are not known yet the bracket with where they come from."""
        bracket = _Bracket(context, self, seeded(context, self, entrants))
        bracket.play()
        is_known = all(entrant.team for entrant in entrants)
        is_finished = is_known and all(tie.decided_by for tie in bracket.ties)
        return StageState(
            name=context.name,
            kind=context.kind,
            title=context.title(self),
            status=(Status.FINISHED if is_finished else Status.RUNNING) if is_known else Status.WAITING,
            teams=tuple(entrant.team for entrant in entrants) if is_known else (),
            fixtures=tuple(bracket.fixtures),
            expected_matches=bracket.expected_matches(),
            ties=tuple(bracket.ties),
            places=bracket.places() if is_finished else (),
        )


def round_count(count: int) -> int:
    """Return the number of rounds for so many teams."""
    return max(0, count - 1).bit_length()


def seeded(context: StageContext, stage: KnockOut, entrants: Sequence[Entrant]) -> list[Entrant]:
    """Return the entrants in the order of their seeds, the best first."""
    if stage.seeding == "drawn":
        by_team = {entrant.team: entrant for entrant in entrants}
        if "" in by_team:
            return [replace(entrant, origin="drawn") for entrant in entrants]
        order = context.drawn.draw(
            context.name,
            list(by_team) if stage.from_ else None,
            lambda: shuffled(context.tournament.seed, f"{context.name}/seeding", list(by_team)),
        )
        return [by_team[team] for team in order if team in by_team]
    if stage.from_ is None:
        return sorted(entrants, key=lambda one: one.pot or inf)
    return list(entrants)


def fold(size: int) -> list[int]:
    """Return the seeds, from 0, from top to bottom of a bracket: the best two can meet in the final only."""
    order = [0]
    while len(order) < size:
        total = 2 * len(order)
        order = [seed for one in order for seed in (one, total - 1 - one)]
    return order


def first_round(entrants: Sequence[Entrant]) -> list[tuple[Entrant | None, Entrant | None]]:
    """Return the pairs of the first round from top to bottom; None is a bye.

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
    order = fold(size)
    return [(seeds[order[i]], seeds[order[i + 1]]) for i in range(0, size, 2)]


def _same_group(one: Entrant | None, other: Entrant | None) -> bool:
    return one is not None and other is not None and bool(one.group) and one.group == other.group


@dataclass
class _Bracket:
    context: StageContext
    stage: KnockOut
    entrants: Sequence[Entrant]
    ties: list[Tie] = field(default_factory=list)
    fixtures: list[Fixture] = field(default_factory=list)

    def play(self) -> None:
        """Fill the ties, round by round."""
        if len(self.entrants) < 2:
            return
        pairs = first_round(self.entrants)
        entries = [(_team(one), _team(two), _source(one), _source(two)) for one, two in pairs]
        round_ = 1
        while True:
            name = _round_name(len(entries))
            if name == "final" and self.stage.third_place and len(self.entrants) >= 4:
                self._third_place(round_)
            done = [self._tie(name, number, entry, round_) for number, entry in enumerate(entries, 1)]
            if len(done) == 1:
                return
            entries = [
                (one.winner, two.winner, _winner_of(one), _winner_of(two))
                for one, two in zip(done[::2], done[1::2], strict=True)
            ]
            round_ += 1

    def expected_matches(self) -> int:
        """Return how many matches there will be, as far as is known."""
        least = self.stage.matches_of_tie[0]
        return sum(
            len(tie.fixtures) if tie.decided_by or "bye" in tie.sources else max(least, len(tie.fixtures))
            for tie in self.ties
        )

    def places(self) -> tuple[Row, ...]:
        """Return the ranking: losers of the same round share a place, unless a lot is listed.

        Teams of a tie that is won by none of them have no place.
        """
        left = [entrant.team for entrant in self.entrants]
        levels: list[list[str]] = [] if self.ties else [left]  # all others have left the tournament
        has_third = any(tie.round == "third_place" for tie in self.ties)
        for tie in reversed([tie for tie in self.ties if tie.round in ("final", "third_place")]):
            levels += [[tie.winner], [_loser(tie)]]
        for name in dict.fromkeys(tie.round for tie in reversed(self.ties)):
            if name in ("final", "third_place") or (name == "semi_finals" and has_third):
                continue
            losers = {_loser(tie) for tie in self.ties if tie.round == name} - {""}
            levels.append([team for team in left if team in losers])
        return tuple(self._rows([ranked for level in levels if (ranked := [team for team in level if team])]))

    def _rows(self, levels: list[list[str]]) -> Iterator[Row]:
        rules = self.context.rules("places")
        counted = [one for one in self.fixtures if one.kind is not FixtureKind.TIE_SCENARIO]
        matches = [match for one in counted if (match := self.context.result(one)) is not None]
        tallies = tally([entrant.team for entrant in self.entrants], matches, rules)
        place = 1
        for level in levels:
            is_by_lot = len(level) > 1 and "lot" in rules.tie_breaks
            for index, team in enumerate(sorted(level, key=rules.lot) if is_by_lot else level):
                own_place = place + index if is_by_lot else place
                is_shared = len(level) > 1 and not is_by_lot
                yield replace(tallies[team].row(team, own_place, shared=is_shared, by_lot=is_by_lot), points=0)
            place += len(level)

    def _third_place(self, round_: int) -> None:
        one, two = [tie for tie in self.ties if tie.round == "semi_finals"]
        sources = tuple("bye" if tie.decided_by and not _loser(tie) else f"loser of {tie.title}" for tie in (one, two))
        self._tie("third_place", 1, (_loser(one), _loser(two), sources[0], sources[1]), round_)

    def _tie(self, name: str, number: int, entry: tuple[str, str, str, str], round_: int) -> Tie:
        one, two, *sources = entry
        path = f"{name}/{number}"
        tie = Tie(f"{self.context.name}/{path}", name, number, (one, two), (sources[0], sources[1]))
        if "bye" in sources:
            is_decided = one or two or sources == ["bye", "bye"]
            tie = replace(tie, winner=one or two, decided_by="bye" if is_decided else "")
        elif one and two:
            title = f"{self.context.title(self.stage)}, {tie.title}"
            # The team above begins on the first seat in every other round.
            pair = (one, two) if round_ % 2 else (two, one)
            legs, best_of = self.stage.legs, self.stage.best_of
            result = play_tie(self.context, self.stage, path, pair, round_, title, legs=legs, best_of=best_of)
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


def _round_name(ties: int) -> str:
    return _NAMES.get(ties, f"round_of_{2 * ties}")


def _winner_of(tie: Tie) -> str:
    one, other = tie.sources
    if tie.decided_by and not tie.winner:
        return "bye"
    if "bye" in (one, other):
        return other if one == "bye" else one
    return f"winner of {tie.title}"


def _loser(tie: Tie) -> str:
    return (tie.teams[1] if tie.winner == tie.teams[0] else tie.teams[0]) if tie.winner else ""


def _team(entrant: Entrant | None) -> str:
    return entrant.team if entrant is not None else ""


def _source(entrant: Entrant | None) -> str:
    return entrant.origin if entrant is not None else "bye"
