"""From an open tournament to what its site shows."""

from __future__ import annotations

from collections.abc import Collection
from datetime import datetime
from zoneinfo import ZoneInfo

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.played import read_played
from rcj_challenges.tournament.release import release_times, round_times
from rcj_challenges.tournament.site.source import RoundTime, SiteSource, hidden_fixtures
from rcj_challenges.tournament.tournament_file import Tournament


def site_source(
    tournament: OpenTournament, now: datetime, premieres: Collection[str] = (), url: str = ""
) -> SiteSource:
    """Return what may be shown at a time; tables and brackets follow from the released results alone.

    Args:
        tournament: with its store.
        now: the time, with a time zone.
        premieres: names of the stages whose matches have a premiere.
        url: where the site will be on the web; empty if that is unknown.

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
        rounds=tuple(time for stage in file.stages for time in _round_times(file, stage)),
        premieres=frozenset(premieres),
        url=f"{url.rstrip('/')}/" if url else "",
    )


def _round_times(file: Tournament, stage: str) -> list[RoundTime]:
    times = round_times(file, stage)
    if len(times) == 1:
        return [RoundTime(stage, 0, times[0])]
    return [RoundTime(stage, number, at) for number, at in enumerate(times, 1)]


def _check_premieres(file: Tournament, premieres: Collection[str]) -> None:
    problems = []
    for stage in premieres:
        if stage not in file.stages:
            message = f"there is no stage '{stage}'"
            problems.append(Diagnostic("unknown-stage", message, f"stages: {', '.join(file.stages)}"))
        elif file.stages[stage].release is None:
            message = f"the matches of stage '{stage}' cannot have a premiere: no time of release is set"
            problems.append(Diagnostic("no-release", message, f"set stages.{stage}.release"))
    if problems:
        raise DiagnosticError(*problems)
