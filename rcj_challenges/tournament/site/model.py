"""The season as pages need it: names that are safe to show, and matches with their links."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cached_property
from typing import Any

from rcj_challenges.core.amounts import HALF, measured_words, number_words
from rcj_challenges.core.files import slug
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.folder import SCENARIO
from rcj_challenges.records.recorded_scenario import read_period
from rcj_challenges.tournament.played import PlayedMatch
from rcj_challenges.tournament.season import Fixture, FixtureKind, Outcome, Ruled, Side, StageState, humanized
from rcj_challenges.tournament.site.public import fault_counts
from rcj_challenges.tournament.site.source import SiteSource
from rcj_challenges.views.naming import distinct_names

_LONGEST_NAME = 60


def group_title(stage: StageState, group: str) -> str:
    """Return the title of a group or a challenge: ``Group A``."""
    return f"Group {group}" if stage.has_groups and group else humanized(group)


@dataclass(frozen=True, slots=True)
class MatchView:
    """One fixture with all facts for its pages.

    Attributes:
        outcome: None if it is open or not released.
        played: None if there is no outcome, so that nothing leaks.
        at: the time of its release, if the file has one.
        slug: name of its folder under ``matches``.
        premiere: whether it has a page that shows it when it is released.
    """

    fixture: Fixture
    stage: StageState
    outcome: Outcome | None
    played: PlayedMatch | None
    at: datetime | None
    slug: str
    premiere: bool = False

    @property
    def period(self) -> str:
        """What a half of it is called."""
        record = None if self.played is None else self.played.record
        return HALF.one if record is None else read_period(record / SCENARIO)

    @property
    def short_title(self) -> str:
        """The title without that of the stage: ``Semi-final 1``."""
        short = self.fixture.title.removeprefix(self.stage.title).lstrip(" ,:")
        return short[:1].upper() + short[1:]

    @property
    def teams(self) -> tuple[str, ...]:
        """Ids of all its teams."""
        return tuple(team for side in self.fixture.sides for team in side.teams)

    @property
    def scores(self) -> tuple[str, ...]:
        """The scores by side, as text; empty while there is none."""
        return tuple(number_words(score) for score in self.outcome.scores) if self.outcome else ()

    @property
    def is_challenge(self) -> bool:
        """Whether one team plays alone."""
        return len(self.fixture.sides) == 1

    @property
    def numbers(self) -> tuple[str, ...]:
        """The values of a challenge's criteria, as text; empty while there is none."""
        values = self.outcome.values or self.outcome.scores if self.outcome else ()
        return tuple(number_words(value, 3) for value in values)

    @property
    def values(self) -> tuple[str, ...]:
        """The same with their names: ``score 2``, ``time 8.75``."""
        numbers = self.numbers
        columns = next((table.columns for table in self.stage.tables if table.name == self.fixture.group), ())
        if len(columns) != len(numbers):
            return numbers
        return tuple(measured_words(name, number) for name, number in zip(columns, numbers, strict=True))

    @property
    def ruled(self) -> str:
        """A referee's decision in a word or two; empty if it was simply played."""
        return self.outcome.ruled.words if self.outcome else ""

    @property
    def lot_winner(self) -> str:
        """The team for which a lot decided after this match, by id; empty without a lot."""
        ties = (tie for tie in self.stage.ties if tie.decided_by == "lot" and self.outcome is not None)
        return next((tie.winner for tie in ties if tie.fixtures[-1:] == (self.fixture.id,)), "")

    @property
    def kind(self) -> str:
        """``extra time``; empty for a match or a challenge."""
        ordinary = (FixtureKind.MATCH, FixtureKind.CHALLENGE)
        return "" if self.fixture.kind in ordinary else self.fixture.kind.value.replace("_", " ")

    @property
    def played_at(self) -> datetime:
        """The time of its end or ruling; long ago if unknown."""
        if self.played is None:
            return datetime.min.replace(tzinfo=UTC)
        ruled = [ruling.at for ruling in self.played.rulings]
        return self.at or self.played.played_at or max(ruled, default=datetime.min.replace(tzinfo=UTC))

    def result_for(self, team: str) -> str:
        """Return ``won``, ``drawn`` or ``lost``; empty in a challenge or if it does not count."""
        if self.outcome is None or self.is_challenge or self.outcome.ruled is Ruled.ANNULLED:
            return ""
        own = next((at for at, side in enumerate(self.fixture.sides) if team in side.teams), None)
        if own is None or len(self.outcome.scores) != 2:
            return ""
        ours, theirs = self.outcome.scores[own], self.outcome.scores[1 - own]
        if self.outcome.ruled is Ruled.DOUBLE_FORFEIT:
            return "lost"
        return "drawn" if ours == theirs else "won" if ours > theirs else "lost"

    def difference_for(self, team: str) -> float:
        """Return the goals that a team was ahead by; negative if it was behind."""
        own = next((at for at, side in enumerate(self.fixture.sides) if team in side.teams), 0)
        scores = self.outcome.scores if self.outcome else (0.0, 0.0)
        return scores[own] - scores[1 - own]


class Season:
    """A `SiteSource`, looked up in the ways that pages need."""

    def __init__(self, source: SiteSource) -> None:
        self.source = source
        self.state = source.state
        self.teams = source.state.teams
        clean = {team.id: sanitize(team.name, _LONGEST_NAME) for team in self.teams.values()}
        shown = {team: name.encode("utf-8", "replace").decode().strip() or team for team, name in clean.items()}
        self._names = distinct_names(shown)

    def name(self, team: str) -> str:
        """Return the name of a team: without control characters, never empty, no two alike."""
        return self._names.get(team, team)

    def unnamed_seats(self, match: MatchView) -> list[str]:
        """Return the seats of teams whose logos are not to be shown."""
        return [side.seat for side in match.fixture.sides if not set(self.source.unnamed).isdisjoint(side.teams)]

    def label(self, teams: Iterable[str]) -> str:
        """Return the name of a side: of a super team the names of its teams."""
        return " + ".join(map(self.name, teams))

    @cached_property
    def matches(self) -> Mapping[str, MatchView]:
        """All known fixtures by id, in playing order."""
        return {fixture.id: self._view(fixture, stage) for stage in self.state.stages for fixture in stage.fixtures}

    @cached_property
    def released(self) -> tuple[MatchView, ...]:
        """The matches with an outcome, in playing order."""
        return tuple(match for match in self.matches.values() if match.outcome is not None)

    @cached_property
    def latest(self) -> tuple[MatchView, ...]:
        """The matches with an outcome, the newest first."""
        order = {match.fixture.id: at for at, match in enumerate(self.released)}
        return tuple(sorted(self.released, key=lambda match: (match.played_at, order[match.fixture.id]), reverse=True))

    @cached_property
    def coming(self) -> tuple[MatchView, ...]:
        """The matches without an outcome, the next first; without a time in playing order."""
        never = datetime.max.replace(tzinfo=UTC)
        found = (match for match in self.matches.values() if match.outcome is None)
        return tuple(sorted(found, key=lambda match: match.at or never))

    def of_stage(self, stage: StageState) -> tuple[MatchView, ...]:
        """Return the matches of a stage."""
        return tuple(self.matches[fixture.id] for fixture in stage.fixtures)

    def of_team(self, team: str) -> tuple[MatchView, ...]:
        """Return the matches of a team."""
        return tuple(match for match in self.matches.values() if team in match.teams)

    def faults_of(self, team: str) -> dict[str, int]:
        """Return the number of faults of a team's programs, by kind."""
        faults = [fault for match in self.of_team(team) for fault in team_faults(match, team)]
        return dict(sorted(fault_counts(faults).items()))

    def played(self, fixture: Fixture) -> PlayedMatch | None:
        """Return the match that was played, released or not; if other teams played it, only the rulings."""
        match = self.source.played.matches.get(fixture.id)
        teams = {team for side in fixture.sides for team in side.teams}
        if match is None or not match.submissions or set(match.submissions) == teams:
            return match
        return PlayedMatch(match.fixture, None, {}, rulings=match.rulings)

    def _view(self, fixture: Fixture, stage: StageState) -> MatchView:
        outcome = self.state.outcomes.get(fixture.id)
        return MatchView(
            fixture=fixture,
            stage=stage,
            outcome=outcome,
            played=self.played(fixture) if outcome is not None else None,
            at=self.source.releases.get(fixture.id),
            slug=slug(fixture.id),
            premiere=outcome is None and stage.name in self.source.premieres and fixture.id in self.source.releases,
        )


def team_faults(match: MatchView, team: str) -> list[Mapping[str, Any]]:
    """Return the faults of a match that are a team's: of a super team those of its own robot."""
    if match.played is None:
        return []
    return [
        fault
        for fault in match.played.result.get("faults", ())
        for side in match.fixture.sides
        if side.seat == fault.get("team") and team == driver(side, str(fault["robot"]))
    ]


def driver(side: Side, robot: str) -> str:
    """Return the team that drives a robot of a side: in a super team by the robot's number."""
    if len(side.teams) == 1:
        return side.teams[0]
    number = re.search(r"\d+$", robot)
    at = int(number[0]) - 1 if number else -1
    return side.teams[at] if 0 <= at < len(side.teams) else ""
