"""Progress of ``rcj-challenge tournament run`` in the terminal."""

from __future__ import annotations

from rich.console import Console

from rcj_challenges.cli.stdio import print_progress
from rcj_challenges.cli.tournament.tables import duration_words, score_words
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.runner import Progress, RunObserver
from rcj_challenges.tournament.season import Fixture, Outcome, SeasonState, Status


class RunLines(RunObserver):
    """Prints a line for each match.

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


def _left(progress: Progress) -> str:
    is_known = progress.left_s is not None and progress.left
    return f"  about {duration_words(progress.left_s or 0)} left" if is_known else ""
