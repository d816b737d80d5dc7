"""Writing the record of a run while it is played: cheap on every tick, readable after a kill at any moment."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from rcj_challenges.facts.amounts import Score, round_score
from rcj_challenges.facts.play import Fault, Firing, HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.records.digest import StatesDigest, inputs_digest, run_digest
from rcj_challenges.records.folder import (
    LOGS,
    RECORD_VERSION,
    REFEREE_LOG,
    REFLOG,
    RESULT,
    SCENARIO,
    TRAJECTORY_PARTS,
    UNRESOLVED,
    folder_name,
    make_run_folder,
    naming,
    replaced,
    timestamp,
    utc_now,
)
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.logos import logo_path
from rcj_challenges.records.pack import pack_trajectory
from rcj_challenges.records.reflog import event_line, events_of, firing_line, reflog_lines
from rcj_challenges.records.result import MemberResult, RunResult, versions
from rcj_challenges.records.track import TrackWriter, write_all
from rcj_challenges.scenario.dump import dumped
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster


@dataclass(frozen=True)
class RunHeader:
    """What is known of a run before it begins.

    Attributes:
        scenario: resolved: presets, parameters and command line worked in.
        seed: of everything that chance decides.
        team_names: name of each team, by its seat of the first half.
        programs: hash of each team's files, by its seat of the first half.
        match_id: as in MATCH_START.
        sandbox: how programs are isolated, JSON-able.
        marks: what makes this run special, such as ``debug``.
        members: of each SuperTeam, by its seat of the first half.
        unresolved: the scenario before its params took their places, for who judges with others; empty: not kept.
        logos: the teams' own ``logo.png`` as they gave it, by team; kept beside the record, looked at when shown.
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
    """The record of one run.

    Use as a context manager, or call `finish` in any case: without it the folder stays readable, but marked as not
    complete. Left by an exception, the context closes the record as it is and names the exception's type.

    Attributes:
        folder: of this run, made by the constructor, shared with nobody.
        logs: folder for the programs' output.
    """

    def __init__(
        self,
        out: Path,
        header: RunHeader,
        *,
        name: str | None = None,
        now: Callable[[], datetime] = utc_now,
    ) -> None:
        """Make the folder; write the scenario and a result that is not complete yet.

        Args:
            out: the folder in which the run's folder is made (``runs``).
            header: what is known before the start.
            name: of the run's folder; left out: time and scenario. A number is added if it exists.
            now: the wall clock, for the name and for ``datetime`` in the reflog.

        Raises:
            RecordError: the folder cannot be made.
        """
        self._now = now
        self._started = now()
        self._header = header
        self._roster = Roster.of(header.scenario)
        scenario = dumped(header.scenario)
        self._inputs = inputs_digest(header.scenario, header.seed, header.programs)
        self._states = StatesDigest()
        self._track: TrackWriter | None = None
        self._half: HalfInfo | None = None
        self._phase: tuple[str, bool] | None = None
        self._held: frozenset[int] = frozenset()
        self._events: list[dict[str, Any]] = []
        self._faults: list[dict[str, Any]] = []
        self._halves: list[dict[str, Any]] = []
        self._begun: list[int] = []
        self._scores: dict[str, Score] = dict.fromkeys(header.team_names, 0)
        self._result: dict[str, Any] | None = None
        self._versions = versions().model_dump()
        self.folder = make_run_folder(out, name or folder_name(self._started, header.scenario.id))
        # First, and not by way of a neighbour: a folder without a result is no record, wherever a kill comes.
        self._begin()
        self.logs = self.folder / LOGS
        self.logs.mkdir()
        self._parts = self.folder / TRAJECTORY_PARTS
        self._parts.mkdir()
        self._write(self.folder / SCENARIO, json_line(scenario))
        if header.unresolved:
            self._write(self.folder / UNRESOLVED, json_line(dict(header.unresolved)))
        for team, logo in header.logos.items():
            self._write(logo_path(self.folder, team), logo)
        self._reflog = (self.folder / REFLOG).open("xb", buffering=0)
        self._referee_log = (self.folder / REFEREE_LOG).open("xb", buffering=0)

    def _begin(self) -> None:
        """Write a result that is not complete; if there is no room for it, the folder goes: it would be no record."""
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
        """What ``result.json`` says at present; a copy may be printed or sent as JSON."""
        return dict(self._result or {})

    def begin_half(self, half: HalfInfo) -> None:
        """Begin a half; its ticks follow, tick 0 (the start, before physics) first."""
        self._track = TrackWriter(self._parts, half, len(self._roster.entities))
        self._begun.append(half.half)
        self._half = half
        self._phase, self._held = None, frozenset()
        self._scores |= {half.teams[seat]: points for seat, points in half.scores.items()}
        self._states.half(half.half)

    def tick(self, snapshot: Snapshot, output: RefereeOutput, state: bytes, poses: bytes = b"") -> None:
        """Record one judged tick.

        Args:
            snapshot: what the referee saw.
            output: what it answered; its placements are carried out after the snapshot.
            state: the judged qpos and qvel as little-endian float64.
            poses: those of the snapshot as little-endian float32 ``[sub-step][entity][3]``; left out: made here.
        """
        track = self._track
        if track is None:
            raise ValueError("a tick outside of a half: call begin_half first")
        self._states.state(state)
        track.append(snapshot, output.placements, poses)
        if output.firings or output.events or snapshot.faults:
            self._say(snapshot, output)
        if (output.phase, output.waiting_for_kickoff) != self._phase:
            self._phase = (output.phase, output.waiting_for_kickoff)
            self._note_phase(snapshot.tick, output)
        if output.held is not self._held:
            self._note_held(snapshot.tick, output.held)
        if output.counted is not None:
            self._note_counted(snapshot.tick, output.counted)

    def end_half(
        self, closing: RefereeOutput, scores: Mapping[str, Score] | None = None, ended: str | None = None
    ) -> None:
        """End the half.

        Args:
            closing: what the rules of ``half_ended`` said.
            scores: points by seat; left out: the sum of what the firings scored.
            ended: the reason of the rule that ended it, or the match with it; None if the time was up.
        """
        if self._track is None or self._half is None:
            raise ValueError("no half to end: call begin_half first")
        half, ticks = self._half, self._track.ticks
        if closing.firings or closing.events:
            self._say(Snapshot(ticks, [], [], [], ()), closing)
        if closing.counted is not None:
            self._note_counted(ticks, closing.counted)
        if scores is not None:
            self._scores |= {half.teams[seat]: points for seat, points in scores.items()}
        self._close_half(half, self._track, ended, complete=True)
        self._write_result({})

    def finish(self, result: Mapping[str, Any] | None = None) -> Path:
        """Close the record: the trajectory becomes one file, the result is complete. Returns the folder.

        Args:
            result: fields of `RunResult` that only the caller knows (``wall_s``, ``sandbox``, ``marks``, ``score``),
                and ``complete: False`` with ``stopped`` for a run that was not played to its end.
        """
        states = self._states.hexdigest()
        digests = {"states": states, "digest": run_digest(self._inputs, states)}
        fields = {"complete": True} | digests | dict(result or {})
        self._reflog.close()
        self._referee_log.close()
        if self._track is not None and self._half is not None:
            self._close_half(self._half, self._track, None, complete=False)
        if not fields["complete"]:
            self._write_result(fields)  # at once, should there be neither time nor room for the rest
        pack_trajectory(self.folder, self._trajectory_header(), self._begun)
        self._write_result(fields)
        return self.folder

    def break_off(self, error: type[BaseException], result: Mapping[str, Any] | None = None) -> Path:
        """Close the record of a run that was not played to its end, as `finish` does; can be called again.

        Args:
            error: what stopped it.
            result: as for `finish`.
        """
        fields = {"complete": False, "states": "", "digest": "", "stopped": error.__name__}
        return self.finish(fields | dict(result or {}))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is not None and not self._reflog.closed:
            self.break_off(kind)

    # --- parts ------------------------------------------------------------------------------------------------------

    def _close_half(self, half: HalfInfo, track: TrackWriter, ended: str | None, *, complete: bool) -> None:
        # An interruption in here closes it a second time.
        if half.half not in [one["half"] for one in self._halves]:
            self._halves.append(
                {
                    "half": half.half,
                    "sides": dict(half.teams),
                    "score": dict(self._scores),
                    "ticks": track.ticks,
                    "ended": ended,
                    "complete": complete,
                }
            )
        track.close()
        self._track = None

    def _say(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        """Write what happened: to the reflog, the referee's log, the digest and the result to come."""
        half = self._half
        assert half is not None  # noqa: S101 - only called within a half
        events = events_of(snapshot, output)
        if events:
            write_all(self._reflog, bytearray(reflog_lines(events, timestamp(self._now()))))
        for event in events:
            self._states.event(event)
        lines = [event_line(half.half, event) for event in events]
        self._events += lines
        told = [firing_line(half.half, firing) for firing in output.firings]
        told += [{"kind": "event", **line} for line in lines]
        write_all(self._referee_log, bytearray(b"".join(map(json_line, told))))
        self._faults += [self._fault(fault, half) for fault in snapshot.faults]
        for firing in output.firings:
            self._add_points(firing, half)

    def _note_phase(self, tick: int, output: RefereeOutput) -> None:
        half = self._half
        assert half is not None  # noqa: S101 - only called within a half
        line = {"half": half.half, "kind": "phase", "tick": tick, "phase": output.phase}
        write_all(self._referee_log, bytearray(json_line(line | {"waiting_for_kickoff": output.waiting_for_kickoff})))

    def _note_held(self, tick: int, held: frozenset[int]) -> None:
        """Note which robots rules hold, where that changed."""
        half, before, self._held = self._half, self._held, held
        assert half is not None  # noqa: S101 - only called within a half
        if held != before:
            robots = [self._roster.entities[robot] for robot in sorted(held)]
            line = {"half": half.half, "kind": "held", "tick": tick, "robots": robots}
            write_all(self._referee_log, bytearray(json_line(line)))

    def _note_counted(self, tick: int, counters: Mapping[str, Any]) -> None:
        half = self._half
        assert half is not None  # noqa: S101 - only called within a half
        line = {"half": half.half, "kind": "counted", "tick": tick, "counters": counters}
        write_all(self._referee_log, bytearray(json_line(line)))

    def _add_points(self, firing: Firing, half: HalfInfo) -> None:
        if firing.suppressed is None:
            for seat, points in firing.scored.items():
                team = half.teams[seat]
                self._scores[team] = round_score(self._scores[team] + points)

    def _fault(self, fault: Fault, half: HalfInfo) -> dict[str, Any]:
        entrants = self._header.scenario.entrants
        team = next((half.teams[seat] for seat, entrant in entrants.items() if fault.robot in entrant.robots), None)
        return {
            "robot": fault.robot,
            "team": team,
            "half": fault.half,
            "tick": fault.tick,
            "kind": fault.kind,
            "detail": fault.detail,
            "traceback": fault.traceback,
            "timed": fault.timed,
        }

    def _trajectory_header(self) -> dict[str, Any]:
        roster = self._roster
        return {
            "scenario": self._header.scenario.id,
            "seed": self._header.seed,
            "entities": list(roster.entities),
            "robots": roster.robots,
            "balls": roster.balls,
            "things": list(roster.things),
        }

    def _write_result(self, more: Mapping[str, Any]) -> None:
        line = self._result_line(more)
        with replaced(self.folder / RESULT) as file:
            file.write(line)

    def _result_line(self, more: Mapping[str, Any]) -> bytes:
        """Keep what the result says now, and return it as it is written."""
        header = self._header
        simulated_s = round(sum(half["ticks"] for half in self._halves) * TICK_S, 3)
        entrants = {
            team: {"name": name, "programs": header.programs[team], "members": header.members.get(team, ())}
            for team, name in header.team_names.items()
        }
        fields: dict[str, Any] = {
            "record": RECORD_VERSION,
            "complete": False,
            "stopped": None,
            "scenario": header.scenario.id,
            "title": header.scenario.title,
            "started": timestamp(self._started),
            "seed": header.seed,
            "match_id": header.match_id,
            "entrants": entrants,
            "score": dict(self._scores),
            "halves": self._halves,
            "events": self._events,
            "faults": self._faults,
            "inputs": self._inputs,
            "states": "",
            "digest": "",
            "simulated_s": simulated_s,
            "wall_s": 0.0,
            "real_time_factor": 0.0,
            "versions": self._versions,
            "sandbox": dict(header.sandbox),
            "marks": list(header.marks),
        } | dict(more)
        if fields["wall_s"] > 0 and "real_time_factor" not in more:
            fields["real_time_factor"] = round(fields["simulated_s"] / fields["wall_s"], 2)
        self._result = RunResult.model_validate(fields).model_dump(mode="json")
        return json_line(self._result)
