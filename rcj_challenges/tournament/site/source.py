"""The source of the site, and the results that it may show already."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from datetime import datetime, timedelta, tzinfo
from zoneinfo import ZoneInfo

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.codes import NO_RELEASE, UNKNOWN_STAGE
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.played import Played, read_played
from rcj_challenges.tournament.release import release_times, round_times
from rcj_challenges.tournament.season import Fixture, SeasonState
from rcj_challenges.tournament.tournament_file import Tournament

HALF_TIME_S = 30.0
"""Break between the halves of a premiere."""


@dataclass(frozen=True, slots=True)
class RoundTime:
    """The time of release of a round (from 1), or of a whole stage (0)."""

    stage: str
    round: int
    at: datetime


@dataclass(frozen=True, slots=True)
class SiteSource:
    """All that the site shows.

    Attributes:
        id: of the tournament, safe as a file name.
        state: of the released outcomes only, so that no table, bracket or pairing says more than the results do.
        played: everything that was played, also what is not released.
        now: the time of publishing.
        releases: by fixture id; what is missing is released as soon as it is played.
        rounds: for the schedule.
        premieres: names of the stages whose matches are shown as a premiere when they are released.
        url: of the site on the web, ending in ``/``; empty if unknown.
        home: address of the site of which it is a part; empty if it is none.
        unnamed: teams whose logos are not to be shown.
    """

    id: str
    title: str
    description: str
    seed: str
    time_zone: tzinfo
    state: SeasonState
    played: Played
    now: datetime
    releases: Mapping[str, datetime] = field(default_factory=dict)
    rounds: tuple[RoundTime, ...] = ()
    premieres: frozenset[str] = frozenset()
    url: str = ""
    home: str = ""
    unnamed: Collection[str] = ()

    @property
    def is_over(self) -> bool:
        """Whether all results are released: only then the seed is."""
        return all(stage.status == "finished" for stage in self.state.stages)


def hidden_fixtures(
    fixtures: Collection[Fixture],
    played: Played,
    releases: Mapping[str, datetime],
    now: datetime,
    premieres: Collection[str] = (),
) -> frozenset[str]:
    """Return the ids of the fixtures whose results may not be shown yet.

    A result is shown from its release on; if its stage has premieres, from the end of its premiere on.
    """
    hidden = set()
    for fixture in fixtures:
        at = releases.get(fixture.id)
        if at is None:
            continue
        match = played.matches.get(fixture.id)
        if fixture.stage in premieres and match is not None and match.record is not None:
            breaks = max(0, len(match.result.get("halves", ())) - 1)
            at += timedelta(seconds=float(match.result.get("simulated_s", 0)) + breaks * HALF_TIME_S)
        if at > now:
            hidden.add(fixture.id)
    return frozenset(hidden)


def site_source(
    tournament: OpenTournament, now: datetime, premieres: Collection[str] = (), url: str = ""
) -> SiteSource:
    """Return the source of the site at a time; tables and brackets follow from the released results alone.

    Raises:
        DiagnosticError: there is no such stage, or it has no time of release.
    """
    file = tournament.loaded.tournament
    _check_premieres(file, premieres)
    (whole, outcomes), played = tournament.state_and_outcomes(), read_played(tournament.store)
    hidden = hidden_fixtures(whole.fixtures, played, release_times(file, whole), now, premieres)
    shown = {fixture: outcome for fixture, outcome in outcomes.items() if fixture not in hidden}
    state = tournament.season.state(shown, hidden & outcomes.keys())
    return SiteSource(
        id=tournament.loaded.name,
        title=file.title,
        description=file.description,
        seed=str(file.seed),
        time_zone=ZoneInfo(file.time_zone),
        state=state,
        played=played,
        now=now,
        releases=release_times(file, state),
        rounds=tuple(
            RoundTime(stage, number, at)
            for stage in file.stages
            for times in [round_times(file, stage)]
            for number, at in enumerate(times, int(len(times) > 1))
        ),
        premieres=frozenset(premieres),
        url=f"{url.rstrip('/')}/" if url else "",
    )


def _check_premieres(file: Tournament, premieres: Collection[str]) -> None:
    problems = []
    for stage in premieres:
        if stage not in file.stages:
            message = f"there is no stage '{stage}'"
            problems.append(Diagnostic(UNKNOWN_STAGE, message, f"stages: {', '.join(file.stages)}"))
        elif file.stages[stage].release is None:
            message = f"the matches of stage '{stage}' cannot have a premiere: no time of release is set"
            problems.append(Diagnostic(NO_RELEASE, message, f"set stages.{stage}.release"))
    if problems:
        raise DiagnosticError(*problems)
