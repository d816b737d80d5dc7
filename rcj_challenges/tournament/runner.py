"""Plays what is not played yet. It can be interrupted at any moment, and goes on where it was."""

from __future__ import annotations

import shutil
import time
from collections import deque
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import format_error
from rcj_challenges.records.folder import replaced, when_free
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.result import has_time_fault
from rcj_challenges.tournament.codes import CANNOT_GO_ON
from rcj_challenges.tournament.executor import Executor, JobOutcome
from rcj_challenges.tournament.fixtures import JobMaker, outcome_of, summary_of
from rcj_challenges.tournament.jobs import MatchJob, Workplace, sizes
from rcj_challenges.tournament.opened import OpenTournament, sides_of
from rcj_challenges.tournament.reconcile import has_whole_record
from rcj_challenges.tournament.scenarios import ScenarioUse
from rcj_challenges.tournament.season import Fixture, FixtureKind, Outcome, SeasonState
from rcj_challenges.tournament.store.store import PlayedFixture

_WAITING_PER_LANE = 1
"""Jobs that wait in the executor, so that no lane is idle while a result is written."""
_STATE_EVERY_S = 2.0
_STATE_SHARE = 0.01
"""Of the time at most, for tables that are only shown."""


@dataclass(frozen=True)
class Progress:
    """The progress of a run, in matches.

    Attributes:
        state: of the tournament; some of the newest outcomes may be missing in it.
        done: with an outcome.
        left: without an outcome, as far as is known.
        left_s: time for these; None if unknown.
    """

    state: SeasonState
    done: int
    left: int
    left_s: float | None


class RunObserver:
    """Sees what a run does; what is not overridden does nothing."""

    def played(self, fixture: Fixture, outcome: Outcome, progress: Progress, *, is_doubtful: bool) -> None:
        """A match has an outcome."""

    def not_played(self, fixture: Fixture, complaint: str) -> None:
        """A match could not be played, twice; it has no result."""

    def played_again(self, fixture: Fixture) -> None:
        """A time limit decided something in a match, so it will be played once more, alone."""


@dataclass
class _Task:
    """A job in the executor; ``first_digest``: of the first attempt, if a time limit decided something in it."""

    job: MatchJob
    fixtures: list[Fixture]
    first_digest: str | None = None


@dataclass
class Runner:
    """Plays a tournament, whose store is open for writing."""

    tournament: OpenTournament
    jobs: JobMaker
    executor: Executor
    observer: RunObserver
    _played: dict[str, PlayedFixture] = field(default_factory=dict)
    _tasks: dict[str, _Task] = field(default_factory=dict)
    _alone: deque[_Task] = field(default_factory=deque)
    _open: deque[Fixture] = field(default_factory=deque)
    _failed: set[str] = field(default_factory=set)
    _wall_s: float = 0.0
    _planned_s: float = 0.0
    _in_play: list[str] | None = None
    _state_at_s: float = 0.0
    _state_took_s: float = 0.0

    def run(self) -> SeasonState:
        """Play everything; returns the state at the end. Matches that could not be played have no outcome in it.

        Raises:
            DiagnosticError: this computer cannot go on; what was played until then is kept.
            KeyboardInterrupt: it was interrupted; the same.
        """
        with suppress(OSError):  # of a run that was killed
            shutil.rmtree(self._place.playing)
        self._played = self.tournament.store.played()
        self._rows = self.tournament.store.jobs()
        self._recompute()
        try:
            with self.executor:
                self._play_all()
        except OSError as error:
            raise cannot_go_on(self._place.folder, format_error(error)) from error
        return self._state

    # --- the loop -----------------------------------------------------------------------------------------------------

    def _play_all(self) -> None:
        while True:
            self._feed()
            self._keep_progress()
            if not self._tasks:
                if not self._recompute():
                    return
                continue
            outcomes = self.executor.poll()
            done = [fixture for outcome in outcomes for fixture in self._tasks[outcome.job.id].fixtures]
            for outcome in outcomes:
                self._take(outcome)
            if done and (not self._open or (_is_challenge(self._open[0]) and not all(map(_is_challenge, done)))):
                self._recompute()  # it may have been the match that the next round waited for

    def _feed(self) -> None:
        """Give the executor work: matches side by side, and when all are over those that are to be played alone."""
        room = self.executor.lanes * (1 + _WAITING_PER_LANE)
        while self._open and len(self._tasks) < room:
            fixture = self._open.popleft()
            job = self.jobs.job_for(fixture)
            task = self._tasks.get(job.id) or next((one for one in self._alone if one.job.id == job.id), None)
            if task is not None:
                task.fixtures.append(fixture)
            else:
                self._begin(_Task(job, [fixture]))
        if not self._tasks and not self._open and self._alone:
            self._submit(self._alone.popleft())

    def _begin(self, task: _Task) -> None:
        row = self._rows.get(task.job.id)
        if row is not None and row.state == "suspect":
            task.first_digest = row.summary["digest"]
            self._alone.append(task)
        elif row is not None and row.state == "played" and has_whole_record(row, self._place):
            counts = [(fixture, outcome_of(fixture, row.summary)) for fixture in task.fixtures]
            self.tournament.store.count_job(row, counts)
            self._count(task, counts, is_doubtful=row.doubtful)
        else:
            self._submit(task)

    def _submit(self, task: _Task) -> None:
        self._tasks[task.job.id] = task
        self.executor.submit(task.job)

    def _take(self, outcome: JobOutcome) -> None:
        task = self._tasks.pop(outcome.job.id)
        if outcome.result is None or outcome.folder is None:
            if outcome.is_host_error:
                raise cannot_go_on(self._place.folder, outcome.complaint)
            self._failed.update(fixture.id for fixture in task.fixtures)
            self.tournament.store.keep_job(task.job, "failed", complaint=outcome.complaint)
            for fixture in task.fixtures:
                self.observer.not_played(fixture, outcome.complaint)
            return
        summary = summary_of(outcome.result)
        if has_time_fault(outcome.result) and task.first_digest is None:
            task.first_digest = summary["digest"]
            self.tournament.store.keep_job(task.job, "suspect", summary=summary)
            shutil.rmtree(outcome.folder, ignore_errors=True)
            self._alone.append(task)
            for fixture in task.fixtures:
                self.observer.played_again(fixture)
            return
        is_doubtful = task.first_digest not in (None, summary["digest"])
        keep_record(outcome.folder, self._place, task.job.id)
        counts = [(fixture, outcome_of(fixture, outcome.result)) for fixture in task.fixtures]
        self.tournament.store.keep_job(
            task.job, "played", summary=summary, files=sizes(self._place.record_of(task.job.id)),
            doubtful=is_doubtful, counts_for=counts,
        )  # fmt: skip
        self._wall_s += summary["wall_s"]
        use = ScenarioUse(task.fixtures[0].scenario, task.fixtures[0].overrides)
        self._planned_s += self.tournament.loaded.scenarios[use].duration_s
        self._count(task, counts, is_doubtful=is_doubtful)

    def _count(self, task: _Task, counts: list[tuple[Fixture, Outcome]], *, is_doubtful: bool) -> None:
        for fixture, outcome in counts:
            self._played[fixture.id] = PlayedFixture(task.job.id, sides_of(fixture), outcome)
        for fixture, outcome in counts:
            self.observer.played(fixture, outcome, self._progress(), is_doubtful=is_doubtful)

    # --- the state ----------------------------------------------------------------------------------------------------

    def _recompute(self) -> bool:
        """Compute the state, and find what can be played now; returns whether there is anything."""
        self._compute_state()
        busy = {fixture.id for task in (*self._tasks.values(), *self._alone) for fixture in task.fixtures}
        todo = (fixture for fixture in self._state.open_fixtures() if fixture.id not in busy | self._failed)
        self._open = deque(sorted(todo, key=_is_challenge))  # the next round waits for matches
        return bool(self._open or self._alone)

    def _compute_state(self) -> None:
        began = time.monotonic()
        self._state = self.tournament.state(self._played)
        self.tournament.keep_drawn()
        self._state_at_s = time.monotonic()
        self._state_took_s = self._state_at_s - began

    def _progress(self) -> Progress:
        due_s = self._state_at_s + max(_STATE_EVERY_S, self._state_took_s / _STATE_SHARE)
        if time.monotonic() >= due_s:
            self._compute_state()
        expected = sum(stage.expected_matches for stage in self._state.stages)
        done = len(self._played.keys() | self._state.outcomes.keys())
        left = max(expected - done, len(self._open) + len(self._tasks) + len(self._alone))
        left_s = None
        if self._planned_s:
            work = self.tournament.work_left(self._state)
            mean_s = sum(one.matches * one.mean_s for one in work) / max(1, sum(one.matches for one in work))
            left_s = self._wall_s / self._planned_s * mean_s * left / self.executor.lanes
        return Progress(self._state, done, left, left_s)

    def _keep_progress(self) -> None:
        """Write the progress for `status` in another terminal."""
        playing = islice(self._tasks.values(), self.executor.lanes)
        in_play = [fixture.id for task in playing for fixture in task.fixtures]
        if in_play != self._in_play:
            self._in_play = in_play
            with replaced(self._place.progress) as file:
                file.write(json_line({"in_play": in_play, "left_s": self._progress().left_s}))

    # --- files --------------------------------------------------------------------------------------------------------

    @property
    def _place(self) -> Workplace:
        return self.tournament.store.place


def _is_challenge(fixture: Fixture) -> bool:
    return fixture.kind is FixtureKind.CHALLENGE


def keep_record(folder: Path, place: Workplace, job_id: str) -> None:
    """Move the record of a match that is over to its place; one that was there goes.

    Raises:
        OSError: it cannot be moved.
    """
    target = place.record_of(job_id)
    if target.exists():
        old = folder.with_name(f"{folder.name}.old")
        when_free(lambda: target.rename(old))
        shutil.rmtree(old, ignore_errors=True)
    when_free(lambda: folder.rename(target))


def cannot_go_on(folder: Path, why: str) -> DiagnosticError:
    """Return the error for a computer that cannot go on; nothing that was played is lost."""
    message = f"this computer cannot continue the matches in {folder}: {why}"
    return DiagnosticError(Diagnostic(CANNOT_GO_ON, message, "fix this and run again: it continues where it stopped"))
