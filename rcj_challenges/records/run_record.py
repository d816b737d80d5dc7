"""Reads a whole run, as far as possible, for views and statistics.

`Trajectory.open` refuses what is damaged, because a match is judged again by all of it. Here a trajectory counts up to
the damage, and a sentence says what is missing.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.codes import RECORD_EMPTY
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SCENARIO, TRAJECTORY
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.referee_log import RefereeLog, log_of_result, read_referee_log
from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.records.trajectory import HalfTrack, Trajectory
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster


@dataclass(frozen=True)
class RunRecord:
    """A run, as far as it can be read: halves with at least one tick, and sentences about what is missing."""

    result: RunResult
    scenario: Scenario
    halves: tuple[HalfTrack, ...]
    log: RefereeLog
    problems: tuple[str, ...]

    @property
    def shown_log(self) -> RefereeLog:
        """The log; if it is lost, the events of the result."""
        return self.log if self.log.ticks else log_of_result(self.result)


def read_run(folder: Path) -> RunRecord:
    """Read a run that is finished, still played, was killed, or is damaged.

    Raises:
        RecordError: there is nothing in the folder that could be shown.
    """
    result = read_result(folder)
    scenario = read_scenario(folder)
    period = scenario.match.period
    trajectory = Trajectory.read(folder)
    if trajectory.entities != Roster.of(scenario).entities:
        raise RecordError.damaged(f"{folder.name}: {TRAJECTORY} belongs to another scenario than {SCENARIO}")
    halves = tuple(half for half in trajectory.halves if half.ticks)
    for half in halves:
        if set(half.info.teams) != set(scenario.entrants):
            what = f"{folder.name}: {period} {half.info.half} was played by other seats than the scenario has"
            raise RecordError.damaged(what)
    if not halves:
        if trajectory.damage:
            raise RecordError.damaged(f"{folder.name}: {trajectory.damage}")
        how = "match was over" if result.complete else "run was stopped"
        raise RecordError(RECORD_EMPTY, f"{folder.name}: the {how} before its first tick: there is nothing to show")
    problems, extent = [], ", ".join(f"{s_from_ticks(one.ticks):.1f} s of {period} {one.info.half}" for one in halves)
    if not result.complete:
        stopped = "it was interrupted" if result.stopped == KeyboardInterrupt.__name__ else result.stopped
        why = f" ({stopped})" if stopped else ""
        problems.append(f"This run was not played to its end{why}: what was recorded is shown, {extent}.")
    if trajectory.damage:
        ticks = sum(half.ticks for half in halves)
        problems.append(f"The recorded poses are damaged: {ticks} ticks of them could be read, {extent}.")
    log = read_referee_log(folder)
    if log.damaged_lines:
        are = "is" if log.damaged_lines == 1 else "are"
        lines = counted(log.damaged_lines, "line")
        problems.append(f"{lines} of the referee's log {are} damaged and left out.")
    return RunRecord(result, scenario, halves, log, tuple(problems))
