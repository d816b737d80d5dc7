"""Writes the record of a run during play: cheap on every tick, readable after a kill at any moment."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Any, Self

from rcj_challenges.core.changes import Change, ScoreChange
from rcj_challenges.core.play import Event, Fault, Firing, HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.records.digest import StatesDigest, inputs_digest, run_digest
from rcj_challenges.records.folder import (
    LOGS,
    RECORD_VERSION,
    REFEREE_LOG,
    REFLOG,
    RESULT,
    SCENARIO,
    UNRESOLVED,
    folder_name,
    make_run_folder,
    naming,
    replaced,
    timestamp,
    utc_now,
    write_all,
)
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.logos import logo_path
from rcj_challenges.records.referee_log import copies_of_rules, log_lines
from rcj_challenges.records.reflog import event_line, events_of, reflog_lines
from rcj_challenges.records.result import MemberResult, RunResult, versions
from rcj_challenges.records.trajectory import TrajectoryWriter
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster


@dataclass(frozen=True)
class RunHeader:
    """The facts of a run before it begins.

    Attributes:
        scenario: resolved: presets, parameters and command line worked in.
        team_names: by the seat of the first half.
        programs: hash of each team's files, by its seat of the first half.
        match_id: as in MATCH_START.
        sandbox: isolation of programs, JSON-able.
        marks: what makes this run special, such as ``debug``.
        members: of each SuperTeam, by its seat of the first half.
        unresolved: the scenario before its params took their places, for judging with other values; empty: not kept.
        logos: the teams' own ``logo.png`` as they gave it, by team; kept beside the record, checked when shown.
    """

    scenario: Scenario
    seed: int
    team_names: Mapping[str, str]
    programs: Mapping[str, str]
    match_id: int = 0
    sandbox: Mapping[str, Any] = field(default_factory=dict)
    marks: tuple[str, ...] = ()
    members: Mapping[str, Sequence[MemberResult]] = field(default_factory=dict)
    unresolved: Mapping[str, Any] = field(default_factory=dict)
    logos: Mapping[str, bytes] = field(default_factory=dict)


class RecordWriter:
    """The record of one run, in a folder that the constructor makes and that is never shared.

    Use as a context manager, or call `finish` in any case: without it the folder stays readable, but marked as not
    complete. Left by an exception, the context closes the record as it is and names the exception's type.
    """

    def __init__(
        self, out: Path, header: RunHeader, *, name: str | None = None, now: Callable[[], datetime] = utc_now
    ) -> None:
        """Make the folder of the run in ``out``; write the scenario and an incomplete result.

        The folder's name, left out, is time and scenario; a number is added if it exists. ``now`` is the wall clock,
        for the name and for ``datetime`` in the reflog.

        Raises:
            RecordError: the folder cannot be made.
        """
        self._now = now
        started = now()
        self._header = header
        scenario = header.scenario.dumped()
        self._states = StatesDigest()
        self._copies = copies_of_rules(header.unresolved)
        self._half: HalfInfo | None = None
        self._fields = _first_fields(header, timestamp(started))
        self._result: dict[str, Any] = {}
        self.folder = make_run_folder(out, name or folder_name(started, header.scenario.id))
        # First, and not through a temporary file: wherever a kill comes, only a folder with a result is a record.
        self._begin()
        self.logs = self.folder / LOGS
        self.logs.mkdir()
        self._write(self.folder / SCENARIO, json_line(scenario))
        if header.unresolved:
            self._write(self.folder / UNRESOLVED, json_line(dict(header.unresolved)))
        for team, logo in header.logos.items():
            self._write(logo_path(self.folder, team), logo)
        roster = Roster.of(header.scenario)
        self._trajectory = TrajectoryWriter(self.folder, header.scenario.id, header.seed, roster)
        self._reflog = (self.folder / REFLOG).open("xb", buffering=0)
        self._referee_log = (self.folder / REFEREE_LOG).open("xb", buffering=0)

    def _begin(self) -> None:
        """Write an incomplete result; if the disk is full, remove the folder, which would not be a record."""
        try:
            self._write(self.folder / RESULT, self._result_line({}))
        except OSError:
            with suppress(OSError):
                (self.folder / RESULT).unlink(missing_ok=True)
                self.folder.rmdir()
            raise

    @staticmethod
    def _write(path: Path, content: bytes) -> None:
        with naming(path):
            path.write_bytes(content)

    @property
    def result(self) -> dict[str, Any]:
        """The current content of ``result.json``."""
        return dict(self._result)

    def begin_half(self, half: HalfInfo) -> None:
        """Begin a half; its ticks follow, tick 0 (the start, before physics) first."""
        self._trajectory.begin_half(half)
        self._half = half
        self._fields["score"] |= {half.teams[seat]: points for seat, points in half.scores.items()}
        self._states.half(half.half)

    def tick(self, snapshot: Snapshot, output: RefereeOutput, state: bytes, poses: bytes = b"") -> None:
        """Record one judged tick.

        Args:
            snapshot: what the referee saw.
            output: its answer; placements are carried out after the snapshot.
            state: the judged qpos and qvel as little-endian float64.
            poses: those of the snapshot as little-endian float32 ``[sub-step][entity][3]``; left out: made here.
        """
        if self._half is None:
            raise ValueError("a tick outside of a half: call begin_half first")
        self._states.state(state)
        self._trajectory.append(snapshot, output.placements, poses)
        if output.firings or output.events or output.changes or snapshot.faults:
            self._log(self._half, events_of(snapshot, output), output.firings, output.changes)
            self._fields["faults"] += [self._fault(fault, self._half) for fault in snapshot.faults]

    def end_half(self, closing: RefereeOutput, ended: str | None = None) -> None:
        """End the half; ``ended`` is the reason of the rule that ended it (or the match), None if the time was up."""
        if self._half is None:
            raise ValueError("no half to end: call begin_half first")
        self._log(self._half, closing.events, closing.firings, closing.changes)
        self._close_half(self._half, ended, complete=True)
        self._write_result({})

    def finish(self, result: Mapping[str, Any] | None = None) -> Path:
        """Close the record: the trajectory ends, the result is complete. Returns the folder.

        ``result`` has fields of `RunResult` that only the caller knows (``wall_s``, ``sandbox``, ``marks``, ``score``),
        and ``complete: False`` with ``stopped`` for a run that was not played to its end.
        """
        states = self._states.hexdigest()
        digests = {"states": states, "digest": run_digest(self._fields["inputs"], states)}
        fields = {"complete": True} | digests | dict(result or {})
        self._reflog.close()
        self._referee_log.close()
        if self._half is not None:
            self._close_half(self._half, None, complete=False)
        if not fields["complete"]:
            self._write_result(fields)  # at once, should there be neither time nor room for the rest
        self._trajectory.close()
        self._write_result(fields)
        return self.folder

    def break_off(self, error: type[BaseException], result: Mapping[str, Any] | None = None) -> Path:
        """Close the record of a run that was stopped by an error, as `finish` does; can be called again."""
        fields = {"complete": False, "states": "", "digest": "", "stopped": error.__name__}
        return self.finish(fields | dict(result or {}))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: object, trace: object) -> None:
        if kind is not None and not self._reflog.closed:
            self.break_off(kind)

    def _close_half(self, half: HalfInfo, ended: str | None, *, complete: bool) -> None:
        # An interruption in here closes it a second time.
        if half.half not in [one["half"] for one in self._fields["halves"]]:
            facts = {"half": half.half, "sides": dict(half.teams), "score": dict(self._fields["score"])}
            self._fields["halves"].append(
                facts | {"ticks": self._trajectory.ticks, "ended": ended, "complete": complete}
            )
        self._half = None

    def _log(
        self, half: HalfInfo, events: Sequence[Event], firings: Sequence[Firing], changes: Sequence[Change]
    ) -> None:
        if events:
            write_all(self._reflog, bytearray(reflog_lines(events, timestamp(self._now()))))
        for event in events:
            self._states.event(event)
        self._fields["events"] += [event_line(half.half, event) for event in events]
        write_all(self._referee_log, bytearray(log_lines(half.half, events, firings, changes, self._copies)))
        for change in changes:
            if isinstance(change, ScoreChange):
                self._fields["score"] |= {half.teams[seat]: points for seat, points in change.scores.items()}

    def _fault(self, fault: Fault, half: HalfInfo) -> dict[str, Any]:
        entrants = self._header.scenario.entrants
        team = next((half.teams[seat] for seat, entrant in entrants.items() if fault.robot in entrant.robots), None)
        return {**asdict(fault), "team": team}

    def _write_result(self, more: Mapping[str, Any]) -> None:
        line = self._result_line(more)
        with replaced(self.folder / RESULT) as file:
            file.write(line)

    def _result_line(self, more: Mapping[str, Any]) -> bytes:
        simulated_s = round(sum(half["ticks"] for half in self._fields["halves"]) * TICK_S, 3)
        fields = {**self._fields, "simulated_s": simulated_s, **more}
        if fields["wall_s"] > 0 and "real_time_factor" not in more:
            fields["real_time_factor"] = round(fields["simulated_s"] / fields["wall_s"], 2)
        self._result = RunResult.model_validate(fields).model_dump(mode="json")
        return json_line(self._result)


def _first_fields(header: RunHeader, started: str) -> dict[str, Any]:
    """Return the fields of the result of a run that begins."""
    return {
        "record": RECORD_VERSION,
        "complete": False,
        "stopped": None,
        "scenario": header.scenario.id,
        "title": header.scenario.title,
        "started": started,
        "seed": header.seed,
        "match_id": header.match_id,
        "entrants": {
            team: {"name": name, "programs": header.programs[team], "members": header.members.get(team, ())}
            for team, name in header.team_names.items()
        },
        "score": dict.fromkeys(header.team_names, 0),
        "halves": [],
        "events": [],
        "faults": [],
        "inputs": inputs_digest(header.scenario, header.seed, header.programs),
        "states": "",
        "digest": "",
        "wall_s": 0.0,
        "real_time_factor": 0.0,
        "versions": versions().model_dump(),
        "sandbox": dict(header.sandbox),
        "marks": list(header.marks),
    }
