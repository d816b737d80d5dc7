"""``rcj-challenge tournament run``: checks the submissions, then plays, and shows how far it is."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from rich.console import Console, Group, RenderableType
from rich.live import Live
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from rcj_challenges.cli import OK, OUR_FAULT
from rcj_challenges.cli.sandbox import require_layers
from rcj_challenges.cli.stdio import print_progress
from rcj_challenges.cli.tournament_tables import duration_words, score_words, stage_tables
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.scenario.errors import listing
from rcj_challenges.tournament.admission import Failure, Submitted, check_submissions, take_submissions
from rcj_challenges.tournament.executor import Executor, LocalExecutor
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.reconcile import other_pythons, reconcile
from rcj_challenges.tournament.redrawing import add_teams, redraw
from rcj_challenges.tournament.runner import Progress, Runner
from rcj_challenges.tournament.season import Fixture, Outcome, SeasonState, Status
from rcj_challenges.views.console import console_for

_NEWEST_SHOWN = 5


class SubmissionsFailError(DiagnosticError):
    """Submissions that fail the check: a negative verdict, not a wrong input."""

    exit_code = 1


@dataclass(frozen=True)
class RunOptions:
    """The options of ``tournament run``, as given."""

    at_once: int | None
    sandbox: str
    accepted: frozenset[str]
    cascade: bool
    quiet: bool
    cluster: str | None = None
    shared: bool = False
    redraw: bool = False
    added: tuple[str, ...] = ()


def run_tournament(tournament: OpenTournament, options: RunOptions) -> int:
    """Check, then play what is not played yet; returns the exit code.

    Raises:
        RcjError: a submission fails the check, or the input or this computer is not as it should be.
        KeyboardInterrupt: it was interrupted; says how far it came.
    """
    require_layers(options.sandbox)
    lanes = options.at_once or os.cpu_count() or 1
    console = console_for()
    observer = observer_for(console, tournament, quiet=options.quiet)
    for line in (redraw(tournament) if options.redraw else []) + add_teams(tournament, options.added):
        observer.note(line)
    # A cluster that cannot be used is found before submissions are checked, which takes minutes.
    with _executor(tournament, options, lanes, observer) as executor:
        jobs = prepare(tournament, options, lanes, observer)
        for fixture, reason in reconcile(tournament, jobs, cascade=options.cascade).items():
            observer.note(f"{fixture} is played again: {reason}")
        for python in other_pythons(tournament.store):
            observer.note(f"matches were played with {python}, which matters only to programs that depend on it")
        with observer:
            try:
                state = Runner(tournament, jobs, executor, observer).run()
            except KeyboardInterrupt as error:
                left = "run the same command again: it continues where it stopped"
                raise KeyboardInterrupt(f"{counted(observer.done, 'match', 'matches')} played; {left}") from error
    for table in stage_tables(state):
        console.print(table)
    if observer.failed:
        line = f"{counted(len(observer.failed), 'match', 'matches')} could not be played; run again to try once more"
        console.print(line, markup=False, highlight=False)
        return OUR_FAULT
    return OK


def _executor(tournament: OpenTournament, options: RunOptions, lanes: int, observer: RunLines) -> Executor:
    """Return what plays the matches: this computer, or a cluster.

    Raises:
        DiagnosticError: the cluster cannot be used.
    """
    place = tournament.store.place
    if options.cluster is None:
        if options.shared:
            message = "--shared is about the workers of a cluster"
            raise DiagnosticError(Diagnostic("shared-without-cluster", message, "give --cluster ADDRESS too"))
        return LocalExecutor(place, lanes)
    from rcj_challenges.records.result import versions
    from rcj_challenges.tournament.cluster import ClusterExecutor

    return ClusterExecutor(place, options.cluster, versions().model_dump(), options.shared, observer.note)


def prepare(tournament: OpenTournament, options: RunOptions, lanes: int, observer: RunLines) -> JobMaker:
    """Take the submissions and check them; returns what makes jobs of them.

    Raises:
        RcjError: one cannot be read, or fails the check and is not accepted.
    """
    loaded, season = tournament.loaded, tournament.season
    unknown = options.accepted - loaded.entries.keys()
    if unknown:
        message = f"there is no team {', '.join(map(repr, sorted(unknown)))}"
        raise DiagnosticError(Diagnostic("unknown-team", message, f"teams: {', '.join(loaded.entries)}"))
    staying = [entry for entry in loaded.entries.values() if not season.teams[entry.id].withdrawn]
    handed = take_submissions(staying, tournament.store)
    tournament.refresh()
    jobs = JobMaker(tournament, _earlier(tournament) | handed, options.sandbox)
    tasks = jobs.check_tasks(handed)
    failures = check_submissions(tasks, tournament.store, jobs=lanes, sandbox=options.sandbox, observer=observer)
    refused = [one for one in failures if one.team not in options.accepted or one.is_unchecked]
    if refused:
        raise SubmissionsFailError(*(_diagnostic(one) for one in refused))
    return jobs


def _earlier(tournament: OpenTournament) -> dict[tuple[str, str], Submitted]:
    """Return the last submissions of all teams: of those that have left, what they played stays comparable."""
    rows = tournament.store.current_submissions()
    return {key: Submitted(*key, row.archive, row.file, row.name) for key, row in rows.items()}


def _diagnostic(failure: Failure) -> Diagnostic:
    team, scenarios = failure.team, listing(failure.scenarios, 3)
    if failure.is_unchecked:
        message = f"the submission of {team} could not be checked ({scenarios})"
        return Diagnostic("submission-unchecked", message, "run the command again")
    message = f"the submission of {team} fails the check: {failure.message} ({scenarios})"
    help_ = f"let the team replace it (its report is {failure.report}); or play it as it is: --accept {team}"
    return Diagnostic("submission-fails", message, help_)


def observer_for(console: Console, tournament: OpenTournament, *, quiet: bool) -> RunLines:
    """Return what shows a run: a table that is drawn over in a terminal, plain lines elsewhere."""
    if quiet:
        return RunLines(console, tournament, quiet=True)
    if console.is_terminal and not console.is_dumb_terminal:
        return RunBoard(console, tournament)
    return RunLines(console, tournament)


class RunLines:
    """Prints a line for each match; a context manager.

    Attributes:
        done: matches played in this run.
        failed: fixtures that could not be played.
    """

    def __init__(self, console: Console, tournament: OpenTournament, *, quiet: bool = False) -> None:
        self.done = 0
        self.failed: list[str] = []
        self._console = console
        self._tournament = tournament
        self._quiet = quiet
        self._finished: set[str] = set()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def note(self, line: str) -> None:
        """Print a line."""
        if not self._quiet:
            print_progress(self._console, line)

    def checked(self, team: str, scenario: str, level: str, done: int, total: int) -> None:
        """Print the verdict of a check."""
        self.note(f"check {done}/{total}  {team}  {scenario}  {level}")

    def played(self, fixture: Fixture, outcome: Outcome, progress: Progress, *, is_doubtful: bool) -> None:
        """Print the score of a match, and of a stage that is over the tables."""
        self.done += 1
        score = score_words(fixture, outcome, self._tournament.season.teams)
        total = progress.done + progress.left
        doubtful = "  doubtful: a time limit decided something in it" if is_doubtful else ""
        self.note(f"{progress.done}/{total}  {fixture.id}  {score}{doubtful}{_left(progress)}")
        self._print_tables(progress.state)

    def not_played(self, fixture: Fixture, complaint: str) -> None:
        """Print why a match could not be played."""
        self.failed.append(fixture.id)
        lines = complaint.strip().splitlines() or ["its process died"]
        self.note(f"{fixture.id} could not be played: {sanitize(lines[-1])}")

    def played_again(self, fixture: Fixture) -> None:
        """Print that a match is played once more."""
        self.note(f"{fixture.id}: a time limit decided something; it is played once more, alone")

    def moment(self, progress: Progress) -> None:
        """Nothing has happened for a moment."""

    def _print_tables(self, state: SeasonState) -> None:
        for stage in state.stages:
            if stage.status is Status.FINISHED and stage.name not in self._finished:
                self._finished.add(stage.name)
                self.note(f"stage {stage.name} is finished")


class RunBoard(RunLines):
    """Shows a run in a terminal: how far it is, the newest scores, the tables of the stage that is played."""

    def __init__(self, console: Console, tournament: OpenTournament) -> None:
        super().__init__(console, tournament)
        self._live = Live(console=console, auto_refresh=False, transient=True)
        self._newest: list[str] = []
        self._shown_at_s = 0.0

    def __enter__(self) -> Self:
        self._live.__enter__()
        return self

    def __exit__(self, *error: object) -> None:
        self._live.__exit__(None, None, None)

    def note(self, line: str) -> None:
        """Show a line among the newest, or print it while nothing is drawn."""
        if not self._live.is_started:
            super().note(line)
        self._newest = [*self._newest, line][-_NEWEST_SHOWN:]

    def played(self, fixture: Fixture, outcome: Outcome, progress: Progress, *, is_doubtful: bool) -> None:
        """Show the score of a match."""
        super().played(fixture, outcome, progress, is_doubtful=is_doubtful)
        self._draw(progress)

    def moment(self, progress: Progress) -> None:
        """Show the remaining time."""
        if time.monotonic() - self._shown_at_s >= 1.0:
            self._draw(progress)

    def _draw(self, progress: Progress) -> None:
        self._shown_at_s = time.monotonic()
        total = progress.done + progress.left
        counts = f"{progress.done} played, {progress.running} running, {progress.left - progress.running} left"
        parts: list[RenderableType] = [
            Text(f"{sanitize(self._tournament.loaded.tournament.title)}: {counts}{_left(progress)}"),
            ProgressBar(total=max(total, 1), completed=progress.done),
            *map(Text, self._newest),
            *_current_tables(progress.state),
        ]
        self._live.update(Group(*parts), refresh=True)


def _current_tables(state: SeasonState) -> Sequence[Table]:
    running = [stage for stage in state.stages if stage.status is Status.RUNNING]
    return stage_tables(state, only={stage.name for stage in running[:1]})


def _left(progress: Progress) -> str:
    is_known = progress.left_s is not None and progress.left
    return f"  about {duration_words(progress.left_s or 0)} left" if is_known else ""
