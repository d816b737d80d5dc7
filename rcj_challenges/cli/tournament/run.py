"""``rcj-challenge tournament run``: checks the submissions, then plays."""

from __future__ import annotations

import os
from collections.abc import Collection
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli import OK, OUR_FAULT
from rcj_challenges.cli.app import PLAY
from rcj_challenges.cli.options import AtOnce, Sandbox
from rcj_challenges.cli.stdio import print_lines, require_layers
from rcj_challenges.cli.tournament.group import Cascade, Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.tables import stage_tables
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.codes import SHARED_WITHOUT_CLUSTER, SUBMISSION_FAILS, SUBMISSION_UNCHECKED, UNKNOWN_TEAM

if TYPE_CHECKING:
    from rcj_challenges.cli.tournament.run_lines import RunLines
    from rcj_challenges.tournament.admission import Failure
    from rcj_challenges.tournament.executor import Executor
    from rcj_challenges.tournament.fixtures import JobMaker
    from rcj_challenges.tournament.jobs import Workplace
    from rcj_challenges.tournament.opened import OpenTournament


class SubmissionsFailError(DiagnosticError):
    """Submissions that fail the check: a negative verdict, not a wrong input."""

    exit_code = 1


@tournament_app.register(PLAY, "rcj-challenge tournament run cup")
def run(
    file: File,
    data: Data = None,
    at_once: AtOnce = None,
    sandbox: Sandbox = "auto",
    accept: Annotated[
        list[str] | None,
        typer.Option("--accept", metavar="TEAM", help="Let a team play although it fails the check. Repeatable."),
    ] = None,
    cascade: Cascade = False,
    cluster: Annotated[
        str | None,
        typer.Option("--cluster", metavar="ADDRESS", help="Play on the workers of a Dask cluster: tcp://HOST:8786."),
    ] = None,
    shared: Annotated[
        bool, typer.Option("--shared", help="The workers of the cluster see the data folder under the same path.")
    ] = False,
    redraw: Annotated[
        bool, typer.Option("--redraw", help="Draw again after a change; matches of pairs that still exist are kept.")
    ] = False,
    add: Annotated[
        list[str] | None,
        typer.Option("--add", metavar="TEAM", help="Take a late team into what is not drawn yet, and round robins."),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print only the last lines.")] = False,
) -> int:
    """Check all submissions, then play what has not been played yet. After an interruption, run it again to continue.

    Exit status 0: everything is played; 1: a submission fails the check; 2: wrong input, or this computer cannot
    continue; 3: a match could not be played because of a bug in this project.
    """
    from rcj_challenges.cli.tournament.run_lines import RunLines
    from rcj_challenges.tournament import redrawing
    from rcj_challenges.tournament.reconcile import other_pythons, reconcile
    from rcj_challenges.tournament.runner import Runner
    from rcj_challenges.views.console import console_for

    with opened(file, data, writing=True) as tournament:
        require_layers(sandbox)
        lanes = at_once or os.cpu_count() or 1
        console = console_for()
        observer = RunLines(console, tournament, quiet=quiet)
        for line in (redrawing.redraw(tournament) if redraw else []) + redrawing.add_teams(tournament, add or ()):
            observer.note(line)
        # A cluster that cannot be used is found before submissions are checked, which takes minutes.
        with _executor(tournament.store.place, cluster, lanes, observer, shared=shared) as executor:
            jobs = prepare(tournament, frozenset(accept or ()), sandbox, lanes, observer)
            for fixture, reason in reconcile(tournament, jobs, cascade=cascade).items():
                observer.note(f"{fixture} is played again: {reason}")
            for python in other_pythons(tournament.store):
                observer.note(f"matches were played with {python}, which matters only to programs that depend on it")
            try:
                state = Runner(tournament, jobs, executor, observer).run()
            except KeyboardInterrupt as error:
                left = "run the same command again: it continues where it stopped"
                raise KeyboardInterrupt(f"{counted(observer.done, 'match', 'matches')} played; {left}") from error
    for table in stage_tables(state):
        console.print(table)
    if observer.failed:
        line = f"{counted(len(observer.failed), 'match', 'matches')} could not be played; run again to try once more"
        print_lines(console, line)
        return OUR_FAULT
    return OK


def _executor(place: Workplace, cluster: str | None, lanes: int, observer: RunLines, *, shared: bool) -> Executor:
    """Player of the matches: this computer, or a cluster.

    Raises:
        DiagnosticError: the cluster cannot be used.
    """
    from rcj_challenges.records.result import versions
    from rcj_challenges.tournament.executor import LocalExecutor

    if cluster is None:
        if shared:
            message = "--shared is about the workers of a cluster"
            raise DiagnosticError(Diagnostic(SHARED_WITHOUT_CLUSTER, message, "give --cluster ADDRESS too"))
        return LocalExecutor(place, lanes)
    from rcj_challenges.tournament.cluster import ClusterExecutor

    return ClusterExecutor(place, cluster, versions().model_dump(), shared, observer.note)


def prepare(
    tournament: OpenTournament, accepted: Collection[str], sandbox: str, lanes: int, observer: RunLines
) -> JobMaker:
    """Take the submissions and check ``lanes`` of them at a time; returns what makes jobs of them.

    Teams whose ids are ``accepted`` play although they fail the check.

    Raises:
        RcjError: one cannot be read, or fails the check and is not accepted.
    """
    from rcj_challenges.tournament.admission import check_submissions, take_submissions
    from rcj_challenges.tournament.fixtures import JobMaker

    loaded, season = tournament.loaded, tournament.season
    unknown = set(accepted) - loaded.entries.keys()
    if unknown:
        message = f"there is no team {', '.join(map(repr, sorted(unknown)))}"
        raise DiagnosticError(Diagnostic(UNKNOWN_TEAM, message, f"teams: {', '.join(loaded.entries)}"))
    staying = [entry for entry in loaded.entries.values() if not season.teams[entry.id].withdrawn]
    handed = take_submissions(staying, tournament.store)
    tournament.refresh()
    # Also those of teams that have left: what these have played stays comparable.
    jobs = JobMaker(tournament, tournament.store.current_submissions() | handed, sandbox)
    tasks = jobs.check_tasks(handed)
    failures = check_submissions(tasks, tournament.store, jobs=lanes, sandbox=sandbox, observer=observer)
    refused = [one for one in failures if one.team not in accepted or one.is_unchecked]
    if refused:
        raise SubmissionsFailError(*(_diagnostic(one) for one in refused))
    return jobs


def _diagnostic(failure: Failure) -> Diagnostic:
    from rcj_challenges.scenario.errors import listing

    team, scenarios = failure.team, listing(failure.scenarios, 3)
    if failure.is_unchecked:
        message = f"the submission of {team} could not be checked ({scenarios})"
        return Diagnostic(SUBMISSION_UNCHECKED, message, "run the command again")
    message = f"the submission of {team} fails the check: {failure.message} ({scenarios})"
    help_ = f"let the team replace it (its report is {failure.report}); or play it as it is: --accept {team}"
    return Diagnostic(SUBMISSION_FAILS, message, help_)
