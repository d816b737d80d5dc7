"""The state of a tournament as plain data: stages, fixtures, tables, brackets, places.

It is a pure function of the tournament file, the teams, and the outcomes so far: the same three give the same state,
in whichever order the matches were played. The runner plays the fixtures that have no outcome, the site renders the
rest.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum


def humanized(name: str) -> str:
    """Return a name of the file as people write it: ``round_of_16`` becomes ``Round of 16``."""
    text = name.replace("_", " ").strip()
    return text[:1].upper() + text[1:]


class Status(StrEnum):
    """The progress of a stage."""

    WAITING = "waiting"
    """The stages that it takes its teams from are not finished: it has no teams and no fixtures yet."""
    RUNNING = "running"
    FINISHED = "finished"


class FixtureKind(StrEnum):
    """The purpose of a fixture."""

    MATCH = "match"
    EXTRA_TIME = "extra_time"
    TIE_SCENARIO = "tie_scenario"
    CHALLENGE = "challenge"


class Ruled(StrEnum):
    """The source of an outcome's score."""

    PLAYED = "played"
    FORFEIT = "forfeit"
    DOUBLE_FORFEIT = "double_forfeit"
    CORRECTED = "corrected"
    WITHDRAWN = "withdrawn"
    ANNULLED = "annulled"
    """It does not count: the scores are kept for display only."""

    @property
    def words(self) -> str:
        """The note beside the score; empty if it was played."""
        words = {Ruled.PLAYED: "", Ruled.CORRECTED: "score corrected", Ruled.WITHDRAWN: "team withdrew"}
        return words.get(self, self.value.replace("_", " "))


@dataclass(frozen=True, slots=True)
class Team:
    """One team of a tournament.

    Attributes:
        id: as in the file; unique without regard to case, safe as a file name.
        name: as shown: that of the submission, or of the file.
        pot: for drawing groups; 1 is the strongest, 0 if there are no pots.
        last_rounds: of a team that has left: by stage, the last round for which it was drawn before (see
            `SeasonState.last_rounds`). It takes part in no other stage, and in no later round.
        left_after: of a team that has left: the number of others that had left before it.
    """

    id: str
    name: str
    pot: int = 0
    withdrawn: bool = False
    last_rounds: Mapping[str, int] = field(default_factory=dict)
    left_after: int = 0


@dataclass(frozen=True, slots=True)
class Side:
    """One side of a fixture.

    Attributes:
        seat: of the first half.
        teams: ids: one, or in a super team one for each robot number (1, 2, 3) of the seat.
    """

    seat: str
    teams: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Fixture:
    """One run of a scenario that the tournament asks for.

    Attributes:
        id: unique in the tournament and stable: ``groups/A/round2/ada-bee``; Latin letters, digits, ``-_/``.
        group: name of its group, of its challenge, or empty.
        round: from 1, within its stage.
        sides: two in a match, one in a challenge.
        scenario: name of a shipped scenario, or the path of its file.
        overrides: ``PATH=VALUE`` each, applied to the scenario.
        seed: of the match; derived from the tournament's seed and this id.
        tie: of a knock-out the pairing that it belongs to (``knock_out/quarter_finals/1``), else empty.
        leg: from 1, number among the matches of its pairing.
        title: for people: ``Group A, round 2``.
    """

    id: str
    stage: str
    group: str
    round: int
    sides: tuple[Side, ...]
    scenario: str
    overrides: tuple[str, ...]
    seed: int
    kind: FixtureKind = FixtureKind.MATCH
    tie: str = ""
    leg: int = 1
    title: str = ""


@dataclass(frozen=True, slots=True)
class Outcome:
    """The outcome of a fixture that counts.

    Attributes:
        scores: by side, in the order of the fixture's sides.
        reason: of a ruling, in the words of the referee; empty if it was played.
        values: of a challenge, by the scenario's criteria; empty in a match.
    """

    scores: tuple[float, ...]
    ruled: Ruled = Ruled.PLAYED
    reason: str = ""
    values: tuple[float | None, ...] = ()


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a table.

    Attributes:
        team: id; of a super team the ids joined with ``+``.
        place: from 1; equal for teams that share one.
        played, won, drawn, lost: matches.
        goals, conceded: goals for and against.
        by_lot: whether its place among equals was drawn from the seed.
        values: of a challenge or a combined table, under the table's ``columns``.
    """

    team: str
    place: int
    shared: bool = False
    played: int = 0
    won: int = 0
    drawn: int = 0
    lost: int = 0
    goals: float = 0
    conceded: float = 0
    points: float = 0
    by_lot: bool = False
    values: tuple[float | None, ...] = ()


@dataclass(frozen=True, slots=True)
class Table:
    """A ranking of the teams of a group, a Swiss stage, a challenge, or several challenges together.

    Attributes:
        name: of the group or challenge; empty if the stage has one table.
        rows: best first.
        columns: names of each row's ``values``; empty in a table of matches.
    """

    name: str
    rows: tuple[Row, ...]
    columns: tuple[str, ...] = ()
    complete: bool = False

    @property
    def has_begun(self) -> bool:
        """Whether anything in it was played: before that, its places mean nothing."""
        return any(row.played or row.points for row in self.rows)


@dataclass(frozen=True, slots=True)
class Tie:
    """One pairing of a knock-out.

    Attributes:
        id: as in the fixtures' ``tie``.
        round: name of its round: ``round_of_16``, ``quarter_finals``, ``semi_finals``, ``third_place``, ``final``.
        number: from 1 within the round, from top to bottom of the bracket.
        teams: the two ids; empty text for a place that is not decided yet.
        sources: of each team, for people: ``winner of quarter final 1``, ``A1``, ``bye``.
        fixtures: ids, in the order they are played.
        scores: sum of the legs, or matches won in a best-of; None while nothing is played.
        winner: id, or empty: of a tie that is decided if both teams have left or forfeit.
        decided_by: ``match``, ``extra_time``, ``tie_scenario``, ``lot``, ``bye``, ``forfeit``, or empty.
        tree: the bracket of the stage that it is drawn in; empty if there is one.
    """

    id: str
    round: str
    number: int
    teams: tuple[str, str]
    sources: tuple[str, str] = ("", "")
    fixtures: tuple[str, ...] = ()
    scores: tuple[float, float] | None = None
    winner: str = ""
    decided_by: str = ""
    tree: str = ""

    @property
    def round_title(self) -> str:
        """Its round as a heading: ``Quarter-finals``, ``Round of 16``."""
        return humanized(self.round.replace("_finals", "-finals"))

    @property
    def title(self) -> str:
        """Its name in a sentence: ``final``, ``quarter-final 1``, ``match 1 of the round of 16``."""
        if self.round in _TIE_TITLES:
            return _TIE_TITLES[self.round].format(self.number)
        return f"match {self.number} of the {self.round.replace('_', ' ')}"


_TIE_TITLES = {
    "final": "final",
    "third_place": "match for third place",
    "semi_finals": "semi-final {}",
    "quarter_finals": "quarter-final {}",
}


@dataclass(frozen=True, slots=True)
class StageState:
    """One stage.

    Attributes:
        kind: its format as in the file: ``round_robin``.
        teams: ids that take part, of super teams their members; empty while it waits.
        fixtures: all that are known so far (of a Swiss stage the rounds drawn so far), in playing order.
        expected_matches: in all, as far as is known: extra time counts once it is to be played.
        tables: groups, challenges; the last one of several challenges combines them.
        ties: of a knock-out, round by round.
        byes: of a Swiss stage (round, team).
        has_groups: whether each table has places that the next stage takes teams from.
        has_matrices: whether the teams of a table meet each other.
        is_solo: whether teams play alone; the last table combines the others.
        places: the ranking of the whole stage as far as it is decided, best first; for leading into the next stage.
    """

    name: str
    kind: str
    title: str
    status: Status
    teams: tuple[str, ...] = ()
    fixtures: tuple[Fixture, ...] = ()
    expected_matches: int = 0
    tables: tuple[Table, ...] = ()
    ties: tuple[Tie, ...] = ()
    byes: tuple[tuple[int, str], ...] = ()
    places: tuple[Row, ...] = ()
    has_groups: bool = False
    has_matrices: bool = False
    is_solo: bool = False

    @property
    def rankings(self) -> list[tuple[str, tuple[Row, ...]]]:
        """The rankings that others take places from, by name: one for each group, else the stage's."""
        return [(found.name, found.rows) for found in self.tables] if self.has_groups else [("", self.places)]


@dataclass(frozen=True, slots=True)
class SeasonState:
    """The whole tournament; outcomes are by fixture id, with withdrawn teams and rulings applied."""

    stages: tuple[StageState, ...]
    teams: Mapping[str, Team]
    outcomes: Mapping[str, Outcome] = field(default_factory=dict)

    def last_rounds(self, team: str) -> dict[str, int]:
        """Return the last round for which a team has been drawn, by stage: what is to be noted when it withdraws."""
        found: dict[str, int] = {}
        for stage in self.stages:
            if team in stage.teams:
                rounds = [one.round for one in stage.fixtures if any(team in side.teams for side in one.sides)]
                byes = [number for number, name in stage.byes if name == team]
                found[stage.name] = max((0, *rounds, *byes))
        return found

    @property
    def fixtures(self) -> tuple[Fixture, ...]:
        """All known fixtures, in playing order."""
        return tuple(fixture for stage in self.stages for fixture in stage.fixtures)

    def open_fixtures(self) -> tuple[Fixture, ...]:
        """Return the known fixtures that have no outcome yet, in playing order."""
        return tuple(fixture for fixture in self.fixtures if fixture.id not in self.outcomes)
