"""Progress of ``rcj-challenge tournament run`` in the terminal."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Self

from rich.console import Console, Group, RenderableType
from rich.live import Live
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from rcj_challenges.cli.stdio import print_progress
from rcj_challenges.cli.tournament.tables import duration_words, score_words, stage_tables
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.runner import Progress, RunObserver
from rcj_challenges.tournament.season import Fixture, Outcome, SeasonState, Status

_NEWEST_SHOWN = 5


def observer_for(console: Console, tournament: OpenTournament, *, quiet: bool) -> RunLines:
    """Display of a run: a table that is drawn over in a terminal, plain lines elsewhere."""
    if quiet:
        return RunLines(console, tournament, quiet=True)
    if console.is_terminal and not console.is_dumb_terminal:
        return RunBoard(console, tournament)
    return RunLines(console, tournament)


class RunLines(RunObserver):
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
